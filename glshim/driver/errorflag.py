"""The error flag: what the program has not fetched yet is kept, and set again by number."""

from __future__ import annotations

from collections.abc import Callable

from glshim.driver.ask import integer
from glshim.driver.context import has_debug_output, has_fixed_function, has_framebuffers
from glshim.driver.functions import gl
from glshim.driver.objects import delete, made
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_ARRAY_BUFFER_BINDING,
    GL_ATTRIB_STACK_DEPTH,
    GL_CLIENT_ATTRIB_STACK_DEPTH,
    GL_DEBUG_GROUP_STACK_DEPTH,
    GL_DEBUG_SOURCE_THIRD_PARTY,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRAMEBUFFER,
    GL_INVALID_ENUM,
    GL_INVALID_FRAMEBUFFER_OPERATION,
    GL_INVALID_OPERATION,
    GL_INVALID_VALUE,
    GL_MATRIX_MODE,
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH,
    GL_MAX_DEBUG_GROUP_STACK_DEPTH,
    GL_MODELVIEW,
    GL_MODELVIEW_STACK_DEPTH,
    GL_OUT_OF_MEMORY,
    GL_PROJECTION,
    GL_PROJECTION_STACK_DEPTH,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_STACK_OVERFLOW,
    GL_STACK_UNDERFLOW,
    GL_STREAM_DRAW,
    GL_TEXTURE,
    GL_TEXTURE_STACK_DEPTH,
)
from glshim.spec.kinds import BUFFER, FRAMEBUFFER

_MOST = 16
"""Flags that are looked at: a context that is lost reports errors for ever."""
_STACKS = (
    (GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH), (GL_PROJECTION, GL_PROJECTION_STACK_DEPTH),
    (GL_TEXTURE, GL_TEXTURE_STACK_DEPTH),
)  # fmt: skip
"""Of matrices, each with its depth."""
_NOWHERE = (1 << 62) - 1
"""More bytes than any machine has."""


def taken() -> list[int]:
    """The errors that are waiting, which wait no more. Drivers may hold several."""
    found: list[int] = []
    while len(found) < _MOST:
        error = int(gl.glGetError())
        if not error:
            break
        found.append(error)
    return found


def drain() -> None:
    """Forget the errors of our own so far."""
    taken()


def put_back(errors: list[int]) -> None:
    """Have errors wait again: each is provoked anew, so that whoever asks the driver hears of it.
    With debug output off, outside primitives and open lists; no other state changes."""
    for error in errors:
        common = _COMMON.get(error)
        if common is not None:
            common()
        elif not any(_gives(error, way) for way in _RARE.get(error, ())):
            _COMMON[GL_INVALID_OPERATION]()


def _gives(error: int, way: Callable[[], object]) -> bool:
    """Whether a way sets the flag to an error, which waits then."""
    way()
    if error not in taken():
        return False
    way()
    return True


def _overflow_client_attributes() -> None:
    if has_fixed_function():
        free = integer(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH) - integer(GL_CLIENT_ATTRIB_STACK_DEPTH)
        for _ in range(free + 1):
            gl.glPushClientAttrib(0)
        for _ in range(free):
            gl.glPopClientAttrib()


def _overflow_debug_groups() -> None:
    if has_debug_output():
        free = integer(GL_MAX_DEBUG_GROUP_STACK_DEPTH) - integer(GL_DEBUG_GROUP_STACK_DEPTH)
        for _ in range(free + 1):
            gl.glPushDebugGroup(GL_DEBUG_SOURCE_THIRD_PARTY, 0, 1, b" ")
        for _ in range(free):
            gl.glPopDebugGroup()


def _underflow_attributes() -> None:
    if has_fixed_function():
        if not integer(GL_CLIENT_ATTRIB_STACK_DEPTH):
            gl.glPopClientAttrib()
        elif not integer(GL_ATTRIB_STACK_DEPTH):
            gl.glPopAttrib()


def _underflow_matrices() -> None:
    if has_fixed_function():
        kept = integer(GL_MATRIX_MODE)
        for mode, depth in _STACKS:
            if integer(depth) == 1:
                gl.glMatrixMode(mode)
                gl.glPopMatrix()
                break
        gl.glMatrixMode(kept)


def _underflow_debug_groups() -> None:
    if has_debug_output() and integer(GL_DEBUG_GROUP_STACK_DEPTH) == 1:
        gl.glPopDebugGroup()


def _ask_for_too_much() -> None:
    name, bound = made(BUFFER), integer(GL_ARRAY_BUFFER_BINDING)
    gl.glBindBuffer(GL_ARRAY_BUFFER, name)
    gl.glBufferData(GL_ARRAY_BUFFER, _NOWHERE, None, GL_STREAM_DRAW)
    gl.glBindBuffer(GL_ARRAY_BUFFER, bound)
    delete(BUFFER, (name,))


def _clear_nothing() -> None:
    """A framebuffer object that has no image."""
    if not has_framebuffers():
        return
    name = made(FRAMEBUFFER)
    draw, read = integer(GL_DRAW_FRAMEBUFFER_BINDING), integer(GL_READ_FRAMEBUFFER_BINDING)
    gl.glBindFramebuffer(GL_FRAMEBUFFER, name)
    gl.glClear(0)
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw)
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, read)
    delete(FRAMEBUFFER, (name,))


_COMMON: dict[int, Callable[[], object]] = {
    GL_INVALID_ENUM: lambda: gl.glEnable(0),
    GL_INVALID_VALUE: lambda: gl.glLineWidth(-1.0),
    GL_INVALID_OPERATION: lambda: gl.glEnd(),  # noqa: PLW0108 (found when it is called)
}
"""What sets the flag for sure."""
_RARE: dict[int, tuple[Callable[[], object], ...]] = {
    GL_STACK_OVERFLOW: (_overflow_client_attributes, _overflow_debug_groups),
    GL_STACK_UNDERFLOW: (_underflow_attributes, _underflow_matrices, _underflow_debug_groups),
    GL_OUT_OF_MEMORY: (_ask_for_too_much,),
    GL_INVALID_FRAMEBUFFER_OPERATION: (_clear_nothing,),
}
"""What may, in the state that the program has left: the first that does is taken."""
