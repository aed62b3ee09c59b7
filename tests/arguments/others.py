"""What other modules of a program do to ctypes: types of functions that PyOpenGL finds there, made
before it; and other ways of converting numbers, after it."""

from __future__ import annotations

import ctypes
from itertools import combinations_with_replacement
from typing import Any

_WHOLE = (ctypes.c_int, ctypes.c_uint, ctypes.c_short, ctypes.c_ubyte)
_REAL = (ctypes.c_float, ctypes.c_double)


def first() -> None:
    """Have ctypes keep types of functions that take up to four numbers."""
    for count in range(5):
        for kinds in combinations_with_replacement((*_WHOLE, *_REAL), count):
            ctypes.CFUNCTYPE(None, *kinds)


def last() -> None:
    """Have ctypes take text for numbers."""
    for kind in (*_WHOLE, *_REAL):
        _take_text(kind, float if kind in _REAL else int)


def _take_text(kind: Any, number: Any) -> None:
    usual = kind.from_param

    def from_param(value: Any) -> Any:
        return usual(number(value) if isinstance(value, str) else value)

    kind.from_param = staticmethod(from_param)
