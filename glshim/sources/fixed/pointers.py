"""What lies behind the pointer-like arguments of PyOpenGL's raw calls."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.arguments import address_of, reals_of
from glshim.system import memory

_DTYPES: dict[str, type[np.generic]] = {
    "b": np.int8, "s": np.int16, "i": np.int32, "ui": np.uint32, "f": np.float32, "d": np.float64,
}  # fmt: skip
"""By the letters that entry points name their types with."""


def dtype_of(letters: str) -> type[np.generic]:
    """The numpy type of an entry point's type letters."""
    return _DTYPES[letters]


def numbers_at(value: Any, letters: str, count: int) -> NDArray[Any]:
    """(count,) a copy of the numbers that a vector form is given, of the type of its letters.
    Raises TypeError where they cannot be had."""
    dtype = dtype_of(letters)
    if type(value) is list or type(value) is tuple:
        given = np.array(reals_of(value)[:count]).astype(dtype)
        if len(given) < count:
            raise TypeError(f"{len(given)} numbers are given where {count} are needed")
        return given
    found = memory.read(address_of(value), count * np.dtype(dtype).itemsize)
    if found is None:
        raise TypeError("the memory of an argument cannot be read")
    return found.view(dtype)
