"""Kinds of objects by how they get their names, as data."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_ARRAY_BUFFER_BINDING,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_RENDERBUFFER,
    GL_RENDERBUFFER_BINDING,
    GL_TEXTURE_2D,
    GL_TEXTURE_BINDING_2D,
)


@dataclass(frozen=True, slots=True, eq=False)
class Kind:
    """Of objects that are named alike."""

    plural: str
    """As glGen* and glDelete* have it."""
    singular: str
    """As glIs* has it."""
    bind: str = ""
    """What makes an object of any name, in a compatibility profile; nothing where no call does."""
    target: int = 0
    binding: int = 0
    extension: str = ""
    """Of what makes it, where that is one."""


_FRAMEBUFFERS = "GL_EXT_framebuffer_object"
TEXTURE = Kind("Textures", "Texture", "glBindTexture", GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D)
BUFFER = Kind("Buffers", "Buffer", "glBindBuffer", GL_ARRAY_BUFFER, GL_ARRAY_BUFFER_BINDING)
FRAMEBUFFER = Kind(
    "Framebuffers", "Framebuffer", "glBindFramebufferEXT", GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING, _FRAMEBUFFERS,
)  # fmt: skip
RENDERBUFFER = Kind(
    "Renderbuffers", "Renderbuffer", "glBindRenderbufferEXT", GL_RENDERBUFFER,
    GL_RENDERBUFFER_BINDING, _FRAMEBUFFERS,
)  # fmt: skip
PROGRAM = Kind("Programs", "Program")
"""Programs and shaders, which share names: the driver's choice in every profile."""
