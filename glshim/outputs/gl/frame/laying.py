"""Depth for windows that have none: lines need it to hide them, so the layer's polygons are laid
down in a depth buffer of our own."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.device.programs import compiled
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, scissor
from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.spec.context import has_vertex_arrays
from glshim.spec.driver import gl

_TRIANGLES, _FLOAT = 0x0004, 0x1406
_ARRAY_BUFFER, _DEPTH_TEST, _SCISSOR_TEST = 0x8892, 0x0B71, 0x0C11
_NO_PLANE = (0.0, 0.0, 0.0, 1.0)
Item = tuple[PolygonBatch, Camera]


def triangles(batch: PolygonBatch) -> NDArray[np.float32]:
    """(T, 3, 3) the polygons of a batch as fans, object space."""
    starts, sizes = batch.starts[:-1], np.diff(batch.starts)
    count = np.maximum(sizes - 2, 0)
    first = np.repeat(starts, count)
    step = np.arange(len(first)) - np.repeat(np.cumsum(count) - count, count)
    fans = batch.corners[np.stack([first, first + step + 1, first + step + 2], axis=1)]
    return np.ascontiguousarray(batch.positions[fans], np.float32)


class Layer:
    """Lays polygons down as depth. Make and use it inside the state guard."""

    def __init__(self) -> None:
        shaders = files("glshim.outputs.gl") / "shaders"
        texts = ((shaders / f"lay.{kind}.glsl").read_text("utf-8") for kind in ("vert", "frag"))
        self._program = compiled("lay", next(texts), next(texts), ("vertex",))
        self._at = {
            name: int(gl.glGetUniformLocation(self._program, name.encode()))
            for name in ("modelview", "projection", "planes")
        }

    def lay(self, items: Iterable[Item], depth: DepthCopy, box: Box, greater: bool) -> None:
        """Fill a depth copy with the polygons of items, in a box of the framebuffer. greater:
        farther is less depth."""
        depth.open(box, greater)
        gl.glEnable(_DEPTH_TEST)
        gl.glDepthFunc(0x0206 if greater else 0x0203)
        gl.glEnable(_SCISSOR_TEST)
        gl.glUseProgram(self._program)
        if has_vertex_arrays():
            gl.glBindVertexArray(0)
        gl.glBindBuffer(_ARRAY_BUFFER, 0)
        gl.glEnableVertexAttribArray(0)
        for batch, camera in items:
            points = triangles(batch)
            if not len(points) or min(camera.viewport[2:]) <= 0:
                continue
            gl.glViewport(*camera.viewport)
            gl.glDepthRange(*camera.depth_range)
            scissor(camera, box)
            for name in ("modelview", "projection"):
                matrix = np.ascontiguousarray(getattr(camera, name).T, np.float32)
                gl.glUniformMatrix4fv(self._at[name], 1, 0, matrix.ctypes.data)
            planes = [*camera.clip_planes, *[_NO_PLANE] * MOST_CLIP_PLANES][:MOST_CLIP_PLANES]
            values = np.array(planes, np.float32)
            gl.glUniform4fv(self._at["planes"], MOST_CLIP_PLANES, values.ctypes.data)
            gl.glVertexAttribPointer(0, 3, _FLOAT, 0, 0, points.ctypes.data)
            gl.glDrawArrays(_TRIANGLES, 0, 3 * len(points))
        gl.glDisableVertexAttribArray(0)
        gl.glDisable(_DEPTH_TEST)
        gl.glDepthMask(0)
