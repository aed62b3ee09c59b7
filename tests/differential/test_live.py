"""Styles that may come, and a panel over the picture, leave to the app what plain GL gives it."""

from __future__ import annotations

import numpy as np
import pytest
from OpenGL import GL

from glshim import pipeline
from glshim.outputs.gl.frame import overlay
from tests.sweep import some

from .registry import SCENES, plain
from .test_contexts import cube
from .world import HEIGHT, WIDTH, App, Outcome, observe, prepare, styled, window

PANEL = overlay.panel(["sketch  width=3", "16.7 ms, 60 fps"], WIDTH)


def followed(name: str) -> Outcome:
    """The scene while lists are followed for a style that may come."""
    app = App()
    with styled(None):
        pipeline.install("none", live=True)
        with window():
            prepare()
            SCENES[name](app)
            return observe(app)


def with_panel(name: str) -> Outcome:
    app = App()
    with styled(None), window():
        prepare()
        SCENES[name](app)
        overlay.show(PANEL, (WIDTH, HEIGHT), 0)
        return observe(app)


@pytest.mark.parametrize("name", some(tuple(SCENES), len(SCENES) // 2))
def test_a_style_that_may_come_changes_not_a_byte(name: str) -> None:
    assert plain(name).differences(followed(name)) == {}


@pytest.mark.parametrize("name", some(tuple(SCENES), len(SCENES) // 3))
def test_the_panel_changes_nothing_but_the_picture(name: str) -> None:
    assert plain(name).differences(with_panel(name), pictures=False) == {}


@pytest.mark.parametrize("version", ["2.1", "3.3"])
@pytest.mark.parametrize("ground", [0.0, 1.0])
def test_the_panel_can_be_read_on_any_ground(
    version: str, ground: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever the app has set: the same pixels, text in them that stands out."""
    monkeypatch.setenv("MESA_GL_VERSION_OVERRIDE", f"{version}COMPAT" if version > "3" else version)
    pictures = []
    for hostile in (False, True):
        with window():
            GL.glClearColor(ground, ground, ground, 1.0)
            GL.glClear(GL.GL_COLOR_BUFFER_BIT)
            if hostile:
                unsettle()
            overlay.show(PANEL, (WIDTH, HEIGHT), 0)
            GL.glPixelTransferf(GL.GL_RED_SCALE, 1.0)
            read = GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
        pictures.append(np.frombuffer(read, np.uint8).reshape(HEIGHT, WIDTH, 3)[::-1])
    assert np.array_equal(*pictures)
    height, width = PANEL.shape[:2]
    margin = overlay.MARGIN
    inside = pictures[0][margin : margin + height, margin : margin + width].astype(int)
    assert inside.max() - inside.min() > 150
    outside = pictures[0].copy()
    outside[margin : margin + height, margin : margin + width] = round(255 * ground)
    assert (outside == round(255 * ground)).all()


def unsettle() -> None:
    """All that could change or drop what is drawn."""
    for switch in (
        GL.GL_LIGHTING, GL.GL_FOG, GL.GL_SCISSOR_TEST, GL.GL_STENCIL_TEST, GL.GL_DEPTH_TEST,
        GL.GL_ALPHA_TEST, GL.GL_COLOR_LOGIC_OP, GL.GL_TEXTURE_2D, GL.GL_CLIP_PLANE0,
        GL.GL_CULL_FACE, GL.GL_POLYGON_STIPPLE, GL.GL_COLOR_SUM,
    ):  # fmt: skip
        GL.glEnable(switch)
    GL.glScissor(0, 0, 5, 5)
    GL.glStencilFunc(GL.GL_NEVER, 0, 255)
    GL.glDepthFunc(GL.GL_NEVER)
    GL.glAlphaFunc(GL.GL_NEVER, 0.0)
    GL.glLogicOp(GL.GL_CLEAR)
    GL.glBlendEquation(GL.GL_FUNC_REVERSE_SUBTRACT)
    GL.glColorMask(0, 0, 0, 0)
    GL.glPixelZoom(2.0, -1.0)
    GL.glPixelTransferf(GL.GL_RED_SCALE, 0.0)
    GL.glPixelTransferf(GL.GL_ALPHA_BIAS, -1.0)
    GL.glPixelStorei(GL.GL_UNPACK_ROW_LENGTH, 7)
    GL.glPixelStorei(GL.GL_UNPACK_SKIP_PIXELS, 3)
    GL.glViewport(3, 3, 4, 4)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glTranslatef(9.0, 9.0, 9.0)
    GL.glBindTexture(GL.GL_TEXTURE_2D, GL.glGenTextures(1))
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 1, 1, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, b"abc")


def test_where_gl_cannot_draw_there_is_no_panel() -> None:
    with window():
        prepare()
        GL.glNewList(GL.glGenLists(1), GL.GL_COMPILE)
        overlay.show(PANEL, (WIDTH, HEIGHT), 0)
        GL.glEndList()
        cube()
        assert GL.glGetError() == 0
