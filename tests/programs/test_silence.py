"""A program under a style that draws no line says once why, and what to do; never under none."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.sweep import some

WINDOW = """
import ctypes, sys
import glfw
from OpenGL.GL import *

glfw.init()
glfw.window_hint(glfw.VISIBLE, False)
window = glfw.create_window(96, 96, "", None, None)
glfw.make_context_current(window)
glClearColor(0.9, 0.9, 0.9, 1.0)

def quad(mode=GL_QUADS):
    glBegin(mode)
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        glVertex3f(x, y, 0.0)
    glEnd()

def frames(draw, count=3, show=lambda: glfw.swap_buffers(window)):
    for _ in range(count):
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        draw()
        show()
"""
DEPTH = "glEnable(GL_DEPTH_TEST)\n"
SHADERS = """
from OpenGL.GL import shaders
vertex = shaders.compileShader("void main() { gl_Position = gl_Vertex; }", GL_VERTEX_SHADER)
fragment = shaders.compileShader("void main() { gl_FragColor = vec4(1); }", GL_FRAGMENT_SHADER)
glUseProgram(shaders.compileProgram(vertex, fragment))
"""
ARRAYS = """
points = (ctypes.c_float * 12)(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0)
glEnableClientState(GL_VERTEX_ARRAY)
glVertexPointer(3, GL_FLOAT, 0, points)
"""
UNSEEN = "frames(quad, 3, lambda: None)\nimport os; print('shown'); sys.stdout.flush()\n"
REASONS = {
    "own shaders": (DEPTH + SHADERS + "frames(quad)", "its own shaders"),
    "lines": (DEPTH + "frames(lambda: quad(GL_LINES))", "only lines, points or pixels"),
    "lines of arrays": (
        ARRAYS + "frames(lambda: glDrawArrays(GL_LINES, 0, 4))", "only lines, points or pixels",
    ),
    "points": (
        DEPTH + ARRAYS + "frames(lambda: glDrawArrays(GL_POINTS, 0, 4))",
        "only lines, points or pixels",
    ),
    "no depth test": ("frames(quad)", "without depth test"),
    "transparent": (DEPTH + "glDepthMask(False)\nframes(quad)", "do not write depth"),
    "wire": (
        DEPTH + "glPolygonMode(GL_FRONT_AND_BACK, GL_LINE)\nframes(quad)", "switch the program to",
    ),
    "nothing": ("frames(lambda: None)", "draws nothing through PyOpenGL"),
    "no frame end": (DEPTH + UNSEEN, "no end of a frame was seen"),
    "no line asked for": (DEPTH + "frames(quad)", "the style adds nothing"),
}  # fmt: skip
NO_LINES = "raskar:silhouettes=off,ridges=off,valleys=off"


def run(tmp_path: Path, program: str, style: str) -> subprocess.CompletedProcess[str]:
    (tmp_path / "app.py").write_text(WINDOW + program)
    return subprocess.run(
        [sys.executable, "app.py"], cwd=tmp_path, env={**os.environ, "GLSHIM_STYLE": style},
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def said(done: subprocess.CompletedProcess[str]) -> list[str]:
    """What is said of no line."""
    assert done.returncode == 0, done.stderr
    return [line for line in done.stderr.splitlines() if "no lines are drawn" in line]


@pytest.mark.parametrize("name", some(tuple(REASONS), 3))
def test_a_program_without_a_line_says_why_at_its_end(tmp_path: Path, name: str) -> None:
    program, expected = REASONS[name]
    style = NO_LINES if name == "no line asked for" else "raskar"
    done = run(tmp_path, program, style)
    assert len(said(done)) == 1, done.stderr
    assert expected in said(done)[0]
    assert "glshim doctor PROGRAM" in said(done)[0]


def test_under_none_nothing_is_said(tmp_path: Path) -> None:
    for name in some(("own shaders", "no depth test", "nothing", "no frame end"), 2):
        assert run(tmp_path, REASONS[name][0], "none").stderr == ""


LONG = DEPTH + """
import os
frames(lambda: quad(GL_LINES), 70)
sys.stderr.write("the program is at its end\\n"); sys.stderr.flush()
"""


def test_it_is_said_after_some_frames_once(tmp_path: Path) -> None:
    done = run(tmp_path, LONG, "raskar")
    lines = done.stderr.splitlines()
    assert len(said(done)) == 1 and lines[-1] == "the program is at its end"


def test_a_frame_end_that_is_never_seen_is_said_while_the_program_runs(tmp_path: Path) -> None:
    unseen = DEPTH + "frames(quad, 70, lambda: None)\nimport os; os._exit(0)"
    assert "no end of a frame was seen" in said(run(tmp_path, unseen, "raskar"))[0]


@pytest.mark.parametrize("leave", ["ctypes.CDLL(None).exit(0)", "sys.exit(0)"])
def test_it_is_said_whichever_way_the_program_ends(tmp_path: Path, leave: str) -> None:
    assert len(said(run(tmp_path, f"frames(quad)\n{leave}", "raskar"))) == 1


def test_a_program_with_a_line_says_nothing(tmp_path: Path) -> None:
    done = run(tmp_path, DEPTH + "frames(quad)", "raskar")
    assert (done.returncode, done.stderr) == (0, "")
    assert run(tmp_path, "pass", "raskar").stderr == ""  # a window, and no frame


DARK = DEPTH + "glClearColor(0.1, 0.1, 0.2, 1.0)\nframes(quad)"


@pytest.mark.parametrize(
    ("style", "hints"),
    [("raskar", 1), *some((
        ("crease", 1), ("two_pass", 1), ("raskar:ink=#ffffff", 0), ("sketch", 0),
        ("raskar:fill=#ffffff", 0), ("none", 0)), 2)],
)  # fmt: skip
def test_dark_lines_on_a_dark_ground_get_a_hint(tmp_path: Path, style: str, hints: int) -> None:
    done = run(tmp_path, DARK, style)
    assert done.stderr.count("background is dark") == hints, done.stderr
    assert done.stderr.count("ink=#ffffff") == hints
    assert done.stderr.count("\n") == hints
