"""What the arguments of calls say: numbers and addresses, in every form that PyOpenGL takes."""

from __future__ import annotations

import ctypes
from operator import index
from typing import Any

import numpy as np

from glshim.system.interrupts import is_ours


def integer_of(value: Any) -> int:
    """An integer, given plain, by numpy or by ctypes. Raises TypeError for anything else."""
    return value if type(value) is int else index(_bare(value))


def real_of(value: Any) -> float:
    """A number, given plain, by numpy or by ctypes. Raises TypeError for anything else."""
    return float(_bare(value))


def _bare(value: Any) -> Any:
    """What ctypes would hand to C."""
    for _ in range(8):  # so deep is nobody; it may name itself
        if isinstance(value, (int, float)):
            return value
        if hasattr(value, "_as_parameter_"):
            value = value._as_parameter_
        elif isinstance(value, ctypes._SimpleCData):
            return value.value
        else:
            return value
    raise TypeError("what stands for the argument is itself")


def signed(value: Any) -> int:
    """A GLint or GLsizei, which wraps as in C. Raises TypeError where there is no integer."""
    if type(value) is int and -0x80000000 <= value <= 0x7FFFFFFF:
        return value
    return (integer_of(value) + 0x80000000 & 0xFFFFFFFF) - 0x80000000


def unsigned(value: Any) -> int:
    """A GLuint, GLenum or GLbitfield, which wraps as in C. Raises TypeError where there is no
    integer."""
    return integer_of(value) & 0xFFFFFFFF


def number(args: tuple[Any, ...], position: int) -> int:
    """A GLint or GLsizei among arguments; 0 where there is none, as the binding will say."""
    try:
        return signed(args[position])
    except (IndexError, TypeError, ValueError) as error:
        if not is_ours(error):
            raise
        return 0


def name(args: tuple[Any, ...], position: int) -> int:
    """A GLuint, GLenum or GLbitfield among arguments; 0 where there is none."""
    return number(args, position) & 0xFFFFFFFF


def address_of(value: Any) -> int:
    """The address, or the offset in a buffer, that an argument stands for. Raises TypeError where
    that cannot be told."""
    if value is None:
        return 0
    if isinstance(value, int):
        return value
    if isinstance(value, ctypes.c_void_p):
        return value.value or 0
    if isinstance(value, np.ndarray):
        return int(value.__array_interface__["data"][0])
    if isinstance(value, (str, list, tuple)):  # PyOpenGL made a copy of it, which is gone
        raise TypeError(f"a {type(value).__name__} has no address")
    try:
        return int(ctypes.cast(value, ctypes.c_void_p).value or 0)  # all of ctypes; bytes
    except (TypeError, ValueError, ctypes.ArgumentError) as error:
        if not is_ours(error):
            raise
    from OpenGL.arrays import ArrayDatatype

    try:
        return int(ArrayDatatype.voidDataPointer(value).value or 0)
    except Exception as error:  # of whatever handler PyOpenGL has for it
        if not is_ours(error):
            raise
        raise TypeError(f"the address of a {type(value).__name__} is not known") from error
