"""What a call's arguments arrive as, told without the call. No GL: the function is one of C's."""

from __future__ import annotations

import ctypes
from typing import Any

import numpy as np
import pytest
from OpenGL.arrays import GLfloatArray

from glshim.bindings.pyopengl import conversions
from glshim.bindings.pyopengl.attributes import scalars
from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.bindings.pyopengl.record import Record
from glshim.spec.attributes import BY_NAME
from glshim.system.prototypes import function_type

POINT = [1.0, 2.0, 3.0]
_libc = ctypes.CDLL(None)
_place = ctypes.cast(_libc.abort, ctypes.c_void_p).value  # it is never called
VECTOR = ctypes.CFUNCTYPE(None, GLfloatArray)(_place)
SCALARS = ctypes.CFUNCTYPE(None, *[ctypes.c_float] * 3)(_place)
C_ARRAY = (ctypes.c_float * 3)(*POINT)


@pytest.mark.parametrize("value", [
    np.array(POINT, np.float32),
    np.array([POINT], np.float32),
    np.array([*POINT, 4.0], np.float32),
    np.matrix(POINT, np.float32),
    C_ARRAY,
    ctypes.pointer(C_ARRAY),
    ctypes.byref(C_ARRAY),
    ctypes.cast(C_ARRAY, ctypes.POINTER(ctypes.c_float)),
    POINT,
    bytes(C_ARRAY),
], ids=[
    "row", "nested", "longer", "matrix", "c-array", "pointer", "by reference", "c-pointer", "list",
    "bytes",
])  # fmt: skip
def test_what_lies_at_an_address(value: object) -> None:
    assert conversions.behind(VECTOR, "f", 3)(value) == tuple(POINT)


class Counted:
    """A number of the program's."""

    def __init__(self) -> None:
        self.asked = 0

    def __float__(self) -> float:
        self.asked += 1
        return 7.0


def test_numbers_are_asked_once() -> None:
    number = Counted()
    convert = conversions.numbers(SCALARS, "fff")
    assert convert(number, True, 1e300, ignored=1) == (7.0, 1.0, float("inf"))
    assert number.asked == 1


@pytest.mark.parametrize(
    "args", [(1, 2), (1, 2, "3"), (1, 2, 3, object()), (None, 2, 3), (1j, 2, 3)]
)
def test_refused_in_the_same_words(args: tuple[Any, ...]) -> None:
    said = []
    for call in (SCALARS, conversions.numbers(SCALARS, "fff")):
        with pytest.raises((TypeError, ctypes.ArgumentError)) as refusal:
            call(*args)
        said.append(repr(refusal.value))
    assert said[0] == said[1]


def of_its_own() -> Any:
    """A type of functions that ctypes has made just now."""
    ctypes._c_functype_cache.pop((None, (ctypes.c_int,), 1), None)  # type: ignore[attr-defined]
    return ctypes.CFUNCTYPE(None, ctypes.c_int)


def converted(function: Any) -> Any:
    return conversions.numbers(function, "i")


def hooked(function: Any) -> Any:
    call = original_call(function)
    hook_function(function, call)
    return call


@pytest.mark.parametrize("way", [converted, hooked])
def test_arguments_are_converted_as_when_the_type_was_made(
    way: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """PyOpenGL changes how (`ALLOW_NUMPY_SCALARS`); what others have had made before stays."""
    place = ctypes.cast(_libc.srand, ctypes.c_void_p).value
    old = of_its_own()(place)
    whole = staticmethod(lambda value: ctypes.c_int(int(value)))
    monkeypatch.setattr(ctypes.c_int, "from_param", whole)
    new = of_its_own()(place)
    with pytest.raises(ctypes.ArgumentError):
        way(old)(3.5)
    monkeypatch.undo()
    way(new)(3.5)


def test_types_of_ours_are_nobody_elses() -> None:
    assert function_type(None, ctypes.c_int) is function_type(None, ctypes.c_int)
    assert function_type(None, ctypes.c_int) is not ctypes.CFUNCTYPE(None, ctypes.c_int)


@pytest.mark.parametrize("name, args, arrived", [
    ("glVertex2s", (10**400, 70_000), (0, 4464)), ("glColor3ub", (300, -1, 10**400), (44, 255, 0)),
    ("glVertex2f", (True, np.float64(1e300)), (1, float("inf"))),
])  # fmt: skip
def test_logged_calls_are_recorded_as_their_arguments_arrive(
    name: str, args: tuple[Any, ...], arrived: tuple[float, ...]
) -> None:
    record, row = Record(), BY_NAME[name]
    record.shadow = True
    scalars(record, row)(lambda *_: None)(*args)
    assert record.stream() == conversions.recorded(row)(arrived)


def test_extra_arguments_are_taken() -> None:
    assert conversions.numbers(SCALARS, "fff")(1, 2, 3, 4, "5") == (1.0, 2.0, 3.0)


def test_a_vector_that_is_refused() -> None:
    with pytest.raises(ctypes.ArgumentError, match="argument 1"):
        conversions.behind(VECTOR, "f", 3)(np.zeros(3))
