"""Bitmaps magnified: each of their pixels becomes a block of the picture's."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_PIXEL_UNPACK_BUFFER,
    GL_PIXEL_UNPACK_BUFFER_BINDING,
    GL_UNPACK_ALIGNMENT,
    GL_UNPACK_LSB_FIRST,
    GL_UNPACK_ROW_LENGTH,
    GL_UNPACK_SKIP_PIXELS,
    GL_UNPACK_SKIP_ROWS,
)
from glshim.system import memory

_UNPACK = {
    name: (value, plain)
    for name, value, plain in (
        ("lsb", GL_UNPACK_LSB_FIRST, 0), ("row_length", GL_UNPACK_ROW_LENGTH, 0),
        ("skip_rows", GL_UNPACK_SKIP_ROWS, 0), ("skip_pixels", GL_UNPACK_SKIP_PIXELS, 0),
        ("alignment", GL_UNPACK_ALIGNMENT, 1),
    )
}  # fmt: skip
Bits = NDArray[np.uint8]
"""(height, width), 0 or 1, the lowest row first."""


def read(width: int, height: int, address: int) -> Bits | None:
    """The bits that glBitmap would take from an address; None for those in a buffer object, and
    where they cannot be read."""
    if integer(GL_PIXEL_UNPACK_BUFFER_BINDING):
        return None
    state = {name: integer(value) for name, (value, _) in _UNPACK.items()}
    row = state["row_length"] or width
    row_bytes, step = (row + 7) // 8, state["alignment"]
    stride = (row_bytes + step - 1) // step * step
    start = address + state["skip_rows"] * stride
    # Nobody need own the end of the last row.
    used = max(stride * (height - 1) + (state["skip_pixels"] + width + 7) // 8, 0)
    found = memory.read(start, used) if width and height else np.empty(0, np.uint8)
    if found is None:
        return None
    rows = np.zeros(max(stride * height, len(found)), np.uint8)
    rows[: len(found)] = found
    raw = rows[: stride * height].reshape(height, stride)
    order: Any = "little" if state["lsb"] else "big"
    bits: Bits = np.unpackbits(raw, axis=1, bitorder=order)
    return bits[:, state["skip_pixels"] : state["skip_pixels"] + width]


def magnified(bits: Bits, across: float, up: float) -> Bits:
    """Bits drawn larger."""
    height, width = bits.shape
    size = max(round(height * up), 1), max(round(width * across), 1)
    rows = (np.arange(size[0]) + 0.5) * height // size[0]
    columns = (np.arange(size[1]) + 0.5) * width // size[1]
    found: Bits = bits[rows.astype(int)][:, columns.astype(int)]
    return found


def draw(bits: Bits, origin: tuple[float, float], move: tuple[float, float]) -> None:
    """glBitmap of bits, whatever unpack state the program has set."""
    before = {value: integer(value) for value, _ in _UNPACK.values()}
    buffer = integer(GL_PIXEL_UNPACK_BUFFER_BINDING)
    if buffer:
        gl.glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0)
    for value, plain in _UNPACK.values():
        gl.glPixelStorei(value, plain)
    packed = np.packbits(bits, axis=1).tobytes()
    gl.glBitmap(bits.shape[1], bits.shape[0], *origin, *move, packed)
    for value, number in before.items():
        gl.glPixelStorei(value, number)
    if buffer:
        gl.glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer)
