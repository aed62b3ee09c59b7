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
from OpenGL.platform import PLATFORM

_bare = ctypes.CDLL(PLATFORM.GL._name)
_SKIPPED = ("_TOKEN", "NUM_EXTENSIONS", "PERFMON", "NVX", "MEMORY_INFO", "TIMESTAMP", "MEM_INFO")
_queries: dict[int, str] = {}


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
            self.saw.append(f"{type(error).__name__}: {_steady(str(error))}")
            return None
        self.saw.append(_steady(repr(result)))
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


def _steady(text: str) -> str:
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
    _bare.glReadPixels(0, 0, width, height, 0x1902, 0x1406, _at(depth))
    return Outcome(
        app.saw, np.frombuffer(picture, np.uint8).reshape(height, width, 4), depth, state
    )


def _at(array: NDArray[Any]) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def dump() -> dict[str, Any]:
    """Some hundreds of values, asked past PyOpenGL. Pops the matrix stacks: the last thing."""
    state = _values()
    state |= _vectors()
    state |= _vertex_arrays()
    state |= _matrix_stacks()
    return state


def _values() -> dict[str, Any]:
    out = np.zeros(64)
    if not _queries:
        for name in dir(GL):
            token = getattr(GL, name)
            if not name.startswith("GL_") or not isinstance(token, int) or not 0 < token < 65536:
                continue
            if any(part in name for part in _SKIPPED):
                continue
            _bare.glGetDoublev(int(token), _at(out))
            if _bare.glGetError() == 0:
                _queries[int(token)] = name
    found = {}
    for token, name in _queries.items():
        out[:] = 0.0
        _bare.glGetDoublev(token, _at(out))
        found[name] = tuple(np.trim_zeros(out, "b").tolist())
    while _bare.glGetError():
        pass
    return found


def _vectors() -> dict[str, Any]:
    """Materials, lights, texture environment, clip planes, stipple."""
    found: dict[str, Any] = {}
    out = np.zeros(16, np.float32)

    def ask(function: str, *args: int) -> None:
        out[:] = 0.0
        getattr(_bare, function)(*args, _at(out))
        found[f"{function}{args}"] = tuple(out.tolist())

    for face in (0x0404, 0x0405):
        for name in (0x1200, 0x1201, 0x1202, 0x1600, 0x1601, 0x1603):
            ask("glGetMaterialfv", face, name)
    for light in (0x4000, 0x4001):
        for name in (*range(0x1200, 0x1204), 0x1205):
            ask("glGetLightfv", light, name)
    for name in (0x2200, 0x2201):
        ask("glGetTexEnvfv", 0x2300, name)
    for coordinate in (0x2000, 0x2001):
        for name in (0x2500, 0x2501, 0x2502):
            ask("glGetTexGenfv", coordinate, name)
    for index in range(1, 16):
        ask("glGetVertexAttribfv", index, 0x8626)
    active = ctypes.c_int()
    _bare.glGetIntegerv(0x84E0, ctypes.byref(active))
    for unit in range(8):
        _bare.glActiveTexture(0x84C0 + unit)
        ask("glGetFloatv", 0x0B03)
        found[f"current texture coordinates {unit}"] = found.pop("glGetFloatv(2819,)")
    _bare.glActiveTexture(active.value)
    return found


def _vertex_arrays() -> dict[str, Any]:
    found: dict[str, Any] = {}
    pointer, value = ctypes.c_void_p(), ctypes.c_int()

    def address() -> Any:
        return pointer.value if (pointer.value or 0) < 65536 else "memory"

    for name in (0x808E, 0x808F, 0x8090, 0x8091, 0x8092, 0x8093, 0x8456, 0x845D):
        _bare.glGetPointerv(name, ctypes.byref(pointer))
        found[f"pointer {name:#x}"] = address()
    for index in range(16):
        for name in (0x8622, 0x8623, 0x8624, 0x8625, 0x886A, 0x889F):
            _bare.glGetVertexAttribiv(index, name, ctypes.byref(value))
            found[f"attribute {index} {name:#x}"] = value.value
        _bare.glGetVertexAttribPointerv(index, 0x8645, ctypes.byref(pointer))
        found[f"attribute {index} pointer"] = address()
    client = ctypes.c_int()
    _bare.glGetIntegerv(0x84E1, ctypes.byref(client))
    for unit in range(8):
        _bare.glClientActiveTexture(0x84C0 + unit)
        found[f"texture array {unit}"] = _bare.glIsEnabled(0x8078) & 255
    _bare.glClientActiveTexture(client.value)
    return found


def _matrix_stacks() -> dict[str, Any]:
    found: dict[str, Any] = {}
    depth, matrix = ctypes.c_int(), np.zeros(16)
    for name, mode, top, level in (
        ("modelview", 0x1700, 0x0BA6, 0x0BA3),
        ("projection", 0x1701, 0x0BA7, 0x0BA4),
        ("texture", 0x1702, 0x0BA8, 0x0BA5),
    ):
        _bare.glMatrixMode(mode)
        _bare.glGetIntegerv(level, ctypes.byref(depth))
        for position in range(depth.value, 0, -1):
            _bare.glGetDoublev(top, _at(matrix))
            found[f"{name} {position}"] = tuple(matrix.tolist())
            if position > 1:
                _bare.glPopMatrix()
    return found
