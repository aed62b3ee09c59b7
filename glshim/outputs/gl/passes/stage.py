"""Where passes draw: a canvas with a depth buffer that begins as the layer's, and a stencil."""

from __future__ import annotations

from importlib.resources import files

from glshim.errors import RenderError
from glshim.outputs.gl.device.programs import compiled
from glshim.outputs.gl.device.uploads import made
from glshim.outputs.gl.frame.canvas import Canvas
from glshim.outputs.gl.frame.depth import UNIT, Box
from glshim.spec.driver import gl

_FRAMEBUFFER, _RENDERBUFFER, _COMPLETE = 0x8D40, 0x8D41, 0x8CD5
_DEPTH_24_STENCIL_8, _DEPTH_STENCIL_AT = 0x88F0, 0x821A
_DEPTH_TEST, _ALWAYS = 0x0B71, 0x0207
NOTHING_DRAWN = 255
"""What the stencil begins with (McGuire & Hughes 2004, section 3.4)."""


class Stage:
    """Make and use it inside the state guard, in a context of OpenGL 3.3."""

    def __init__(self) -> None:
        self._canvas = Canvas(modern=True)
        shaders = files("glshim.outputs.gl") / "shaders"
        texts = ((shaders / f"seed.{kind}.glsl").read_text("utf-8") for kind in ("vert", "frag"))
        self._seed = compiled("seed", *texts)
        self._depth_at = int(gl.glGetUniformLocation(self._seed, b"finished_depth"))
        self._buffer = made("glGenRenderbuffers")
        self._size = (0, 0)

    def open(self, box: Box, *, deep: bool = True) -> None:
        """Bind it: no colour, the finished depth (bound at its unit), stencil `NOTHING_DRAWN`.
        deep: whether depth matters; else it is anything."""
        self._canvas.open(box)
        if self._canvas.size != self._size:
            self._size = self._canvas.size
            gl.glBindRenderbuffer(_RENDERBUFFER, self._buffer)
            gl.glRenderbufferStorage(_RENDERBUFFER, _DEPTH_24_STENCIL_8, *self._size)
            gl.glFramebufferRenderbuffer(
                _FRAMEBUFFER, _DEPTH_STENCIL_AT, _RENDERBUFFER, self._buffer
            )
            if gl.glCheckFramebufferStatus(_FRAMEBUFFER) != _COMPLETE:
                raise RenderError("a framebuffer with depth and stencil cannot be made here")
        gl.glStencilMask(0xFF)
        gl.glClearStencil(NOTHING_DRAWN)
        gl.glClear(0x0400)
        if not deep:
            return
        gl.glViewport(0, 0, *self._size)
        gl.glDepthRange(0.0, 1.0)
        gl.glColorMask(0, 0, 0, 0)
        gl.glEnable(_DEPTH_TEST)
        gl.glDepthFunc(_ALWAYS)
        gl.glDepthMask(1)
        gl.glUseProgram(self._seed)
        gl.glUniform1i(self._depth_at, UNIT)
        gl.glBegin(0x0004)
        for corner in ((-1.0, -1.0), (3.0, -1.0), (-1.0, 3.0)):
            gl.glVertex2f(*corner)
        gl.glEnd()

    def reopen(self) -> None:
        """Bind it again as it is."""
        self._canvas.bind()

    def put_over(self, framebuffer: int, box: Box) -> None:
        """Lay the colour over a framebuffer, and leave that bound."""
        gl.glDepthMask(0)
        gl.glStencilMask(0)
        gl.glColorMask(1, 1, 1, 1)
        self._canvas.put_over(framebuffer, box, tidy=False)
