"""What vertex and geometry shaders make of their inputs: the pen and the runner of passes with
transform feedback in place of pixels, for tests that hold them to the numpy references."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.linework.objects import Objects
from glshim.model.camera import Camera
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.device.programs import Program
from glshim.outputs.gl.frame.cameras import inputs_of
from glshim.outputs.gl.frame.depth import DepthCopy
from glshim.outputs.gl.frame.frame import Frame
from glshim.outputs.gl.lines.pen import Pen, stages
from glshim.outputs.gl.passes.meshprograms import MeshPrograms
from glshim.outputs.gl.passes.runner import BY_INDEX, Ready, Runner, issue
from glshim.styling.lines import Shader
from glshim.styling.passes import MeshShader, Pass
from glshim.styling.values import Uniform

Rows = NDArray[np.float32]


class CapturingPen(Pen):
    """In the context that is current."""

    def __init__(self) -> None:
        with Guard():
            super().__init__(ModernDevice())
        self._names: Mapping[str, int] = {}
        self._found: dict[str, Rows] | None = None

    def varyings(
        self,
        records: Rows,
        camera: Camera,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        names: Mapping[str, int],
        *,
        hair: float,
    ) -> dict[str, Rows]:
        """What the vertex shader makes of line records: (L, shader.vertices, size) by name, for
        names and their sizes."""
        if names != self._names:
            self._programs.clear()
        self._names, self._found = names, None
        with Guard():
            self.draw(records, camera, shader, uniforms, Frame(DepthCopy(), hair))
        assert self._found is not None, "this camera sees nothing"
        return self._found

    def _compiled(self, shader: Shader, planes: int) -> Program:
        texts = stages(shader, planes)
        return self._device.program(shader.name, texts[0], captured=tuple(self._names))

    def _issue(self, vertices: int, lines: int) -> None:
        def draw() -> None:
            gl.glDrawArraysInstanced(GL.GL_POINTS, 0, vertices, lines)

        self._found = _captured(draw, GL.GL_POINTS, (lines, vertices), self._names)


class _Captured(MeshPrograms):
    def __init__(self, device: ModernDevice, names: tuple[str, ...]) -> None:
        super().__init__(device)
        self._names = names

    def compiled(self, shader: MeshShader, texts: tuple[str, str, str]) -> Program:
        vertex, _, geometry = texts
        return self._device.program(
            shader.name, vertex, geometry=geometry, captured=self._names
        )


class CapturingRunner(Runner):
    """In the context that is current; use it inside the state guard."""

    def __init__(self) -> None:
        with Guard():
            self._device = ModernDevice()
            super().__init__(self._device, Objects(1 << 28), 1 << 28)
        self._captured: dict[tuple[str, ...], _Captured] = {}

    def varyings(self, one: Pass, names: Mapping[str, int]) -> list[dict[str, Rows]]:
        """What the vertex shader of a pass makes of each body: (elements, vertices, size) by name,
        for names and their sizes (floats); with a geometry shader what that makes, (triangles, 3,
        size)."""
        key = tuple(names)
        self._programs = self._captured.setdefault(key, _Captured(self._device, key))
        found = []
        for body in one.bodies:
            camera = body.camera.affine()
            inputs = inputs_of(camera, Frame(DepthCopy(), 0.0))
            assert inputs is not None, "this camera sees nothing"
            self._open_array()
            ready = self._ready(one, replace(body, camera=camera), inputs)
            assert ready is not None, "this pose is another mesh's"
            found.append(self._capture(one, ready, names))
            ready.release()
            self.residents.release()
        return found

    def _capture(self, one: Pass, ready: Ready, names: Mapping[str, int]) -> dict[str, Rows]:
        def triangles() -> None:
            issue(one, ready)

        def points() -> None:
            count = ready.elements * ready.each
            gl.glDrawArraysInstanced(GL.GL_POINTS, 0, count, one.primitives.copies)

        shape = ready.elements, ready.each
        if one.shader.geometry:
            shape = _triangles_of(triangles), 3
        if one.shader.geometry or one.element in BY_INDEX:
            return _captured(triangles, GL.GL_TRIANGLES, shape, names)
        return _captured(points, GL.GL_POINTS, shape, names)


def _captured(
    draw: Callable[[], None], kind: int, shape: tuple[int, int], names: Mapping[str, int]
) -> dict[str, Rows]:
    """What a draw of the program in use captures, by name: (*shape, size)."""
    width = sum(names.values())
    found = np.zeros((*shape, width), np.float32)
    target = GL.GL_TRANSFORM_FEEDBACK_BUFFER
    buffer = GL.glGenBuffers(1)
    GL.glBindBufferBase(target, 0, buffer)
    GL.glBufferData(target, max(found.nbytes, 4), None, GL.GL_DYNAMIC_READ)
    GL.glEnable(GL.GL_RASTERIZER_DISCARD)
    GL.glBeginTransformFeedback(kind)
    draw()
    GL.glEndTransformFeedback()
    GL.glDisable(GL.GL_RASTERIZER_DISCARD)
    if found.size:
        gl.glGetBufferSubData(target, 0, found.nbytes, found.ctypes.data)
    GL.glDeleteBuffers(1, [buffer])
    ends = np.cumsum(list(names.values()))
    return {
        name: found[..., end - size : end]
        for (name, size), end in zip(names.items(), ends, strict=True)
    }


def _triangles_of(draw: Callable[[], None]) -> int:
    """How many triangles a geometry shader makes."""
    query, found = GL.glGenQueries(1), ctypes.c_uint()
    name = int(np.ravel(query)[0])
    GL.glBeginQuery(GL.GL_PRIMITIVES_GENERATED, name)
    GL.glEnable(GL.GL_RASTERIZER_DISCARD)
    draw()
    GL.glDisable(GL.GL_RASTERIZER_DISCARD)
    GL.glEndQuery(GL.GL_PRIMITIVES_GENERATED)
    gl.glGetQueryObjectuiv(name, GL.GL_QUERY_RESULT, ctypes.addressof(found))
    GL.glDeleteQueries(1, [name])
    return found.value
