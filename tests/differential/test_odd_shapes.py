"""Arguments of GLU's shapes in every form: taken or refused as plain, their code run once."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from OpenGL import GLU

from .world import App, run


class Parameter:
    _as_parameter_ = GLU.GLU_FILL


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
}


@pytest.mark.parametrize("style", ["none", "raskar"])
def test_taken_or_refused_as_plain(style: str, capfd: pytest.CaptureFixture[str]) -> None:
    numbers: list[Number] = []

    def scene(app: App) -> None:
        quadric = GLU.gluNewQuadric()
        for call in CALLS.values():
            app.tries(call, quadric)
        numbers.append(Number())
        app.tries(GLU.gluSphere, quadric, numbers[-1], 8, 6)

    plain = run(scene)
    assert plain.differences(run(scene, style), pictures=style == "none") == {}
    assert [number.asked for number in numbers] == [1, 1]
    assert "Traceback" not in capfd.readouterr().err
