"""Buffers in the driver's memory."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.outputs.gl.device.names import delete, made
from glshim.spec.constants import GL_ARRAY_BUFFER, GL_DYNAMIC_DRAW, GL_STATIC_DRAW
from glshim.spec.driver import gl


class Buffer:
    """Use it inside the guard; indices with their vertex array bound."""

    def __init__(self, target: int = GL_ARRAY_BUFFER) -> None:
        self._target = target
        self.name = made("glGenBuffers")

    def bind(self) -> None:
        """To its target."""
        gl.glBindBuffer(self._target, self.name)

    def fill(self, rows: NDArray[Any], usage: int = GL_STATIC_DRAW) -> None:
        """Bind it and give it its contents."""
        self.bind()
        rows = np.ascontiguousarray(rows)
        gl.glBufferData(self._target, rows.nbytes, rows.ctypes.data, usage)

    def release(self) -> None:
        """Delete it. In its context."""
        delete("glDeleteBuffers", (self.name,))


class Ring:
    """A buffer through which what changes from draw to draw streams. Use it inside the guard."""

    def __init__(self, size: int) -> None:
        """size: bytes, which grow when one draw needs more."""
        self._buffer = Buffer()
        self._size = size
        self._at = 0
        self._renew()

    def bind(self) -> None:
        """For vertices."""
        self._buffer.bind()

    def put(self, *parts: NDArray[Any]) -> int:
        """Have parts in it, one after another, and bind it; the byte at which the first begins."""
        size = sum(part.nbytes for part in parts)
        self.bind()
        if size > self._size:
            self._size = 2 * size
            self._renew()
        elif self._at + size > self._size:
            self._renew()
        first = self._at
        for part in parts:
            rows = np.ascontiguousarray(part)
            gl.glBufferSubData(GL_ARRAY_BUFFER, self._at, rows.nbytes, rows.ctypes.data)
            self._at += rows.nbytes
        return first

    def _renew(self) -> None:
        """Memory that no draw under way reads."""
        self.bind()
        gl.glBufferData(GL_ARRAY_BUFFER, self._size, None, GL_DYNAMIC_DRAW)
        self._at = 0
