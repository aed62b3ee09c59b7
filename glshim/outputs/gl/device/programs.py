"""Uniforms of programs, whatever made them, set by the bare driver; in GLSL from 1.20 on."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from importlib.resources import files
from typing import Any, Protocol

import numpy as np

from glshim.driver.functions import gl, quick
from glshim.spec.constants import (
    GL_ACTIVE_UNIFORMS,
    GL_BOOL,
    GL_BOOL_VEC2,
    GL_BOOL_VEC3,
    GL_BOOL_VEC4,
    GL_FLOAT,
    GL_FLOAT_MAT2,
    GL_FLOAT_MAT3,
    GL_FLOAT_MAT4,
    GL_FLOAT_VEC2,
    GL_FLOAT_VEC3,
    GL_FLOAT_VEC4,
    GL_INT,
    GL_INT_VEC2,
    GL_INT_VEC3,
    GL_INT_VEC4,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_INT_VEC2,
    GL_UNSIGNED_INT_VEC3,
    GL_UNSIGNED_INT_VEC4,
    GL_FLOAT_MAT2x3,
    GL_FLOAT_MAT2x4,
    GL_FLOAT_MAT3x2,
    GL_FLOAT_MAT3x4,
    GL_FLOAT_MAT4x2,
    GL_FLOAT_MAT4x3,
)

_SETTERS: dict[int, tuple[str, int, type[np.generic]]] = {
    kind: (f"glUniform{size}{letter}v", size, numbers)
    for letter, numbers, kinds in (
        ("f", np.float32, (GL_FLOAT, GL_FLOAT_VEC2, GL_FLOAT_VEC3, GL_FLOAT_VEC4)),
        ("i", np.int32, (GL_INT, GL_INT_VEC2, GL_INT_VEC3, GL_INT_VEC4)),
        ("i", np.int32, (GL_BOOL, GL_BOOL_VEC2, GL_BOOL_VEC3, GL_BOOL_VEC4)),
        ("ui", np.uint32, (GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3,
                           GL_UNSIGNED_INT_VEC4)),
    )
    for size, kind in enumerate(kinds, 1)
}  # fmt: skip
"""By type of a uniform: what sets it, how many numbers one has, and what those are."""
_SETTERS |= {
    kind: (f"glUniformMatrix{shape}fv", size, np.float32)
    for kind, shape, size in (
        (GL_FLOAT_MAT2, "2", 4), (GL_FLOAT_MAT3, "3", 9), (GL_FLOAT_MAT4, "4", 16),
        (GL_FLOAT_MAT2x3, "2x3", 6), (GL_FLOAT_MAT2x4, "2x4", 8), (GL_FLOAT_MAT3x2, "3x2", 6),
        (GL_FLOAT_MAT3x4, "3x4", 12), (GL_FLOAT_MAT4x2, "4x2", 8), (GL_FLOAT_MAT4x3, "4x3", 12),
    )
}  # fmt: skip


@dataclass(slots=True)
class _Uniform:
    """One that a program uses."""

    location: int
    length: int
    """Elements of an array, else 1."""
    size: int
    """Numbers of an element."""
    numbers: type[np.generic]
    setter: Callable[..., Any]
    is_matrix: bool
    said: Any = field(default=None)
    """Its value now."""

    def set(self, value: Any) -> None:
        """Of the program in use. Raises `ValueError` for numbers that are not its own."""
        said = self.said
        if isinstance(value, np.ndarray):
            if said is value:
                return
        elif not isinstance(said, np.ndarray) and said == value:
            return
        rows = np.asarray(value)
        count, rest = divmod(rows.size, self.size)
        if rest or not count or count > self.length == 1:
            raise ValueError(f"{rows.size} numbers for {self.size} x {self.length}")
        if self.numbers is not np.float32 and rows.dtype.kind == "f":
            raise ValueError("not whole numbers")
        count = min(count, self.length)  # compilers drop the end of an array that nothing reads
        data = rows.astype(self.numbers).tobytes()
        if self.is_matrix:
            self.setter(self.location, count, 0, data)
        else:
            self.setter(self.location, count, data)
        self.said = value


class Linked(Protocol):
    """A program as it was made: moderngl's own has these, too."""

    @property
    def glo(self) -> int:
        """The driver's name for it."""

    def release(self) -> None:
        """Delete it. In its context."""


class Lost(Exception):
    """Objects of ours were deleted by the program."""


class Program:
    """A program of the current context, made by a `Device`; uniforms that it does not have are
    passed over."""

    def __init__(self, linked: Linked) -> None:
        self._linked = linked
        self.name = linked.glo
        self._uniforms = dict(self._used())

    def use(self, *values: Mapping[str, Any]) -> None:
        """Draw with it from now on, with uniforms by name. Arrays as they lie in memory (matrices
        columns first), and not to be changed later: what is there already is not sent again.
        Raises `Lost`."""
        if not gl.glIsProgram(self.name):
            raise Lost
        gl.glUseProgram(self.name)
        for some in values:
            self.set(some)

    def set(self, values: Mapping[str, Any]) -> None:
        """Uniforms by name, while it is in use."""
        for name, value in values.items():
            uniform = self._uniforms.get(name)
            if uniform is None:
                continue
            try:
                uniform.set(value)
            except ValueError as error:
                raise ValueError(f"uniform {name!r} cannot be {value!r}: {error}") from None

    def wants(self, name: str) -> bool:
        """Whether it has a uniform."""
        return name in self._uniforms

    def location(self, attribute: str) -> int:
        """Of a vertex attribute; -1 where nothing reads it."""
        return int(gl.glGetAttribLocation(self.name, attribute.encode("ascii")))

    def release(self) -> None:
        """Delete it. In its context."""
        self._linked.release()

    def _used(self) -> Iterator[tuple[str, _Uniform]]:
        """The uniforms by name, without those in blocks."""
        length, kind = ctypes.c_int(), ctypes.c_uint()
        text = ctypes.create_string_buffer(256)
        count = ctypes.c_int()
        gl.glGetProgramiv(self.name, GL_ACTIVE_UNIFORMS, ctypes.byref(count))
        for i in range(count.value):
            gl.glGetActiveUniform(
                self.name, i, len(text), None, ctypes.byref(length), ctypes.byref(kind), text
            )
            location = int(gl.glGetUniformLocation(self.name, text.value))
            if location < 0:
                continue
            # Samplers of every type take an integer.
            setter, size, numbers = _SETTERS.get(kind.value, _SETTERS[GL_INT])
            yield text.value.decode("ascii").removesuffix("[0]"), _Uniform(
                location, length.value, size, numbers, quick(setter), "Matrix" in setter
            )


def shader_text(*names: str) -> str:
    """Files of the folder ``shaders``, one after another."""
    folder = files("glshim.outputs.gl") / "shaders"
    return "".join((folder / name).read_text("utf-8") for name in names)
