"""Where passes draw: a canvas with a depth buffer that begins as the layer's, and a stencil."""

from __future__ import annotations

from glshim.driver.functions import gl
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.programs import shader_text
from glshim.outputs.gl.frame.canvas import Canvas, fill_viewport
from glshim.outputs.gl.frame.depth import UNIT, Box
from glshim.spec.constants import (
    GL_ALWAYS,
    GL_DEPTH24_STENCIL8,
    GL_DEPTH_TEST,
    GL_STENCIL_BUFFER_BIT,
)

NOTHING_DRAWN = 255
"""What the stencil begins with (McGuire & Hughes 2004, section 3.4)."""


class Stage:
    """Make and use it inside the state guard."""

    def __init__(self, device: ModernDevice) -> None:
        self._canvas = Canvas(device, buffers=(GL_DEPTH24_STENCIL8,))
        self._seed = device.program(
            "seed", shader_text("seed.vert.glsl"), shader_text("seed.frag.glsl")
        )

    def open(self, box: Box, *, deep: bool = True) -> None:
        """Draw on it from now on: no colour, the finished depth (bound at its unit), stencil
        `NOTHING_DRAWN`. deep: whether depth matters; else it is anything."""
        self._canvas.open(box)
        gl.glStencilMask(0xFF)
        gl.glClearStencil(NOTHING_DRAWN)
        gl.glClear(GL_STENCIL_BUFFER_BIT)
        if not deep:
            return
        gl.glViewport(0, 0, *self._canvas.size)
        gl.glDepthRange(0.0, 1.0)
        gl.glColorMask(0, 0, 0, 0)
        gl.glEnable(GL_DEPTH_TEST)
        gl.glDepthFunc(GL_ALWAYS)
        gl.glDepthMask(1)
        self._seed.use({"finished_depth": UNIT})
        fill_viewport()

    def reopen(self) -> None:
        """Draw on it again as it is."""
        self._canvas.reopen()

    def put_over(self, framebuffer: int, box: Box) -> None:
        """Lay the colour over a framebuffer, and leave that bound."""
        gl.glDepthMask(0)
        gl.glStencilMask(0)
        gl.glColorMask(1, 1, 1, 1)
        self._canvas.put_over(framebuffer, box, tidy=False)
