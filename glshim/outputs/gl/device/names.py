"""Names of GL objects: made and given back one way for every kind."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable

from glshim.spec.driver import gl


def made(make: str) -> int:
    """The name of a new object, by the function that makes it, e.g. ``glGenTextures``."""
    value = ctypes.c_uint()
    getattr(gl, make)(1, ctypes.addressof(value))
    return value.value


def delete(function: str, names: Iterable[int]) -> None:
    """Delete objects by the function that does it, e.g. ``glDeleteTextures``."""
    listed = list(names)
    values = (ctypes.c_uint * len(listed))(*listed)
    getattr(gl, function)(len(listed), ctypes.addressof(values))
