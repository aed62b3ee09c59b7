"""What programs may give as an argument: kinds by name, each made anew for every call.

Those of the program's own count how often their code runs."""

from __future__ import annotations

import array
import ctypes
import enum
import fractions
import weakref
from collections.abc import Callable
from decimal import Decimal
from typing import Any

import numpy as np

CALLS: list[str] = []
"""What of the program's own code ran, in order."""


class MyInt(int):
    def __index__(self) -> int:
        CALLS.append("index")
        return 3

    def __and__(self, other: Any) -> int:
        CALLS.append("and")
        return 3


class MyFloat(float):
    def __float__(self) -> float:
        CALLS.append("float")
        return 0.25


class MyList(list[Any]):
    def __iter__(self) -> Any:
        CALLS.append("iter")
        return super().__iter__()

    def __len__(self) -> int:
        CALLS.append("len")
        return super().__len__()


class MyArray(np.ndarray[Any, Any]):
    def __array_finalize__(self, other: Any) -> None:
        CALLS.append("finalize")


class Number:
    """All that makes a number."""

    def __float__(self) -> float:
        CALLS.append("float")
        return 0.5

    def __index__(self) -> int:
        CALLS.append("index")
        return 2

    def __int__(self) -> int:
        CALLS.append("int")
        return 2


class OnlyFloat:
    def __float__(self) -> float:
        CALLS.append("float")
        return 0.5


class Raising:
    def __float__(self) -> float:
        CALLS.append("float")
        raise ZeroDivisionError("of the program's")

    def __index__(self) -> int:
        CALLS.append("index")
        raise ZeroDivisionError("of the program's")


class BadFloat:
    def __float__(self) -> Any:
        CALLS.append("float")
        return "no float"


class Parameter:
    def __init__(self, value: Any) -> None:
        self._as_parameter_ = value


class AskedParameter:
    @property
    def _as_parameter_(self) -> int:
        CALLS.append("parameter")
        return 1


class Lying:
    @property
    def __class__(self) -> Any:
        return float

    def __float__(self) -> float:
        CALLS.append("float")
        return 0.75


class Sequence:
    """Has what a list has, and is none."""

    def __len__(self) -> int:
        CALLS.append("len")
        return 3

    def __getitem__(self, at: int) -> float:
        CALLS.append("item")
        return (0.1, 0.2, 0.3)[at]


class Mode(enum.Enum):
    TRIANGLES = 4


class IntMode(enum.IntEnum):
    TRIANGLES = 4


class Value:
    value = 4


KEPT: list[Any] = []
"""Referents of weak references."""


def _proxy() -> Any:
    KEPT.append(OnlyFloat())
    return weakref.proxy(KEPT[-1])


SCALARS: dict[str, Callable[[], Any]] = {
    "0": lambda: 0,
    "1": lambda: 1,
    "4": lambda: 4,
    "-1": lambda: -1,
    "bool": lambda: True,
    "2**32+4": lambda: 2**32 + 4,
    "2**40": lambda: 2**40,
    "huge": lambda: 10**400,
    "-2**31": lambda: -(2**31),
    "300": lambda: 300,
    "float": lambda: 0.5,
    "nan": lambda: float("nan"),
    "inf": lambda: float("inf"),
    "1e300": lambda: 1e300,
    "complex": lambda: 1j,
    "none": lambda: None,
    "str": lambda: "1",
    "empty str": lambda: "",
    "bytes": lambda: b"\1",
    "decimal": lambda: Decimal("0.5"),
    "fraction": lambda: fractions.Fraction(1, 2),
    "object": object,
    "type": lambda: float,
    "my int": lambda: MyInt(1),
    "my float": lambda: MyFloat(0.5),
    "number": Number,
    "only float": OnlyFloat,
    "raising": Raising,
    "bad float": BadFloat,
    "proxy": _proxy,
    "parameter": lambda: Parameter(1),
    "deep parameter": lambda: Parameter(Parameter(1)),
    "asked parameter": AskedParameter,
    "float parameter": lambda: Parameter(0.5),
    "lying": Lying,
    "enum": lambda: Mode.TRIANGLES,
    "int enum": lambda: IntMode.TRIANGLES,
    "value": Value,
    "i4": lambda: np.int32(1),
    "u4": lambda: np.uint32(1),
    "i8": lambda: np.int64(1),
    "u1": lambda: np.uint8(200),
    "f2": lambda: np.float16(0.5),
    "f4": lambda: np.float32(0.5),
    "f8": lambda: np.float64(0.5),
    "longdouble": lambda: np.longdouble(0.5),
    "c8": lambda: np.complex64(1),
    "b1": lambda: np.bool_(True),
    "0-d": lambda: np.array(1.0),
    "0-d int": lambda: np.array(1),
    "one": lambda: np.array([1.0]),
    "c_int": lambda: ctypes.c_int(1),
    "c_uint": lambda: ctypes.c_uint(1),
    "c_float": lambda: ctypes.c_float(0.5),
    "c_double": lambda: ctypes.c_double(0.5),
    "c_ubyte": lambda: ctypes.c_ubyte(200),
    "c_short": lambda: ctypes.c_short(1),
    "c_bool": lambda: ctypes.c_bool(True),
    "c_char": lambda: ctypes.c_char(b"1"),
    "c_long": lambda: ctypes.c_long(1),
    "list": lambda: [1, 2, 3],
    "function": lambda: len,
}
POINT = (0.1, 0.2, 0.3, 1.0)


def _ctypes_array(kind: Any, count: int) -> Any:
    return (kind * count)(
        *(kind(int(9 * p) if kind not in _REAL else p).value for p in POINT[:count])
    )


_REAL = (ctypes.c_float, ctypes.c_double)


def _read_only(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    values.flags.writeable = False
    return values


def vectors(count: int, dtype: np.dtype[Any]) -> dict[str, Callable[[], Any]]:
    """Things for a vector of so many elements of a type."""
    real = dtype.kind == "f"
    numbers: list[Any] = [p if real else int(9 * p) for p in POINT[:count]]
    c_type = np.ctypeslib.as_ctypes_type(dtype)
    kinds: dict[str, Callable[[], Any]] = {
        "list": lambda: list(numbers),
        "tuple": lambda: tuple(numbers),
        "nested": lambda: [list(numbers)],
        "short": lambda: numbers[:-1],
        "long": lambda: [*numbers, 1],
        "empty": list,
        "empty tuple": tuple,
        "my list": lambda: MyList(numbers),
        "sequence": Sequence,
        "set": lambda: set(numbers),
        "range": lambda: range(count),
        "generator": lambda: (n for n in numbers),
        "map": lambda: dict.fromkeys(numbers),
        "right": lambda: np.array(numbers, dtype),
        "swapped": lambda: np.array(numbers, dtype.newbyteorder()),
        "2-d": lambda: np.array([numbers], dtype),
        "column": lambda: np.array([[n] for n in numbers], dtype),
        "longer": lambda: np.array([*numbers, *numbers], dtype),
        "shorter": lambda: np.array(numbers[:-1], dtype),
        "0-d": lambda: np.array(numbers[0], dtype),
        "nothing": lambda: np.array([], dtype),
        "strided": lambda: np.array([*numbers, *numbers], dtype)[::2],
        "backwards": lambda: np.array(numbers, dtype)[::-1],
        "fortran": lambda: np.asfortranarray(np.array([numbers, numbers], dtype))[0],
        "read-only": lambda: _read_only(np.array(numbers, dtype)),
        "objects": lambda: np.array(numbers, object),
        "my array": lambda: np.array(numbers, dtype).view(MyArray),
        "masked": lambda: np.ma.array(numbers, dtype=dtype),
        "memoryview": lambda: memoryview(np.array(numbers, dtype)),
        "bytes": lambda: np.array(numbers, dtype).tobytes(),
        "bytearray": lambda: bytearray(np.array(numbers, dtype).tobytes()),
        "str": lambda: "abc",
        "array": lambda: array.array(dtype.char, numbers),
        "array d": lambda: array.array("d", numbers),
        "c array": lambda: (c_type * count)(*numbers),
        "c longer": lambda: (c_type * (count + 2))(*numbers),
        "c shorter": lambda: (c_type * (count - 1))(*numbers[:-1]),
        "c wrong": ctypes.c_longlong * count,
        "pointer": lambda: ctypes.pointer((c_type * count)(*numbers)),
        "cast": lambda: ctypes.cast((c_type * count)(*numbers), ctypes.POINTER(c_type)),
        "by reference": lambda: ctypes.byref((c_type * count)(*numbers)),
        "scalar": lambda: numbers[0],
        "none": lambda: None,
        "object": object,
        "number": Number,
        "complex": lambda: [1j] * count,
        "of str": lambda: ["1"] * count,
        "of none": lambda: [None] * count,
        "of number": lambda: [Number(), *numbers[1:]],
        "of raising": lambda: [*numbers[:-1], Raising()],
        "of bool": lambda: [True] * count,
        "of huge": lambda: [10**400] * count,
        "of 1e300": lambda: [1e300] * count,
        "of 300": lambda: [300] * count,
        "of -1": lambda: [-1] * count,
        "of f4": lambda: [np.float32(n) for n in numbers],
        "of i4": lambda: [np.int32(n) for n in numbers],
        "of f8": lambda: tuple(np.float64(n) for n in numbers),
        "of c_float": lambda: [ctypes.c_float(n) for n in numbers],
        "of decimal": lambda: [Decimal(n) for n in numbers],
        "of floats": lambda: [float(n) for n in numbers],
        "of ints": lambda: [int(n) for n in numbers],
        "of my float": lambda: [MyFloat(n) for n in numbers],
        "of my int": lambda: [MyInt(n) for n in numbers],
        "parameter": lambda: Parameter((c_type * count)(*numbers)),
    }
    for other in ("f2", "f4", "f8", "g", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "?", "c8"):
        kinds[f"of dtype {other}"] = lambda other=other: np.array(numbers).astype(other)
    kinds["1e300 of f8"] = lambda: np.array([1e300] * count)
    kinds["buffer object"] = _buffer_object(numbers, dtype)
    return kinds


def _buffer_object(numbers: list[Any], dtype: np.dtype[Any]) -> Callable[[], Any]:
    def make() -> Any:
        from OpenGL.arrays.vbo import VBO

        KEPT.append(VBO(np.array(numbers, dtype)))
        return KEPT[-1]

    return make
