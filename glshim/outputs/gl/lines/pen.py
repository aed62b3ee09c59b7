"""Draws line records by a styler's shader, a strip of vertices a line, in OpenGL 3.3."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.model.camera import Camera
from glshim.model.lines import RECORD
from glshim.outputs.gl.device.arrays import put_away
from glshim.outputs.gl.device.buffers import Ring
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.programs import Program, shader_text
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, inputs_of
from glshim.outputs.gl.frame.frame import Frame
from glshim.spec.constants import GL_FLOAT, GL_TRIANGLE_STRIP
from glshim.styling.lines import Shader
from glshim.styling.values import Uniform

_DEPTH = shader_text("depth.glsl")
_LINE = shader_text("line.glsl", "window.glsl")
INPUTS = {
    "edge_a": 3, "edge_b": 3, "edge_c": 3, "edge_own": 3, "edge_other": 3, "edge_kind": 3,
    "edge_hand": 3,
}  # fmt: skip
"""Floats of each input, in the order of a record."""
Records = NDArray[np.float32]


class Pen:
    """Make and use it inside the state guard."""

    def __init__(self, device: ModernDevice, ring_bytes: int = 8 << 20) -> None:
        self._device = device
        self._programs: dict[tuple[Shader, int], Program] = {}
        self._ring = Ring(device, ring_bytes)

    def draw(
        self,
        records: Records,
        camera: Camera,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        frame: Frame,
    ) -> None:
        """Ink into the framebuffer that is bound, where the frame's finished depth does not hide
        it. The camera's depth range is turned (`turned`)."""
        inputs = inputs_of(camera, frame)
        if inputs is None:
            return
        self._program(shader, camera).use(inputs, uniforms)
        gl.glViewport(*camera.viewport)
        start = self._ring.put(records)
        for location, size in enumerate(INPUTS.values()):
            gl.glEnableVertexAttribArray(location)
            gl.glVertexAttribDivisor(location, 1)
            gl.glVertexAttribPointer(location, size, GL_FLOAT, 0, RECORD * 4, start)
            start += size * 4
        self._issue(shader.vertices, len(records))
        put_away(range(len(INPUTS)))

    def _issue(self, vertices: int, lines: int) -> None:
        """The draw itself."""
        gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, vertices, lines)

    def _program(self, shader: Shader, camera: Camera) -> Program:
        planes = min(len(camera.clip_planes), MOST_CLIP_PLANES)
        found = self._programs.get((shader, planes))
        if found is None:
            found = self._programs[shader, planes] = self._compiled(shader, planes)
        return found

    def _compiled(self, shader: Shader, planes: int) -> Program:
        return self._device.program(shader.name, *stages(shader, planes))


def stages(shader: Shader, planes: int) -> tuple[str, str]:
    """The texts of the vertex and the fragment stage, for so many clip planes of the app's."""
    head = f"#version 330\n#define CLIP_PLANES {planes}\n"
    return (
        f"{head}#define VERTEX_STAGE\n{_DEPTH}{_LINE}#line 1\n{shader.vertex}",
        f"{head}{_DEPTH}#line 1\n{shader.fragment}",
    )
