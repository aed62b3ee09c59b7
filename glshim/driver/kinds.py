"""Objects of each kind in the driver: made, asked about and deleted by name, past every hook."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable

from glshim.driver.ask import integer, text
from glshim.driver.context import list_is_open
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_BUFFER_SIZE,
    GL_EXTENSIONS,
    GL_TEXTURE_WIDTH,
)
from glshim.spec.kinds import BUFFER, PROGRAM, TEXTURE, Kind

ASKED = (TEXTURE, BUFFER)
"""Kinds whose objects can be made without a binding (EXT_direct_state_access)."""


def generate(kind: Kind, number: int) -> list[int]:
    """Some names of the driver's choice."""
    if kind is PROGRAM:
        return [int(gl.glCreateProgram()) for _ in range(number)]
    names = (ctypes.c_uint * number)()
    getattr(gl, f"glGen{kind.plural}")(number, ctypes.addressof(names))
    return list(names)


def delete(kind: Kind, names: Iterable[int]) -> None:
    """As the driver does it."""
    listed = list(names)
    if kind is PROGRAM:
        for name in listed:
            gl.glDeleteProgram(name)
        return
    values = (ctypes.c_uint * len(listed))(*listed)
    getattr(gl, f"glDelete{kind.plural}")(len(listed), ctypes.addressof(values))


def is_there(kind: Kind, name: int) -> bool:
    """Whether an object has that name."""
    if kind is PROGRAM:
        return bool(gl.glIsProgram(name) or gl.glIsShader(name))
    return bool(getattr(gl, f"glIs{kind.singular}")(name))


def create(kind: Kind, name: int, target: int = 0, binding: int = 0) -> None:
    """An empty object of a name, of its own target or another one with its binding; what was bound
    is bound again."""
    if list_is_open() and kind in ASKED and _made_by_a_question(kind, name, target):
        return
    before = integer(binding or kind.binding)
    bind = getattr(gl, kind.bind)
    bind(target or kind.target, name)
    bind(target or kind.target, before)


def _made_by_a_question(kind: Kind, name: int, target: int) -> bool:
    """Without a binding, which might go into the list that is open, or be refused inside its
    primitive. These questions make what they ask about; False where the driver lacks them."""
    value = ctypes.byref(ctypes.c_int(0))
    try:
        if kind is TEXTURE:
            gl.glGetTextureLevelParameterivEXT(
                name, target or kind.target, 0, GL_TEXTURE_WIDTH, value
            )
        else:
            gl.glGetNamedBufferParameterivEXT(name, GL_BUFFER_SIZE, value)
    except AttributeError:
        return False
    return True


def is_free(kind: Kind) -> bool:
    """Whether names may be chosen in the current context, of a compatibility profile."""
    return not kind.extension or kind.extension in text(GL_EXTENSIONS).split()
