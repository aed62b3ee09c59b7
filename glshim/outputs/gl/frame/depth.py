"""The layer's finished depth as a texture, for line shaders to look up."""

from __future__ import annotations

import ctypes

from glshim.errors import RenderError
from glshim.spec.ask import integer
from glshim.spec.driver import gl

UNIT = 15
"""Texture unit of the copy while lines are drawn: one that apps hardly use."""
Box = tuple[int, int, int, int]
"""x, y, width, height in pixels of the framebuffer."""
_TEXTURE_2D, _TEXTURE_0 = 0x0DE1, 0x84C0
_UNPACK_BUFFER, _DRAW, _READ = 0x88EC, 0x8CA9, 0x8CA8
_DRAW_BINDING, _SAMPLE_BUFFERS, _STENCIL_BITS = 0x8CA6, 0x80A8, 0x0D57
_DEPTH, _DEPTH_STENCIL = 0x1902, 0x84F9
_DEPTH_16, _DEPTH_24, _DEPTH_24_STENCIL_8 = 0x81A5, 0x81A6, 0x88F0
_UNSIGNED_INT, _UNSIGNED_INT_24_8 = 0x1405, 0x84FA
_DEPTH_AT, _DEPTH_STENCIL_AT = 0x8D00, 0x821A
_COMPLETE = 0x8CD5
_PLAIN = ((0x2801, 0x2600), (0x2800, 0x2600), (0x884C, 0))  # nearest, no comparison
_DEPTH_SCALE, _DEPTH_BIAS = 0x0D1E, 0x0D1F


class DepthCopy:
    """A texture in which every pixel holds the depth of the framebuffer's pixel at the same place.
    Make and use it inside the state guard."""

    def __init__(self) -> None:
        self.blur = 0.0
        """Pixels by which depths may not be those of pixel centres: samples lie elsewhere."""
        self.size = (0, 0)
        """Pixels of the texture."""
        self.texture = 0
        self._framebuffer = 0
        self._format = 0

    def take(self, box: Box, bits: int) -> bool:
        """Copy the depth of the bound framebuffer (of so many bits) in a box and bind the texture
        at `UNIT`. Whether that worked: some multisampled depths cannot be resolved."""
        x, y, width, height = box
        source = integer(_DRAW_BINDING)
        several = integer(_SAMPLE_BUFFERS) > 0
        self.blur = 0.5 if several else 0.0
        kind = _format(bits, integer(_STENCIL_BITS)) if several else _DEPTH_24
        self._make(x + width, y + height, kind)
        gl.glBindFramebuffer(_READ, source)
        if not several:
            gl.glPixelTransferf(_DEPTH_SCALE, 1.0)
            gl.glPixelTransferf(_DEPTH_BIAS, 0.0)
            gl.glCopyTexSubImage2D(_TEXTURE_2D, 0, x, y, x, y, width, height)
        else:
            gl.glBindFramebuffer(_DRAW, self._framebuffer)
            gl.glDisable(0x0C11)
            corners = (x, y, x + width, y + height)
            gl.glBlitFramebuffer(*corners, *corners, 0x0100, 0x2600)
            gl.glBindFramebuffer(_DRAW, source)
        return int(gl.glGetError()) == 0

    def open(self, box: Box, greater: bool) -> None:
        """Bind it as an empty depth buffer to draw into, large enough for a box; greater: farther
        is less depth."""
        x, y, width, height = box
        self.blur = 0.0
        self._make(x + width, y + height, _DEPTH_24)
        gl.glBindFramebuffer(_DRAW, self._framebuffer)
        if gl.glCheckFramebufferStatus(_DRAW) != _COMPLETE:
            raise RenderError("this window has no depth buffer, and none can be made for it")
        gl.glDisable(0x0C11)
        gl.glDepthMask(1)
        gl.glClearDepth(0.0 if greater else 1.0)
        gl.glClear(0x0100)

    def _make(self, width: int, height: int, kind: int) -> None:
        """The texture, bound, and large enough."""
        gl.glActiveTexture(_TEXTURE_0 + UNIT)
        name = ctypes.c_uint(self.texture)
        if not name.value:
            gl.glGenTextures(1, ctypes.addressof(name))
            self.texture = name.value
        gl.glBindTexture(_TEXTURE_2D, self.texture)
        if kind == self._format and width <= self.size[0] and height <= self.size[1]:
            return
        self._format = kind
        self.size = (max(width, self.size[0]), max(height, self.size[1]))
        for parameter, value in _PLAIN:
            gl.glTexParameteri(_TEXTURE_2D, parameter, value)
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        with_stencil = kind == _DEPTH_24_STENCIL_8
        layout = (_DEPTH_STENCIL, _UNSIGNED_INT_24_8) if with_stencil else (_DEPTH, _UNSIGNED_INT)
        gl.glTexImage2D(_TEXTURE_2D, 0, kind, *self.size, 0, *layout, None)
        if not self._framebuffer:
            name = ctypes.c_uint()
            gl.glGenFramebuffers(1, ctypes.addressof(name))
            self._framebuffer = name.value
        bound = integer(_DRAW_BINDING)
        gl.glBindFramebuffer(_DRAW, self._framebuffer)
        gl.glFramebufferTexture2D(_DRAW, _DEPTH_STENCIL_AT, _TEXTURE_2D, 0, 0)
        at = _DEPTH_STENCIL_AT if with_stencil else _DEPTH_AT
        gl.glFramebufferTexture2D(_DRAW, at, _TEXTURE_2D, self.texture, 0)
        gl.glDrawBuffer(0)
        gl.glReadBuffer(0)
        gl.glBindFramebuffer(_DRAW, bound)


def _format(bits: int, stencil: int) -> int:
    """The texture format that a blit from such a depth buffer asks for."""
    if bits == 16:
        return _DEPTH_16
    return _DEPTH_24_STENCIL_8 if stencil else _DEPTH_24
