"""Polygons as the triangles that a driver draws."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.model import polygons
from glshim.model.batch import PolygonBatch
from glshim.model.vectors import cross

_SLIVER = 1e-6
"""Area of a triangle over the square of its longest side below which float32 has no facing for it.
"""


def triangles(batch: PolygonBatch) -> NDArray[np.float32]:
    """(T, 3, 3) the polygons of a batch as fans, object space."""
    corners = batch.corners[polygons.fans(batch.starts).corners]
    return np.ascontiguousarray(batch.positions[corners], np.float32)


def flagged_triangles(batch: PolygonBatch) -> tuple[NDArray[np.float32], NDArray[np.uint8]]:
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
