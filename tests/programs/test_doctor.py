"""``glshim doctor PROGRAM``: what is seen of a program, whichever way it runs and ends."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from glshim.running.examine import Examined, examine
from tests.programs.test_silence import ARRAYS, DEPTH, REASONS, WINDOW
from tests.sweep import some

ROOT = Path(__file__).parents[2]
GLUT = """
import sys
from OpenGL.GL import *
from OpenGL.GLUT import *
glutInit(sys.argv)
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutCreateWindow(b"")
glEnable(GL_DEPTH_TEST)
def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glutSolidTeapot(0.5)
    glRasterPos2f(0.0, 0.0)
    glutBitmapCharacter(GLUT_BITMAP_8_BY_13, 65)
    glutSwapBuffers()
    glutDestroyWindow(glutGetWindow())  # which ends freeglut's loop by C's exit
glutDisplayFunc(display)
glutMainLoop()
"""
BUFFER = """
from OpenGL.arrays import vbo
buffer = vbo.VBO(bytes(points))
def buffered():
    with buffer:
        glVertexPointer(3, GL_FLOAT, 0, buffer)
        glDrawArrays(GL_QUADS, 0, 4)
"""
PATHS = {
    "glBegin and glEnd": DEPTH + "frames(quad)",
    "client arrays": DEPTH + ARRAYS + "frames(lambda: glDrawArrays(GL_QUADS, 0, 4))",
    "buffer objects": DEPTH + ARRAYS + BUFFER + "frames(buffered)",
    "display lists": DEPTH
    + "glNewList(1, GL_COMPILE)\nquad()\nglEndList()\nframes(lambda: glCallList(1))",
    "shapes of C libraries": DEPTH
    + "from OpenGL.GLU import *\nq = gluNewQuadric()\nframes(lambda: gluSphere(q, 0.5, 8, 8))",
}


def seen(
    tmp_path: Path, program: str, *arguments: str, frames: int = 3, seconds: float = 60.0
) -> Examined:
    (tmp_path / "app.py").write_text(program)
    command = [str(tmp_path / "app.py"), *arguments]
    return examine(command, "raskar", frames=frames, seconds=seconds, environ=os.environ)


@pytest.mark.parametrize("path", some(tuple(PATHS), 2))
def test_polygons_are_counted_by_path(tmp_path: Path, path: str) -> None:
    found = seen(tmp_path, WINDOW + PATHS[path])
    assert found.seen is not None
    assert list(found.seen.polygons) == [path] and found.seen.polygons[path] % 3 == 0
    assert found.seen.calls["clear"] == {"glClear": 3}
    assert found.seen.frame_ends == {"glfw": 3} and "stopped after 3 frames" in found.ended
    assert found.is_restyled and found.verdict == "restyled: all polygons"


@pytest.mark.parametrize("name", some(tuple(sorted(set(REASONS) - {"no line asked for"})), 2))
def test_what_keeps_lines_away_is_the_verdict(tmp_path: Path, name: str) -> None:
    program, expected = REASONS[name]
    found = seen(tmp_path, WINDOW + program)
    assert not found.is_restyled
    assert found.verdict.startswith("not restyled: ") and expected in found.verdict


def test_a_program_that_never_presents_is_stopped_and_told_of(tmp_path: Path) -> None:
    found = seen(
        tmp_path, WINDOW + DEPTH + "while True: frames(quad, 1, lambda: None)", seconds=4.0
    )
    assert found.status is None and found.ended.startswith("stopped after 4 s and no frames")
    assert found.seen is not None and found.seen.calls["clear"]["glClear"] > 0
    assert "no end of a frame" in found.verdict


def test_freeglut_leaves_by_c_and_is_told_of_all_the_same(tmp_path: Path) -> None:
    found = seen(tmp_path, GLUT, frames=30)
    assert found.seen is not None and found.seen.frame_ends == {"GLUT": 1}
    assert found.ended.startswith("exited with status 0 after 1 frame,")
    assert found.seen.calls["shape"] == {"glutSolidTeapot": 1, "glutBitmapCharacter": 1}
    assert (found.seen.carried, found.seen.passed, found.seen.others) == (1, {}, 1)


def test_a_program_that_crashes_shows_why_and_is_told_of(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    found = seen(tmp_path, WINDOW + DEPTH + "frames(quad, 2)\nraise KeyError(sys.argv[1])", "it")
    assert "KeyError: 'it'" in capfd.readouterr().err
    assert found.status == 1 and found.ended.startswith("exited with status 1 after 2 frames")
    assert found.is_restyled
    killed = seen(tmp_path, WINDOW + DEPTH + "frames(quad, 2)\nctypes.string_at(0)")
    assert killed.status == -11 and killed.seen is not None and "signal 11" in killed.ended


def test_a_program_without_pyopengl_and_one_that_is_not_there(tmp_path: Path) -> None:
    found = seen(tmp_path, "print('hello')")
    assert found.seen is None and "PyOpenGL was not imported" in found.verdict
    assert seen(tmp_path, "import sys; sys.exit(3)").status == 3


def glshim(*arguments: str, **variables: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "glshim", "doctor", *arguments], cwd=ROOT,
        env={**os.environ, **variables}, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def test_the_command_prints_it_for_people() -> None:
    done = glshim("--frames", "2", "-m", "demo_apps.03_robot_arm", "--style")
    assert done.returncode == 0, done.stderr
    told = done.stdout
    for part in ("python -m demo_apps.03_robot_arm --style", "stopped after 2 frames", "glClear 2",
                 "by path", "what passes through", "restyled"):  # fmt: skip
        assert part in told


def test_the_command_prints_json(tmp_path: Path) -> None:
    (tmp_path / "app.py").write_text(WINDOW + "print('of the program')\nframes(quad)")
    done = glshim("--json", "--frames", "2", str(tmp_path / "app.py"), GLSHIM_STYLE="crease")
    assert done.returncode == 1 and "of the program" in done.stderr
    told = json.loads(done.stdout)
    assert (told["style"], told["status"], told["restyled"]) == ("crease", 0, False)
    assert told["seen"]["passed"] == {"there is no depth test": 2}


@pytest.mark.parametrize(
    "arguments", [["--frames", "0", "a.py"], ["--timeout", "0", "a.py"], ["--style", "x", "a.py"]]
)
def test_what_makes_no_sense_ends_with_2(arguments: list[str]) -> None:
    done = glshim(*arguments)
    assert (done.returncode, done.stdout) == (2, "") and done.stderr.count("\n") == 1
