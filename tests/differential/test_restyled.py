"""Switching styles while an app runs leaves nothing behind in its context."""

from __future__ import annotations

from collections.abc import Iterator

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
