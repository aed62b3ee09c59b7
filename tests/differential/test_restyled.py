"""Switching styles while an app runs leaves nothing behind in its context."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Iterator
from functools import cache
from itertools import product
from pathlib import Path

import numpy as np
import pygame
import pytest
from OpenGL import GL
from OpenGL.GLU import gluNewQuadric, gluSphere

import glshim
from glshim import pipeline
from glshim.driver import objects
from glshim.driver.functions import gl
from glshim.spec.kinds import BUFFER
from glshim.styling.protocol import Layer, Lines, Styler
from tests.sweep import some


@pytest.fixture
def window() -> Iterator[None]:
    pygame.display.init()
    pygame.display.set_mode((64, 64), pygame.OPENGL | pygame.DOUBLEBUF)
    GL.glEnable(GL.GL_DEPTH_TEST)
    yield
    glshim.uninstall()
    pygame.display.quit()


def frame() -> bytes:
    GL.glClearColor(1, 1, 1, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glBegin(GL.GL_QUADS)
    for x, y in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
        GL.glVertex2f(x, y)
    GL.glEnd()
    return bytes(GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))


def made() -> set[int]:
    """Names of glshim's buffers."""
    return set().union(*(kinds.get(BUFFER, ()) for kinds in objects._made_in.values()))


def test_styles_switched_often_make_no_new_buffers(window: None) -> None:
    plain = frame()
    styles = ("raskar:ink=#ff0000", "none", "raskar:silhouette_width=5")
    pictures = []
    for style in styles:
        glshim.install(style)
        pictures.append(frame())
    assert pictures[0] != plain == pictures[1] != pictures[2] != pictures[0]
    before = made()
    assert before
    for style in styles * 10:
        glshim.install(style)
        frame()
    assert made() == before
    glshim.uninstall()
    assert frame() == plain


def test_styles_that_paint_give_their_programs_back(window: None) -> None:
    before = int(GL.glCreateProgram())
    for style in ("cartoon", "technical:textures=off", "raskar:fill=#ff0000") * 4:
        glshim.install(style)
        frame()
    glshim.uninstall()
    # What mesh and line shaders are compiled to is kept; of each surface no program is.
    kept = [name for name in range(1, before + 300) if gl.glIsProgram(name)]
    assert len(kept) > 4
    glshim.install("cartoon")
    frame()
    glshim.uninstall()
    assert [name for name in range(1, before + 300) if gl.glIsProgram(name)] == kept
    assert [name for name in range(1, before + 300) if GL.glIsProgram(name)] == [before]


def test_a_new_context_at_an_old_address_gets_a_backend_of_its_own() -> None:
    """The app's own vertex array objects there have the names that ours had in the old one."""
    pictures = set()
    for _ in range(6):
        pygame.display.init()
        pygame.display.set_mode((64, 64), pygame.OPENGL | pygame.DOUBLEBUF)
        GL.glEnable(GL.GL_DEPTH_TEST)
        for name in GL.glGenVertexArrays(8):
            GL.glBindVertexArray(int(name))
        GL.glBindVertexArray(0)
        plain = frame()
        glshim.install("raskar:ink=#ff0000")
        pictures.add(frame())
        assert plain not in pictures
        glshim.uninstall()
        pygame.display.quit()
    assert len(pictures) == 1


def coloured(shades: list[tuple[float, float, float]]) -> bytes:
    """Two faces of a roof in one primitive, the ridge between them turned to the viewer."""
    GL.glClearColor(1, 1, 1, 1)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glBegin(GL.GL_QUADS)
    for shade, side in zip(shades, (-0.7, 0.7), strict=True):
        GL.glColor3f(*shade)
        for x, y, z in ((0, -0.8, -0.9), (side, -0.8, 0.9), (side, 0.8, 0.9), (0, 0.8, -0.9)):
            GL.glVertex3f(x, y, z)
    GL.glEnd()
    return bytes(GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))


def inked(style: str, shades: list[tuple[float, float, float]]) -> list[bool]:
    glshim.install(style)
    found = coloured(shades)
    glshim.uninstall()
    return [max(found[i : i + 3]) < 60 for i in range(0, len(found), 3)]


def test_colours_change_no_lines_unless_edges_are_marked(window: None) -> None:
    """What the program says between glBegin and glEnd about colours is not asked for."""
    alike, unlike = [(1.0, 0.5, 0.5)] * 2, [(1.0, 0.5, 0.5), (0.5, 1.0, 0.5)]
    assert inked("edge_mesh", alike) == inked("edge_mesh", unlike)
    assert sum(inked("edge_mesh", unlike)) > 100
    marks = "edge_mesh:marked=on,ridges=off,valleys=off,contours=off,boundary=off"
    assert not any(inked(marks, alike))
    assert sum(inked(marks, unlike)) > 30


def test_a_buffer_written_while_no_style_was_on_is_read_again(window: None) -> None:
    """What the backend keeps of buffers outlives a style, which alone saw them written."""
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)

    def picture(buffer: int, size: float) -> bytes:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer)
        GL.glVertexPointer(2, GL.GL_FLOAT, 0, None)
        corners = np.array([(-size, -size), (size, -size), (size, size), (-size, size)], "f4")
        GL.glBufferData(GL.GL_ARRAY_BUFFER, corners.nbytes, corners, GL.GL_STATIC_DRAW)
        glshim.install("raskar:ink=#ff0000")
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glDrawArrays(GL.GL_QUADS, 0, 4)
        found = bytes(GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))
        glshim.uninstall()
        return found

    one, other = (int(name) for name in GL.glGenBuffers(2))
    picture(one, 0.7)
    assert picture(one, 0.4) == picture(other, 0.4)


def test_a_buffer_copied_from_another_is_read_again(window: None) -> None:
    """The call names the buffer that is read first; the other one has changed."""
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    source, shown, fresh = (int(name) for name in GL.glGenBuffers(3))

    def fill(buffer: int, size: float) -> int:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer)
        corners = np.array([(-size, -size), (size, -size), (size, size), (-size, size)], "f4")
        GL.glBufferData(GL.GL_ARRAY_BUFFER, corners.nbytes, corners, GL.GL_STATIC_DRAW)
        return corners.nbytes

    def picture(buffer: int) -> bytes:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffer)
        GL.glVertexPointer(2, GL.GL_FLOAT, 0, None)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glDrawArrays(GL.GL_QUADS, 0, 4)
        return bytes(GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE))

    glshim.install("raskar:ink=#ff0000")
    fill(shown, 0.7)
    before = picture(shown)
    size = fill(source, 0.4)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, source)  # what is read is bound to where arrays are
    GL.glBindBuffer(GL.GL_COPY_WRITE_BUFFER, shown)
    GL.glCopyBufferSubData(GL.GL_ARRAY_BUFFER, GL.GL_COPY_WRITE_BUFFER, 0, 0, size)
    copied = picture(shown)
    fill(fresh, 0.4)
    expected = picture(fresh)
    glshim.uninstall()
    assert copied == expected != before


# -- a style switched while the app runs -----------------------------------------------------------
# Programs in a process each; they say at which frame which style comes, and write the last picture.

PROGRAM = """
import ctypes
import sys
import numpy as np
import pygame
from glshim import pipeline, parse_style
styles = [None if text == "off" else parse_style(text) for text in sys.argv[2:]]
pipeline.install(styles[0] or "none", live=True)
pygame.display.init()
pygame.display.set_mode((96, 72), pygame.OPENGL | pygame.DOUBLEBUF)
from OpenGL.GL import *
from OpenGL.GLU import *
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glEnable(GL_COLOR_MATERIAL)

RED, GREEN = (1, 0.5, 0.5), (0.5, 1, 0.5)
LEFT = ((-0.6, -0.5), (0, -0.5), (0, 0.5), (-0.6, 0.5))
RIGHT = ((0, -0.5), (0.6, -0.5), (0.6, 0.5), (0, 0.5))

def sheet(first, second):
    # Flat: that there is a line between its halves only their colours or normals say.
    glColor3f(*first)
    glBegin(GL_QUADS)
    glNormal3f(-1, 0, 1)
    for x, y in LEFT:
        glVertex2f(x, y)
    glColor3f(*second)
    glNormal3f(1, 0, 1)
    for x, y in RIGHT:
        glVertex2f(x, y)
    glEnd()

def said_between():
    # The normals stand between the primitives, in a form that is not recorded.
    for half, side in ((LEFT, -20000), (RIGHT, 20000)):
        glNormal3s(side, 0, 20000)
        glBegin(GL_QUADS)
        for x, y in half:
            glVertex2f(x, y)
        glEnd()

points = np.array([(*at, 0) for at in LEFT + RIGHT], "f4")
normals = np.array([(-1, 0, 1)] * 4 + [(1, 0, 1)] * 4, "f4")
buffer = glGenBuffers(1)
glBindBuffer(GL_ARRAY_BUFFER, buffer)
glBufferData(GL_ARRAY_BUFFER, np.concatenate((points, normals)), GL_STATIC_DRAW)
glEnableClientState(GL_VERTEX_ARRAY)
glEnableClientState(GL_NORMAL_ARRAY)
glVertexPointer(3, GL_FLOAT, 0, None)
glNormalPointer(GL_FLOAT, 0, ctypes.c_void_p(points.nbytes))

def arrays():
    glDrawArrays(GL_QUADS, 0, 8)

def elements():
    glBegin(GL_QUADS)
    for i in range(8):
        glArrayElement(i)
    glEnd()

KINDS = (lambda: sheet(RED, GREEN), said_between, arrays, elements,
         lambda: gluSphere(gluNewQuadric(), 0.5, 12, 8))
lists = glGenLists(2 * len(KINDS))

def compiled(first):
    for i, draw in enumerate(KINDS):
        glNewList(lists + first + i, GL_COMPILE)
        draw()
        glEndList()

compiled(0)

def frame(number):
    glClearColor(1, 1, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    if number == 2:  # compiled while another style, or none, was on
        compiled(len(KINDS))
        glBufferSubData(GL_ARRAY_BUFFER, 0, points * np.float32(0.9))
    draws = [lambda i=i: glCallList(lists + i) for i in range(2 * len(KINDS) if number > 1 else 5)]
    for i, draw in enumerate(draws + list(KINDS)):
        glLoadIdentity()
        glTranslatef(0.4 * (i % 5) - 0.8, 0.6 * (i // 5) - 0.6, 0)
        glScalef(0.3, 0.3, 0.3)
        glRotatef(25, 1, 1, 0)
        draw()

# A style a frame, then two more of the last.
for number, style in enumerate(styles + styles[-1:] * 4, start=1):
    frame(number)
    kept = glReadPixels(0, 0, 96, 72, GL_RGB, GL_UNSIGNED_BYTE)
    nexts = (styles[1:] + styles[-1:] * 5)[number - 1]
    pipeline.switch(nexts)
    pygame.display.flip()
    assert pipeline.current() is (nexts and (nexts if nexts.wants_polygons else None)), number
    assert glGetError() == 0
with open(sys.argv[1], "wb") as file:
    file.write(kept)
"""

MARKS = "edge_mesh:marked=on"
RASKAR = "raskar:ink=#ff0000"
SURFACE = "crease:fill=#ddeeff,rule=normals,least_angle=0"


@cache
def last_picture(*styles: str) -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        script, picture = Path(folder, "app.py"), Path(folder, "picture")
        script.write_text(PROGRAM)
        done = subprocess.run(
            [sys.executable, str(script), str(picture), *styles],
            capture_output=True, text=True, timeout=120, check=False,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (0, ""), done.stderr
        return picture.read_bytes()


CHANGES = tuple(product([(RASKAR,), (MARKS,), ("off",), (SURFACE, "off", "none")],
                        [RASKAR, MARKS, SURFACE, "fins", "off"]))  # fmt: skip


@pytest.mark.parametrize(("before", "target"), some(CHANGES, 4))
def test_a_style_that_comes_later_draws_as_if_it_had_been_on_from_the_start(
    before: tuple[str, ...], target: str
) -> None:
    """Lists compiled, buffers written and shapes drawn under another style, or under none."""
    from_the_start = last_picture(*[target] * 4)
    switched = last_picture(*(*before, *before, *before)[:3], target)
    assert switched == from_the_start
    assert last_picture(target, *before, target) == from_the_start
    assert (from_the_start == last_picture(*["off"] * 4)) == (target == "off")


def test_installing_another_style_keeps_what_lists_hold(window: None) -> None:
    name = GL.glGenLists(1)
    glshim.install("raskar:ink=#ff0000")
    GL.glNewList(name, GL.GL_COMPILE)
    GL.glRectf(-0.5, -0.5, 0.5, 0.5)
    GL.glEndList()
    pictures = []
    for style in ("raskar:ink=#0000ff", "none", "raskar:ink=#0000ff"):
        glshim.install(style)
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glCallList(name)
        pictures.append(bytes(GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)))
    assert b"\x00\x00\xff" in pictures[0]
    assert pictures[0] == pictures[2] != pictures[1]


class Failing(Styler):
    """A styler with a fault in it."""

    name = "failing"

    def draws(self, layer: Layer) -> Iterator[Lines]:
        raise ValueError("the styler's own")


def test_a_style_that_fails_ends_alone_where_others_may_come(
    window: None, capsys: pytest.CaptureFixture[str]
) -> None:
    plain = frame()
    pipeline.install(Failing(), live=True)
    assert [frame(), frame()] == [plain, plain]
    assert pipeline.current() is None
    said = capsys.readouterr().err
    assert said.count("'failing' fails and is switched off: ValueError") == 1
    pipeline.switch(glshim.parse_style("raskar"))
    pygame.display.flip()
    assert frame() != plain


def test_memory_stays_flat_when_styles_are_gone_through(window: None) -> None:
    """After every style was on some times, nothing is added by 200 more switches."""
    styles = [glshim.parse_style(text) for text in ("raskar", MARKS, SURFACE, "fins", "fur")]
    pipeline.install("none", live=True)
    name = GL.glGenLists(1)
    GL.glNewList(name, GL.GL_COMPILE)
    gluSphere(gluNewQuadric(), 0.8, 40, 40)
    GL.glEndList()

    def cycle(switches: int) -> tuple[int, ...]:
        for number in range(switches):
            pipeline.switch(None if number % 7 == 6 else styles[number % len(styles)])
            frame()
            GL.glCallList(name)
            pygame.display.flip()
        GL.glFinish()
        kinds = (GL.glIsBuffer, GL.glIsTexture, GL.glIsProgram, GL.glIsFramebuffer)
        return (resident(), *(sum(map(is_one, range(1, 20000))) for is_one in kinds))

    cycle(200)
    before, *objects = cycle(60)
    after, *objects_after = cycle(200)
    assert objects_after == objects
    assert after - before < 4 << 20


def resident() -> int:
    """Bytes of memory that this process holds."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096
