"""Windows and contexts that come and go, old contexts, core profiles, no context at all."""

from __future__ import annotations

import gc
import subprocess
import sys
import textwrap
from typing import Any

import glfw
import moderngl
import pytest
from OpenGL import GL

from glshim.driver import kinds, objects
from glshim.driver.functions import current_context
from glshim.outputs.gl.backend import Backend
from glshim.sources.following import scene
from glshim.sources.following.scene import Scene

from .scenes_lists import recorded
from .scenes_state import mesh
from .world import App, Outcome, observe, prepare, run, styled, window

INK = (232, 100, 27)
VISIBLE = "raskar:ink=#e8641b"


def inked(outcome: Outcome) -> int:
    """Pixels of exactly the ink's colour."""
    return int((outcome.picture[..., :3] == INK).all(axis=2).sum())


def cube() -> None:
    """A closed box, turned."""
    GL.glRotatef(30.0, 1.0, 1.0, 0.0)
    GL.glBegin(GL.GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)][::side]
            for a, b in corners:
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                GL.glColor3f(0.2, 0.4, 0.6)
                GL.glVertex3f(*(0.8 * p for p in point))
    GL.glEnd()


def one_window() -> Outcome:
    app = App()
    with window():
        prepare()
        cube()
        return observe(app)


def test_raskar_inks_the_cube_that_the_other_tests_draw() -> None:
    assert inked(run(lambda app: cube())) == 0
    assert inked(run(lambda app: cube(), VISIBLE)) > 100


def test_contexts_made_and_destroyed_again_and_again() -> None:
    with styled(VISIBLE):
        outcomes = [one_window() for _ in range(12)]
    assert inked(outcomes[0]) > 100
    for outcome in outcomes[1:]:
        assert outcomes[0].differences(outcome) == {}


def known() -> int:
    """Objects of ours that belong to contexts."""
    gc.collect()
    of = Scene, Backend, moderngl.Program, moderngl.Buffer, moderngl.Context
    return sum(type(each) in of for each in gc.get_objects())


def test_what_is_known_of_dead_contexts_goes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Toolkits destroy contexts unheard; handles are given again only by chance."""
    with styled(VISIBLE):
        for _ in range(3):
            one_window()
        before = known()
        for _ in range(12):
            one_window()
        assert known() <= before
        with window() as first:
            for _ in range(3):
                one_window()
            glfw.make_context_current(first)
            prepare()
            cube()
            monkeypatch.setattr(scene, "_FRAMES_BETWEEN_LOOKS", 1)
            glfw.swap_buffers(first)
            assert known() <= before


def test_what_dead_contexts_shared_is_deleted() -> None:
    """Objects live on in the contexts that share with a dead one."""

    def ours() -> int:
        named_alike = objects.TEXTURE, objects.BUFFER, objects.RENDERBUFFER, objects.PROGRAM
        names = [n for first in (1, objects._OFF, objects._FAR) for n in range(first, first + 2000)]
        return sum(kinds.is_there(kind, name) for kind in named_alike for name in names)

    def child(root: Any) -> int:
        app = App()
        with window(share=root):
            prepare()
            cube()
            assert inked(observe(app)) > 100
            return ours()

    with styled(VISIBLE), window() as root:
        counts = [child(root) for _ in range(5)]
    assert counts[1:] == counts[:1] * 4


def test_a_context_that_others_came_after_is_still_known() -> None:
    with styled(VISIBLE), window() as first:
        prepare()
        recorded(1, cube)
        for _ in range(4):
            one_window()
        glfw.make_context_current(first)
        app = App()
        app.tries(GL.glCallList, 1)
        assert inked(observe(app)) > 100


def test_a_new_context_at_the_old_address(monkeypatch: pytest.MonkeyPatch) -> None:
    """Context handles are addresses, which the next context may get."""
    monkeypatch.setattr(scene, "current_context", lambda: 4711 if current_context() else 0)

    def lists(rectangle: bool) -> Outcome:
        app = App()
        with window():
            prepare()
            if rectangle:
                recorded(1, lambda: GL.glRectf(-1.8, -0.5, -1.2, 0.5))
            GL.glCallList(1)
            cube()
            return observe(app)

    with styled(VISIBLE):
        first, second, third = lists(True), lists(False), lists(True)
    assert inked(first) > inked(second) + 50 > 150
    assert first.differences(third) == {}
    assert second.differences(run(lambda app: cube(), VISIBLE)) == {}


def test_two_windows_in_turns() -> None:
    def both(style: str | None) -> list[Outcome]:
        with styled(style), window() as a, window() as b:
            apps = (App(), App())
            for current in (a, b):
                glfw.make_context_current(current)
                prepare()
            recorded(1, lambda: mesh(12))
            for current, mode in ((a, GL.GL_TRIANGLES), (b, GL.GL_QUADS), (a, GL.GL_POLYGON)):
                glfw.make_context_current(current)
                GL.glBegin(mode)
                for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    GL.glVertex2f(x * 0.5, y * 0.5)
                GL.glEnd()
                GL.glTranslatef(0.2, 0.2, 0.2)
            found = []
            for current, app in zip((a, b), apps, strict=True):
                glfw.make_context_current(current)
                app.tries(GL.glCallList, 1)
                found.append(observe(app))
            return found

    plain = both(None)
    for there, none in zip(plain, both("none"), strict=True):
        assert there.differences(none) == {}
    for there, lines in zip(plain, both(VISIBLE), strict=True):
        assert there.differences(lines, pictures=False) == {}
        assert inked(lines) > 100


@pytest.mark.parametrize("style", ["none", VISIBLE])
def test_a_context_that_goes_away_inside_a_primitive(style: str) -> None:
    with styled(style):
        with window():
            GL.glBegin(GL.GL_TRIANGLES)
            GL.glVertex3f(0, 0, 0)
        GL.glVertex3f(1, 0, 0)
        GL.glEnd()
        assert one_window().differences(_alone(style)) == {}


def _alone(style: str) -> Outcome:
    with styled(style):
        return one_window()


NO_CONTEXT = """
import sys
import OpenGL
from OpenGL import GL
STYLE and __import__("glshim").install(STYLE)
def tries(call, *args):
    try:
        print(call.__name__, repr(call(*args)))
    except Exception as error:
        print(call.__name__, type(error).__name__, str(error).replace("\\n", " "))
for _ in range(2):
    tries(GL.glBegin, GL.GL_QUADS)
    tries(GL.glVertex3f, 1, 2, 3)
    tries(GL.glVertex3fv, [1, 2, 3])
    tries(GL.glVertex3f, "x", 2, 3)
    tries(GL.glMaterialf, GL.GL_FRONT, GL.GL_SHININESS, 1.0)
    tries(GL.glEnd)
    tries(GL.glClear, 0x4000)
    tries(GL.glRectf, 0, 0, 1, 1)
    tries(GL.glNewList, 1, GL.GL_COMPILE)
    tries(GL.glEndList)
    tries(GL.glCallList, 1)
    tries(GL.glFlush)
"""


def test_no_context_at_all() -> None:
    said = [_program(NO_CONTEXT, style) for style in ("", "none", "raskar")]
    assert said[0] == said[1] == said[2]
    assert "glEnd" in said[0]


def _program(text: str, style: str, **environment: str) -> str:
    import os

    code = f"STYLE = {style!r}\n{textwrap.dedent(text)}"
    ended = subprocess.run(
        [sys.executable, "-c", code], env=os.environ | environment, capture_output=True,
        text=True, timeout=60, check=False,
    )  # fmt: skip
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


OLD = """
import numpy as np
from tests.differential.world import *
from tests.differential.scenes_state import mesh
from tests.differential.test_contexts import cube
app = App()
with styled(STYLE or None), window(**HINTS):
    for call, *args in ((cube,), (mesh, 200), (GL.glRectf, 0, 0, 1, 1), (GL.glFlush,)):
        app.tries(call, *args)
    app.error()
    app.tries(GL.glGetString, GL.GL_VERSION)
    picture = np.frombuffer(GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE),
                            np.uint8)
    print(app.saw)
    print(picture.tolist()[::7], GL.glGetError())
"""


@pytest.mark.parametrize(
    ("hints", "environment"),
    [
        ("dict()", {"MESA_GL_VERSION_OVERRIDE": "2.1",
                    "MESA_EXTENSION_OVERRIDE": "-GL_ARB_framebuffer_object"}),
        ("dict()", {"MESA_GL_VERSION_OVERRIDE": "1.4"}),
        ("dict(CONTEXT_VERSION_MAJOR=3, CONTEXT_VERSION_MINOR=3, "
         "OPENGL_PROFILE=glfw.OPENGL_CORE_PROFILE)", {}),
    ],
    ids=["2.1 without framebuffer objects", "1.4", "core"],
)  # fmt: skip
def test_old_and_core_contexts_are_left_alone(hints: str, environment: dict[str, str]) -> None:
    text = OLD.replace("HINTS", hints)
    plain = _program(text, "", **environment)
    assert plain == _program(text, "none", **environment)
    assert plain == _program(text, VISIBLE, **environment)


def test_a_2_1_context_gets_lines_and_the_program_sees_nothing_of_them() -> None:
    text = OLD.replace("HINTS", "dict()").replace("    for", "    prepare()\n    for")
    plain, none, lines = (
        _program(text, style, MESA_GL_VERSION_OVERRIDE="2.1").splitlines()
        for style in ("", "none", VISIBLE)
    )
    assert plain == none
    assert plain[0] == lines[0] and plain[1] != lines[1]
