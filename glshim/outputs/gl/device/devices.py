"""What makes programs and buffers in a context: moderngl from OpenGL 3.3 on, before it the bare
driver. Which of the two is chosen once a context, by `attach`."""

from __future__ import annotations

import ctypes
from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import Any, ClassVar
from weakref import WeakSet

import moderngl

from glshim.driver.context import MODERN, OLDEST, version
from glshim.driver.functions import gl
from glshim.driver.objects import delete, losses, made_program
from glshim.errors import RenderError
from glshim.outputs.gl.device.connection import connection
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.programs import Program
from glshim.spec.constants import GL_FRAGMENT_SHADER, GL_LINK_STATUS, GL_VERTEX_SHADER
from glshim.spec.kinds import PROGRAM

_INFO_BYTES = 4096
"""Of what a driver says about a shader, at most."""


class Device(ABC):
    """Makes objects in the context that is current when it is made, while that is current."""

    modern: ClassVar[bool]
    """Whether the context has what OpenGL 3.3 has."""

    def __init__(self) -> None:
        self._losses = losses()

    @property
    def is_whole(self) -> bool:
        """Whether the program has left its programs alone."""
        return losses() == self._losses

    @abstractmethod
    def program(self, name: str, vertex: str, fragment: str = "") -> Program:
        """From GLSL texts; an empty one leaves its stage to the fixed function. Raises
        `RenderError` with the driver's words when it does not compile. No other state changes."""

    def abandon(self) -> None:  # noqa: B027
        """Its context is gone, and its objects with it: free the memory that they take on our side.
        Calls no GL."""


def attach() -> Device:
    """A device of the current context, whose state stays as it was. Outside the state guard."""
    if (version() or OLDEST) < MODERN or not possible():  # what moderngl sets could not be undone
        return LegacyDevice()
    with Guard():
        return ModernDevice()


class ModernDevice(Device):
    """Through moderngl. Make it inside the state guard."""

    modern = True

    def __init__(self) -> None:
        super().__init__()
        self._connection = connection()
        self._made: WeakSet[Any] = WeakSet()
        """Objects of moderngl's, whose memory is free only when each has been released."""

    def program(
        self,
        name: str,
        vertex: str,
        fragment: str = "",
        geometry: str = "",
        captured: Sequence[str] = (),
    ) -> Program:
        """See `Device.program`; also with a geometry stage. captured: outputs that transform
        feedback takes."""
        try:
            linked = self._connection.context.program(
                vertex_shader=vertex, fragment_shader=fragment or None,
                geometry_shader=geometry or None, varyings=tuple(captured),
            )  # fmt: skip
        except moderngl.Error as error:
            lines = (line.strip("= ") for line in str(error).splitlines())
            raise _not_compiled(name, " ".join(filter(None, lines))) from error
        self._made.add(linked)
        for shader in _attached(linked.glo):
            gl.glDetachShader(linked.glo, shader)
        return Program(linked)

    def buffer(self, size: int, *, dynamic: bool = False) -> Any:
        """A buffer of moderngl's with room for so many bytes, one at least. Inside the guard: it
        binds what it makes and writes to ``GL_ARRAY_BUFFER``."""
        made = self._connection.context.buffer(reserve=max(size, 1), dynamic=dynamic)
        self._made.add(made)
        return made

    def abandon(self) -> None:
        """See `Device.abandon`."""
        self._connection.forget(list(self._made))


class LegacyDevice(Device):
    """By the bare driver, with what OpenGL 2.1 has."""

    modern = False

    def program(self, name: str, vertex: str, fragment: str = "") -> Program:
        """See `Device.program`."""
        made = _Bare()
        for kind, text in ((GL_VERTEX_SHADER, vertex), (GL_FRAGMENT_SHADER, fragment)):
            if text:
                made.attach(kind, text)
        words = made.link()
        if words is not None:
            made.release()
            raise _not_compiled(name, words)
        return Program(made)


class _Bare:
    """A program of the driver's (`glshim.outputs.gl.device.programs.Linked`)."""

    def __init__(self) -> None:
        self.glo = made_program()

    def attach(self, kind: int, text: str) -> None:
        """A stage of it."""
        shader = gl.glCreateShader(kind)
        source = text.encode("utf-8")
        pointer, length = ctypes.c_char_p(source), ctypes.c_int(len(source))
        gl.glShaderSource(shader, 1, ctypes.byref(pointer), ctypes.byref(length))
        gl.glCompileShader(shader)
        gl.glAttachShader(self.glo, shader)
        gl.glDeleteShader(shader)

    def link(self) -> str | None:
        """Finish it; what the driver says where that cannot be done."""
        linked = ctypes.c_int()
        gl.glLinkProgram(self.glo)
        gl.glGetProgramiv(self.glo, GL_LINK_STATUS, ctypes.byref(linked))
        words = None if linked.value else self._words()
        for shader in _attached(self.glo):
            gl.glDetachShader(self.glo, shader)
        return words

    def release(self) -> None:
        """Delete it. In its context."""
        delete(PROGRAM, (self.glo,))

    def _words(self) -> str:
        """What the driver says about it and its shaders."""
        text = ctypes.create_string_buffer(_INFO_BYTES)
        gl.glGetProgramInfoLog(self.glo, len(text), None, text)
        said = [text.value]
        for shader in _attached(self.glo):
            gl.glGetShaderInfoLog(shader, len(text), None, text)
            said.append(text.value)
        return b" ".join(said).decode("utf-8", "replace").strip()


def _attached(program: int) -> list[int]:
    """The shaders of a program, which have names as long as they are."""
    count, shaders = ctypes.c_int(), (ctypes.c_uint * 8)()
    gl.glGetAttachedShaders(program, len(shaders), ctypes.byref(count), shaders)
    return shaders[: count.value]


def _not_compiled(name: str, words: str) -> RenderError:
    return RenderError(f"shader {name!r} does not compile: {words}")
