"""The app's finished picture as a texture, for mesh shaders to look up."""

from __future__ import annotations

import ctypes

from glshim.notices import say_once
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.ask import integer
from glshim.spec.driver import gl

UNIT = 5
"""Texture unit of the copy while passes are drawn."""
_TEXTURE_2D, _TEXTURE_0, _UNPACK_BUFFER = 0x0DE1, 0x84C0, 0x88EC
_DRAW, _READ, _DRAW_BINDING, _COLOUR_AT = 0x8CA9, 0x8CA8, 0x8CA6, 0x8CE0
_DRAW_BUFFER, _READ_BUFFER, _ALPHA_BITS = 0x0C01, 0x0C02, 0x0D55
_RGB_8, _RGBA_8, _RGBA, _BYTE = 0x8051, 0x8058, 0x1908, 0x1401
_SCISSOR_TEST = 0x0C11


class ColourCopy:
    """A texture in which every pixel holds the colour of the framebuffer's pixel at the same
    place. Make and use it inside the state guard."""

    def __init__(self) -> None:
        self._texture = self._framebuffer = 0
        self._size = (0, 0)
        self._format = 0

    def take(self, framebuffer: int, box: Box) -> None:
        """Copy the colour of a framebuffer in a box and bind the texture at `UNIT`. The binding of
        the framebuffer that is drawn to stays."""
        x, y, width, height = box
        stage = integer(_DRAW_BINDING)
        gl.glBindFramebuffer(_DRAW, framebuffer)
        shown, kind = integer(_DRAW_BUFFER), _RGBA_8 if integer(_ALPHA_BITS) else _RGB_8
        self._make(x + width, y + height, kind)
        gl.glBindFramebuffer(_READ, framebuffer)
        kept = integer(_READ_BUFFER)
        gl.glReadBuffer(shown)
        gl.glBindFramebuffer(_DRAW, self._framebuffer)
        gl.glColorMask(1, 1, 1, 1)
        gl.glDisable(_SCISSOR_TEST)
        corners = (x, y, x + width, y + height)
        gl.glBlitFramebuffer(*corners, *corners, 0x4000, 0x2600)
        if gl.glGetError():
            say_once("the program's picture cannot be copied here: its colours are left out")
        gl.glEnable(_SCISSOR_TEST)
        gl.glReadBuffer(kept)
        gl.glBindFramebuffer(_DRAW, stage)
        gl.glBindFramebuffer(_READ, stage)

    def _make(self, width: int, height: int, kind: int) -> None:
        """The texture, bound, and large enough; one that is made anew is black."""
        gl.glActiveTexture(_TEXTURE_0 + UNIT)
        name = ctypes.c_uint(self._texture)
        if not name.value:
            gl.glGenTextures(1, ctypes.addressof(name))
            self._texture = name.value
        gl.glBindTexture(_TEXTURE_2D, self._texture)
        if kind == self._format and width <= self._size[0] and height <= self._size[1]:
            return
        self._format = kind
        self._size = (max(width, self._size[0]), max(height, self._size[1]))
        for parameter in (0x2801, 0x2800):
            gl.glTexParameteri(_TEXTURE_2D, parameter, 0x2600)
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        gl.glTexImage2D(_TEXTURE_2D, 0, kind, *self._size, 0, _RGBA, _BYTE, None)
        if not self._framebuffer:
            name = ctypes.c_uint()
            gl.glGenFramebuffers(1, ctypes.addressof(name))
            self._framebuffer = name.value
        gl.glBindFramebuffer(_DRAW, self._framebuffer)
        gl.glFramebufferTexture2D(_DRAW, _COLOUR_AT, _TEXTURE_2D, self._texture, 0)
