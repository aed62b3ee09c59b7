"""``--headless`` where there is no Xvfb: toolkits that can draw without a display do."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

DRAW = """
def draw(size, ground):
    glViewport(0, 0, *size)
    glClearColor(*ground, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glColor3f(0.5, 0.5, 0.5)
    glCallList(1)
    glFlush()  # no frame of its own
def make():
    glNewList(1, GL_COMPILE)
    glBegin(GL_QUADS)
    for corner in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        glVertex2f(*corner)
    glEnd()
    glEndList()
"""
GLFW = (
    """
import glfw
glfw.init()
glfw.window_hint(glfw.STENCIL_BITS, 8)
first = glfw.create_window(120, 90, "first", None, None)
second = glfw.create_window(50, 40, "second", None, first)
glfw.make_context_current(first)
from OpenGL.GL import *
"""
    + DRAW
    + """
make()
assert glGetIntegerv(GL_STENCIL_BITS) == 8
for frame in range(4):
    for window, ground in ((first, (1, 1, 1)), (second, (1, 1, 0))):
        glfw.make_context_current(window)
        draw(glfw.get_framebuffer_size(window), ground)
        glfw.swap_buffers(window)
    if frame == 1:
        glfw.set_window_size(first, 200, 150)
    glfw.poll_events()
glfw.destroy_window(second)
assert not glfw.get_current_context()
glfw.terminate()
print("ended")
"""
)
PYGAME = (
    """
import pygame
pygame.display.init()
pygame.display.set_mode((120, 90), pygame.OPENGL | pygame.DOUBLEBUF)
from OpenGL.GL import *
"""
    + DRAW.replace("    glFlush()  # no frame of its own\n", "")
    + """
make()
for frame in range(3):
    draw((120, 90), (1, 1, 1))
    pygame.display.flip()
print("ended")
"""
)
GLUT = """
import sys
from OpenGL.GLUT import *
glutInit(sys.argv)
"""


def run(
    folder: Path, program: str, *, xvfb: bool
) -> tuple[subprocess.CompletedProcess[str], list[np.ndarray]]:
    """The program under ``--headless``, and its frames."""
    folder.mkdir()
    (folder / "app.py").write_text(program)
    environ = {name: text for name, text in os.environ.items() if name != "DISPLAY"}
    if not xvfb:
        environ["PATH"] = str(folder)
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "run", "--headless", "--style", "raskar:ink=#ff0000",
         "--capture", "%d.png", "app.py"],
        cwd=folder, env=environ, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    paths = sorted(folder.glob("*.png"), key=lambda path: int(path.stem))
    return done, [np.asarray(Image.open(path)) for path in paths]


def test_without_a_screen_the_frames_are_those_of_a_screen(tmp_path: Path) -> None:
    there, seen = run(tmp_path / "there", GLFW, xvfb=True)
    none, unseen = run(tmp_path / "none", GLFW, xvfb=False)
    assert there.stdout.split()[-1] == none.stdout.split()[-1] == "ended"
    assert (there.returncode, there.stderr) == (0, "")
    assert none.returncode == 0
    assert none.stderr.startswith("glshim: Xvfb is not installed: running without a screen")
    assert none.stderr.count("\n") == 1
    assert len(seen) == len(unseen) == 8
    for one, other in zip(seen, unseen, strict=True):
        assert one.shape == other.shape
        assert (one == other).all()
    assert (unseen[0] == (255, 0, 0)).all(axis=2).sum() > 100


def test_pygame_draws_without_a_screen(tmp_path: Path) -> None:
    done, pictures = run(tmp_path / "none", PYGAME, xvfb=False)
    assert (done.returncode, done.stdout.split()[-1]) == (0, "ended")
    assert [picture.shape for picture in pictures] == [(90, 120, 3)] * 3
    assert all((picture == (255, 0, 0)).all(axis=2).sum() > 100 for picture in pictures)


def test_a_toolkit_that_needs_a_screen_ends_and_it_was_said_what_to_install(
    tmp_path: Path,
) -> None:
    done, pictures = run(tmp_path / "none", GLUT, xvfb=False)
    assert done.returncode == 1
    assert "other toolkits need Xvfb: apt-get install xvfb" in done.stderr
    assert pictures == []


CORE = """
import glfw
glfw.init()
glfw.window_hint(glfw.CONTEXT_VERSION_MAJOR, 3)
glfw.window_hint(glfw.CONTEXT_VERSION_MINOR, 3)
glfw.window_hint(glfw.OPENGL_PROFILE, glfw.OPENGL_CORE_PROFILE)
window = glfw.create_window(60, 40, "core", None, None)
glfw.make_context_current(window)
from OpenGL.GL import *
assert glGetIntegerv(GL_CONTEXT_PROFILE_MASK) == GL_CONTEXT_CORE_PROFILE_BIT
assert glfw.get_window_attrib(window, glfw.CONTEXT_VERSION_MAJOR) == 3
assert glfw.get_proc_address("glClear")
assert glfw.get_current_context()
glfw.default_window_hints()
glfw.window_hint(glfw.CLIENT_API, glfw.NO_API)
bare = glfw.create_window(60, 40, "bare", None, None)
assert bare
glfw.swap_interval(1)
glfw.terminate()
glfw.init()  # once more
window = glfw.create_window(60, 40, "again", None, None)
glfw.make_context_current(window)
assert glGetIntegerv(GL_CONTEXT_PROFILE_MASK) != GL_CONTEXT_CORE_PROFILE_BIT
print("ended")
"""


def test_glfw_makes_the_contexts_that_are_asked_for(tmp_path: Path) -> None:
    done, _ = run(tmp_path / "none", CORE, xvfb=False)
    assert (done.returncode, done.stdout.strip()) == (0, "ended"), done.stderr


def test_shots_come_without_a_screen_too(tmp_path: Path) -> None:
    environ = {name: text for name, text in os.environ.items() if name != "DISPLAY"}
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "shot", "cube", "--scale", "1", "-o", "shot.png"],
        cwd=tmp_path, env=environ | {"PATH": str(tmp_path)}, capture_output=True, text=True,
        timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    with Image.open(tmp_path / "shot.png") as picture:
        assert len(np.unique(np.asarray(picture.convert("L")))) > 3


def test_the_order_of_imports_does_not_matter(tmp_path: Path) -> None:
    program = "import OpenGL.GL\n" + GLFW
    done, pictures = run(tmp_path / "none", program, xvfb=False)
    assert (done.returncode, len(pictures)) == (0, 8), done.stderr
