"""What lies behind the pointer-like arguments of PyOpenGL's raw calls."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ARRAYS: dict[str, tuple[str, type[np.generic]]] = {
    "b": ("GLbyteArray", np.int8), "s": ("GLshortArray", np.int16), "i": ("GLintArray", np.int32),
    "ui": ("GLuintArray", np.uint32), "f": ("GLfloatArray", np.float32),
    "d": ("GLdoubleArray", np.float64),
}  # fmt: skip
"""By the letters that entry points name their types with."""


def dtype_of(letters: str) -> type[np.generic]:
    """The numpy type of an entry point's type letters."""
    return _ARRAYS[letters][1]


def numbers_at(value: Any, letters: str, count: int) -> NDArray[Any]:
    """(count,) a copy of the numbers that a vector form is given, of the type of its letters."""
    from OpenGL import arrays

    name, dtype = _ARRAYS[letters]
    address = int(getattr(arrays, name).dataPointer(value))
    return np.frombuffer(ctypes.string_at(address, count * np.dtype(dtype).itemsize), dtype)


def address_of(value: Any) -> int:
    """The address, or the offset in a buffer, that an argument stands for."""
    if value is None:
        return 0
    if isinstance(value, int):
        return value
    if isinstance(value, ctypes.c_void_p):
        return value.value or 0
    from OpenGL.arrays import ArrayDatatype

    return int(ArrayDatatype.voidDataPointer(value).value or 0)
