"""The app's finished picture as a texture, for mesh shaders to look up."""

from __future__ import annotations

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.notices import say_once
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.constants import (
    GL_ALPHA_BITS,
    GL_COLOR_BUFFER_BIT,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRAMEBUFFER,
    GL_NEAREST,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER,
    GL_RGB8,
    GL_RGBA8,
    GL_SCISSOR_TEST,
)

UNIT = 5
"""Texture unit of the copy while passes are drawn."""


class ColourCopy:
    """A texture in which every pixel holds the colour of the framebuffer's pixel at the same
    place. Use it inside the state guard."""

    def __init__(self) -> None:
        self._targets = {kind: RenderTarget(kind, unit=UNIT) for kind in (GL_RGB8, GL_RGBA8)}
        self._size = 1, 1

    @property
    def size(self) -> tuple[int, int]:
        """Pixels of the texture."""
        return self._size

    def take(self, framebuffer: int, box: Box) -> None:
        """Copy the colour of a framebuffer in a box and bind the texture at `UNIT`. The binding of
        the framebuffer that is drawn to stays."""
        x, y, width, height = box
        drawn_to = integer(GL_DRAW_FRAMEBUFFER_BINDING)
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer)
        shown = integer(GL_DRAW_BUFFER)
        target = self._targets[GL_RGBA8 if integer(GL_ALPHA_BITS) else GL_RGB8]
        target.fit(x + width, y + height)
        self._size = target.size
        target.bind_texture()
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer)
        kept = integer(GL_READ_BUFFER)
        gl.glReadBuffer(shown)
        target.bind(GL_DRAW_FRAMEBUFFER)
        gl.glColorMask(1, 1, 1, 1)
        gl.glDisable(GL_SCISSOR_TEST)
        corners = (x, y, x + width, y + height)
        gl.glBlitFramebuffer(*corners, *corners, GL_COLOR_BUFFER_BIT, GL_NEAREST)
        if gl.glGetError():
            say_once("the program's picture cannot be copied here: its colours are left out")
        gl.glEnable(GL_SCISSOR_TEST)
        gl.glReadBuffer(kept)
        gl.glBindFramebuffer(GL_FRAMEBUFFER, drawn_to)
