"""Arguments that the driver took: numbers, and addresses of memory that the program sees."""

from __future__ import annotations

import ctypes
from operator import index
from typing import Any

import numpy as np

from glshim.system.interrupts import is_ours


def are_ints(args: tuple[Any, ...]) -> bool:
    """Whether nothing of the program's runs while they are read: signal handlers may wait then. Of
    other kinds a handler may strike in the midst of reading, and raise there."""
    return all(type(value) is int for value in args)


def number(args: tuple[Any, ...], position: int) -> int:
    """A GLuint or GLsizei among arguments, 0 for none."""
    try:
        value = args[position]
        return index(getattr(value, "value", value)) & 0xFFFFFFFF
    except (IndexError, TypeError) as error:
        if not is_ours(error):
            raise
        return 0


def address_of(value: Any) -> int:
    """0 for none: PyOpenGL copies lists."""
    if isinstance(value, np.ndarray):
        return int(value.__array_interface__["data"][0])
    try:
        return int(ctypes.cast(value, ctypes.c_void_p).value or 0)
    except (TypeError, ctypes.ArgumentError) as error:
        if not is_ours(error):
            raise
        return 0
