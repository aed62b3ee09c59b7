"""Where ink is gathered before it goes over the app's picture.

Strokes overlap: neighbours at their corners, both halves of a ridge, every line and the one behind
it. Drawn here each pixel keeps the greatest coverage, whatever the order, and the app's picture
gets the ink once.
"""

from __future__ import annotations

from importlib.resources import files

from glshim.errors import RenderError
from glshim.outputs.gl.device.programs import compiled
from glshim.outputs.gl.device.uploads import made
from glshim.outputs.gl.frame.depth import Box
from glshim.spec.driver import gl

_FRAMEBUFFER, _COLOUR_AT, _COMPLETE = 0x8D40, 0x8CE0, 0x8CD5
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_RGBA_8, _RGBA, _BYTE = 0x8058, 0x1908, 0x1401
_UNIT = 14
_BLEND, _DEPTH_TEST, _SCISSOR_TEST = 0x0BE2, 0x0B71, 0x0C11
_ADD, _MAX, _ONE, _REST = 0x8006, 0x8008, 1, 0x0303


class Canvas:
    """Colour (premultiplied) of at least a window's size. Use it inside the state guard.
    modern: the context has GLSL 1.30."""

    def __init__(self, modern: bool) -> None:
        shaders = files("glshim.outputs.gl") / "shaders"
        texts = (shaders / name for name in ("over.vert.glsl", "over.frag.glsl"))
        head = f"#version {130 if modern else 120}\n"
        vertex, fragment = (text.read_text("utf-8") for text in texts)
        self._over = {  # drivers in software walk through branches that are never taken
            tidy: compiled("over", head + vertex, head + "#define TIDY\n" * tidy + fragment)
            for tidy in (False, True)
        }
        self._at = {
            (tidy, name): int(gl.glGetUniformLocation(over, name.encode()))
            for tidy, over in self._over.items()
            for name in ("ink", "box", "size")
        }
        self.size = (0, 0)
        """Pixels."""
        self._framebuffer, self._texture = made("glGenFramebuffers"), made("glGenTextures")

    def open(self, box: Box) -> None:
        """Bind it, large enough for a box of the framebuffer and without ink there."""
        x, y, width, height = box
        gl.glActiveTexture(_TEXTURE_0 + _UNIT)
        gl.glBindTexture(_TEXTURE_2D, self._texture)
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
        if x + width > self.size[0] or y + height > self.size[1]:
            self._resize(max(x + width, self.size[0]), max(y + height, self.size[1]))
        gl.glDisable(_DEPTH_TEST)
        gl.glEnable(_SCISSOR_TEST)
        gl.glScissor(*box)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClear(0x4000)
        gl.glEnable(_BLEND)
        gl.glBlendEquation(_MAX)

    def bind(self) -> None:
        """Bind it as it is."""
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)

    def put_over(self, framebuffer: int, box: Box, *, tidy: bool) -> None:
        """Lay the ink in a box over a framebuffer, and leave that bound. tidy: without lonely
        specks. The app's stencil test, if it is on, holds."""
        gl.glBindFramebuffer(_FRAMEBUFFER, framebuffer)
        gl.glEnable(_SCISSOR_TEST)
        gl.glScissor(*box)
        gl.glDisable(_DEPTH_TEST)
        gl.glEnable(_BLEND)
        gl.glBlendEquation(_ADD)
        gl.glBlendFunc(_ONE, _REST)
        gl.glViewport(0, 0, *self.size)
        gl.glActiveTexture(_TEXTURE_0 + _UNIT)
        gl.glBindTexture(_TEXTURE_2D, self._texture)
        gl.glUseProgram(self._over[tidy])
        x, y, width, height = box
        gl.glUniform1i(self._at[tidy, "ink"], _UNIT)
        gl.glUniform4f(self._at[tidy, "box"], x + 0.5, y + 0.5, x + width - 0.5, y + height - 0.5)
        gl.glUniform2f(self._at[tidy, "size"], *map(float, self.size))
        # One triangle over everything, in calls that every version has.
        gl.glBegin(0x0004)
        for corner in ((-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)):
            gl.glVertex2f(*corner)
        gl.glEnd()

    def _resize(self, width: int, height: int) -> None:
        self.size = (width, height)
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA_8, width, height, 0, _RGBA, _BYTE, None)
        for parameter in (0x2801, 0x2800):
            gl.glTexParameteri(_TEXTURE_2D, parameter, 0x2600)
        gl.glFramebufferTexture2D(_FRAMEBUFFER, _COLOUR_AT, _TEXTURE_2D, self._texture, 0)
        if gl.glCheckFramebufferStatus(_FRAMEBUFFER) != _COMPLETE:
            raise RenderError("lines need a framebuffer of their own, and none can be made here")
