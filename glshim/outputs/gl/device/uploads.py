"""Rows of numbers as textures that shaders look up by number."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.driver.objects import made
from glshim.driver.pixels import unpack_plainly
from glshim.spec.constants import (
    GL_FLOAT,
    GL_INT,
    GL_NEAREST,
    GL_RGBA,
    GL_RGBA16_SNORM,
    GL_RGBA32F,
    GL_RGBA32I,
    GL_RGBA_INTEGER,
    GL_SHORT,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MAX_LEVEL,
    GL_TEXTURE_MIN_FILTER,
)
from glshim.spec.kinds import TEXTURE

WIDTH = 2048
"""Texels in a row of a texture that has more than one."""
_ANY_UNIT = 6
_FORMATS = {
    np.dtype(np.float32): (GL_RGBA32F, GL_RGBA, GL_FLOAT),
    np.dtype(np.int32): (GL_RGBA32I, GL_RGBA_INTEGER, GL_INT),
    np.dtype(np.int16): (GL_RGBA16_SNORM, GL_RGBA, GL_SHORT),
}
"""Format of the texture, layout and type of its texels."""
_PARAMETERS = (
    (GL_TEXTURE_MIN_FILTER, GL_NEAREST), (GL_TEXTURE_MAG_FILTER, GL_NEAREST),
    (GL_TEXTURE_MAX_LEVEL, 0),
)  # fmt: skip


def upload(rows: NDArray[np.generic]) -> int:
    """The name of a texture whose texels are rows (N, 4)."""
    inner, outer, kind = _FORMATS[rows.dtype]
    width, height = min(max(len(rows), 1), WIDTH), max(1, -(-len(rows) // WIDTH))
    padded = np.ascontiguousarray(rows)
    if len(rows) < width * height:
        padded = np.zeros((height * width, 4), rows.dtype)
        padded[: len(rows)] = rows
    name = made(TEXTURE)
    gl.glActiveTexture(GL_TEXTURE0 + _ANY_UNIT)
    gl.glBindTexture(GL_TEXTURE_2D, name)
    unpack_plainly()
    for parameter, value in _PARAMETERS:
        gl.glTexParameteri(GL_TEXTURE_2D, parameter, value)
    gl.glTexImage2D(GL_TEXTURE_2D, 0, inner, width, height, 0, outer, kind, padded.ctypes.data)
    return name
