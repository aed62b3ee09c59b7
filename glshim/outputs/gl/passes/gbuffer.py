"""The G-buffer: what passes say of each pixel before others draw.

T. Saito, T. Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990; P. Rideout,
"Silhouette Extraction", 2010, keeps normals and depths in it.
"""

from __future__ import annotations

from glshim.driver.functions import gl
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.constants import (
    GL_COLOR_BUFFER_BIT,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_COMPONENT24,
    GL_RGBA32F,
)

UNIT = 4
"""Texture unit of it while passes are drawn."""


class GBuffer:
    """Four floats and a depth a pixel, of at least a window's size. Use it inside the guard."""

    def __init__(self) -> None:
        self._target = RenderTarget(GL_RGBA32F, (GL_DEPTH_COMPONENT24,), unit=UNIT)

    def open(self, box: Box, *, reversed_depth: bool) -> None:
        """Draw into it from now on: it is large enough for a box of the framebuffer and empty
        there. reversed_depth: farther is less depth."""
        x, y, width, height = box
        self._target.fit(x + width, y + height)
        self._target.bind()
        gl.glScissor(*box)
        gl.glColorMask(1, 1, 1, 1)
        gl.glDepthMask(1)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClearDepth(0.0 if reversed_depth else 1.0)
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)

    def bind_texture(self) -> None:
        """Let shaders read it at `UNIT`."""
        self._target.bind_texture()
