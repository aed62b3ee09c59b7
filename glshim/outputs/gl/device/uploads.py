"""Rows of numbers in the driver's memory: textures that shaders look up by number, and indices."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from glshim.spec.driver import gl

WIDTH = 2048
"""Texels in a row of a texture that has more than one."""
_ANY_UNIT = 6
_ELEMENT_BUFFER, _STREAM_DRAW = 0x8893, 0x88E0
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_FLOAT, _INT, _SHORT, _RGBA, _RGBA_INTEGER = 0x1406, 0x1404, 0x1402, 0x1908, 0x8D99
_RGBA_32F, _RGBA_32I, _RGBA_16_SNORM = 0x8814, 0x8D82, 0x8F9B
_PLAIN = ((0x2801, 0x2600), (0x2800, 0x2600), (0x813D, 0))  # nearest, one level


def made(make: str) -> int:
    """The name of a new object, by the function that makes it."""
    value = ctypes.c_uint()
    getattr(gl, make)(1, ctypes.addressof(value))
    return value.value


def upload(rows: NDArray[np.generic]) -> int:
    """The name of a texture whose texels are rows (N, 4)."""
    kinds = {"f": (_RGBA_32F, _RGBA, _FLOAT), "i": (_RGBA_32I, _RGBA_INTEGER, _INT)}
    inner, outer, kind = kinds[rows.dtype.kind]
    if rows.dtype == np.int16:
        inner, outer, kind = _RGBA_16_SNORM, _RGBA, _SHORT
    width, height = min(max(len(rows), 1), WIDTH), max(1, -(-len(rows) // WIDTH))
    padded = np.ascontiguousarray(rows)
    if len(rows) < width * height:
        padded = np.zeros((height * width, 4), rows.dtype)
        padded[: len(rows)] = rows
    name = made("glGenTextures")
    gl.glActiveTexture(_TEXTURE_0 + _ANY_UNIT)
    gl.glBindTexture(_TEXTURE_2D, name)
    gl.glBindBuffer(_UNPACK_BUFFER, 0)
    for alignment in ((0x0CF5, 4), (0x0CF2, 0), (0x0CF3, 0), (0x0CF4, 0)):
        gl.glPixelStorei(*alignment)
    for parameter, value in _PLAIN:
        gl.glTexParameteri(_TEXTURE_2D, parameter, value)
    gl.glTexImage2D(_TEXTURE_2D, 0, inner, width, height, 0, outer, kind, padded.ctypes.data)
    return name


def delete(textures: Iterable[int]) -> None:
    """Delete textures by name."""
    names = list(textures)
    values = (ctypes.c_uint * len(names))(*names)
    gl.glDeleteTextures(len(names), ctypes.addressof(values))


class Indices:
    """Indices in a buffer. Use it inside the guard, with a vertex array bound."""

    def __init__(self) -> None:
        self._name = made("glGenBuffers")

    def bind(self) -> None:
        """To the vertex array."""
        gl.glBindBuffer(_ELEMENT_BUFFER, self._name)

    def fill(self, rows: NDArray[np.int32]) -> None:
        """Bind it and give it its contents."""
        self.bind()
        rows = np.ascontiguousarray(rows)
        gl.glBufferData(_ELEMENT_BUFFER, rows.nbytes, rows.ctypes.data, _STREAM_DRAW)

    def free(self) -> None:
        """Delete it."""
        name = ctypes.c_uint(self._name)
        gl.glDeleteBuffers(1, ctypes.addressof(name))
