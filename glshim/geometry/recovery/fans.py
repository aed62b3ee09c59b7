"""Polygons as the triangles that drivers draw them in: fans from the first corner."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch

Indices = NDArray[np.int32]
Flags = NDArray[np.bool_]


def fans(batch: PolygonBatch, vertex: Indices) -> tuple[Indices, Indices, Flags]:
    """(T, 3) vertices of triangles, wound as their polygons, (T,) the polygon of each, and (T, 3)
    whether the side from each corner to the next is a true side of the polygon.

    vertex (N,) is the welded vertex of each position. Corners that repeat the next one are passed
    over; triangles with fewer than three distinct vertices are left out.
    """
    corners, starts, true = vertex[batch.corners], batch.starts, batch.boundary
    if len(corners) == 3 * batch.polygon_count and (np.diff(starts) == 3).all():
        triangles, true = corners.reshape(-1, 3), true.reshape(-1, 3)
        polygon = np.arange(len(triangles), dtype=np.int32)
    else:
        triangles, polygon, true = _fans(*_distinct(corners, starts, true))
    a, b, c = triangles.T
    sound = (a != b) & (b != c) & (c != a)
    if sound.all():
        return triangles, polygon, true
    return triangles[sound], polygon[sound], true[sound]


def _distinct(corners: Indices, starts: Indices, true: Flags) -> tuple[Indices, Indices, Flags]:
    """Polygons without the corners that the next one repeats: their sides have no length, and
    the sides before them lead to the next just as well."""
    starts = starts.astype(np.int64)
    sizes = np.diff(starts)
    following = np.arange(1, len(corners) + 1)
    full = sizes > 0
    following[starts[1:][full] - 1] = starts[:-1][full]
    keep = corners != corners[following]
    if keep.all():
        return corners, starts.astype(np.int32), true
    kept = np.concatenate(([0], np.cumsum(keep)))
    return corners[keep], kept[starts].astype(np.int32), true[keep]


def _fans(corners: Indices, starts: Indices, true: Flags) -> tuple[Indices, Indices, Flags]:
    sizes = np.diff(starts)
    counts = np.maximum(sizes - 2, 0)
    polygon = np.repeat(np.arange(len(sizes), dtype=np.int32), counts)
    step = np.arange(len(polygon)) - np.repeat(np.cumsum(counts) - counts, counts)
    hub = starts[:-1][polygon]
    triangles = np.stack((corners[hub], corners[hub + step + 1], corners[hub + step + 2]), axis=1)
    sides = np.zeros((len(polygon), 3), np.bool_)
    sides[:, 0] = true[hub] & (step == 0)
    sides[:, 1] = true[hub + step + 1]
    last = step == sizes[polygon] - 3
    sides[:, 2] = true[hub + step + 2] & last
    return triangles, polygon, sides
