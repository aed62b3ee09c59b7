"""Draws that read memory which is not there, arguments in every form, and calls that fail: the
program lives on as it would plain, and stays in its style."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from OpenGL import GL
from OpenGL.raw.GL.VERSION import GL_1_0 as RAW_1_0
from OpenGL.raw.GL.VERSION import GL_1_1 as RAW_1_1

from glshim.sources.fixed.fetch import VertexFetch

from .test_contexts import VISIBLE, cube, inked
from .world import App, run

WORLD = """
import ctypes, sys
import glfw
import numpy as np
import OpenGL
FLAGS
from OpenGL import GL
from OpenGL.raw.GL.VERSION import GL_1_0, GL_1_1, GL_1_4, GL_3_2
if not glfw.init():
    sys.exit("no display")
glfw.window_hint(glfw.VISIBLE, 0)
window = glfw.create_window(64, 64, "odd", None, None)
glfw.make_context_current(window)
GL.glEnable(GL.GL_DEPTH_TEST)
POINTS = np.random.RandomState(0).rand(40, 3).astype("f")
GONE = ctypes.c_void_p(4096)
UINT = GL.GL_UNSIGNED_INT
i4 = lambda *numbers: np.array(numbers, "i4")
def arrays(at=POINTS):
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, at)
def enclosed(*calls):
    GL.glBegin(4)
    for call in calls:
        call()
    GL.glEnd()
def listed(*calls):
    GL.glNewList(7, GL.GL_COMPILE)
    for call in calls:
        call()
    GL.glEndList()
    GL.glCallList(7)
CASES = {
CASES_HERE
}
for name, case in CASES.items():
    arrays()
    print(name, end=" ", flush=True)
    try:
        case()
        print("done", GL.glGetError())
    except Exception as error:
        print(type(error).__name__, getattr(error, "err", ""))
    for end in (GL.glEnd, GL.glEndList):
        try:
            end()
        except GL.GLError:
            pass
    GL.glGetError()
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)
    GL.glDisableVertexAttribArray(0)
    glfw.swap_buffers(window)
    sys.stdout.flush()
print("alive")
"""
UNREADABLE = """
    "incomplete framebuffer": lambda: (
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, GL.glGenFramebuffers(1)),
        arrays(GONE), GL.glDrawArrays(4, 0, 3)),
    "end before start": lambda: GL.glDrawRangeElements(4, 5, 2, 3, UINT, GONE),
    "element far away": lambda: enclosed(lambda: GL.glArrayElement(2**30)),
    "too few vertices": lambda: (arrays(GONE), GL.glDrawArrays(4, 0, 2)),
    "too few indices": lambda: (arrays(GONE), GL.glDrawElements(4, 2, UINT, i4(0, 1))),
    "generic attribute 0": lambda: (
        arrays(GONE), GL.glEnableVertexAttribArray(0),
        GL.glVertexAttribPointer(0, 3, GL.GL_FLOAT, 0, 0, POINTS), GL.glDrawArrays(4, 0, 3)),
    "generic attribute 0, normalised": lambda: (
        arrays(GONE), GL.glEnableVertexAttribArray(0),
        GL.glVertexAttribPointer(0, 3, GL.GL_SHORT, 1, 0, np.zeros((3, 3), "i2")),
        GL.glDrawArrays(4, 0, 3)),
    "wrapping indices": lambda: GL.glDrawElementsBaseVertex(
        4, 3, UINT, np.array([2**32 - 1, 2**32 - 2, 2**32 - 3], "u4"), 4),
    "bad mode": lambda: (arrays(GONE), GL.glDrawArrays(77, 0, 3)),
    "bad type": lambda: (arrays(GONE), GL.glDrawElements(4, 3, GL.GL_FLOAT, GONE)),
    "negative count": lambda: (arrays(GONE), GL_1_1.glDrawElements(4, -5, UINT, GONE)),
    "many draws, negative": lambda: GL.glMultiDrawArrays(4, i4(0), i4(3), -1),
"""
ODD = """
    "mode": lambda: GL.glDrawArrays(ctypes.c_uint(4), 0, 3),
    "count": lambda: GL_1_1.glDrawArrays(4, ctypes.c_int(0), ctypes.c_int(3)),
    "numpy": lambda: GL_1_1.glDrawArrays(np.int32(4), np.int64(0), np.uint8(3)),
    "wrapping": lambda: (GL_1_1.glDrawArrays(2**32 + 4, 0, 2**32 + 3), GL.glCallList(-1)),
    "by reference": lambda: GL_1_1.glDrawElements(
        4, 1, UINT, ctypes.byref(ctypes.c_uint(1))),
    "pointer": lambda: GL_1_1.glDrawElements(4, 1, UINT, ctypes.pointer(ctypes.c_uint(1))),
    "bytes": lambda: GL_1_1.glDrawElements(4, 3, GL.GL_UNSIGNED_BYTE, b"012"),
    "list": lambda: GL.glMultiDrawArrays(4, [0], [3], 1),
    "many, null": lambda: GL_1_4.glMultiDrawElements(4, None, UINT, None, 0),
    "many, negative": lambda: GL_1_4.glMultiDrawElements(
        4, i4(3), UINT, (ctypes.c_void_p * 1)(POINTS.ctypes.data), -1),
    "many, negative base": lambda: GL_3_2.glMultiDrawElementsBaseVertex(
        4, i4(3), UINT, (ctypes.c_void_p * 1)(POINTS.ctypes.data), -1, i4(0)),
    "many, one negative": lambda: GL.glMultiDrawArrays(4, i4(0, 0), i4(3, -3), 2),
    "display list": lambda: GL.glCallList(ctypes.c_uint(5)),
    "new list": lambda: (GL.glNewList(ctypes.c_uint(5), ctypes.c_uint(GL.GL_COMPILE)),
                         GL.glEndList()),
    "lists": lambda: GL_1_0.glCallLists(ctypes.c_int(1), UINT, ctypes.byref(ctypes.c_uint(5))),
    "lists, no number": lambda: GL_1_0.glCallLists(2, GL.GL_FLOAT, np.array([np.nan, np.inf], "f")),
    "lists, negative": lambda: GL_1_0.glCallLists(-1, UINT, None),
    "rectangle": lambda: GL.glRectf(*map(ctypes.c_float, (0, 0, 1, 1))),
    "rectangle, huge": lambda: GL.glRectd(1e300, 0, 1, float("nan")),
    "rectangle, pointers": lambda: GL_1_0.glRectfv(
        (ctypes.c_float * 2)(0, 0), ctypes.pointer((ctypes.c_float * 2)(1, 1)[0:1] and
                                                   ctypes.c_float(1))),
    "clear": lambda: GL.glClear(ctypes.c_uint(0x4100)),
    "element": lambda: enclosed(lambda: GL.glArrayElement(ctypes.c_int(1))),
    "bad mesh": lambda: GL.glEvalMesh2(5, 0, 3, 0, 3),
    "bad mesh in a list": lambda: listed(lambda: GL.glEvalMesh2(5, 0, 3, 0, 3)),
    "mesh of an array": lambda: GL.glEvalMesh1(GL.GL_LINE, 0, np.array(2)),
    "bad matrices in a list": lambda: listed(
        lambda: GL.glOrtho(0, 0, 0, 0, 0, 0), lambda: GL.glFrustum(-1, 1, -1, 1, -1, 1),
        lambda: enclosed(*[lambda: GL.glVertex3f(0, 0, 1)] * 3)),
    "switches in a list": lambda: listed(
        lambda: GL.glMatrixMode(ctypes.c_uint(0x1700)), lambda: GL.glPushAttrib(ctypes.c_uint(1)),
        lambda: GL.glPopAttrib(), lambda: GL.glEnable(ctypes.c_uint(0xb71)),
        lambda: GL.glDepthMask(ctypes.c_ubyte(1)), lambda: GL.glRotatef(ctypes.c_float(3), 0, 0, 1),
        lambda: GL.glPolygonMode(ctypes.c_uint(0x408), ctypes.c_uint(0x1b02)),
        lambda: enclosed(*[lambda: GL.glVertex3f(0, 0, 1)] * 3)),
"""


def _ended(cases: str, style: str, flags: str) -> tuple[list[str], int, str]:
    """Lines, exit status and messages of a program of such cases."""
    text = WORLD.replace("CASES_HERE", cases).replace("FLAGS", flags)
    environment = {name: v for name, v in os.environ.items() if not name.startswith("GLSHIM_")}
    if style:
        environment["GLSHIM_STYLE"] = style
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True,
                          timeout=120, check=False, env=environment)  # fmt: skip
    return done.stdout.splitlines(), done.returncode, done.stderr


@pytest.mark.parametrize("flags", ["", "OpenGL.ERROR_CHECKING = False"], ids=["checked", "not"])
@pytest.mark.parametrize("cases", [UNREADABLE, ODD], ids=["unreadable", "odd"])
def test_the_program_ends_as_it_does_plain(cases: str, flags: str) -> None:
    plain, status, _ = _ended(cases, "", flags)
    assert (plain[-1], status) == ("alive", 0)
    for style in ("none", "raskar", "technical"):
        lines, status, said = _ended(cases, style, flags)
        assert (style, lines) == (style, plain)
        assert status == 0
        assert "Traceback" not in said and "switched off" not in said


INDICES = (ctypes.c_uint * 6)(0, 1, 2, 0, 2, 3)
CORNERS = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0.3], [-1, 1, 0]], "f")


def _generic() -> None:
    GL.glEnableVertexAttribArray(0)
    GL.glVertexAttribPointer(0, 3, GL.GL_FLOAT, False, 0, CORNERS)
    GL.glDrawElements(4, 6, GL.GL_UNSIGNED_INT, INDICES)
    GL.glDisableVertexAttribArray(0)


FORMS: dict[str, Callable[[], Any]] = {
    "byref": lambda: RAW_1_1.glDrawElements(4, 6, GL.GL_UNSIGNED_INT, ctypes.byref(INDICES)),
    "pointer": lambda: RAW_1_1.glDrawElements(4, 6, GL.GL_UNSIGNED_INT, ctypes.pointer(INDICES)),
    "scalars": lambda: RAW_1_1.glDrawElements(
        ctypes.c_uint(4), np.int64(6), ctypes.c_uint(GL.GL_UNSIGNED_INT), INDICES
    ),
    "wrapped": lambda: GL.glDrawElementsBaseVertex(
        4, 6, GL.GL_UNSIGNED_INT, np.array([*INDICES], "u4") - np.uint32(9), 9
    ),
    "generic": _generic,
    "left over": lambda: GL.glDrawElements(
        4, 8, GL.GL_UNSIGNED_INT, np.array([*INDICES, 7777777, 7777777], "u4")
    ),
}


@pytest.mark.parametrize("form", FORMS)
def test_every_form_draws_the_same_lines(form: str) -> None:
    def scene(app: App, draw: Callable[[], Any]) -> None:
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, CORNERS)
        draw()

    def plainly() -> None:
        GL.glDrawElements(4, 6, GL.GL_UNSIGNED_INT, INDICES)

    expected = run(lambda app: scene(app, plainly), VISIBLE)
    assert inked(expected) > 30
    assert (run(lambda app: scene(app, FORMS[form]), VISIBLE).picture == expected.picture).all()


def test_rectangles_of_ctypes_are_inked() -> None:
    numbers = (-1, -1, 1, 1)
    plain = run(lambda app: RAW_1_0.glRectf(*numbers), VISIBLE)
    odd = run(lambda app: RAW_1_0.glRectf(*map(ctypes.c_float, numbers)), VISIBLE)
    assert inked(plain) == inked(odd) > 30


@pytest.mark.parametrize("style", [VISIBLE, "hiddenline:line=#e8641b"])
@pytest.mark.parametrize("faults", [1, 2, 40])
def test_a_fault_in_following_costs_one_draw(
    faults: int, style: str, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    left = [0]

    def fails(*_: Any) -> None:
        if left[0]:
            left[0] -= 1
            raise ZeroDivisionError(f"{faults} times")

    monkeypatch.setattr(VertexFetch, "batch", fails)
    monkeypatch.setattr("glshim.notices._said", set())

    def scene(app: App) -> None:
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, CORNERS)
        for _ in range(faults):
            app.tries(GL.glDrawArrays, GL.GL_QUADS, 0, 4)
            app.asks(GL.GL_COLOR_WRITEMASK)
        # What a style has laid below this picture stays to its end.
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        cube()

    plain = run(scene)
    capfd.readouterr()
    left[0] = faults
    outcome = run(scene, style)
    said = capfd.readouterr().err
    ends = faults > 16
    assert said.count("by a fault of glshim at") == 1
    assert said.count("is switched off") == ends
    assert (inked(outcome) > 100) is not ends
    assert plain.differences(outcome, pictures=ends) == {}
