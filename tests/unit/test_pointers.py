"""What lies behind the argument of a raw vector call, as the recorder reads it. No GL."""

import ctypes

import numpy as np
import pytest

from glshim.bindings.pyopengl import forward
from glshim.spec.attributes import BY_NAME

VERTEX = BY_NAME["glVertex3f"]
POINT = [1.0, 2.0, 3.0]


@pytest.mark.parametrize("value", [
    np.array(POINT, np.float32),
    np.array([POINT], np.float32),
    np.array([*POINT, 4.0], np.float32),
    np.matrix(POINT, np.float32),  # two dimensions, however it is reshaped
    (ctypes.c_float * 3)(*POINT),
    ctypes.cast((ctypes.c_float * 3)(*POINT), ctypes.POINTER(ctypes.c_float)),
], ids=["row", "nested", "longer", "matrix", "c-array", "c-pointer"])
def test_the_components_in_order(value: object) -> None:
    assert list(forward.read(VERTEX, value)) == POINT


@pytest.mark.parametrize("value", [
    np.array(POINT, np.float64),
    np.array([*POINT, *POINT], np.float32)[::2],
    np.array(POINT[:2], np.float32),
    POINT,
    None,
], ids=["doubles", "strided", "short", "list", "nothing"])
def test_what_pyopengl_must_convert_is_left_to_it(value: object) -> None:
    with pytest.raises(TypeError):
        forward.read(VERTEX, value)
