"""What the arguments of calls say: numbers and addresses, in every form that PyOpenGL takes."""

from __future__ import annotations

import ctypes
from inspect import getattr_static
from operator import index
from typing import Any

import numpy as np

from glshim.system.interrupts import is_ours

_PLAIN = frozenset((int, float, bool))
_VALUE: Any = vars(ctypes._SimpleCData)["value"]
_INTERFACE: Any = vars(np.ndarray)["__array_interface__"]
_OWN = frozenset(("OpenGL", "OpenGL_accelerate"))
_OF_CTYPES: tuple[Any, ...] = (
    ctypes._SimpleCData, ctypes._Pointer, ctypes.Array, ctypes.Structure, ctypes.Union,
    ctypes._CFuncPtr, type(ctypes.byref(ctypes.c_int())),  # type: ignore[attr-defined]
)  # fmt: skip


def integer_of(value: Any) -> int:
    """An integer, given plain, by numpy or by ctypes. Raises TypeError for anything else."""
    return value if type(value) is int else index(_bare(value))


def real_of(value: Any) -> float:
    """A number, given plain, by numpy or by ctypes. Raises TypeError for anything else."""
    return value if type(value) is float else float(_bare(value))


def reals_of(value: Any) -> list[float]:
    """The numbers of a list or tuple, nested ones included, one after the other."""
    if type(value) is list or type(value) is tuple:
        return [number for each in value for number in reals_of(each)]
    return [real_of(value)]


def _bare(value: Any) -> Any:
    """What ctypes would hand to C, of plain types. No code of the program's runs: PyOpenGL asks its
    objects for their numbers itself, once."""
    for _ in range(8):  # so deep is nobody; it may name itself
        kind = type(value)
        if kind in _PLAIN:
            return value
        if issubclass(kind, int):
            return int.__index__(value)
        if issubclass(kind, float):
            return float.__pos__(value)
        if issubclass(kind, ctypes._SimpleCData):
            return _VALUE.__get__(value)
        if issubclass(kind, np.generic) and kind.__module__ == "numpy":
            return value.item()
        if kind is np.ndarray and not value.shape:
            return value.item()
        value = getattr_static(value, "_as_parameter_", None)
        if value is None:
            raise TypeError(f"a {kind.__name__} is not a number that can be known")
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


def are_ints(args: tuple[Any, ...]) -> bool:
    """Whether nothing of the program's runs while they are read: signal handlers may wait then. Of
    other kinds a handler may strike in the midst of reading, and raise there."""
    return all(type(value) is int for value in args)


def place_of(value: Any) -> int:
    """`address_of`; 0 where that cannot be told."""
    try:
        return address_of(value)
    except TypeError as error:
        if not is_ours(error):
            raise
        return 0


def address_of(value: Any) -> int:
    """The address, or the offset in a buffer, that an argument stands for. Raises TypeError where
    that cannot be told. No code of the program's runs."""
    for _ in range(8):
        found = _known_address(value)
        if found is not None:
            return found
        value = getattr_static(value, "_as_parameter_", None)
    raise TypeError("what stands for the argument is itself")


def _known_address(value: Any) -> int | None:
    """None for what another object may stand for."""
    if value is None:
        return 0
    kind = type(value)
    if issubclass(kind, int):
        return int.__index__(value)
    if issubclass(kind, ctypes.c_void_p):
        return _VALUE.__get__(value) or 0
    if issubclass(kind, np.ndarray):
        return int(_INTERFACE.__get__(value)["data"][0])
    if issubclass(kind, (str, list, tuple)):  # PyOpenGL made a copy of it, which is gone
        raise TypeError(f"a {kind.__name__} has no address")
    if issubclass(kind, (bytes, *_OF_CTYPES)):
        try:
            return int(ctypes.cast(value, ctypes.c_void_p).value or 0)
        except (TypeError, ValueError, ctypes.ArgumentError) as error:
            if not is_ours(error):
                raise
    elif getattr_static(value, "_as_parameter_", None) is not None:
        return None
    return _by_pyopengl(value)


def _by_pyopengl(value: Any) -> int:
    from OpenGL.arrays import ArrayDatatype

    try:
        handler = ArrayDatatype.getHandler(value)
        if type(handler).__module__.partition(".")[0] not in _OWN:
            raise TypeError("the program has a handler of its own")
        return int(ArrayDatatype.voidDataPointer(value).value or 0)
    except Exception as error:  # of whatever handler PyOpenGL has for it
        if not is_ours(error):
            raise
        raise TypeError(f"the address of a {type(value).__name__} is not known") from error
