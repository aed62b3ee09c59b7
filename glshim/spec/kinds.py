"""Kinds of objects by how they get their names, and the driver's calls for each."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from dataclasses import dataclass

from glshim.spec.ask import integer, text
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_ARRAY_BUFFER_BINDING,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_EXTENSIONS,
    GL_RENDERBUFFER,
    GL_RENDERBUFFER_BINDING,
    GL_TEXTURE_2D,
    GL_TEXTURE_BINDING_2D,
)
from glshim.spec.driver import gl


@dataclass(frozen=True, slots=True, eq=False)
class Kind:
    """Of objects that are named alike."""

    plural: str
    """As glGen* and glDelete* have it."""
    singular: str
    """As glIs* has it."""
    bind: str
    """What makes an object of any name, in a compatibility profile."""
    target: int
    binding: int
    extension: str = ""
    """Of what makes it, where that is one."""

    def generate(self, number: int) -> list[int]:
        """Some names of the driver's choice."""
        names = (ctypes.c_uint * number)()
        getattr(gl, f"glGen{self.plural}")(number, ctypes.addressof(names))
        return list(names)

    def delete(self, names: Iterable[int]) -> None:
        """As the driver does it."""
        listed = list(names)
        values = (ctypes.c_uint * len(listed))(*listed)
        getattr(gl, f"glDelete{self.plural}")(len(listed), ctypes.addressof(values))

    def is_there(self, name: int) -> bool:
        """Whether an object has that name."""
        return bool(getattr(gl, f"glIs{self.singular}")(name))

    def create(self, name: int, target: int = 0, binding: int = 0) -> None:
        """An empty object of a name, of its own target or another one with its binding; what was
        bound is bound again."""
        before = integer(binding or self.binding)
        bind = getattr(gl, self.bind)
        bind(target or self.target, name)
        bind(target or self.target, before)

    @property
    def is_free(self) -> bool:
        """Whether names may be chosen in the current context, of a compatibility profile."""
        return not self.extension or self.extension in text(GL_EXTENSIONS).split()


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


class _Programs(Kind):
    """Programs and shaders, which share names: the driver's choice in every profile."""

    def generate(self, number: int) -> list[int]:
        return [int(gl.glCreateProgram()) for _ in range(number)]

    def delete(self, names: Iterable[int]) -> None:
        for name in names:
            gl.glDeleteProgram(name)

    def is_there(self, name: int) -> bool:
        return bool(gl.glIsProgram(name) or gl.glIsShader(name))


PROGRAM = _Programs("Programs", "Program", "", 0, 0)
