"""Programs: moderngl's, and through the bare driver, in GLSL that every version from 2.1 on has."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping, Sequence
from typing import Any

import moderngl
import numpy as np

from glshim.errors import RenderError
from glshim.spec.driver import gl

_VERTEX, _FRAGMENT = 0x8B31, 0x8B30
_LINKED = 0x8B82


class Program:
    """A program of moderngl's; uniforms that it does not have are passed over."""

    def __init__(self, made: Any) -> None:
        self.made = made
        self.name = int(made.glo)
        members = {name: made[name] for name in made}
        self._uniforms = {n: m for n, m in members.items() if isinstance(m, moderngl.Uniform)}
        self._said: dict[str, Any] = {}

    def wants(self, name: str) -> bool:
        """Whether it has a uniform."""
        return name in self._uniforms

    def set(self, values: Mapping[str, Any]) -> None:
        """Uniforms by name; arrays as they lie in memory, columns first, and not to be changed
        later: what is there already is not sent again."""
        for name, value in values.items():
            found = self._uniforms.get(name)
            if found is None:
                continue
            before = self._said.get(name)
            if isinstance(value, np.ndarray):
                if before is value:
                    continue
                found.write(np.ascontiguousarray(value, np.float32))
            elif isinstance(before, np.ndarray) or before != value:
                found.value = value
            self._said[name] = value


def compiled(name: str, vertex: str, fragment: str, attributes: Sequence[str] = ()) -> int:
    """The GL name of a program whose vertex attributes lie at their place in the sequence, from
    GLSL texts; an empty one leaves its stage to the fixed function. Raises `RenderError` with the
    driver's words when it does not link."""
    program = int(gl.glCreateProgram())
    for kind, text in ((_VERTEX, vertex), (_FRAGMENT, fragment)):
        if not text:
            continue
        shader = gl.glCreateShader(kind)
        source = text.encode("ascii")
        pointer, length = ctypes.c_char_p(source), ctypes.c_int(len(source))
        gl.glShaderSource(shader, 1, ctypes.byref(pointer), ctypes.byref(length))
        gl.glCompileShader(shader)
        gl.glAttachShader(program, shader)
        gl.glDeleteShader(shader)
    for location, attribute in enumerate(attributes):
        gl.glBindAttribLocation(program, location, attribute.encode("ascii"))
    gl.glLinkProgram(program)
    linked = ctypes.c_int()
    gl.glGetProgramiv(program, _LINKED, ctypes.byref(linked))
    if not linked.value:
        raise RenderError(f"program {name!r} does not link in this context: {_words(program)}")
    return program


def _words(program: int) -> str:
    """What the driver says about a program and its shaders."""
    count, shaders, text = ctypes.c_int(), (ctypes.c_uint * 8)(), ctypes.create_string_buffer(2048)
    gl.glGetProgramInfoLog(program, len(text), None, text)
    said = [text.value]
    gl.glGetAttachedShaders(program, 8, ctypes.byref(count), shaders)
    for shader in shaders[: count.value]:
        gl.glGetShaderInfoLog(shader, len(text), None, text)
        said.append(text.value)
    return b" ".join(said).decode("utf-8", "replace").strip()
