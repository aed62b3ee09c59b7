"""Polygons as the triangles that drivers draw them in: fans from the first corner."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from glshim.model import polygons
from glshim.model.arrays import Flags, Indices, Rows
from glshim.model.batch import PolygonBatch


class Fans(NamedTuple):
    """Triangles of polygons, wound as these."""

    triangles: Indices
    """(T, 3) vertices."""
    polygon: Indices
    """(T,) the polygon of each."""
    true: Flags
    """(T, 3) the side from each corner to the next is a true side of the polygon."""
    corners: Indices | None
    """(T, 3) which corner of the batch each is; None where it has no normals."""

    def only(self, which: Flags | Rows) -> Fans:
        """Some of them."""
        corners = None if self.corners is None else self.corners[which]
        return Fans(self.triangles[which], self.polygon[which], self.true[which], corners)


def fans(batch: PolygonBatch, vertex: Indices) -> Fans:
    """The triangles of a batch.

    vertex (N,) is the welded vertex of each position. Corners that repeat the next one are passed
    over; triangles with fewer than three distinct vertices are left out.
    """
    corners, starts, true = vertex[batch.corners], batch.starts, batch.boundary
    number = None if batch.normals is None else np.arange(len(corners), dtype=np.int32)
    if len(corners) == 3 * batch.polygon_count and (np.diff(starts) == 3).all():
        polygon = np.arange(batch.polygon_count, dtype=np.int32)
        at = None if number is None else number.reshape(-1, 3)
        found = Fans(corners.reshape(-1, 3), polygon, true.reshape(-1, 3), at)
    else:
        found = _fans(*_distinct(corners, starts, true, number))
    a, b, c = found.triangles.T
    sound = (a != b) & (b != c) & (c != a)
    return found if sound.all() else found.only(sound)


def _distinct(
    corners: Indices, starts: Indices, true: Flags, number: Indices | None
) -> tuple[Indices, Indices, Flags, Indices | None]:
    """Polygons without the corners that the next one repeats: their sides have no length, and
    the sides before them lead to the next just as well."""
    starts = starts.astype(np.int64)
    sizes = np.diff(starts)
    following = np.arange(1, len(corners) + 1)
    full = sizes > 0
    following[starts[1:][full] - 1] = starts[:-1][full]
    keep = corners != corners[following]
    if keep.all():
        return corners, starts.astype(np.int32), true, number
    kept = np.concatenate(([0], np.cumsum(keep)))
    number = None if number is None else number[keep]
    return corners[keep], kept[starts].astype(np.int32), true[keep], number


def _fans(corners: Indices, starts: Indices, true: Flags, number: Indices | None) -> Fans:
    at, polygon, outer = polygons.fans(starts)
    sides = true[at] & outer
    return Fans(corners[at], polygon, sides, None if number is None else number[at])
