"""Depth for windows that have none: lines need it to hide them, so the layer's polygons are laid
down in a depth buffer of our own."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.driver.functions import gl
from glshim.model.batch import Item
from glshim.outputs.gl.device.devices import Device
from glshim.outputs.gl.device.programs import shader_text
from glshim.outputs.gl.device.triangles import triangles
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, scissor
from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_DEPTH_TEST,
    GL_FLOAT,
    GL_GEQUAL,
    GL_LEQUAL,
    GL_SCISSOR_TEST,
    GL_TRIANGLES,
)

_NO_PLANE = (0.0, 0.0, 0.0, 1.0)


class DepthFill:
    """Draws polygons as depth alone. Make and use it inside the state guard."""

    def __init__(self, device: Device) -> None:
        self._program = device.program(
            "depth fill", shader_text("depth_fill.vert.glsl"), shader_text("depth_fill.frag.glsl")
        )
        self._vertex = self._program.location("vertex")

    def fill(
        self, depth: DepthCopy, items: Iterable[Item], box: Box, reversed_depth: bool
    ) -> None:
        """Have the depth of items in a copy, in a box of the framebuffer. reversed_depth: farther
        is less depth."""
        depth.open(box, reversed_depth)
        gl.glEnable(GL_DEPTH_TEST)
        gl.glDepthFunc(GL_GEQUAL if reversed_depth else GL_LEQUAL)
        gl.glEnable(GL_SCISSOR_TEST)
        self._program.use()
        gl.glBindBuffer(GL_ARRAY_BUFFER, 0)
        gl.glEnableVertexAttribArray(self._vertex)
        for batch, camera in items:
            points = triangles(batch)
            if not len(points) or min(camera.viewport[2:]) <= 0:
                continue
            gl.glViewport(*camera.viewport)
            gl.glDepthRange(*camera.depth_range)
            scissor(camera, box)
            planes = [*camera.clip_planes, *[_NO_PLANE] * MOST_CLIP_PLANES][:MOST_CLIP_PLANES]
            self._program.set(
                {
                    "modelview": camera.modelview.T, "projection": camera.projection.T,
                    "planes": tuple(planes),
                }
            )  # fmt: skip
            gl.glVertexAttribPointer(self._vertex, 3, GL_FLOAT, 0, 0, points.ctypes.data)
            gl.glDrawArrays(GL_TRIANGLES, 0, 3 * len(points))
        gl.glDisableVertexAttribArray(self._vertex)
        gl.glDisable(GL_DEPTH_TEST)
        gl.glDepthMask(0)
