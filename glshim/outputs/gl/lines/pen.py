"""Draws line records by a styler's shader, a strip of vertices a line, in OpenGL 3.3."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from importlib.resources import files
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from glshim.errors import RenderError
from glshim.model.camera import Camera
from glshim.model.lines import RECORD
from glshim.outputs.gl.device.programs import Program
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, inputs_of
from glshim.outputs.gl.frame.depth import DepthCopy
from glshim.spec.driver import gl
from glshim.styling.protocol import Shader, Uniform

_SHADERS = files("glshim.outputs.gl") / "shaders"
_LINE = "".join((_SHADERS / name).read_text("utf-8") for name in ("line.glsl", "window.glsl"))
DEPTH = (_SHADERS / "depth.glsl").read_text("utf-8")
"""Prelude of both stages, for every version of GLSL."""
_STRIP = 0x0005
_INPUTS = {
    "edge_a": 3, "edge_b": 3, "edge_c": 3, "edge_own": 3, "edge_other": 3, "edge_kind": 3,
    "edge_hand": 3,
}  # fmt: skip
"""Floats of each input, in the order of a record."""
Records = NDArray[np.float32]
Uniforms = Mapping[str, Uniform]


class Pen:
    """Make it with the context of moderngl that is current, inside the state guard."""

    def __init__(self, context: Any, ring_bytes: int) -> None:
        self.context = context
        self._programs: dict[tuple[Shader, int, tuple[str, ...]], Program] = {}
        self._ring = context.buffer(reserve=ring_bytes, dynamic=True)
        self._ring_at = 0
        array = ctypes.c_uint()
        gl.glGenVertexArrays(1, ctypes.addressof(array))
        self._array = array.value
        gl.glBindVertexArray(self._array)
        for location in range(len(_INPUTS)):
            gl.glEnableVertexAttribArray(location)
            gl.glVertexAttribDivisor(location, 1)

    def draw(
        self,
        records: Records,
        camera: Camera,
        shader: Shader,
        uniforms: Uniforms,
        depth: DepthCopy,
        *,
        away: float,
        hair: float,
    ) -> None:
        """Ink into the framebuffer that is bound. The camera's depth range is turned by away; hair
        is in window depth."""
        program = self._ready(camera, shader, uniforms, depth, away=away, hair=hair)
        if program is None:
            return
        offset = self._stream(records)
        gl.glViewport(*camera.viewport)
        gl.glUseProgram(program.name)
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(0x8892, self._ring.glo)
        start = offset
        for location, size in enumerate(_INPUTS.values()):
            gl.glVertexAttribPointer(location, size, 0x1406, 0, RECORD * 4, start)
            start += size * 4
        gl.glDrawArraysInstanced(_STRIP, 0, shader.vertices, len(records))

    def varyings(
        self,
        records: Records,
        camera: Camera,
        shader: Shader,
        uniforms: Uniforms,
        names: Mapping[str, int],
        *,
        hair: float,
    ) -> dict[str, Records]:
        """What the vertex shader makes of line records: (L, shader.vertices, size) by name, for
        names and their sizes. Transform feedback; what tests hold to the numpy reference."""
        depth = DepthCopy()
        program = self._ready(
            camera, shader, uniforms, depth, away=1.0, hair=hair, varyings=tuple(names)
        )
        if program is None:
            raise RenderError("this camera sees nothing")
        width = sum(names.values())
        source = self.context.buffer(records)
        target = self.context.buffer(reserve=len(records) * shader.vertices * width * 4)
        used = [name for name in _INPUTS if name in program.made]  # compilers drop the others
        steps = (f"{n}f" if name in used else f"{n}x4" for name, n in _INPUTS.items())
        array = self.context.vertex_array(
            program.made, [(source, " ".join(steps) + " /i", *used)]
        )
        array.transform(target, moderngl.POINTS, shader.vertices, instances=len(records))
        found = np.frombuffer(target.read(), np.float32).reshape(len(records), -1, width)
        for held in (array, source, target):
            held.release()
        ends = np.cumsum(list(names.values()))
        return {
            name: found[..., end - size : end]
            for (name, size), end in zip(names.items(), ends, strict=True)
        }

    def _ready(
        self,
        camera: Camera,
        shader: Shader,
        uniforms: Uniforms,
        depth: DepthCopy,
        *,
        away: float,
        hair: float,
        varyings: tuple[str, ...] = (),
    ) -> Program | None:
        """The program of a shader with its uniforms set; None where the camera sees nothing."""
        inputs = inputs_of(camera, depth, away=away, hair=hair)
        if inputs is None:
            return None
        planes = min(len(camera.clip_planes), MOST_CLIP_PLANES)
        program = self._program(shader, planes, varyings)
        program.set(inputs)
        program.set(uniforms)
        return program

    def _stream(self, records: Records) -> int:
        """Byte offset in the ring at which records now lie."""
        size = records.nbytes
        if size > self._ring.size:
            self._ring.release()
            self._ring = self.context.buffer(reserve=2 * size, dynamic=True)
            self._ring_at = 0
        if self._ring_at + size > self._ring.size:
            self._ring.orphan()
            self._ring_at = 0
        offset = self._ring_at
        self._ring.write(records, offset=offset)
        self._ring_at = offset + size
        return offset

    def _program(self, shader: Shader, planes: int, varyings: tuple[str, ...]) -> Program:
        key = (shader, planes, varyings)
        found = self._programs.get(key)
        if found is None:
            head = f"#version 330\n#define CLIP_PLANES {planes}\n"
            first = f"{head}#define VERTEX_STAGE\n{DEPTH}{_LINE}"
            try:
                program = self.context.program(
                    vertex_shader=f"{first}#line 1\n{shader.vertex}",
                    fragment_shader=None
                    if varyings
                    else f"{head}{DEPTH}#line 1\n{shader.fragment}",
                    varyings=varyings,
                )
            except moderngl.Error as error:
                raise RenderError(f"shader {shader.name!r} does not compile: {error}") from error
            found = self._programs[key] = Program(program)
        return found
