"""The client's arrays, for draws of our own from the client's memory."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.model import polygons
from glshim.model.batch import PolygonBatch
from glshim.model.vectors import cross
from glshim.spec.ask import integer
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_COLOR_ARRAY,
    GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY,
    GL_INDEX_ARRAY,
    GL_MAX_TEXTURE_COORDS,
    GL_MAX_TEXTURE_UNITS,
    GL_MAX_VERTEX_ATTRIBS,
    GL_NORMAL_ARRAY,
    GL_SECONDARY_COLOR_ARRAY,
    GL_TEXTURE0,
    GL_TEXTURE_COORD_ARRAY,
    GL_VERTEX_ARRAY,
)
from glshim.spec.context import version
from glshim.spec.driver import gl

_ARRAYS = (
    GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY,
)  # fmt: skip
_SLIVER = 1e-6
"""Area of a triangle over the square of its longest side below which float32 has no facing for it.
"""


def put_the_apps_arrays_away() -> None:
    """They may be shorter than what is drawn now. Asks nothing that a version does not have but
    for arrays that it does not know."""
    number = version() or (1, 1)
    if number >= (1, 5):
        gl.glBindBuffer(GL_ARRAY_BUFFER, 0)
    for array in _ARRAYS:
        gl.glDisableClientState(array)
    if number >= (1, 3):
        units = integer(GL_MAX_TEXTURE_UNITS)
        if number >= (2, 0):
            units = max(units, integer(GL_MAX_TEXTURE_COORDS))
        for unit in range(units):
            gl.glClientActiveTexture(GL_TEXTURE0 + unit)
            gl.glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    else:
        gl.glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    if number >= (2, 0):
        for location in range(integer(GL_MAX_VERTEX_ATTRIBS)):
            gl.glDisableVertexAttribArray(location)


def fans(batch: PolygonBatch) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
    """The polygons of a batch as triangles: corners (T, 3, 3), object space, and for each the edge
    flag (T, 3) of the side that leaves it: 1 for a true edge, 0 for a diagonal of a polygon.

    Points that repeat along a polygon (the pole of a sphere of quads) count once. Triangles without
    area are left out: GL takes them for back faces wherever they lie.
    """
    owner = np.repeat(np.arange(batch.polygon_count), np.diff(batch.starts))
    following = np.arange(1, len(owner) + 1)
    following[batch.starts[1:] - 1] = batch.starts[:-1]
    points = batch.positions[batch.corners]
    kept = (points != points[following]).any(axis=1)
    points, flags, owner = points[kept], batch.boundary[kept], owner[kept]
    sizes = np.bincount(owner, minlength=batch.polygon_count)
    corners, _, outer = polygons.fans(np.concatenate(([0], np.cumsum(sizes))))
    flags = flags[corners] & outer
    points = points[corners]
    with np.errstate(invalid="ignore", over="ignore"):
        sides = (points[:, [1, 2, 0]] - points).astype(np.float64)
        area = np.linalg.norm(cross(sides[:, 0], sides[:, 1]), axis=1)
        whole = area > _SLIVER * (sides * sides).sum(axis=2).max(axis=1, initial=0.0)
    return (
        np.ascontiguousarray(points[whole], np.float32),
        np.ascontiguousarray(flags[whole], np.uint8),
    )
