"""Functions of the driver's that a program calls past PyOpenGL, between glBegin and glEnd."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from OpenGL import GL
from OpenGL.platform import PLATFORM

from .world import App, run

CORNERS = (((-1, -1, 0), (255, 0, 0)), ((1, -1, 0), (0, 255, 0)), ((0, 1, 0), (0, 0, 255)))
WAYS: dict[str, Callable[[], Any]] = {
    "attribute": lambda: PLATFORM.GL.glColor3ub,
    "item": lambda: PLATFORM.GL["glColor3ub"],
    "by name": lambda: getattr(PLATFORM.OpenGL, "glColor3ub"),  # noqa: B009
    "library of its own": lambda: ctypes.CDLL(PLATFORM.GL._name).glColor3ub,
}


@pytest.fixture(autouse=True)
def _left_as_found() -> Iterator[None]:
    """What a library has given it keeps, and hands out unseen."""
    vars(PLATFORM.GL).pop("glColor3ub", None)
    yield
    vars(PLATFORM.GL).pop("glColor3ub", None)


@pytest.mark.parametrize("style", ["none", "raskar"])
@pytest.mark.parametrize("when", ["before", "at first", "in it"])
@pytest.mark.parametrize("way", WAYS)
def test_colours_stay_at_their_vertices(way: str, when: str, style: str) -> None:
    early = WAYS[way]() if when == "before" and way != "library of its own" else None

    def scene(app: App) -> None:
        colour = early or (WAYS[way]() if when != "in it" else None)
        for _ in range(2):
            GL.glBegin(GL.GL_TRIANGLES)
            for corner, shade in CORNERS:
                colour = colour or WAYS[way]()
                colour(*shade)
                GL.glVertex3f(*corner)
            GL.glEnd()

    if when == "before" and way == "item":
        pytest.skip("what was looked up before glshim was there leaves no trace")
    plain = run(scene)
    if early is None:
        vars(PLATFORM.GL).pop("glColor3ub", None)
    assert len({tuple(c) for c in plain.picture[..., :3].reshape(-1, 3).tolist()}) > 50
    assert plain.differences(run(scene, style), pictures=style == "none") == {}


def test_a_library_keeps_nothing_of_ours() -> None:
    before = set(vars(PLATFORM.GL))
    run(lambda app: GL.glRectf(0, 0, 1, 1), "none")
    assert not {name for name in set(vars(PLATFORM.GL)) - before if name.startswith("gl")}
    assert ctypes.CDLL.__getitem__.__module__ == "ctypes"


def test_nothing_is_asked_inside_a_primitive_that_goes_straight_through() -> None:
    """A question there is an error that glEnd would tell."""

    def scene(app: App) -> None:
        ctypes.CDLL(PLATFORM.GL._name).glColor3ub(1, 2, 3)
        for name in ("list", 2.5):
            GL.glBegin(GL.GL_TRIANGLES)
            GL.glVertex3f(0, 0, 0)
            with pytest.raises(ctypes.ArgumentError):
                GL.glNewList(name, GL.GL_COMPILE)
            GL.glEnd()

    assert run(scene).differences(run(scene, "none"), pictures=True) == {}
