"""The surface in place of the window: a framebuffer object as large as a tile."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from PIL.Image import Image

from glshim.driver.ask import integer
from glshim.driver.errorflag import drain
from glshim.driver.functions import gl
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.frame.grab import grab
from glshim.running.shots.mapping import Mapping
from glshim.running.shots.plan import Size
from glshim.spec.constants import (
    GL_ALPHA_BITS,
    GL_COLOR_BUFFER_BIT,
    GL_DEPTH24_STENCIL8,
    GL_DEPTH_BITS,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_COMPONENT16,
    GL_DEPTH_COMPONENT24,
    GL_DEPTH_COMPONENT32,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_NEAREST,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RGB8,
    GL_RGBA8,
    GL_SAMPLES,
    GL_SCISSOR_TEST,
    GL_STENCIL_BITS,
    GL_STENCIL_BUFFER_BIT,
    GL_STENCIL_INDEX8,
)

_DEPTHS = {
    16: GL_DEPTH_COMPONENT16, 24: GL_DEPTH_COMPONENT24, 32: GL_DEPTH_COMPONENT32,
}  # fmt: skip
"""Formats by the bits of a window's depth buffer."""


class Target:
    """Make it while the window it stands for is bound; its state stays as it was."""

    def __init__(self, size: Size) -> None:
        """Raises `RenderError` where the driver has no framebuffer of that size."""
        self.size = size
        self._samples = integer(GL_SAMPLES)
        formats = _formats_of_the_window()
        self._drawn = RenderTarget(buffers=formats, samples=self._samples)
        self._resolved = RenderTarget(buffers=formats)
        """What is drawn, a sample a pixel."""
        self._small = RenderTarget(buffers=formats)
        """What is drawn, in pixels of the window."""
        with Guard():
            self._drawn.fit(*size)
            gl.glDisable(GL_SCISSOR_TEST)
            gl.glColorMask(1, 1, 1, 1)
            gl.glDepthMask(1)
            gl.glClearColor(0.0, 0.0, 0.0, 0.0)
            gl.glClearDepth(1.0)
            gl.glStencilMask(0xFF)
            gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)

    @property
    def name(self) -> int:
        """Of the framebuffer object that is drawn into."""
        return self._drawn.name

    @property
    def is_drawn_to(self) -> bool:
        """Whether it is bound to be drawn into."""
        return integer(GL_DRAW_FRAMEBUFFER_BINDING) == self.name

    @property
    def is_read(self) -> bool:
        """Whether it is bound to be read from."""
        return integer(GL_READ_FRAMEBUFFER_BINDING) == self.name

    def bind(self) -> None:
        """Draw into it and read from it from now on."""
        self._drawn.bind()

    def picture(self) -> Image:
        """What is drawn, topmost row first."""
        if not self._samples:
            return grab(self.size, self.name)
        with Guard():
            self._resolve()
        return grab(self.size, self._resolved.name)

    @contextmanager
    def as_window(self, mapping: Mapping) -> Iterator[None]:
        """For reading: what is drawn, in pixels of the window (where no tile was: `remember`)."""
        bound = integer(GL_READ_FRAMEBUFFER_BINDING)
        with Guard():
            source = self._drawn
            if self._samples:  # which cannot be resolved and shrunk at once
                source = self._resolve()
            x, y = (-o for o in mapping.origin)
            box = (x, y, x + mapping.sheet[0], y + mapping.sheet[1])
            _blit(source.name, box, self._small, mapping.window)
        self._small.bind(GL_READ_FRAMEBUFFER)
        try:
            yield
        finally:
            gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, bound)

    def remember(self, window: int, size: Size) -> None:
        """Take what the window's framebuffer holds for what lies outside the tiles to come."""
        with Guard():
            _blit(window, (0, 0, *size), self._small, size)

    def release(self) -> None:
        """Delete it. In its context."""
        for target in (self._drawn, self._resolved, self._small):
            target.release()

    def _resolve(self) -> RenderTarget:
        """What is drawn, a sample a pixel; inside the guard."""
        _blit(self.name, (0, 0, *self.size), self._resolved, self.size)
        return self._resolved


def _formats_of_the_window() -> list[int]:
    """Formats like those of the framebuffer that is bound."""
    depth, stencil = integer(GL_DEPTH_BITS), integer(GL_STENCIL_BITS)
    found = [GL_RGBA8 if integer(GL_ALPHA_BITS) else GL_RGB8]
    if depth and stencil:
        found.append(GL_DEPTH24_STENCIL8)
    elif depth:
        found.append(_DEPTHS.get(depth, GL_DEPTH_COMPONENT24))
    elif stencil:
        found.append(GL_STENCIL_INDEX8)
    return found


def _blit(source: int, box: tuple[int, int, int, int], to: RenderTarget, size: Size) -> None:
    """Copy a box (corners) of a framebuffer over a size of another; inside the guard."""
    to.fit(*size)
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, source)
    to.bind(GL_DRAW_FRAMEBUFFER)
    gl.glDisable(GL_SCISSOR_TEST)
    for buffers in (GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT):
        gl.glBlitFramebuffer(*box, 0, 0, *size, buffers, GL_NEAREST)
    drain()
