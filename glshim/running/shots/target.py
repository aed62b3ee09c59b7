"""The surface in place of the window: a framebuffer object as large as a tile."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from contextlib import contextmanager

from PIL.Image import Image

from glshim.errors import RenderError
from glshim.outputs.gl.device.guard import Guard, drain
from glshim.outputs.gl.frame.grab import grab
from glshim.running.shots.mapping import Mapping
from glshim.running.shots.plan import Size
from glshim.spec.ask import integer
from glshim.spec.driver import gl

READ, DRAW, BOTH = 0x8CA8, 0x8CA9, 0x8D40
READ_BINDING, DRAW_BINDING = 0x8CAA, 0x8CA6
COLOUR_AT = 0x8CE0
_RENDERBUFFER = 0x8D41
_DEPTH_AT, _STENCIL_AT, _DEPTH_STENCIL_AT = 0x8D00, 0x8D20, 0x821A
_COMPLETE, _SCISSOR_TEST, _NEAREST = 0x8CD5, 0x0C11, 0x2600
_ALPHA_BITS, _DEPTH_BITS, _STENCIL_BITS, _SAMPLES = 0x0D55, 0x0D56, 0x0D57, 0x80A9
_DEPTHS = {16: 0x81A5, 24: 0x81A6, 32: 0x81A7}
_COLOUR, _DEPTH, _STENCIL = 0x4000, 0x100, 0x400


class Target:
    """Make it while the window it stands for is bound; its state stays as it was."""

    def __init__(self, size: Size) -> None:
        """Raises `RenderError` where the driver has no framebuffer of that size."""
        self.size = size
        self._colour = 0x8058 if integer(_ALPHA_BITS) else 0x8051
        depth, stencil = integer(_DEPTH_BITS), integer(_STENCIL_BITS)
        self._depth = 0x88F0 if stencil and depth else _DEPTHS.get(depth, 0x81A6) if depth else 0
        self._depth_at = _DEPTH_STENCIL_AT if stencil and depth else _DEPTH_AT
        self._stencil_alone = bool(stencil and not depth)
        self._samples = integer(_SAMPLES)
        self._small: tuple[Size, int] | None = None
        self._resolved = 0
        with Guard():
            self.name = self._framebuffer(size, self._samples)
            gl.glDisable(_SCISSOR_TEST)
            gl.glColorMask(1, 1, 1, 1)
            gl.glDepthMask(1)
            gl.glClearColor(0.0, 0.0, 0.0, 0.0)
            gl.glClearDepth(1.0)
            gl.glStencilMask(0xFF)
            gl.glClear(_COLOUR | _DEPTH | _STENCIL)

    def picture(self) -> Image:
        """What is drawn, topmost row first."""
        if not self._samples:
            return grab(self.size, self.name)
        with Guard():
            self._blit(self._resolve(), self.size, (0, 0, *self.size), self.name)
        return grab(self.size, self._resolved)

    @contextmanager
    def as_window(self, mapping: Mapping) -> Iterator[None]:
        """For reading: what is drawn, in pixels of the window (where no tile was: `remember`)."""
        bound = integer(READ_BINDING)
        with Guard():
            source, whole = self.name, (0, 0, *self.size)
            if self._samples:  # which cannot be resolved and shrunk at once
                self._blit(self._resolve(), self.size, whole, source)
                source = self._resolved
            small = self._smaller(mapping.window)
            x, y = (-o for o in mapping.origin)
            box = (x, y, x + mapping.sheet[0], y + mapping.sheet[1])
            self._blit(small, mapping.window, box, source)
        gl.glBindFramebuffer(READ, small)
        try:
            yield
        finally:
            gl.glBindFramebuffer(READ, bound)

    def remember(self, window: int, size: Size) -> None:
        """Take what the window's framebuffer holds for what lies outside the tiles to come."""
        with Guard():
            self._blit(self._smaller(size), size, (0, 0, *size), window)

    def _smaller(self, size: Size) -> int:
        if self._small is None or self._small[0] != size:
            self._small = size, self._framebuffer(size, 0)
        return self._small[1]

    def _resolve(self) -> int:
        if not self._resolved:
            self._resolved = self._framebuffer(self.size, 0)
        return self._resolved

    def _blit(self, to: int, size: Size, box: tuple[int, int, int, int], source: int) -> None:
        """Copy a box (corners) of a framebuffer over all of another; inside the guard."""
        gl.glBindFramebuffer(READ, source)
        gl.glBindFramebuffer(DRAW, to)
        gl.glDisable(_SCISSOR_TEST)
        for buffers in (_COLOUR, _DEPTH, _STENCIL):
            gl.glBlitFramebuffer(*box, 0, 0, *size, buffers, _NEAREST)
        drain()

    def _framebuffer(self, size: Size, samples: int) -> int:
        """A framebuffer object with buffers like the window's, bound."""
        name = ctypes.c_uint()
        gl.glGenFramebuffers(1, ctypes.addressof(name))
        gl.glBindFramebuffer(BOTH, name.value)
        self._attach(COLOUR_AT, self._colour, size, samples)
        if self._depth:
            self._attach(self._depth_at, self._depth, size, samples)
        if self._stencil_alone:
            self._attach(_STENCIL_AT, 0x8D48, size, samples)
        if gl.glCheckFramebufferStatus(BOTH) != _COMPLETE or gl.glGetError():
            raise RenderError(f"this GL has no framebuffer of {size[0]}x{size[1]} pixels")
        gl.glDrawBuffer(COLOUR_AT)
        gl.glReadBuffer(COLOUR_AT)
        return name.value

    def _attach(self, where: int, kind: int, size: Size, samples: int) -> None:
        name = ctypes.c_uint()
        gl.glGenRenderbuffers(1, ctypes.addressof(name))
        gl.glBindRenderbuffer(_RENDERBUFFER, name.value)
        if samples:
            gl.glRenderbufferStorageMultisample(_RENDERBUFFER, samples, kind, *size)
        else:
            gl.glRenderbufferStorage(_RENDERBUFFER, kind, *size)
        gl.glFramebufferRenderbuffer(BOTH, where, _RENDERBUFFER, name.value)
