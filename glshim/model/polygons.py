"""Polygons cut into triangles as drivers cut them: fans about the first corner."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.model.arrays import Flags, Indices, Rows, within


class Fans(NamedTuple):
    """The triangles of polygons, wound as these."""

    corners: Rows
    """(T, 3) corners of the polygons' rows."""
    polygon: Indices
    """(T,) the polygon of each."""
    outer: Flags
    """(T, 3) the side from each corner to the next is one of the polygon's."""


def fan(sides: int) -> Rows:
    """(sides - 2, 3) the corners of the triangles of one polygon; none of fewer than 3."""
    step = np.arange(max(sides - 2, 0))
    return np.stack((np.zeros_like(step), step + 1, step + 2), axis=1)


def fans(starts: NDArray[np.integer]) -> Fans:
    """The triangles of polygons with the corners starts[p] to starts[p + 1] - 1; none of fewer
    than 3."""
    sizes = np.diff(starts)
    counts = np.maximum(sizes - 2, 0)
    polygon = np.repeat(np.arange(len(sizes), dtype=np.int32), counts)
    step = within(counts)
    hub = starts[:-1][polygon]
    corners = np.stack((hub, hub + step + 1, hub + step + 2), axis=1)
    outer = np.ones(corners.shape, np.bool_)
    outer[:, 0] = step == 0
    outer[:, 2] = step == sizes[polygon] - 3
    return Fans(corners, polygon, outer)
