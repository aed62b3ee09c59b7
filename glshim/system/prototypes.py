"""Types of C functions of our own.

ctypes makes one for each set of parameters and keeps it, with the ways of converting arguments as
they are then; PyOpenGL (`ALLOW_NUMPY_SCALARS`) and others change these. What we make must not be
what the program finds there, nor convert by what it has changed.
"""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any


@cache
def function_type(result: Any, *parameters: Any) -> Any:
    """What `ctypes.CFUNCTYPE` gives, for us alone."""
    return type(
        "CFunctionType",
        (ctypes._CFuncPtr,),  # type: ignore[attr-defined]
        {
            "_flags_": ctypes._FUNCFLAG_CDECL,  # type: ignore[attr-defined]
            "_restype_": result,
            "_argtypes_": parameters,
        },
    )
