"""Draws line records by a styler's shader in OpenGL 2.1: the CPU expands them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from glshim.driver.context import MODERN
from glshim.driver.functions import gl
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import put_the_apps_arrays_away
from glshim.outputs.gl.device.devices import Device
from glshim.outputs.gl.device.programs import Program, shader_text
from glshim.outputs.gl.frame.cameras import inputs_of
from glshim.outputs.gl.frame.frame import Frame
from glshim.spec.constants import GL_FLOAT, GL_TRIANGLES
from glshim.styling.lines import Expansion, Shader
from glshim.styling.values import Uniform

_VERTEX, _FRAGMENT = shader_text("legacy.vert.glsl"), shader_text("depth.glsl")
_TYPES = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}
_Sizes = tuple[tuple[str, int], ...]
_AT_ONCE = 1 << 14
"""Records whose vertices lie in memory at a time: a few megabytes."""


class LegacyPen:
    """What `glshim.outputs.gl.lines.pen.Pen` does, with what OpenGL 2.1 has. Use inside the guard.

    It is slower by what the expansion takes, and nothing stays on the GPU between draws.
    """

    def __init__(self, device: Device) -> None:
        self._device = device
        self._programs: dict[tuple[Shader, _Sizes], tuple[Program, list[int]]] = {}
        """With the locations of their attributes: the place, and what lines pass."""

    def draw(
        self,
        records: NDArray[np.float32],
        camera: Camera,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        frame: Frame,
    ) -> None:
        """Ink into the framebuffer that is bound, where the frame's finished depth does not hide
        it. The camera's depth range is turned (`turned`)."""
        inputs = inputs_of(camera, frame)
        if shader.expand is None:
            say_once("style shader {!r} needs OpenGL {}.{}".format(shader.name, *MODERN))
        if inputs is None or shader.expand is None:
            return
        gl.glViewport(*camera.viewport)
        put_the_apps_arrays_away()
        for start in range(0, len(records), _AT_ONCE):
            some = records[start : start + _AT_ONCE]
            found = shader.expand(
                some, camera, uniforms,
                hair=frame.depth_margin, blur=frame.depth.sample_offset,
            )  # fmt: skip
            if not len(found.places):
                continue
            program, locations = self._program(shader, found)
            program.use(inputs, uniforms)
            _draw(found, camera, locations)

    def _program(self, shader: Shader, found: Expansion) -> tuple[Program, list[int]]:
        sizes = tuple((name, rows.shape[1]) for name, rows in found.values.items())
        known = self._programs.get((shader, sizes))
        if known is None:
            declared = " ".join(
                f"attribute {_TYPES[size]} of_{name}; varying {_TYPES[size]} {name};"
                for name, size in sizes
            )
            copied = " ".join(f"{name} = of_{name};" for name, _ in sizes)
            program = self._device.program(
                shader.name,
                f"#version 120\n#define DECLARED {declared}\n#define COPIED {copied}\n{_VERTEX}",
                f"#version 120\n{_FRAGMENT}\n#line 1\n{shader.fragment}",
            )
            attributes = ("place", *(f"of_{name}" for name, _ in sizes))
            known = program, [program.location(attribute) for attribute in attributes]
            self._programs[shader, sizes] = known
        return known


def _draw(found: Expansion, camera: Camera, locations: Sequence[int]) -> None:
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
    used = [one for one in zip(locations, columns, strict=True) if one[0] >= 0]
    for location, (array, width, offset) in used:
        gl.glEnableVertexAttribArray(location)
        data, stride = array.ctypes.data + offset, array.strides[-2]
        gl.glVertexAttribPointer(location, width, GL_FLOAT, 0, stride, data)
    gl.glDrawArrays(GL_TRIANGLES, 0, len(rows))
    for location, _ in used:
        gl.glDisableVertexAttribArray(location)
