"""The ends of frames, toolkit by toolkit: counted, written as presented, and unseen by the app.

Each program runs in a process of its own with no style, so only the frame ends are at work.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PIL import Image

from glshim.toolkits import frames
from glshim.toolkits.frames import Stage

pytestmark = pytest.mark.programs

GLUT = """
import atexit, sys
from OpenGL.GL import *
from OpenGL.GLUT import *
from OpenGL.GLUT import glutSwapBuffers as taken_early
atexit.register(print, "atexit")
drawn = 0
def display():
    global drawn
    drawn += 1
    glClearColor(drawn / 5, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    SHOW
    glutPostRedisplay()
glutInit(sys.argv)
glutInitDisplayMode(GLUT_RGB | MODE)
glutInitWindowSize(120, 80)
glutCreateWindow(b"app")
glutDisplayFunc(display)
glutMainLoop()
"""

GLFW = """
import ctypes
import glfw
from glfw import swap_buffers as taken_early
glfw.init()
a = glfw.create_window(100, 80, "a", None, None)
b = glfw.create_window(60, 50, "b", None, None)
from OpenGL.GL import *
try:
    for frame in range(1000):
        for window, red in ((a, 1), (b, 0)):
            glfw.make_context_current(window)
            glClearColor(red, 1 - red, 0, 1)
            glClear(GL_COLOR_BUFFER_BIT)
        taken_early(a)
        assert ctypes.addressof(glfw.get_current_context().contents) == ctypes.addressof(b.contents)
        assert glGetFloatv(GL_COLOR_CLEAR_VALUE)[1] == 1.0  # b is current still
        taken_early(b)
finally:
    print("finally", frame)
    glfw.terminate()
"""

PYGAME = """
import pygame
from pygame.display import flip as taken_early
pygame.display.init()
pygame.display.set_mode((100, 80), pygame.OPENGL | pygame.DOUBLEBUF)
from OpenGL.GL import *
for frame in range(1000):
    glClearColor(0, 0, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    try:
        taken_early()
    except SystemExit:
        print("swallowed", frame)
"""

PYGAME_FLAT = """
import pygame
import OpenGL.GL
pygame.display.init()
screen = pygame.display.set_mode((100, 80))
for frame in range(20):
    screen.fill((0, 200, 0))
    pygame.display.flip()
    pygame.display.update()
    pygame.display.update(pygame.Rect(0, 0, 5, 5))
print("all", frame)
"""

RAISES = """
import sys
from OpenGL.GL import *
from OpenGL.GLUT import *
times = 0
def display():
    global times
    times += 1
    if times == 2:
        import os
        os._exit(3)
    glutPostRedisplay()
    raise ValueError("the app's own")
glutInit(sys.argv)
glutInitDisplayMode(GLUT_RGB | GLUT_SINGLE)
glutCreateWindow(b"app")
glutDisplayFunc(display)
glutMainLoop()
"""

STATE = """
import ctypes
import OpenGL
OpenGL.ERROR_CHECKING = False
import glfw
glfw.init()
window = glfw.create_window(64, 48, "app", None, None)
glfw.make_context_current(window)
from OpenGL.GL import *

NAMES = (
    GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
    GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PIXEL_PACK_BUFFER_BINDING, GL_MAP_COLOR,
    GL_READ_FRAMEBUFFER_BINDING, GL_DRAW_FRAMEBUFFER_BINDING, GL_RED_SCALE, GL_RED_BIAS,
    GL_BLUE_BIAS, GL_READ_BUFFER,
)
glClearColor(0.2, 0.4, 0.6, 1)
glClear(GL_COLOR_BUFFER_BIT)
glReadBuffer(GL_FRONT)
window_reads = glGetIntegerv(GL_READ_BUFFER)
texture, other = glGenTextures(1), glGenFramebuffers(1)
glBindTexture(GL_TEXTURE_2D, texture)
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, None)
glBindFramebuffer(GL_FRAMEBUFFER, other)
glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0)
buffer = glGenBuffers(1)
glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer)
glBufferData(GL_PIXEL_PACK_BUFFER, 16, None, GL_STATIC_READ)
for name, value in zip(NAMES, (8, 100, 3, 2, 1, 1)):
    glPixelStorei(name, value)
glPixelTransferf(GL_RED_SCALE, 3.0)
glPixelTransferf(GL_BLUE_BIAS, 0.25)
before = [float(glGetFloatv(name)) for name in NAMES]
glEnable(0xBAD)  # an error that the app has yet to fetch
glfw.swap_buffers(window)
assert glGetError() == GL_INVALID_ENUM
assert glGetError() == GL_NO_ERROR
after = [float(glGetFloatv(name)) for name in NAMES]
assert before == after, (before, after)
glBindFramebuffer(GL_FRAMEBUFFER, 0)
assert glGetIntegerv(GL_READ_BUFFER) == window_reads
print("same")
"""


def run(program: str, folder: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    path = folder / "app.py"
    path.write_text(program)
    return subprocess.run(
        [sys.executable, str(path)], cwd=folder, env={**os.environ, **variables},
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip


def glut(mode: str, show: str) -> str:
    return GLUT.replace("MODE", mode).replace("SHOW", show)


def pictures(folder: Path) -> list[tuple[tuple[int, int], tuple[int, ...]]]:
    """Size and the one colour of every picture, in order."""
    found = []
    for path in sorted(folder.glob("*.png")):
        image = Image.open(path)
        colours = image.getcolors()
        assert colours is not None
        assert len(colours) == 1, path
        found.append((image.size, colours[0][1]))
    return found


RED_RISING = [((120, 80), (round(255 * n / 5), 0, 0)) for n in (1, 2, 3)]


@pytest.mark.parametrize(
    ("mode", "show"),
    [
        ("GLUT_DOUBLE", "taken_early()"),
        ("GLUT_DOUBLE", "glutSwapBuffers()"),
        ("GLUT_SINGLE", "glFlush()"),
        ("GLUT_SINGLE", "pass"),
    ],
)
def test_glut(tmp_path: Path, mode: str, show: str) -> None:
    done = run(glut(mode, show), tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%03d.png")
    assert (done.returncode, done.stdout, done.stderr) == (0, "atexit\n", "")
    assert pictures(tmp_path) == RED_RISING


RESTING = {
    "GLUT": glut("GLUT_DOUBLE", "taken_early()").replace("    glutPostRedisplay()", "    pass"),
    "glfw": """
import glfw
glfw.init()
window = glfw.create_window(120, 80, "app", None, None)
glfw.make_context_current(window)
from OpenGL.GL import *
for drawn in range(1, 9):
    glClearColor(drawn / 5, 0, 0, 1)
    glClear(GL_COLOR_BUFFER_BIT)
    glfw.swap_buffers(window)
    glfw.wait_events_timeout(30 if drawn > 2 else 0.01)
""",
}


@pytest.mark.parametrize("program", RESTING.values(), ids=RESTING)
def test_a_program_that_rests_is_asked_for_the_frames_that_are_left(
    tmp_path: Path, program: str
) -> None:
    done = run(program, tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%03d.png")
    assert (done.returncode, done.stderr) == (0, "")
    assert pictures(tmp_path) == RED_RISING


def test_a_swap_in_the_display_callback_is_one_frame_not_two(tmp_path: Path) -> None:
    program = glut("GLUT_DOUBLE", "glFlush(); taken_early(); glFinish()")
    done = run(program, tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%03d.png")
    assert done.returncode == 0
    assert pictures(tmp_path) == RED_RISING


def test_glfw_with_two_windows_and_its_finally(tmp_path: Path) -> None:
    done = run(GLFW, tmp_path, GLSHIM_FRAMES="4", GLSHIM_CAPTURE="%d.png")
    assert (done.returncode, done.stdout, done.stderr) == (0, "finally 1\n", "")
    assert pictures(tmp_path) == [((100, 80), (255, 0, 0)), ((60, 50), (0, 255, 0))] * 2


@pytest.mark.parametrize("platform", ["egl", "glx"])
def test_a_context_of_another_platform_than_pyopengl_was_told(
    tmp_path: Path, platform: str
) -> None:
    """Toolkits choose theirs by themselves."""
    program = GLFW.replace(
        "glfw.init()",
        "glfw.init(); glfw.window_hint(glfw.CONTEXT_CREATION_API, "
        f"glfw.{'NATIVE' if platform == 'egl' else 'EGL'}_CONTEXT_API)")
    done = run(program, tmp_path, PYOPENGL_PLATFORM=platform, GLSHIM_STYLE="none",
               GLSHIM_FRAMES="4", GLSHIM_CAPTURE="%d.png")  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "finally 1\n", "")
    assert pictures(tmp_path) == [((100, 80), (255, 0, 0)), ((60, 50), (0, 255, 0))] * 2


def test_pygame_that_swallows_the_exit_ends_a_frame_later(tmp_path: Path) -> None:
    done = run(PYGAME, tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")
    assert done.returncode == 1  # whoever catches it may be counting failures
    assert "caught the SystemExit that was to end it" in done.stderr
    assert "swallowed 2" in done.stdout
    assert "swallowed 3" not in done.stdout
    assert pictures(tmp_path) == [((100, 80), (0, 0, 255))] * 4


@pytest.mark.parametrize("variable", ["GLSHIM_STILL", "GLSHIM_REPORT"])
def test_who_wants_frames_alone_gets_them_of_a_program_that_swallows(
    tmp_path: Path, variable: str
) -> None:
    done = run(PYGAME, tmp_path, GLSHIM_FRAMES="3", **{variable: str(tmp_path)})
    assert done.returncode == 0
    assert "swallowed 2" in done.stdout


def test_frames_of_exit_functions_change_no_status(tmp_path: Path) -> None:
    program = PYGAME.replace("import pygame\n", "import atexit, pygame\n", 1)
    program = program.replace("except SystemExit", "finally").replace(
        "for frame", "atexit.register(lambda: (print('exit'), pygame.display.flip()))\nfor frame")
    done = run(program, tmp_path, GLSHIM_FRAMES="3")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.split()[-1] == "exit"


TESTED = """
import unittest
import glfw
from OpenGL.GL import *

class Draws(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        glfw.init()
        cls.window = glfw.create_window(60, 50, "b", None, None)
        glfw.make_context_current(cls.window)
    def draw(self):
        glClear(GL_COLOR_BUFFER_BIT)
        glfw.swap_buffers(self.window)
    def test_a(self):
        self.draw()
    def test_b(self):
        self.draw()
    def test_c(self):
        self.draw()
        raise ValueError("of the program's own")
    def test_d(self):
        self.draw()
"""


@pytest.mark.parametrize("runner", [["pytest", "-q", "-p", "no:cacheprovider"], ["unittest"]])
def test_the_end_of_a_program_is_no_end_of_a_test_runner(
    tmp_path: Path, runner: list[str]
) -> None:
    """All tests are run, and none fails that would pass without us."""
    (tmp_path / "test_app.py").write_text(TESTED)
    done = subprocess.run(
        [sys.executable, "-m", *runner, "test_app.py"], cwd=tmp_path, timeout=60, check=False,
        env=os.environ | {"GLSHIM_FRAMES": "2"}, capture_output=True, text=True,
    )  # fmt: skip
    told = done.stdout + done.stderr
    assert done.returncode == 1
    assert "1 failed, 3 passed" in told or ("Ran 4 tests" in told and "(errors=1)" in told)
    assert f"GLSHIM_FRAMES=2 did not end {runner[0]}" in done.stderr


def test_pygame_without_opengl_has_no_frames_of_ours(tmp_path: Path) -> None:
    done = run(PYGAME_FLAT, tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="%d.png")
    assert done.returncode == 0
    assert "all 19" in done.stdout
    assert pictures(tmp_path) == []


def test_an_exception_in_a_glut_callback_looks_as_it_does_plain(tmp_path: Path) -> None:
    def without_addresses(text: str) -> list[str]:
        return [line.split(" at 0x")[0] for line in text.splitlines()]

    plain = run(RAISES, tmp_path)
    shimmed = run(RAISES, tmp_path, GLSHIM_FRAMES="9")
    assert "the app's own" in plain.stderr
    assert shimmed.returncode == plain.returncode == 3
    assert without_addresses(shimmed.stderr) == without_addresses(plain.stderr)


def test_writing_a_frame_leaves_state_and_errors(tmp_path: Path) -> None:
    done = run(STATE, tmp_path, GLSHIM_CAPTURE="frame.png")
    assert (done.returncode, done.stdout, done.stderr) == (0, "same\n", "")
    assert pictures(tmp_path) == [((64, 48), (51, 102, 153))]


def test_a_folder_that_cannot_be_written_is_said_once(tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("")
    program = PYGAME.replace("except SystemExit", "finally")
    done = run(program, tmp_path, GLSHIM_FRAMES="3", GLSHIM_CAPTURE="taken/%d.png")
    assert done.returncode == 0
    assert done.stderr.count("no more frames are written") == 1


@pytest.fixture
def current(monkeypatch: pytest.MonkeyPatch) -> None:
    """As if a context were current, and nobody listened."""
    monkeypatch.setattr(frames, "_context_is_current", lambda: True)
    monkeypatch.setattr(frames, "_listeners", ())
    monkeypatch.setattr(frames, "_leaving", False)
    monkeypatch.setattr(frames, "_exit_raised", False)
    monkeypatch.setattr(frames, "_loop_asked", False)


def noting(log: list[str], word: str) -> Callable[[], None]:
    return lambda: log.append(word)


@pytest.mark.usefixtures("current")
def test_listeners_run_by_stage_around_the_present() -> None:
    log: list[str] = []
    frames.listen(Stage.CAPTURE, before=noting(log, "grab"))
    frames.listen(Stage.DRAW, before=noting(log, "draw"), after=noting(log, "drawn"))
    assert frames.present(lambda: log.append("swap") or 7) == 7
    assert log == ["draw", "grab", "swap", "drawn"]


@pytest.mark.usefixtures("current")
def test_a_listener_that_raises_reaches_nobody(capsys: pytest.CaptureFixture[str]) -> None:
    def broken() -> None:
        raise RuntimeError("in a listener")

    log: list[str] = []
    frames.listen(Stage.DRAW, before=broken, after=broken)
    frames.listen(Stage.DRAW, before=noting(log, "draw"))
    assert frames.present(lambda: 7) == 7
    assert log == ["draw"]
    assert "in a listener" in capsys.readouterr().err


@pytest.mark.usefixtures("current")
def test_what_the_present_raises_is_the_apps() -> None:
    log: list[str] = []
    frames.listen(Stage.DRAW, before=noting(log, "before"), after=noting(log, "after"))
    with pytest.raises(ZeroDivisionError):
        frames.present(lambda: 1 // 0)
    assert log == ["before"]


@pytest.mark.usefixtures("current")
def test_who_stopped_is_gone_and_no_other() -> None:
    log: list[str] = []
    before = noting(log, "before")
    first, second = (frames.listen(Stage.DRAW, before=before) for _ in range(2))
    second.stop()
    second.stop()
    frames.present(lambda: None)
    assert log == ["before"]
    first.stop()
    assert not frames.has_listeners()
    frames.present(lambda: None)
    assert log == ["before"]


@pytest.mark.usefixtures("current")
def test_the_program_ends_after_all_listeners_ran() -> None:
    log: list[str] = []
    frames.listen(Stage.DRAW, before=noting(log, "1"), after=frames.end_program)
    frames.listen(Stage.CAPTURE, before=noting(log, "2"), after=noting(log, "after"))
    with pytest.raises(SystemExit) as caught:
        frames.present(lambda: None)
    assert caught.value.code == 0
    assert log == ["1", "2", "after"]


@pytest.mark.usefixtures("current")
def test_a_main_loop_that_swallows_exceptions_is_asked_to_return() -> None:
    """Nothing ends inside the callback, and what is still shown then is nobody's."""
    log: list[str] = []
    frames.listen(Stage.DRAW, before=noting(log, "1"), after=frames.end_program)
    window = frames.Drawable(lambda: None, may_raise=False, leave=lambda: log.append("ask") is None)
    assert frames.present(lambda: log.append("swap") or 7, on=window) == 7
    assert log == ["1", "swap", "ask"]
    assert frames.present(lambda: log.append("swap") or 7, on=window) == 7
    assert log == ["1", "swap", "ask", "swap"]
