"""Names asked for inside a primitive, where GL gives none, change no name that is given later."""

from __future__ import annotations

import glfw
from OpenGL import GL

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
