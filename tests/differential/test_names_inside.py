"""Names asked for inside a primitive, where GL gives none, change no name that is given later."""

from __future__ import annotations

import glfw
import numpy as np
from OpenGL import GL
from OpenGL.raw.GL.VERSION.GL_4_1 import glShaderBinary

from .world import App, prepare, styled, window


def _names(style: str | None) -> list[str]:
    app = App()
    with styled(style), window() as handle:
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        glfw.swap_buffers(handle)
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
    with styled("pencil"), window() as handle:
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        glfw.swap_buffers(handle)
        GL.glBegin(GL.GL_QUADS)
        for refused in (GL.glCreateShader, GL.glUseProgram, GL.glGetAttachedShaders):
            app.tries(refused, "1")
        app.tries(GL.glEnd)
    assert ["ArgumentError" in said for said in app.saw] == [True, True, True, False]
    assert app.saw[-1] == "None"


def test_names_in_an_array_that_is_refused() -> None:
    """Of another type than GL's: what is given to the driver instead would be taken."""
    app = App()
    with styled("pencil"), window() as handle:
        prepare()
        GL.glRectf(-0.5, -0.5, 0.5, 0.5)
        glfw.swap_buffers(handle)
        names = np.array([GL.glCreateShader(GL.GL_VERTEX_SHADER)], np.int32)
        app.tries(glShaderBinary, 1, names, 0, np.zeros(4, np.uint8), 0)
    assert "CopyError" in app.saw[-1]
