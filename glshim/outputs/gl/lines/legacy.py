"""Draws line records by a styler's shader in OpenGL 2.1: the CPU expands them."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import put_the_apps_arrays_away
from glshim.outputs.gl.device.programs import compiled
from glshim.outputs.gl.frame.cameras import inputs_of
from glshim.outputs.gl.frame.depth import DepthCopy
from glshim.spec.context import MODERN
from glshim.spec.driver import gl
from glshim.styling.protocol import Expansion, Shader, Uniform

_SHADERS = files("glshim.outputs.gl") / "shaders"
_VERTEX = (_SHADERS / "legacy.vert.glsl").read_text("utf-8")
_FRAGMENT = (_SHADERS / "depth.glsl").read_text("utf-8")
_TRIANGLES, _FLOAT, _ACTIVE_UNIFORMS = 0x0004, 0x1406, 0x8B86
_TYPES = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}
_FLOATS = {0x1406: "1fv", 0x8B50: "2fv", 0x8B51: "3fv", 0x8B52: "4fv"}
_MATRICES = {0x8B5A: "Matrix2fv", 0x8B5B: "Matrix3fv", 0x8B5C: "Matrix4fv"}
_AT_ONCE = 1 << 14
"""Records whose vertices lie in memory at a time: a few megabytes."""


@dataclass(frozen=True, slots=True)
class _Program:
    name: int
    uniforms: dict[str, tuple[int, int, int]]
    """Location, type and length by name."""

    def set(self, values: Mapping[str, Any]) -> None:
        """Of the program that is in use. Matrices columns first."""
        for name, value in values.items():
            location, kind, length = self.uniforms.get(name, (-1, 0, 0))
            if location < 0:
                continue
            if kind in _MATRICES:
                array = np.ascontiguousarray(value, np.float32)
                getattr(gl, f"glUniform{_MATRICES[kind]}")(location, length, 0, array.ctypes.data)
            else:
                whole = kind not in _FLOATS  # integers, switches, samplers
                array = np.ascontiguousarray(value, np.int32 if whole else np.float32)
                setter = f"glUniform{'1iv' if whole else _FLOATS[kind]}"
                getattr(gl, setter)(location, length, array.ctypes.data)


class LegacyPen:
    """What `glshim.outputs.gl.lines.pen.Pen` does, with what OpenGL 2.1 has. Use inside the guard.

    It is slower by what the expansion takes, and nothing stays on the GPU between draws.
    """

    def __init__(self) -> None:
        self._programs: dict[tuple[Shader, tuple[tuple[str, int], ...]], _Program] = {}

    def draw(
        self,
        records: NDArray[np.float32],
        camera: Camera,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        depth: DepthCopy,
        *,
        away: float,
        hair: float,
    ) -> None:
        """Ink into the framebuffer that is bound. The camera's depth range is turned by away; hair
        is in window depth."""
        inputs = inputs_of(camera, depth, away=away, hair=hair)
        if shader.expand is None:
            say_once("style shader {!r} needs OpenGL {}.{}".format(shader.name, *MODERN))
        if inputs is None or shader.expand is None:
            return
        gl.glViewport(*camera.viewport)
        put_the_apps_arrays_away()
        for start in range(0, len(records), _AT_ONCE):
            some = records[start : start + _AT_ONCE]
            found = shader.expand(some, camera, uniforms, hair=hair, blur=depth.blur)
            if not len(found.places):
                continue
            program = self._program(shader, found)
            gl.glUseProgram(program.name)
            program.set(inputs)
            program.set(uniforms)
            _draw(found, camera)

    def _program(self, shader: Shader, found: Expansion) -> _Program:
        sizes = tuple((name, rows.shape[1]) for name, rows in found.values.items())
        program = self._programs.get((shader, sizes))
        if program is None:
            declared = " ".join(
                f"attribute {_TYPES[size]} of_{name}; varying {_TYPES[size]} {name};"
                for name, size in sizes
            )
            copied = " ".join(f"{name} = of_{name};" for name, _ in sizes)
            name = compiled(
                shader.name,
                f"#version 120\n#define DECLARED {declared}\n#define COPIED {copied}\n{_VERTEX}",
                f"#version 120\n{_FRAGMENT}\n#line 1\n{shader.fragment}",
                ("place", *(f"of_{name}" for name, _ in sizes)),
            )
            program = self._programs[shader, sizes] = _Program(name, _uniforms(name))
        return program


def _draw(found: Expansion, camera: Camera) -> None:
    """Strips as triangles, from the client's memory: what restarts primitives has no say."""
    x, y, *size = camera.viewport
    half = np.array(size) / 2.0
    places = (found.places - (x + half[0], y + half[1])) / half
    strip = places.shape[1]
    triangles = np.arange(strip - 2)[:, None] + np.arange(3)
    corners = np.ascontiguousarray(places[:, triangles.ravel()], np.float32)
    lines = np.concatenate([*found.values.values()], axis=1).astype(np.float32)
    rows = np.repeat(lines, corners.shape[1], axis=0)
    columns = [(corners, 2, 0)]
    at = 0
    for values in found.values.values():
        columns.append((rows, values.shape[1], at))
        at += 4 * values.shape[1]
    for location, (array, width, offset) in enumerate(columns):
        gl.glEnableVertexAttribArray(location)
        data, stride = array.ctypes.data + offset, array.strides[-2]
        gl.glVertexAttribPointer(location, width, _FLOAT, 0, stride, data)
    gl.glDrawArrays(_TRIANGLES, 0, len(rows))
    for location in range(len(columns)):
        gl.glDisableVertexAttribArray(location)


def _uniforms(program: int) -> dict[str, tuple[int, int, int]]:
    """Location, type and length of the uniforms that a program uses."""
    count, length, kind = ctypes.c_int(), ctypes.c_int(), ctypes.c_uint()
    text = ctypes.create_string_buffer(256)
    gl.glGetProgramiv(program, _ACTIVE_UNIFORMS, ctypes.byref(count))
    found = {}
    for i in range(count.value):
        gl.glGetActiveUniform(
            program, i, len(text), None, ctypes.byref(length), ctypes.byref(kind), text
        )
        location = int(gl.glGetUniformLocation(program, text.value))
        name = text.value.decode("ascii").removesuffix("[0]")
        found[name] = location, kind.value, length.value
    return found
