"""Buffers in the driver's memory: made and written through moderngl, bound by the bare driver."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.spec.constants import GL_ARRAY_BUFFER


class Buffer:
    """Use it inside the guard, with no vertex array object bound."""

    def __init__(
        self, device: ModernDevice, target: int = GL_ARRAY_BUFFER, *, dynamic: bool = False
    ) -> None:
        """dynamic: it is filled again and again."""
        self._target = target
        self._made = device.buffer(0, dynamic=dynamic)

    def bind(self) -> None:
        """To its target."""
        gl.glBindBuffer(self._target, self._made.glo)

    def fill(self, rows: NDArray[Any]) -> None:
        """Give it its contents and bind it."""
        if rows.nbytes:
            self._made.orphan(rows.nbytes)
            self._made.write(np.ascontiguousarray(rows))
        self.bind()

    def release(self) -> None:
        """Delete it. In its context."""
        self._made.release()


class Ring:
    """A buffer through which what changes from draw to draw streams. Use it inside the guard."""

    def __init__(self, device: ModernDevice, size: int) -> None:
        """size: bytes, which grow when one draw needs more."""
        self._made = device.buffer(size, dynamic=True)
        self._size = size
        self._at = 0

    def bind(self) -> None:
        """For vertices."""
        gl.glBindBuffer(GL_ARRAY_BUFFER, self._made.glo)

    def put(self, *parts: NDArray[Any]) -> int:
        """Have parts in it, one after another, and bind it; the byte at which the first begins."""
        size = sum(part.nbytes for part in parts)
        if size > self._size:
            self._size = 2 * size
            self._renew()
        elif self._at + size > self._size:
            self._renew()
        first = self._at
        for part in parts:
            if part.nbytes:
                self._made.write(np.ascontiguousarray(part), self._at)
                self._at += part.nbytes
        self.bind()
        return first

    def _renew(self) -> None:
        """Memory that no draw under way reads."""
        self._made.orphan(self._size)
        self._at = 0
