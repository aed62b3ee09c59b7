"""The primitive that is open: what it began with, and what its record lacks."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from glshim.bindings.base import PrimitiveStream
from glshim.driver.functions import gl


class OpenPrimitive:
    """What is noted between glBegin and glEnd, where nothing may be asked of the driver."""

    def __init__(self, stream: PrimitiveStream) -> None:
        self._stream = stream
        self.colour = self.normal = b""
        """Records of what it began with and has until it says another, if wanted."""
        self.is_whole = True
        """Its record lacks nothing."""
        self._elements: list[tuple[int, int]] = []
        """Positions in the record of glArrayElement calls, and their indices."""
        self._evaluations: list[tuple[int, Callable[[], Any]]] = []
        """Positions in the record of evaluated vertices, and what evaluates them again."""

    def forget(self) -> None:
        """Another primitive begins."""
        self.is_whole = True
        self._evaluations, self._elements = [], []

    def element(self, index: int) -> None:
        """A vertex comes from the arrays: it is fetched at the end."""
        self.is_whole = False
        self._elements.append((self._stream.position(), index))

    def evaluation(self, call: Callable[[], Any]) -> None:
        """A vertex is evaluated."""
        self.is_whole = False
        self._evaluations.append((self._stream.position(), call))

    def with_elements(self, record: bytes, fetch: Callable[[int], bytes]) -> bytes:
        """The record with the vertices of glArrayElement in their places; fetch: the record of the
        vertex of an index. Empty where it cannot be had: the rest stays as it is then."""
        if not self._elements:
            return record
        parts: list[bytes] = []
        at = 0
        places = list(self._evaluations)
        elements, self._elements = self._elements, []
        for position, index in elements:
            vertex = fetch(index)
            if not vertex:
                break
            parts += [record[at:position], vertex]
            at = position
            self._evaluations = [
                (place + len(vertex) if old >= position else place, call)
                for (place, call), (old, _) in zip(self._evaluations, places, strict=True)
            ]
        return b"".join((*parts, record[at:]))

    def again(self, mode: int, record: bytes) -> Callable[[], None] | None:
        """Says the whole primitive again, where it has evaluated vertices."""
        if not self._evaluations:
            return None
        calls, replay = list(self._evaluations), self._stream.replay

        def draw() -> None:
            gl.glBegin(mode)
            at = 0
            for position, call in calls:
                replay(record[at:position])
                call()
                at = position
            replay(record[at:])
            gl.glEnd()

        return draw
