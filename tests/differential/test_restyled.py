"""Switching styles while an app runs leaves nothing behind in its context."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pygame
import pytest
from OpenGL import GL

import glshim


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


def test_styles_switched_often_make_no_new_buffers(window: None) -> None:
    plain = frame()
    styles = ("raskar:ink=#ff0000", "none", "raskar:silhouette_width=5")
    pictures = []
    for style in styles:
        glshim.install(style)
        pictures.append(frame())
    assert pictures[0] != plain == pictures[1] != pictures[2] != pictures[0]
    before = int(GL.glGenBuffers(1))
    for style in styles * 10:
        glshim.install(style)
        frame()
    assert int(GL.glGenBuffers(1)) - before == 1
    glshim.uninstall()
    assert frame() == plain


def test_styles_that_paint_give_their_programs_back(window: None) -> None:
    before = int(GL.glCreateProgram())
    for style in ("cartoon", "technical:textures=off", "raskar:fill=#ff0000") * 4:
        glshim.install(style)
        frame()
    glshim.uninstall()
    # What mesh and line shaders are compiled to is kept; of each surface no program is.
    kept = [name for name in range(1, before + 200) if GL.glIsProgram(name)]
    glshim.install("cartoon")
    frame()
    glshim.uninstall()
    assert [name for name in range(1, before + 200) if GL.glIsProgram(name)] == kept


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
