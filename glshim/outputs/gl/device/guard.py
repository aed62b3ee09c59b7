"""The state guard: what runs inside it leaves every GL state and the error flag as they were."""

from __future__ import annotations

from types import TracebackType

from glshim.driver.ask import integer, is_enabled, of_program, settle_attributes
from glshim.driver.context import has_framebuffers, has_pipelines, has_vertex_arrays, version
from glshim.driver.functions import gl
from glshim.driver.unnoticed import Unnoticed
from glshim.spec.constants import (
    GL_ACTIVE_TEXTURE,
    GL_ALL_ATTRIB_BITS,
    GL_ATTRIB_STACK_DEPTH,
    GL_CLIENT_ALL_ATTRIB_BITS,
    GL_CLIENT_ATTRIB_STACK_DEPTH,
    GL_COLOR_SUM,
    GL_CURRENT_PROGRAM,
    GL_DELETE_STATUS,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_LIST_INDEX,
    GL_MATRIX_MODE,
    GL_MAX_ATTRIB_STACK_DEPTH,
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH,
    GL_MIN,
    GL_NO_ERROR,
    GL_PRIMITIVE_RESTART,
    GL_PROGRAM_PIPELINE_BINDING,
    GL_RASTERIZER_DISCARD,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RENDER,
    GL_RENDER_MODE,
    GL_RENDERBUFFER,
    GL_RENDERBUFFER_BINDING,
    GL_TEXTURE_CUBE_MAP_SEAMLESS,
    GL_VERTEX_ARRAY_BINDING,
)

_STACKS = (
    (GL_ATTRIB_STACK_DEPTH, GL_MAX_ATTRIB_STACK_DEPTH),
    (GL_CLIENT_ATTRIB_STACK_DEPTH, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH),
)
_SWITCHES = (
    GL_RASTERIZER_DISCARD,
    GL_PRIMITIVE_RESTART,
    GL_TEXTURE_CUBE_MAP_SEAMLESS,  # which moderngl turns on in a new context
    GL_COLOR_SUM,  # which Mesa forgets
)
"""What no attribute stack gives back. Contexts before 3.0 need not know them."""
_FRAMEBUFFERS = (
    GL_DRAW_FRAMEBUFFER_BINDING, GL_READ_FRAMEBUFFER_BINDING, GL_RENDERBUFFER_BINDING,
)  # fmt: skip


def possible() -> bool:
    """Whether drawing is possible here: no full attribute stack, no list being compiled, no
    selection or feedback going on, and no program in use that is gone once another one is."""
    return (
        all(integer(depth) < integer(most) for depth, most in _STACKS)
        and integer(GL_RENDER_MODE) == GL_RENDER
        and integer(GL_LIST_INDEX) == 0
        and not _uses_a_deleted_program()
    )


def _uses_a_deleted_program() -> bool:
    program = integer(GL_CURRENT_PROGRAM) if (version() or (1, 1)) >= (2, 0) else 0
    return bool(program) and bool(of_program(program, GL_DELETE_STATUS))


class Guard:
    """``with Guard():`` saves on entry and restores on exit. Only where `possible` says so.

    Costs a few microseconds: the attribute stacks hold nearly everything, and the rest is asked
    for and set again. All of it is `Unnoticed`.

    The client's arrays are saved with no vertex array object bound: what is drawn inside may use
    the arrays of the context itself, and the app's objects are not looked into.
    """

    __slots__ = (
        "_array", "_framebuffers", "_mode", "_pipeline", "_program", "_switches", "_texture",
        "_unnoticed", "_version",
    )  # fmt: skip

    def __enter__(self) -> Guard:
        self._unnoticed = Unnoticed()
        self._unnoticed.__enter__()
        try:
            self._save()
        except BaseException:
            self._unnoticed.__exit__()
            raise
        return self

    def _save(self) -> None:
        self._version = number = version() or (1, 1)
        self._program = integer(GL_CURRENT_PROGRAM) if number >= (2, 0) else None
        self._pipeline = integer(GL_PROGRAM_PIPELINE_BINDING) if has_pipelines() else 0
        framebuffers = _FRAMEBUFFERS if has_framebuffers() else ()
        self._framebuffers = [integer(name) for name in framebuffers]
        self._mode = integer(GL_MATRIX_MODE)
        self._texture = integer(GL_ACTIVE_TEXTURE) if number >= (1, 3) else None
        self._array = integer(GL_VERTEX_ARRAY_BINDING) if has_vertex_arrays() else None
        asked = ((switch, is_enabled(switch)) for switch in _SWITCHES)
        self._switches = [known for known in asked if gl.glGetError() == GL_NO_ERROR]
        if self._pipeline:  # which is in use where no program is
            gl.glBindProgramPipeline(0)
        if self._array:
            gl.glBindVertexArray(0)
        gl.glPushAttrib(GL_ALL_ATTRIB_BITS)
        gl.glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        try:
            self._restore()
        finally:
            self._unnoticed.__exit__()

    def _restore(self) -> None:
        if self._program is not None:
            gl.glUseProgram(self._program)
        if self._pipeline:
            gl.glBindProgramPipeline(self._pipeline)
        if self._framebuffers:
            draw, read, renderbuffer = self._framebuffers
            gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw)
            gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, read)
            gl.glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer)
        if self._array is not None:
            gl.glBindVertexArray(0)
        if self._version >= (4, 0):
            # So that Mesa pops what each buffer has of its own: it looks at what is set now.
            gl.glBlendEquationi(1, GL_MIN)
        gl.glPopClientAttrib()
        settle_attributes()
        gl.glPopAttrib()
        if self._texture is not None:
            gl.glActiveTexture(self._texture)
        gl.glMatrixMode(self._mode)  # Mesa 22 pops it before the unit whose stack it may mean
        if self._array:
            gl.glBindVertexArray(self._array)
        for switch, on in self._switches:
            (gl.glEnable if on else gl.glDisable)(switch)
