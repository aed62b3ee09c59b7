"""What hooks ask of a call's arguments: no code of the program's runs for it, and what PyOpenGL
ignores they ignore."""

from __future__ import annotations

import ctypes
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from glshim.driver.arguments import address_of, number, place_of
from glshim.toolkits import frames
from glshim.toolkits.base import Changes
from glshim.toolkits.egl import Egl
from glshim.toolkits.glx import Glx
from glshim.toolkits.offscreen import Offscreen


class Speaking:
    """Each question is an error."""

    @property
    def value(self) -> int:
        raise AssertionError

    @property
    def _as_parameter_(self) -> int:
        raise AssertionError

    def __index__(self) -> int:
        raise AssertionError

    __int__ = __float__ = __index__


class Standing:
    def __init__(self, value: Any) -> None:
        self._as_parameter_ = value


POINTS = np.zeros(3, np.float32)


def test_objects_of_the_program_are_not_asked() -> None:
    assert number((Speaking(),), 0) == place_of(Speaking()) == 0
    with pytest.raises(TypeError):
        address_of(Speaking())


def test_what_stands_for_an_argument_is_known() -> None:
    assert place_of(Standing(Standing(POINTS))) == POINTS.ctypes.data
    assert place_of(ctypes.byref(ctypes.c_int.from_buffer(POINTS))) == POINTS.ctypes.data
    endless = Standing(None)
    endless._as_parameter_ = endless
    assert place_of(endless) == 0


@pytest.mark.parametrize("value", [float("inf"), float("nan"), Speaking(), "1", None, 1j])
def test_a_picture_begins_with_any_argument(value: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frames, "listening", lambda: True)
    monkeypatch.setattr(frames, "shown_by_a_toolkit", lambda: True)
    assert Offscreen().around("glClear", (value,), lambda *args: args) == (value,)


@pytest.mark.parametrize("toolkit, name", [(Glx(), "glXSwapBuffers"), (Egl(), "eglSwapBuffers")])
def test_swaps_ignore_keywords(toolkit: Any, name: str) -> None:
    swap: Any = type(name, (), {"__call__": staticmethod(lambda *args: args)})()
    changes = Changes()
    toolkit.hook_swaps(SimpleNamespace(**{name: swap}), changes)
    assert swap(1, 2, 3, odd=1, on=2, surface=3) == (1, 2, 3)
    assert swap(1, display=2) == (1,)
