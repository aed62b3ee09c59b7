"""glRect* as the quad that OpenGL says it is (OpenGL 2.1, section 2.10)."""

from __future__ import annotations

from typing import Any

from glshim.driver.arguments import real_of
from glshim.sources.fixed.pointers import numbers_at
from glshim.spec.attributes import BY_NAME
from glshim.spec.draws import RECTANGLES


def rectangle(name: str, args: tuple[Any, ...]) -> bytes:
    """Recorded stream of the four vertices of a RECT call. Raises TypeError or OverflowError where
    its numbers cannot be had."""
    call = RECTANGLES[name]
    if call.vector:
        (x1, y1), (x2, y2) = (numbers_at(each, call.letter, 2).tolist() for each in args[:2])
    else:
        x1, y1, x2, y2 = (real_of(each) for each in args[:4])
    row = BY_NAME["glVertex2f"]
    corners = ((x1, y1), (x2, y1), (x2, y2), (x1, y2))
    return b"".join(row.pack.pack(x, y, row.tag) for x, y in corners)
