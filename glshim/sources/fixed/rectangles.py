"""glRect* as the quad that OpenGL says it is (OpenGL 2.1, section 2.10)."""

from __future__ import annotations

import ctypes
import re
from typing import Any

from glshim.spec.attributes import BY_NAME

_ARRAYS = {"d": "GLdoubleArray", "f": "GLfloatArray", "i": "GLintArray", "s": "GLshortArray"}
_ELEMENTS: dict[str, Any] = {
    "d": ctypes.c_double, "f": ctypes.c_float, "i": ctypes.c_int, "s": ctypes.c_short,
}  # fmt: skip


def rectangle(name: str, args: tuple[Any, ...]) -> bytes:
    """Recorded stream of the four vertices of a glRect call."""
    if name.endswith("v"):
        x1, y1, x2, y2 = (*_pair(name, args[0]), *_pair(name, args[1]))
    else:
        x1, y1, x2, y2 = (float(a) for a in args[:4])
    row = BY_NAME["glVertex2f"]
    corners = ((x1, y1), (x2, y1), (x2, y2), (x1, y2))
    return b"".join(row.pack.pack(x, y, row.tag) for x, y in corners)


def _pair(name: str, value: Any) -> tuple[float, float]:
    from OpenGL import arrays

    match = re.fullmatch(r"glRect([dfis])v", name)
    assert match is not None
    letter = match.group(1)
    address = int(getattr(arrays, _ARRAYS[letter]).dataPointer(value))
    x, y = (_ELEMENTS[letter] * 2).from_address(address)
    return float(x), float(y)
