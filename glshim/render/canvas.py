"""A framebuffer of our own, for windows that have no depth buffer: lines need depth to hide them.

The layer's polygons are laid down here as depth, the lines are drawn against it, and the ink goes
over the app's picture.
"""

from __future__ import annotations

import ctypes
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch
from glshim.errors import RenderError
from glshim.render.driver import gl
from glshim.styling.protocol import Shader

DEPTH_BITS = 24
DEPTH_ONLY = Shader(
    "depth only",
    "void main() {\n"
    "    vec4 eye = modelview * vec4(edge_a, 1.0);\n"
    "    clip_as_the_app(eye);\n"
    "    gl_Position = projection * eye;\n"
    "}\n",
    "void main() {}\n",
    vertices=3,
)
"""Polygons as the app places them, into the depth buffer alone."""
_LARGEST = 8192
_FRAMEBUFFER, _COLOUR_AT, _DEPTH_AT = 0x8D40, 0x8CE0, 0x8D00
_COMPLETE = 0x8CD5
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_RGBA_8, _RGBA, _BYTE = 0x8058, 0x1908, 0x1401
_RENDERBUFFER, _DEPTH_24 = 0x8D41, 0x81A6
_UNIT = 14
_DEPTH_TEST, _SCISSOR_TEST, _STENCIL_TEST = 0x0B71, 0x0C11, 0x0B90


def triangles(batch: PolygonBatch) -> NDArray[np.float32]:
    """(T, 3, 3) the polygons of a batch as fans, object space."""
    starts, sizes = batch.starts[:-1], np.diff(batch.starts)
    count = np.maximum(sizes - 2, 0)
    first = np.repeat(starts, count)
    step = np.arange(len(first)) - np.repeat(np.cumsum(count) - count, count)
    fans = batch.corners[np.stack([first, first + step + 1, first + step + 2], axis=1)]
    return np.ascontiguousarray(batch.positions[fans], np.float32)


class Canvas:
    """Colour and depth of at least a window's size. Make and use it inside the state guard."""

    def __init__(self, context: Any) -> None:
        shaders = files(__package__) / "shaders"
        self._over = context.program(
            vertex_shader=(shaders / "over.vert.glsl").read_text("utf-8"),
            fragment_shader=(shaders / "over.frag.glsl").read_text("utf-8"),
        )
        self._array = context.vertex_array(self._over, [])
        self._size = (0, 0)
        self._framebuffer, self._texture, self._depth = (
            _name(make)
            for make in (gl.glGenFramebuffers, gl.glGenTextures, gl.glGenRenderbuffers)
        )

    def open(self, width: int, height: int, greater: bool) -> None:
        """Bind it, large enough and empty; greater: farther is less depth."""
        gl.glActiveTexture(_TEXTURE_0 + _UNIT)
        gl.glBindTexture(_TEXTURE_2D, self._texture)
        gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
        if width > self._size[0] or height > self._size[1]:
            self._resize(max(width, self._size[0]), max(height, self._size[1]))
        gl.glDisable(_SCISSOR_TEST)
        gl.glDepthMask(1)
        gl.glColorMask(1, 1, 1, 1)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClearDepth(0.0 if greater else 1.0)
        gl.glClear(0x4100)

    def put_over(self, framebuffer: int) -> None:
        """Lay what was drawn since `open` over a framebuffer, and leave that bound."""
        gl.glBindFramebuffer(_FRAMEBUFFER, framebuffer)
        for switch in (_DEPTH_TEST, _SCISSOR_TEST, _STENCIL_TEST):
            gl.glDisable(switch)
        for plane in range(0x3000, 0x3006):
            gl.glDisable(plane)
        gl.glViewport(0, 0, *self._size)
        gl.glActiveTexture(_TEXTURE_0 + _UNIT)
        gl.glBindTexture(_TEXTURE_2D, self._texture)
        self._over["ink"] = _UNIT
        gl.glUseProgram(self._over.glo)
        gl.glBindVertexArray(self._array.glo)
        gl.glDrawArrays(0x0004, 0, 3)

    def _resize(self, width: int, height: int) -> None:
        self._size = (min(width, _LARGEST), min(height, _LARGEST))
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA_8, *self._size, 0, _RGBA, _BYTE, None)
        for parameter in (0x2801, 0x2800):
            gl.glTexParameteri(_TEXTURE_2D, parameter, 0x2600)
        gl.glBindRenderbuffer(_RENDERBUFFER, self._depth)
        gl.glRenderbufferStorage(_RENDERBUFFER, _DEPTH_24, *self._size)
        gl.glFramebufferTexture2D(_FRAMEBUFFER, _COLOUR_AT, _TEXTURE_2D, self._texture, 0)
        gl.glFramebufferRenderbuffer(_FRAMEBUFFER, _DEPTH_AT, _RENDERBUFFER, self._depth)
        if gl.glCheckFramebufferStatus(_FRAMEBUFFER) != _COMPLETE:
            raise RenderError("this window has no depth buffer, and none can be made for it")


def _name(make: Any) -> int:
    value = ctypes.c_uint()
    make(1, ctypes.addressof(value))
    return value.value
