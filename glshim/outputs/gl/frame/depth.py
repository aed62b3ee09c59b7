"""The layer's finished depth as a texture, for line shaders to look up."""

from __future__ import annotations

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.outputs.gl.device.target import RenderTarget
from glshim.spec.constants import (
    GL_DEPTH24_STENCIL8,
    GL_DEPTH_BIAS,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_COMPONENT16,
    GL_DEPTH_COMPONENT24,
    GL_DEPTH_SCALE,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRAMEBUFFER,
    GL_NEAREST,
    GL_NO_ERROR,
    GL_SAMPLE_BUFFERS,
    GL_SCISSOR_TEST,
    GL_STENCIL_BITS,
    GL_TEXTURE_2D,
)

UNIT = 15
"""Texture unit of the copy while lines are drawn: one that apps hardly use."""
Box = tuple[int, int, int, int]
"""x, y, width, height in pixels of the framebuffer."""


class DepthCopy:
    """A texture in which every pixel holds the depth of the framebuffer's pixel at the same place.
    Use it inside the state guard."""

    def __init__(self) -> None:
        self.sample_offset = 0.0
        """Pixels by which depths may not be those of pixel centres: samples lie elsewhere."""
        self._targets: dict[int, RenderTarget] = {}
        """By format."""
        self._target = self._of(GL_DEPTH_COMPONENT24)

    @property
    def size(self) -> tuple[int, int]:
        """Pixels of the texture."""
        return self._target.size

    def take(self, box: Box, bits: int) -> bool:
        """Copy the depth of the bound framebuffer (of so many bits) in a box and bind the texture
        at `UNIT`. Whether that worked: some multisampled depths cannot be resolved."""
        x, y, width, height = box
        source = integer(GL_DRAW_FRAMEBUFFER_BINDING)
        several = integer(GL_SAMPLE_BUFFERS) > 0
        self.sample_offset = 0.5 if several else 0.0
        kind = _format(bits, integer(GL_STENCIL_BITS)) if several else GL_DEPTH_COMPONENT24
        self._fit(box, kind)
        gl.glBindFramebuffer(GL_FRAMEBUFFER, source)
        if not several:
            gl.glPixelTransferf(GL_DEPTH_SCALE, 1.0)
            gl.glPixelTransferf(GL_DEPTH_BIAS, 0.0)
            gl.glCopyTexSubImage2D(GL_TEXTURE_2D, 0, x, y, x, y, width, height)
        else:
            self._target.bind(GL_DRAW_FRAMEBUFFER)
            gl.glDisable(GL_SCISSOR_TEST)
            corners = (x, y, x + width, y + height)
            gl.glBlitFramebuffer(*corners, *corners, GL_DEPTH_BUFFER_BIT, GL_NEAREST)
            gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, source)
        return bool(gl.glGetError() == GL_NO_ERROR)

    def open(self, box: Box, reversed_depth: bool) -> None:
        """Bind it as an empty depth buffer to draw into, large enough for a box.
        reversed_depth: farther is less depth."""
        self.sample_offset = 0.0
        self._fit(box, GL_DEPTH_COMPONENT24)
        self._target.bind()
        gl.glDisable(GL_SCISSOR_TEST)
        gl.glDepthMask(1)
        gl.glClearDepth(0.0 if reversed_depth else 1.0)
        gl.glClear(GL_DEPTH_BUFFER_BIT)

    def _fit(self, box: Box, kind: int) -> None:
        """Be of a format and large enough, with the texture bound."""
        x, y, width, height = box
        self._target = self._of(kind)
        self._target.fit(x + width, y + height)
        self._target.bind_texture()

    def _of(self, kind: int) -> RenderTarget:
        found = self._targets.get(kind)
        if found is None:
            found = self._targets[kind] = RenderTarget(kind, unit=UNIT)
        return found


def _format(bits: int, stencil: int) -> int:
    """The texture format that a blit from such a depth buffer asks for."""
    if bits == 16:
        return GL_DEPTH_COMPONENT16
    return GL_DEPTH24_STENCIL8 if stencil else GL_DEPTH_COMPONENT24
