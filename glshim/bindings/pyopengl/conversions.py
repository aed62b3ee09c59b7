"""PyOpenGL's own conversion of a call's arguments, without the call.

A twin of its ctypes function is of the same type: it takes what that takes, and refuses the rest in
the same words, whatever flags and handlers of arrays the program has set. Behind the twin stands a
function of C's that hands back what it was given. No Python code of ours runs in between.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from struct import Struct
from typing import Any

from numpy import zeros

from glshim.bindings.pyopengl.raw import Call, own_class
from glshim.bindings.pyopengl.record import Record
from glshim.spec.attributes import Attribute
from glshim.system.prototypes import function_type

ELEMENTS: dict[str, Any] = {
    "f": ctypes.c_float, "d": ctypes.c_double, "i": ctypes.c_int, "s": ctypes.c_short,
    "u": ctypes.c_ubyte, "b": ctypes.c_ubyte, "e": ctypes.c_uint, "p": ctypes.c_size_t,
}  # fmt: skip
"""C types by the type letters of attributes, of an enum and of an address."""
_FORMATS = {"f": "f", "d": "d", "i": "i", "s": "h", "u": "B", "b": "B", "e": "I", "p": "N"}
"""The same in the language of struct."""
_SEQUENCES: tuple[Any, ...] = ([], (), zeros(0))
"""One of each."""
_PYOPENGL = ("OpenGL", "OpenGL_accelerate")


def sequences(record: Record) -> frozenset[type]:
    """Those of list, tuple and array that PyOpenGL's own handlers convert, not the program's; as
    long as the primitive is open, the record knows it."""
    from OpenGL.arrays.arraydatatype import ArrayDatatype

    handlers = map(ArrayDatatype.getHandler, _SEQUENCES)
    record.sequences = found = frozenset(
        type(one)
        for one, handler in zip(_SEQUENCES, handlers, strict=True)
        if type(handler).__module__.partition(".")[0] in _PYOPENGL
    )
    return found


def integers() -> frozenset[type]:
    """Exact types of integers that arrive as they are, but for what C cuts off."""
    from OpenGL.constant import IntConstant

    return frozenset((int, IntConstant))


def layout(letter: str, size: int) -> Struct:
    """So many numbers of one type, as they lie in memory."""
    return Struct(f"@{size}{_FORMATS[letter]}")


def function_of(real: Call) -> Any:
    """The ctypes function of a raw call; None where PyOpenGL has wrapped it, to log its calls."""
    function = getattr(real, "__self__", None)
    return function if isinstance(function, ctypes._CFuncPtr) else None  # type: ignore[attr-defined]


def driver_of(function: Any) -> Callable[..., Any]:
    """What it calls, bare: it takes bytes and ctypes' numbers, as they are."""
    return ctypes.PYFUNCTYPE(None)(_place(function))


def numbers(function: Any, letters: str) -> Callable[..., tuple[Any, ...]]:
    """Takes the arguments of a call, positional and named, and gives the numbers that the driver
    would get. letters: their types, each one of `ELEMENTS`."""
    together = Struct("@" + "".join(_FORMATS[letter] for letter in letters))
    given_back = function_type(ctypes.py_object, *(ELEMENTS[letter] for letter in letters))
    twin = _twin(function, given_back(together.pack))
    return lambda *args, **named: together.unpack(twin(*args, **named))


def behind(function: Any, letter: str, size: int) -> Callable[[Any], tuple[Any, ...]]:
    """Takes the one argument of a call, and gives the numbers that the driver would find at its
    address: so many, of one type."""
    together = layout(letter, size)
    length = _Length(together.size)
    # It takes an address and a length. C passes on what a function has no parameter for.
    copied = function_type(ctypes.py_object, _Address, _Length)
    twin = _twin(function, copied(_BYTES))
    return lambda pointer, **named: together.unpack(twin(pointer, length, **named))


class _Address(ctypes.c_void_p):
    """Comes to a callback as it is, and goes on so: a type of ctypes' own would be converted."""


class _Length(ctypes.c_ssize_t):
    """This, too."""


def _place(function: Any) -> int:
    place = ctypes.cast(function, ctypes.c_void_p).value
    assert place is not None
    return place


_BYTES = ctypes.PYFUNCTYPE(ctypes.py_object)(_place(ctypes.pythonapi.PyBytes_FromStringAndSize))
"""Bytes from an address and a length."""


def _twin(function: Any, stand_in: Any) -> Callable[..., bytes]:
    # A type converts as ctypes did when it was made: one of ours may do otherwise.
    twin = own_class(function)(_place(stand_in))
    twin.restype = ctypes.py_object
    twin.stand_in = stand_in  # as long as it
    return twin  # type: ignore[no-any-return]


def recorded(row: Attribute) -> Callable[[Sequence[Any]], bytes]:
    """From the numbers that the driver gets to their record. What is too large for a float is
    infinite in it, as for the driver."""
    pack, tag = Struct("@" + row.pack.format[1:]).pack, row.tag
    if row.type == "u":
        return lambda values: pack(*(value / 255.0 for value in values), tag)
    return lambda values: pack(*values, tag)


# -- integers that are known to arrive as they are, by an argument count ---------------------------


def _ranged(letter: str) -> Callable[[int], Callable[..., tuple[Any, ...]]]:
    def sized(size: int) -> Callable[..., tuple[Any, ...]]:
        check = Struct(f"={size}{letter}").pack

        def convert(*args: Any) -> tuple[Any, ...]:
            for value in args:
                if type(value) is not int:
                    raise TypeError
            check(*args)  # C would wrap it
            return args

        return convert

    return sized


def _bytes(size: int) -> Callable[..., tuple[Any, ...]]:
    """Unsigned bytes as C takes them (300 is 44), made 0..1 as GL does."""

    def three(r: Any, g: Any, b: Any) -> tuple[Any, ...]:
        if type(r) is type(g) is type(b) is int:
            return (r & 255) / 255.0, (g & 255) / 255.0, (b & 255) / 255.0
        raise TypeError

    def four(r: Any, g: Any, b: Any, a: Any) -> tuple[Any, ...]:
        if type(r) is type(g) is type(b) is type(a) is int:
            return (r & 255) / 255.0, (g & 255) / 255.0, (b & 255) / 255.0, (a & 255) / 255.0
        raise TypeError

    return three if size == 3 else four


def _switch(size: int) -> Callable[..., tuple[Any, ...]]:
    def convert(flag: Any) -> tuple[Any, ...]:
        if type(flag) is int or type(flag) is bool:
            return (flag & 255,)  # Mesa answers glGet by its very value
        raise TypeError

    return convert


INTEGERS: dict[str, Callable[[int], Callable[..., tuple[Any, ...]]]] = {
    "i": _ranged("i"), "s": _ranged("h"), "u": _bytes, "b": _switch,
}  # fmt: skip
"""By type letter: from an argument count to what turns Python's integers into the recorded floats,
and raises an error for all others."""
