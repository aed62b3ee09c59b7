"""Arguments of GLU's shapes in every form: taken or refused as plain, their code run once."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from OpenGL import GL, GLU

from .world import App, run


class Parameter:
    _as_parameter_ = GLU.GLU_FILL


class Asked:
    """Stands for something, and counts how often it is asked for what."""

    def __init__(self, value: Any) -> None:
        self._value = value
        self.asked = 0

    @property
    def _as_parameter_(self) -> Any:
        self.asked += 1
        return self._value


class Number:
    def __init__(self) -> None:
        self.asked = 0

    def __float__(self) -> float:
        self.asked += 1
        return 0.5


CALLS: dict[str, Callable[[Any], Any]] = {
    "c_uint": lambda q: GLU.gluQuadricDrawStyle(q, ctypes.c_uint(GLU.GLU_FILL)),
    "parameter": lambda q: GLU.gluQuadricDrawStyle(q, Parameter()),
    "keyword": lambda q: GLU.gluQuadricOrientation(q, GLU.GLU_OUTSIDE, odd=1),
    "missing": lambda q: GLU.gluQuadricOrientation(),
    "ctypes": lambda q: GLU.gluSphere(q, ctypes.c_double(0.5), ctypes.c_int(8), 6),
    "numpy": lambda q: GLU.gluSphere(q, np.float32(0.5), 8, 6),
    "sphere, keyword": lambda q: GLU.gluSphere(q, 0.5, 8, 6, odd=3),
    "sphere, missing": lambda q: GLU.gluSphere(q, 0.5, 8),
    "sphere, str": lambda q: GLU.gluSphere(q, 0.5, 8, "6"),
    "complex": lambda q: GLU.gluCylinder(q, 0.5, np.complex64(1), 1.0, 8, 6),
    "extra": lambda q: GLU.gluDisk(q, 0.2, 0.5, 8, 2, ctypes.c_double(3)),
    "inside, refused": lambda q: inside(GLU.gluSphere, q, "1", 8, 6),
    "inside": lambda q: inside(GLU.gluSphere, q, 0.5, 8, 6),
}


def inside(call: Callable[..., None], *args: Any) -> None:
    """Within a primitive."""
    GL.glBegin(GL.GL_TRIANGLES)
    try:
        call(*args)
    finally:
        GL.glEnd()


@pytest.mark.filterwarnings("ignore:Casting complex")
@pytest.mark.parametrize("style", ["none", "raskar"])
def test_taken_or_refused_as_plain(style: str, capfd: pytest.CaptureFixture[str]) -> None:
    numbers: list[Number | Asked] = []

    def scene(app: App) -> None:
        quadric = GLU.gluNewQuadric()
        for call in CALLS.values():
            app.tries(call, quadric)
        numbers.append(Number())
        app.tries(GLU.gluSphere, quadric, numbers[-1], 8, 6)
        numbers.append(Asked(quadric))
        app.tries(GLU.gluQuadricDrawStyle, numbers[-1], GLU.GLU_FILL)

    plain = run(scene)
    assert plain.differences(run(scene, style), pictures=style == "none") == {}
    assert [number.asked for number in numbers] == [1, 1, 1, 1]
    assert "Traceback" not in capfd.readouterr().err
