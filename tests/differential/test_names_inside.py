"""Names asked for inside a primitive, where GL gives none, change no name that is given later."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import glfw
import numpy as np
import pytest
from OpenGL import GL, GLU
from OpenGL.raw.GL.VERSION.GL_4_1 import glShaderBinary

from .world import App, prepare, styled, window


@contextmanager
def restyled(style: str | None) -> Iterator[None]:
    """A window in which a frame has been drawn: there are objects of ours."""
    with styled(style), window() as handle:
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        glfw.swap_buffers(handle)
        yield


def _names(style: str | None) -> list[str]:
    app = App()
    with restyled(style):
        GL.glBegin(GL.GL_QUADS)
        app.tries(GL.glGenFramebuffers, 1)
        app.tries(GL.glCreateProgram)
        app.tries(GL.glEnd)
        for kind in (GL.GL_FRAGMENT_SHADER, GL.GL_VERTEX_SHADER):
            app.tries(GL.glCreateShader, kind)
        app.tries(GL.glGenFramebuffers, 1)
        app.tries(GL.glCreateProgram)
    return app.saw


def test_names_after_a_primitive() -> None:
    assert _names("pencil") == _names(None)


def test_refused_inside_a_primitive() -> None:
    """Nothing was called, and GL finds no error."""
    app = App()
    with restyled("pencil"):
        GL.glBegin(GL.GL_QUADS)
        for refused in (GL.glCreateShader, GL.glUseProgram, GL.glGetAttachedShaders):
            app.tries(refused, "1")
        app.tries(GL.glEnd)
    assert ["ArgumentError" in said for said in app.saw] == [True, True, True, False]
    assert app.saw[-1] == "None"


def test_names_in_an_array_that_is_refused() -> None:
    """Of another type than GL's: what is given to the driver instead would be taken."""
    app = App()
    with restyled("pencil"):
        names = np.array([GL.glCreateShader(GL.GL_VERTEX_SHADER)], np.int32)
        app.tries(glShaderBinary, 1, names, 0, np.zeros(4, np.uint8), 0)
    assert "CopyError" in app.saw[-1]


def _in_a_list(style: str | None, mode: int) -> list[str]:
    """Mesa gives names while a list is compiled, inside its primitives, too."""
    app = App()
    with styled(style), window() as handle:
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        GL.glBegin(GL.GL_TRIANGLES_ADJACENCY)
        GL.glEnd()
        glfw.swap_buffers(handle)
        first = [make(1) for make in _GIVING.values()]
        app.saw.append(str(first))
        GL.glNewList(7, mode)
        _gives(app)
        GL.glBegin(GL.GL_QUADS)
        GL.glVertex2f(0.0, 0.0)
        # Where the driver itself is inside a primitive, these two are named, but not made.
        _gives(app, bound=mode == GL.GL_COMPILE)
        app.tries(GL.glCreateShader, GL.GL_VERTEX_SHADER)
        GL.glEnd()
        GL.glEndList()
        app.tries(GL.glCallList, 7)
        for kind in _GIVING:
            asked = getattr(GL, f"glIs{kind}")
            app.saw.append(f"{kind} {[asked(name) for name in range(1, 30)]}")
        _gives(app)
    return app.saw


_GIVING = {
    "Texture": GL.glGenTextures, "Buffer": GL.glGenBuffers, "Framebuffer": GL.glGenFramebuffers,
    "Renderbuffer": GL.glGenRenderbuffers,
}  # fmt: skip
_TARGETS = (GL.GL_TEXTURE_3D, GL.GL_TEXTURE_BUFFER, GL.GL_TEXTURE_2D_MULTISAMPLE)


def _gives(app: App, *, bound: bool = True) -> None:
    for make in _GIVING.values():
        app.tries(make, 2)
    names = np.zeros(2, np.uint32)
    for target in _TARGETS:
        app.tries(GL.glCreateTextures, target, 2, names)
        app.saw.append(str(names))
    some = (GL.glCreateFramebuffers, GL.glCreateRenderbuffers) if bound else ()
    for make in (GL.glCreateBuffers, *some):
        app.tries(make, 2, names)
        app.saw.append(str(names))


@pytest.mark.parametrize("mode", [GL.GL_COMPILE, GL.GL_COMPILE_AND_EXECUTE])
@pytest.mark.parametrize("style", ["pencil", "edge_mesh:texture=pen"])
def test_names_while_a_list_is_open(style: str, mode: int) -> None:
    assert _in_a_list(style, mode) == _in_a_list(None, mode)


def _after_a_shape(style: str | None) -> list[str]:
    """GLU's glEnd ends the program's primitive: names are given again."""
    app = App()
    with restyled(style):
        GL.glBegin(GL.GL_POLYGON)
        GLU.gluPartialDisk(GLU.gluNewQuadric(), 0.1, 0.6, 7, 2, 0.0, 90.0)
        app.tries(GL.glGenBuffers, 1)
        app.tries(GL.glEnd)
        app.tries(GL.glGenBuffers, np.array(2))
    return app.saw


def test_names_after_a_shape_inside_a_primitive() -> None:
    assert _after_a_shape("raskar") == _after_a_shape(None)


def _deleted_with_lines(style: str | None) -> list[str]:
    app = App()
    with styled(style), window() as handle:
        prepare()
        name, depths = GL.glGenFramebuffers(1), GL.glGenRenderbuffers(1)
        GL.glBindRenderbuffer(GL.GL_RENDERBUFFER, depths)
        GL.glRenderbufferStorage(GL.GL_RENDERBUFFER, GL.GL_DEPTH_COMPONENT24, 32, 32)
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, name)
        GL.glFramebufferRenderbuffer(
            GL.GL_FRAMEBUFFER, GL.GL_DEPTH_ATTACHMENT, GL.GL_RENDERBUFFER, depths
        )
        GL.glBegin(GL.GL_LINES)
        GL.glEnd()
        GL.glDeleteFramebuffers(1, [name])
        glfw.swap_buffers(handle)
        app.tries(GL.glIsFramebuffer, name)
    return app.saw


def test_a_framebuffer_that_is_deleted_with_lines_in_it_stays_deleted() -> None:
    assert _deleted_with_lines("pencil") == _deleted_with_lines(None)
