"""What a program sees of its context: answers, the picture, depth, and some hundreds of values.

The same scene is run plain and under a style in one process; nothing may differ.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL

from glshim.driver.ask import integer, is_enabled, reals
from glshim.driver.functions import gl

_SKIPPED = ("_TOKEN", "NUM_EXTENSIONS", "PERFMON", "NVX", "MEMORY_INFO", "TIMESTAMP", "MEM_INFO")
_MATERIAL = (GL.GL_AMBIENT, GL.GL_DIFFUSE, GL.GL_SPECULAR, GL.GL_EMISSION, GL.GL_SHININESS,
             GL.GL_COLOR_INDEXES)  # fmt: skip
_LIGHT = (GL.GL_AMBIENT, GL.GL_DIFFUSE, GL.GL_SPECULAR, GL.GL_POSITION, GL.GL_SPOT_EXPONENT)
_POINTERS = (
    GL.GL_VERTEX_ARRAY_POINTER, GL.GL_NORMAL_ARRAY_POINTER, GL.GL_COLOR_ARRAY_POINTER,
    GL.GL_INDEX_ARRAY_POINTER, GL.GL_TEXTURE_COORD_ARRAY_POINTER, GL.GL_EDGE_FLAG_ARRAY_POINTER,
    GL.GL_FOG_COORD_ARRAY_POINTER, GL.GL_SECONDARY_COLOR_ARRAY_POINTER,
)  # fmt: skip
_ATTRIBUTE = (
    GL.GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL.GL_VERTEX_ATTRIB_ARRAY_SIZE,
    GL.GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL.GL_VERTEX_ATTRIB_ARRAY_TYPE,
    GL.GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, GL.GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
)  # fmt: skip
_STACKS = (
    ("modelview", GL.GL_MODELVIEW, GL.GL_MODELVIEW_MATRIX, GL.GL_MODELVIEW_STACK_DEPTH),
    ("projection", GL.GL_PROJECTION, GL.GL_PROJECTION_MATRIX, GL.GL_PROJECTION_STACK_DEPTH),
    ("texture", GL.GL_TEXTURE, GL.GL_TEXTURE_MATRIX, GL.GL_TEXTURE_STACK_DEPTH),
)
_ATTRIBUTES, _UNITS = 16, 8
"""Vertex attributes and texture units that are looked at."""
queries: dict[int, str] = {}


class App:
    """What a scene calls GL through when the answer matters: it is written down."""

    def __init__(self) -> None:
        self.saw: list[str] = []
        self.kept: list[Any] = []
        """What GL points into: kept until the scene has been looked at."""

    def tries(self, call: Callable[..., Any], *args: Any, **named: Any) -> Any:
        """Call; note the result or the exception."""
        try:
            result = call(*args, **named)
        except Exception as error:
            self.saw.append(f"{type(error).__name__}: {steady(str(error))}")
            return None
        self.saw.append(steady(repr(result)))
        return result

    def asks(self, *names: int) -> None:
        """Note what PyOpenGL's glGetFloatv answers."""
        for name in names:
            self.tries(GL.glGetFloatv, name)

    def error(self) -> None:
        """Note glGetError."""
        self.tries(GL.glGetError)

    def keeps(self, value: Any) -> Any:
        """Hold a value until the end; gives it back."""
        self.kept.append(value)
        return value


def steady(text: str) -> str:
    """Without what differs between two runs of the same program."""
    text = re.sub(r"0x[0-9a-f]{5,}", "0x...", text)
    return re.sub(r"c_void_p\(\d+\)", "c_void_p(...)", text)


@dataclass
class Outcome:
    """What is compared."""

    saw: list[str]
    picture: NDArray[np.uint8]
    """(height, width, 4) uint8, bottom row first."""
    depth: NDArray[np.float32]
    state: dict[str, Any] = field(default_factory=dict)

    def differences(self, other: Outcome, pictures: bool = True) -> dict[str, Any]:
        """By name; empty when equal."""
        found: dict[str, Any] = {
            name: (self.state[name], other.state[name])
            for name in self.state
            if self.state[name] != other.state[name]
        }
        if self.saw != other.saw:
            pairs = zip([*self.saw, None], [*other.saw, None], strict=False)
            found["saw"] = next(((i, a, b) for i, (a, b) in enumerate(pairs) if a != b), "length")
        if pictures and (self.picture != other.picture).any():
            found["picture"] = self.changed_pixels(other)
        if (self.depth != other.depth).any():
            found["depth"] = int((self.depth != other.depth).sum())
        return found

    def changed_pixels(self, other: Outcome) -> int:
        """How many pixels of the pictures are not the same."""
        return int((self.picture != other.picture).any(axis=2).sum())


def observe(app: App, width: int, height: int) -> Outcome:
    """What there is to see in a window at the end of a scene, errors fetched by the app's own
    means. Pops the matrix stacks: the last thing."""
    for _ in range(4):
        app.error()
    GL.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
    picture = GL.glReadPixels(0, 0, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)
    state = dump()
    depth = np.zeros((height, width), np.float32)
    gl.glReadPixels(0, 0, width, height, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT, at(depth))
    return Outcome(
        app.saw, np.frombuffer(picture, np.uint8).reshape(height, width, 4), depth, state
    )


def at(array: NDArray[Any]) -> int:
    """Its address."""
    return int(array.ctypes.data)


def dump() -> dict[str, Any]:
    """Some hundreds of values, asked past PyOpenGL. Pops the matrix stacks: the last thing."""
    state = _values()
    state |= _vectors()
    state |= _vertex_arrays()
    state |= _matrix_stacks()
    return state


def _values() -> dict[str, Any]:
    out = np.zeros(64)
    if not queries:
        for name in dir(GL):
            token = getattr(GL, name)
            if not name.startswith("GL_") or not isinstance(token, int) or not 0 < token < 65536:
                continue
            if any(part in name for part in _SKIPPED):
                continue
            gl.glGetDoublev(int(token), at(out))
            if gl.glGetError() == 0:
                queries[int(token)] = name
    found = {}
    for token, name in queries.items():
        out[:] = 0.0
        gl.glGetDoublev(token, at(out))
        found[name] = tuple(np.trim_zeros(out, "b").tolist())
    while gl.glGetError():
        pass
    return found


def _vectors() -> dict[str, Any]:
    """Materials, lights, texture environment, clip planes, stipple."""
    found: dict[str, Any] = {}
    out = np.zeros(16, np.float32)

    def ask(function: str, *args: int) -> None:
        out[:] = 0.0
        getattr(gl, function)(*args, at(out))
        found[f"{function}{args}"] = tuple(out.tolist())

    for face in (GL.GL_FRONT, GL.GL_BACK):
        for name in _MATERIAL:
            ask("glGetMaterialfv", face, name)
    for light in (GL.GL_LIGHT0, GL.GL_LIGHT1):
        for name in _LIGHT:
            ask("glGetLightfv", light, name)
    for name in (GL.GL_TEXTURE_ENV_MODE, GL.GL_TEXTURE_ENV_COLOR):
        ask("glGetTexEnvfv", GL.GL_TEXTURE_ENV, name)
    for coordinate in (GL.GL_S, GL.GL_T):
        for name in (GL.GL_TEXTURE_GEN_MODE, GL.GL_OBJECT_PLANE, GL.GL_EYE_PLANE):
            ask("glGetTexGenfv", coordinate, name)
    for index in range(1, _ATTRIBUTES):
        ask("glGetVertexAttribfv", index, GL.GL_CURRENT_VERTEX_ATTRIB)
    active = integer(GL.GL_ACTIVE_TEXTURE)
    for unit in range(_UNITS):
        gl.glActiveTexture(GL.GL_TEXTURE0 + unit)
        found[f"current texture coordinates {unit}"] = reals(GL.GL_CURRENT_TEXTURE_COORDS, 4)
    gl.glActiveTexture(active)
    return found


def _vertex_arrays() -> dict[str, Any]:
    found: dict[str, Any] = {}
    pointer, value = ctypes.c_void_p(), ctypes.c_int()

    def address() -> Any:
        return pointer.value if (pointer.value or 0) < 65536 else "memory"

    for name in _POINTERS:
        gl.glGetPointerv(name, ctypes.byref(pointer))
        found[f"pointer {int(name):#x}"] = address()
    for index in range(_ATTRIBUTES):
        for name in _ATTRIBUTE:
            gl.glGetVertexAttribiv(index, name, ctypes.byref(value))
            found[f"attribute {index} {int(name):#x}"] = value.value
        gl.glGetVertexAttribPointerv(
            index, GL.GL_VERTEX_ATTRIB_ARRAY_POINTER, ctypes.byref(pointer)
        )
        found[f"attribute {index} pointer"] = address()
    client = integer(GL.GL_CLIENT_ACTIVE_TEXTURE)
    for unit in range(_UNITS):
        gl.glClientActiveTexture(GL.GL_TEXTURE0 + unit)
        found[f"texture array {unit}"] = is_enabled(GL.GL_TEXTURE_COORD_ARRAY)
    gl.glClientActiveTexture(client)
    return found


def _matrix_stacks() -> dict[str, Any]:
    found: dict[str, Any] = {}
    matrix = np.zeros(16)
    for name, mode, top, level in _STACKS:
        gl.glMatrixMode(mode)
        for position in range(integer(level), 0, -1):
            gl.glGetDoublev(top, at(matrix))
            found[f"{name} {position}"] = tuple(matrix.tolist())
            if position > 1:
                gl.glPopMatrix()
    return found
