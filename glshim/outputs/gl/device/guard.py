"""The state guard: what runs inside it leaves every GL state and the error flag as they were."""

from __future__ import annotations

import ctypes
from types import TracebackType

from glshim.spec.ask import integer
from glshim.spec.context import has_framebuffers, has_vertex_arrays, version
from glshim.spec.driver import gl

_ALL = 0xFFFFFFFF
_RENDER = 0x1C00
_NO_ERROR = 0

_STACKS = (0x0BB0, 0x0D35, 0x0BB1, 0x0D3B)  # attribute stack depth, its limit; the client's
_RENDER_MODE, _MATRIX_MODE = 0x0C40, 0x0BA0
_LIST_INDEX = 0x0B33
_PROGRAM = 0x8B8D
_VERTEX_ARRAY = 0x85B5
_DRAW_FRAMEBUFFER, _READ_FRAMEBUFFER = 0x8CA6, 0x8CAA
_RENDERBUFFER = 0x8CA7
_ACTIVE_TEXTURE = 0x84E0
_SWITCHES = (
    0x8C89,  # rasterizer discard
    0x8F9D,  # primitive restart
    0x8458,  # colour sum, which Mesa forgets
)
"""What no attribute stack gives back. Contexts before 3.0 need not know them."""
_FRAMEBUFFERS = (_DRAW_FRAMEBUFFER, _READ_FRAMEBUFFER, _RENDERBUFFER)


def possible() -> bool:
    """Whether drawing is possible here: no full attribute stack, no list being compiled, no
    selection or feedback going on."""
    value = ctypes.c_int()
    at = ctypes.addressof(value)
    got = []
    for name in (*_STACKS, _RENDER_MODE, _LIST_INDEX):
        gl.glGetIntegerv(name, at)
        got.append(value.value)
    return got[0] < got[1] and got[2] < got[3] and got[4] == _RENDER and got[5] == 0


class Guard:
    """``with Guard():`` saves on entry and restores on exit. Only where `possible` says so.

    Costs a few microseconds: the attribute stacks hold nearly everything, and the rest is asked
    for and set again. An error the app has not fetched yet is put back.

    The client's arrays are saved with no vertex array object bound: what is drawn inside may use
    the arrays of the context itself, and the app's objects are not looked into.
    """

    __slots__ = ("_array", "_error", "_framebuffers", "_mode", "_program", "_switches", "_texture")

    def __enter__(self) -> Guard:
        self._error = gl.glGetError()
        number = version() or (1, 1)
        self._program = integer(_PROGRAM) if number >= (2, 0) else None
        framebuffers = _FRAMEBUFFERS if has_framebuffers() else ()
        self._framebuffers = [integer(name) for name in framebuffers]
        self._mode = integer(_MATRIX_MODE)
        self._texture = integer(_ACTIVE_TEXTURE) if number >= (1, 3) else None
        self._array = integer(_VERTEX_ARRAY) if has_vertex_arrays() else None
        asked = ((switch, bool(gl.glIsEnabled(switch))) for switch in _SWITCHES)
        self._switches = [known for known in asked if gl.glGetError() == _NO_ERROR]
        if self._array:
            gl.glBindVertexArray(0)
        gl.glPushAttrib(_ALL)
        gl.glPushClientAttrib(_ALL)
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._program is not None:
            gl.glUseProgram(self._program)
        if self._framebuffers:
            draw, read, renderbuffer = self._framebuffers
            gl.glBindFramebuffer(0x8CA9, draw)
            gl.glBindFramebuffer(0x8CA8, read)
            gl.glBindRenderbuffer(0x8D41, renderbuffer)
        if self._array is not None:
            gl.glBindVertexArray(0)
        gl.glPopClientAttrib()
        gl.glPopAttrib()
        if self._texture is not None:
            gl.glActiveTexture(self._texture)
        gl.glMatrixMode(self._mode)  # Mesa 22 pops it before the unit whose stack it may mean
        if self._array:
            gl.glBindVertexArray(self._array)
        for switch, on in self._switches:
            (gl.glEnable if on else gl.glDisable)(switch)
        drain()
        if self._error:
            _provoke(self._error)


def drain() -> None:
    """Forget the errors of our own so far."""
    for _ in range(16):  # a lost context reports errors for ever
        if gl.glGetError() == _NO_ERROR:
            break


def _provoke(error: int) -> None:
    """Set the error flag to one of the three common errors again."""
    if error == 0x0500:  # invalid enum
        gl.glEnable(0)
    elif error == 0x0501:  # invalid value
        gl.glLineWidth(-1.0)
    else:  # invalid operation; the rarer ones cannot be had on purpose
        gl.glEnd()
