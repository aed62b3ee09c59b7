"""Sides cut where others' ends lie on them, so that they find neighbours piece by piece."""

from __future__ import annotations

import numpy as np

from glshim.geometry.recovery.junctions import PARTED, Lone, junctions
from glshim.geometry.recovery.welding import weld
from glshim.model.arrays import Floats, Indices, Rows


def pieces(
    sides: Floats, polygon: Indices, alone: Rows, owner: Indices | None
) -> tuple[Floats, Rows] | None:
    """(N, 6) sides of which none runs along several others, and (N,) the row that each was; None
    where none does.

    sides (E, 6) and their polygons (E,); alone: rows of those that know no neighbour; owner (E,):
    those of unlike owners keep apart.
    """
    if len(alone) < 3:
        return None
    points = sides[alone].reshape(-1, 3)
    with np.errstate(over="ignore", invalid="ignore"):
        extent = float((points.max(axis=0) - points.min(axis=0)).max())
    if not np.isfinite(extent):
        return None
    first, vertex = weld(points, extent * PARTED)
    own = None if owner is None else owner[alone]
    if own is not None:  # a vertex for each owner
        key = vertex * np.int64(own.max() + 1) + np.repeat(own, 2)
        _, first, found = np.unique(key, return_index=True, return_inverse=True)
        vertex = found.reshape(-1).astype(np.int32)
    places = points[first]
    on = junctions(
        Lone(places.astype(np.float64), vertex.reshape(-1, 2), polygon[alone], own)
    )
    if not len(on.side):
        return None
    # In the order of sides, and along each, a piece before every junction and one behind the last.
    counts = np.ones(len(sides), np.intp)
    rows = alone[on.side]
    np.add.at(counts, rows, 1)
    parent = np.repeat(np.arange(len(sides)), counts)
    cut = sides[parent]
    order = np.argsort(rows, kind="stable")
    last = np.cumsum(counts) - 1
    rank = np.arange(len(rows)) - np.searchsorted(rows[order], rows[order])
    before = last[rows[order]] - counts[rows[order]] + 1 + rank
    cut[before, 3:6] = cut[before + 1, 0:3] = places[on.vertex[order]]
    return cut, parent
