"""Where ink is gathered before it goes over the app's picture.

Strokes overlap: neighbours at their corners, both halves of a ridge, every line and the one behind
it. Drawn here each pixel keeps the greatest coverage, whatever the order, and the app's picture
gets the ink once.
"""

from __future__ import annotations

from collections.abc import Sequence

from glshim.driver.functions import gl
from glshim.outputs.gl.device.devices import Device
from glshim.outputs.gl.device.programs import shader_text
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.constants import (
    GL_BLEND,
    GL_COLOR_BUFFER_BIT,
    GL_DEPTH_TEST,
    GL_FRAMEBUFFER,
    GL_FUNC_ADD,
    GL_MAX,
    GL_ONE,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_RGBA8,
    GL_SCISSOR_TEST,
    GL_TRIANGLES,
)

_UNIT = 14


class Canvas:
    """Colour (premultiplied) of at least a window's size. Make and use it inside the state guard.
    buffers: formats of what else is drawn to."""

    def __init__(self, device: Device, buffers: Sequence[int] = ()) -> None:
        head = f"#version {130 if device.modern else 120}\n"
        vertex, fragment = shader_text("over.vert.glsl"), shader_text("over.frag.glsl")
        self._over = {  # drivers in software walk through branches that are never taken
            tidy: device.program("over", head + vertex, head + "#define TIDY\n" * tidy + fragment)
            for tidy in (False, True)
        }
        self._target = RenderTarget(GL_RGBA8, buffers, unit=_UNIT)

    @property
    def size(self) -> tuple[int, int]:
        """Pixels."""
        return self._target.size

    def open(self, box: Box) -> None:
        """Draw on it from now on: it is large enough for a box of the framebuffer and has no ink
        there."""
        x, y, width, height = box
        self._target.fit(x + width, y + height)
        self._target.bind()
        gl.glDisable(GL_DEPTH_TEST)
        gl.glEnable(GL_SCISSOR_TEST)
        gl.glScissor(*box)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClear(GL_COLOR_BUFFER_BIT)
        gl.glEnable(GL_BLEND)
        gl.glBlendEquation(GL_MAX)

    def reopen(self) -> None:
        """Draw on it again as it is."""
        self._target.bind()

    def put_over(self, framebuffer: int, box: Box, *, tidy: bool) -> None:
        """Lay the ink in a box over a framebuffer, and leave that bound. tidy: without lonely
        specks. The app's stencil test, if it is on, holds."""
        gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
        gl.glEnable(GL_SCISSOR_TEST)
        gl.glScissor(*box)
        gl.glDisable(GL_DEPTH_TEST)
        gl.glEnable(GL_BLEND)
        gl.glBlendEquation(GL_FUNC_ADD)
        gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
        gl.glViewport(0, 0, *self.size)
        self._target.bind_texture()
        x, y, width, height = box
        self._over[tidy].use(
            {
                "ink": _UNIT, "size": self.size,
                "box": (x + 0.5, y + 0.5, x + width - 0.5, y + height - 0.5),
            }
        )  # fmt: skip
        fill_viewport()


def fill_viewport() -> None:
    """One triangle over everything, in calls that every version has."""
    gl.glBegin(GL_TRIANGLES)
    for corner in ((-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)):
        gl.glVertex2f(*corner)
    gl.glEnd()
