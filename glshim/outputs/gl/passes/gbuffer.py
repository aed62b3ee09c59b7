"""The G-buffer: what passes say of each pixel before others draw.

T. Saito, T. Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990; P. Rideout,
"Silhouette Extraction", 2010, keeps normals and depths in it.
"""

from __future__ import annotations

from glshim.errors import RenderError
from glshim.outputs.gl.device.uploads import made
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.driver import gl

UNIT = 4
"""Texture unit of it while passes are drawn."""
_FRAMEBUFFER, _RENDERBUFFER, _COMPLETE = 0x8D40, 0x8D41, 0x8CD5
_COLOUR_AT, _DEPTH_AT, _DEPTH_24 = 0x8CE0, 0x8D00, 0x81A6
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_RGBA_32F, _RGBA, _FLOAT = 0x8814, 0x1908, 0x1406


class GBuffer:
    """Four floats and a depth a pixel, of at least a window's size. Use it inside the guard."""

    def __init__(self) -> None:
        self._framebuffer, self._texture = made("glGenFramebuffers"), made("glGenTextures")
        self._depth = made("glGenRenderbuffers")
        self._size = (0, 0)

    def open(self, box: Box, *, greater: bool) -> None:
        """Bind it, large enough for a box of the framebuffer and empty there. greater: farther is
        less depth."""
        x, y, width, height = box
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
        if x + width > self._size[0] or y + height > self._size[1]:
            self._resize(max(x + width, self._size[0]), max(y + height, self._size[1]))
        gl.glScissor(*box)
        gl.glColorMask(1, 1, 1, 1)
        gl.glDepthMask(1)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClearDepth(0.0 if greater else 1.0)
        gl.glClear(0x4100)

    def bind(self) -> None:
        """Let shaders read it at `UNIT`."""
        gl.glActiveTexture(_TEXTURE_0 + UNIT)
        gl.glBindTexture(_TEXTURE_2D, self._texture)

    def _resize(self, width: int, height: int) -> None:
        self._size = (width, height)
        self.bind()
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA_32F, width, height, 0, _RGBA, _FLOAT, None)
        for parameter in (0x2801, 0x2800):
            gl.glTexParameteri(_TEXTURE_2D, parameter, 0x2600)
        gl.glBindRenderbuffer(_RENDERBUFFER, self._depth)
        gl.glRenderbufferStorage(_RENDERBUFFER, _DEPTH_24, width, height)
        gl.glFramebufferTexture2D(_FRAMEBUFFER, _COLOUR_AT, _TEXTURE_2D, self._texture, 0)
        gl.glFramebufferRenderbuffer(_FRAMEBUFFER, _DEPTH_AT, _RENDERBUFFER, self._depth)
        if gl.glCheckFramebufferStatus(_FRAMEBUFFER) != _COMPLETE:
            raise RenderError("a framebuffer of floats cannot be made here")
