"""Framebuffer objects of ours: one kind for all that is drawn elsewhere than into the app's."""

from __future__ import annotations

from collections.abc import Sequence

from glshim.driver import kinds
from glshim.driver.functions import gl
from glshim.driver.objects import delete, made
from glshim.errors import RenderError
from glshim.spec.constants import (
    GL_COLOR_ATTACHMENT0,
    GL_DEPTH24_STENCIL8,
    GL_DEPTH_ATTACHMENT,
    GL_DEPTH_COMPONENT,
    GL_DEPTH_COMPONENT16,
    GL_DEPTH_COMPONENT24,
    GL_DEPTH_COMPONENT32,
    GL_DEPTH_COMPONENT32F,
    GL_DEPTH_STENCIL,
    GL_DEPTH_STENCIL_ATTACHMENT,
    GL_FLOAT,
    GL_FRAMEBUFFER,
    GL_FRAMEBUFFER_COMPLETE,
    GL_NEAREST,
    GL_NONE,
    GL_PIXEL_UNPACK_BUFFER,
    GL_RENDERBUFFER,
    GL_RG32UI,
    GL_RG_INTEGER,
    GL_RGB8,
    GL_RGBA,
    GL_RGBA8,
    GL_RGBA32F,
    GL_RGBA32UI,
    GL_RGBA_INTEGER,
    GL_STENCIL_ATTACHMENT,
    GL_STENCIL_INDEX8,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MIN_FILTER,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_INT_24_8,
)
from glshim.spec.kinds import FRAMEBUFFER, RENDERBUFFER, TEXTURE

_COLOURS = {
    GL_RGB8: (GL_RGBA, GL_UNSIGNED_BYTE),
    GL_RGBA8: (GL_RGBA, GL_UNSIGNED_BYTE),
    GL_RGBA32F: (GL_RGBA, GL_FLOAT),
    GL_RGBA32UI: (GL_RGBA_INTEGER, GL_UNSIGNED_INT),
    GL_RG32UI: (GL_RG_INTEGER, GL_UNSIGNED_INT),
}
"""Layout and type of pixels for a texture of each format."""
_DEPTHS = {
    GL_DEPTH_COMPONENT16: (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
    GL_DEPTH_COMPONENT24: (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
    GL_DEPTH_COMPONENT32: (GL_DEPTH_COMPONENT, GL_UNSIGNED_INT),
    GL_DEPTH_COMPONENT32F: (GL_DEPTH_COMPONENT, GL_FLOAT),
    GL_DEPTH24_STENCIL8: (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8),
}
_LAYOUTS = _COLOURS | _DEPTHS
_ATTACHMENTS = {
    **dict.fromkeys(_COLOURS, GL_COLOR_ATTACHMENT0),
    **dict.fromkeys(_DEPTHS, GL_DEPTH_ATTACHMENT),
    GL_DEPTH24_STENCIL8: GL_DEPTH_STENCIL_ATTACHMENT,
    GL_STENCIL_INDEX8: GL_STENCIL_ATTACHMENT,
}
"""Where an image of each format is attached."""


class RenderTarget:
    """A framebuffer object as large as the largest window so far: it grows and never shrinks.

    Make it anywhere; nothing of GL is made before `fit`. Use it inside the state guard.
    """

    def __init__(
        self, texture: int = 0, buffers: Sequence[int] = (), *, unit: int = 0, samples: int = 0,
        deep: tuple[int, int] | None = None,
    ) -> None:
        """texture: the format of an image that shaders look up pixel for pixel, at a texture unit;
        0: there is none. buffers: formats of images that are only drawn to, of so many samples a
        pixel (0: plain ones). deep: format and unit of a second texture, its depth."""
        self._format, self._buffers = texture, tuple(buffers)
        self._unit, self._samples = unit, samples
        self.name = 0
        """Of the framebuffer object."""
        self.texture = 0
        """Name."""
        self.depth = 0
        """Name of the texture of its depth."""
        self._deep = deep
        self.size = (0, 0)
        """Pixels."""
        self._renderbuffers: list[int] = []

    def fit(self, width: int, height: int) -> None:
        """Have room for so many pixels, and bind it where it had too few. What it held is lost
        then. Raises `RenderError` where the driver has no such framebuffer."""
        if self.name and not kinds.is_there(FRAMEBUFFER, self.name):  # the program has deleted it
            self.release()
        if width <= self.size[0] and height <= self.size[1]:
            return
        if not self.name:
            self.name = made(FRAMEBUFFER)
            self.texture = made(TEXTURE) if self._format else 0
            self.depth = 0 if self._deep is None else made(TEXTURE)
            self._renderbuffers = [made(RENDERBUFFER) for _ in self._buffers]
        size = max(width, self.size[0]), max(height, self.size[1])
        self.bind()
        if self._format:
            self.bind_texture()
            self._attach_texture(self.texture, self._format, size)
        if self._deep is not None:
            self.bind_depth()
            self._attach_texture(self.depth, self._deep[0], size)
        for name, kind in zip(self._renderbuffers, self._buffers, strict=True):
            self._attach_buffer(name, kind, size)
        if not any(kind in _COLOURS for kind in (self._format, *self._buffers)):
            gl.glDrawBuffer(GL_NONE)
            gl.glReadBuffer(GL_NONE)
        if gl.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE:
            raise RenderError("this GL has no framebuffer of {}x{} pixels".format(*size))
        self.size = size

    def bind(self, target: int = GL_FRAMEBUFFER) -> None:
        """Draw into it from now on, and read from it; or one of both."""
        gl.glBindFramebuffer(target, self.name)

    def bind_texture(self) -> None:
        """Let shaders look its texture up, at its unit."""
        gl.glActiveTexture(GL_TEXTURE0 + self._unit)
        gl.glBindTexture(GL_TEXTURE_2D, self.texture)

    def bind_depth(self) -> None:
        """Let shaders look its depth up, at the unit of that."""
        assert self._deep is not None
        gl.glActiveTexture(GL_TEXTURE0 + self._deep[1])
        gl.glBindTexture(GL_TEXTURE_2D, self.depth)

    def release(self) -> None:
        """Delete all of it. In its context."""
        if self.name:
            delete(FRAMEBUFFER, (self.name,))
            delete(TEXTURE, (self.texture, self.depth))
            delete(RENDERBUFFER, self._renderbuffers)
        self.name = self.texture = self.depth = 0
        self._renderbuffers = []
        self.size = (0, 0)

    def _attach_texture(self, name: int, kind: int, size: tuple[int, int]) -> None:
        """The texture that is bound."""
        gl.glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0)
        gl.glTexImage2D(GL_TEXTURE_2D, 0, kind, *size, 0, *_LAYOUTS[kind], None)
        for filtering in (GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER):
            gl.glTexParameteri(GL_TEXTURE_2D, filtering, GL_NEAREST)
        at = _ATTACHMENTS[kind]
        gl.glFramebufferTexture2D(GL_FRAMEBUFFER, at, GL_TEXTURE_2D, name, 0)

    def _attach_buffer(self, name: int, kind: int, size: tuple[int, int]) -> None:
        gl.glBindRenderbuffer(GL_RENDERBUFFER, name)
        if self._samples:
            gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, self._samples, kind, *size)
        else:
            gl.glRenderbufferStorage(GL_RENDERBUFFER, kind, *size)
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, _ATTACHMENTS[kind], GL_RENDERBUFFER, name)
