"""Faults of stylers, and installing and uninstalling at odd times: the app never notices."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import glfw
import numpy as np
import pytest
from OpenGL import GL
from OpenGL.GL import glBegin, glCallList, glColor3f, glEnd, glVertex3f, glVertex3fv

import glshim
from glshim.errors import StyleError
from glshim.styling.lines import Medium
from glshim.styling.protocol import Layer, Lines, Styler
from tests.sweep import some

from .scenes_immediate import shade, spiral
from .scenes_lists import recorded
from .scenes_state import mesh
from .test_contexts import INK, VISIBLE, cube, inked
from .world import App, observe, prepare, run, styled, window


def frames(app: App) -> None:
    """Three frames, each of a cube, an error and a readback."""
    window_now = glfw.get_current_context()
    for _ in range(3):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        app.tries(cube)
        app.tries(GL.glEnable, 0xFFFF)
        app.tries(mesh, 150)
        app.asks(GL.GL_CURRENT_COLOR)
        app.error()
        glfw.swap_buffers(window_now)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    app.tries(cube)


@dataclass(frozen=True)
class Faulty(Styler):
    """Does what a test tells it to."""

    name: ClassVar[str] = "faulty"
    does: ClassVar[Callable[[Layer], Any]] = lambda layer: ()

    def draws(self, layer: Layer) -> Iterable[Lines]:
        return type(self).does(layer)  # type: ignore[no-any-return]


def _raises(layer: Layer) -> Any:
    raise ZeroDivisionError("in the styler")


def _raises_later(layer: Layer) -> Any:
    yield from ()
    raise ZeroDivisionError("in the styler")


def _bad_uniform(layer: Layer) -> Any:
    for lines in glshim.parse_style("raskar").draws(layer):
        assert isinstance(lines, Lines)
        wrong: dict[str, Any] = {"inks": "black"}
        yield replace(lines, medium=Medium(lines.medium.shader, wrong))


FAULTS: dict[str, Callable[[Layer], Any]] = {
    "raises": _raises,
    "raises-later": _raises_later,
    "None": lambda layer: None,
    "number": lambda layer: 3,
    "strings": lambda layer: ["draw", "this"],
    "nothing-known": lambda layer: [object()],
    "uniform": _bad_uniform,
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_faulty_styler_is_switched_off_once(
    fault: str, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    plain = run(frames)
    calls = []

    def does(layer: Layer) -> Any:
        calls.append(layer)
        return FAULTS[fault](layer)

    monkeypatch.setattr(Faulty, "does", does)
    monkeypatch.setattr(Faulty, "name", f"faulty-{fault}")  # each fault is said once
    capfd.readouterr()
    outcome = run(frames, Faulty())
    said = capfd.readouterr().err
    assert len(calls) == 1
    assert said.count(f"'faulty-{fault}' is switched off") == 1
    assert said.count("Traceback") == 1
    assert plain.differences(outcome) == {}


def test_an_unknown_style_installs_nothing() -> None:
    with pytest.raises(StyleError):
        glshim.install("no such style")
    assert run(frames).differences(run(frames)) == {}


def _loaded_calls() -> dict[str, Any]:
    from OpenGL.platform import baseplatform

    found: dict[str, Any] = {}
    waiting: list[type] = [baseplatform._NullFunctionPointer]
    while waiting:
        cls = waiting.pop()
        waiting += cls.__subclasses__()
        found[f"{cls.__name__} {id(cls)}"] = getattr(cls.__call__, "__self__", cls.__call__)
    return found


def test_uninstalling_leaves_pyopengl_as_it_was() -> None:
    run(frames)  # loads what is used
    run(frames, VISIBLE)
    before = _loaded_calls()
    for style in ("none", VISIBLE):
        run(frames, style)
    assert _loaded_calls() == before


@pytest.mark.parametrize("style", ["none", VISIBLE])
@pytest.mark.parametrize("count", [6, 300])
def test_installed_and_uninstalled_inside_a_primitive(style: str, count: int) -> None:
    def halves(app: App, between: Callable[[], None]) -> None:
        for first, second in ((count, count), (0, count), (count, 0)):
            GL.glTranslatef(0.2, 0.1, 0.0)
            glBegin(GL.GL_TRIANGLE_STRIP)
            for part in (first, second):
                for i, point in enumerate(spiral(part)):
                    glColor3f(*shade(i))
                    glVertex3fv(point)
                if part is first:
                    between()
            app.tries(glEnd)
        app.asks(GL.GL_CURRENT_COLOR)

    def installs() -> None:
        if installed.pop():
            glshim.uninstall()
            installed.append(False)
        else:
            glshim.install(style)
            installed.append(True)

    plain = run(lambda app: halves(app, lambda: None))
    for on in (False, True):
        installed = [on]
        changing = run(lambda app: halves(app, installs), style if on else None)
        assert plain.differences(changing, pictures=style == "none") == {}


def test_names_taken_before_and_lists_compiled_before_are_followed() -> None:
    """Late installation: the app has its functions, and has called them."""

    def scene(app: App) -> None:
        recorded(2, cube)
        glCallList(2)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        glshim.install(VISIBLE)
        glBegin(GL.GL_TRIANGLES)
        for x, y in ((-1, -1), (1, -1), (0, 1)):
            glVertex3f(x, y, 0.5)
        glEnd()

    assert inked(run(scene)) > 60
    assert inked(run(lambda app: [recorded(1, cube), glCallList(1)][0], VISIBLE)) > 100


def test_another_style_takes_over() -> None:
    def scene(app: App) -> None:
        cube()
        glshim.install("raskar:ink=#00ff00")
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        recorded(3, lambda: GL.glRectf(-2, -1, -1.5, 1))
        glCallList(3)
        cube()
        glshim.install("raskar:ink=#00ff00")

    outcome = run(scene, VISIBLE)
    assert inked(outcome) == 0
    green = (outcome.picture[..., :3] == (0, 255, 0)).all(axis=2)
    assert green.sum() == 0  # what was pending went with the style that was replaced

    def settled(app: App) -> None:
        scene(app)
        cube()

    assert (run(settled, VISIBLE).picture[..., :3] == (0, 255, 0)).all(axis=2).sum() > 100


def test_the_styled_picture_is_what_readback_gives() -> None:
    outcome = run(lambda app: cube(), VISIBLE)
    assert inked(outcome) > 100

    def copied(app: App) -> None:
        cube()
        GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
        GL.glCopyTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 0, 0, 96, 72, 0)
        image = GL.glGetTexImage(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        app.kept.append(np.frombuffer(image, np.uint8).reshape(72, 96, 3))

    app = App()
    with styled(VISIBLE), window():
        prepare()
        copied(app)
        observe(app)
    assert (app.kept[-1] == INK).all(axis=2).sum() == inked(outcome)


FLAGS = """
import logging, sys
import OpenGL
FLAGS
log = []
class Keep(logging.Handler):
    def emit(self, record):
        log.append(record.getMessage()[:200])
EARLY and __import__("glshim").install("none")
import numpy as np
from OpenGL import GL
for name in ("OpenGL.calltrace", "OpenGL.errors", "OpenGL.arrays"):
    logging.getLogger(name).addHandler(Keep())
    logging.getLogger(name).propagate = False
from glshim.checks import observe
from tests.differential import world
from tests.differential.scenes_state import mesh, _texture
import glshim
def tries(call, *args):
    try:
        print(call.__name__, repr(call(*args))[:300])
    except Exception as error:
        print(call.__name__, type(error).__name__, observe.steady(str(error))[:300])
def scene():
    GL.glClear(0x4100)
    for count in (12, 300, 300):
        tries(mesh, count)
        tries(GL.glBegin, 7)
        for args in ((1, 2, 3), ("a", 2, 3), (1, 2), (np.float32(1), 2, 3), (1e300, 1, 1)):
            tries(GL.glVertex3f, *args)
        for value in ([0, 1, 0], (0, 1), np.ones(3, "f"), np.ones(3, "d"), [1, "x", 2]):
            tries(GL.glVertex3fv, value)
        tries(GL.glColor3ub, 300, 2, -1)
        tries(GL.glColor3ubv, [1, 2, 3])
        tries(GL.glTranslatef, 1, 0, 0)
        tries(GL.glMaterialfv, GL.GL_FRONT, GL.GL_DIFFUSE, [1, 0, 1, 1])
        tries(GL.glEnd)
        tries(GL.glEnable, 0xFFFF)
        tries(GL.glGetError)
        tries(GL.glNewList, 1, GL.GL_COMPILE)
        tries(mesh, 5)
        tries(GL.glEndList)
        tries(GL.glCallList, 1)
        tries(GL.glGetFloatv, GL.GL_CURRENT_COLOR)
    pixels = np.zeros((72, 96, 4), np.uint8)
    observe.gl.glReadPixels(0, 0, 96, 72, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE, observe.at(pixels))
    print(hash(pixels.tobytes()), observe.gl.glGetError(), observe.steady(str(log)))
for style in STYLES:
    log.clear()
    print("STYLE")
    with world.window():
        style and not EARLY and glshim.install(style)
        scene()
    tries(GL.glBegin, 4)
    tries(GL.glVertex3f, 1, 2, 3)
    tries(GL.glEnd)
    EARLY or glshim.uninstall()
"""


@pytest.mark.parametrize("flags", some(
    ["ERROR_CHECKING = False", "ERROR_LOGGING = True", "FULL_LOGGING = True",
     "CONTEXT_CHECKING = True", "ERROR_ON_COPY = True",
     "STORE_POINTERS = False; X.ERROR_ON_COPY = True",
     "USE_ACCELERATE = False", "ALLOW_NUMPY_SCALARS = True", "ARRAY_SIZE_CHECKING = False",
     "SIZE_1_ARRAY_UNPACK = False", "UNSIGNED_BYTE_IMAGES_AS_STRING = False"], 6
))  # fmt: skip
def test_flags_of_pyopengl(flags: str) -> None:
    def said(*styles: str, early: bool = False) -> list[str]:
        """What is said under each of the styles, one after the other; "" is without glshim."""
        text = FLAGS.replace("FLAGS", f"X = OpenGL; X.{flags}")
        text = f"STYLES, EARLY = {styles!r}, {early}\n{text}"
        ended = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True,
                               timeout=60, check=False, env=_hashed())  # fmt: skip
        assert ended.returncode == 0, ended.stderr[-2000:]
        return ended.stdout.split("STYLE\n")[1:]

    plain, none, raskar = said("", "none", "raskar")
    assert "glEnd" in plain
    assert none == plain
    assert said("none", early=True) == [plain]
    assert _without_picture(raskar) == _without_picture(plain)


def _hashed() -> dict[str, str]:
    import os

    return os.environ | {"PYTHONHASHSEED": "0"}


def _without_picture(said: str) -> list[str]:
    return [line for line in said.splitlines() if " 0 [" not in line]
