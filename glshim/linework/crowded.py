"""Lines where many lie within a few pixels: what is hidden there is left out, as a draughtsman
does. Dashes of it would make a thicket that hides what is seen."""

from __future__ import annotations

import numpy as np

from glshim.geometry.window import cut, window
from glshim.model.arrays import Floats
from glshim.model.camera import Camera
from glshim.model.lines import CROWDED, Line

_CELL = 6.0
"""Pixels; lines are counted over three times as many either way."""
_MOST = 4.0
"""Lines side by side there, from which on they are many."""


def crowded(records: Floats, camera: Camera) -> Floats:
    """Records (L, 21), in eye space, with `CROWDED` in the kinds of those that lie among many for
    most of their way in the window."""
    whole = records[:, Line.A].astype(np.float64), records[:, Line.B].astype(np.float64)
    with np.errstate(all="ignore"):
        (a, b), _, left = cut(*whole, camera)
        begin, end = (window(point, camera)[:, :2] for point in (a, b))
        x, y, width, height = camera.viewport
        low, high = np.array((x, y)) - _CELL, np.array((x + width, y + height)) + _CELL
        way = end - begin
        sides = np.sort([(low - begin) / way, (high - begin) / way], axis=0)
        # A line along an axis is between the two sides of it all the way, or never.
        beside = ((begin < low) | (begin > high))[None] & (way == 0.0)[None]
        sides = np.where(way == 0.0, np.array((-np.inf, np.inf))[:, None, None], sides)
        sides = np.where(beside, np.array((np.inf, -np.inf))[:, None, None], sides)
        enter = np.maximum(sides[0].max(axis=1), 0.0)
        leave = np.minimum(sides[1].min(axis=1), 1.0)
        left &= np.isfinite(way).all(axis=1) & (enter < leave)
    rows = np.flatnonzero(left)
    begin, way = begin[rows] + enter[rows, None] * way[rows], way[rows]
    way *= (leave - enter)[rows, None]
    length = np.hypot(*way.T)
    count = np.maximum(np.ceil(2.0 * length / _CELL), 1.0).astype(np.intp)
    which = np.repeat(np.arange(len(rows)), count)
    number = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    share = (number + 0.5) / count[which]
    at = begin[which] + share[:, None] * way[which]
    inside = ((at >= low) & (at < high)).all(axis=1)
    which, at = which[inside], at[inside]
    columns, lines = (np.ceil((high - low) / _CELL).astype(np.intp) + 1).tolist()
    column, line = ((at - low) / _CELL).astype(np.intp).T
    cell = line * columns + column
    weight = (length / count)[which]
    total = np.bincount(cell, weight, minlength=columns * lines).reshape(lines, columns)
    padded = np.pad(total, 1)
    near = np.zeros_like(total)  # in nine cells
    for i, j in np.ndindex(3, 3):
        near += padded[i : i + lines, j : j + columns]
    many = near.ravel()[cell] > _MOST * 3.0 * _CELL
    among = np.bincount(which, many, minlength=len(rows))
    seen = np.bincount(which, minlength=len(rows))
    records = records.copy()
    records[rows[2.0 * among > seen], Line.KIND] += CROWDED
    return records
