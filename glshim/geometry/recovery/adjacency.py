"""Which triangles share which edges: the rows of a Mesh."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from glshim.geometry.recovery.components import turned
from glshim.geometry.recovery.welding import sorted_with
from glshim.model.arrays import Flags, Indices, Rows

_NEXT, _BEFORE = np.array((1, 2, 0)), np.array((2, 0, 1))


class Adjacency(NamedTuple):
    """The fields of `Mesh` with these names."""

    triangles: Indices
    edges: Indices
    faces: Indices
    opposite: Indices
    halves: Indices
    true: Flags
    manifold: Flags
    turned: Flags
    twisted: Flags


class Sides(NamedTuple):
    """Sides of triangles, 3 t + k for the one from corner k of triangle t, by their edges."""

    one: Rows
    other: Rows
    """The two sides of each edge that has two, the lesser first."""
    crowded: Rows
    """Sides on edges with three and more, edge by edge."""
    crowds: Rows
    """Where in crowded each edge begins."""
    alone: Rows
    """Sides on edges of their own."""


def meet(triangles: Indices, count: int) -> Sides:
    """The sides of triangles (T, 3) that lie on one edge, of count vertices."""
    start, end = triangles, triangles[:, _NEXT]
    key = np.minimum(start, end).astype(np.int64)
    key *= count
    key += np.maximum(start, end)
    key = key.ravel()
    order, ordered = sorted_with(key.view(np.uint64), 2 * count.bit_length())
    begins = np.ones(len(key), np.bool_)
    np.not_equal(ordered[1:], ordered[:-1], out=begins[1:])
    at = np.flatnonzero(begins)
    sizes = np.diff(at, append=len(key))
    pairs = at[sizes == 2]
    one, other = order[pairs], order[pairs + 1]
    many = sizes > 2
    crowded = order[np.repeat(many, sizes)] if many.any() else order[:0]
    crowds = np.cumsum(sizes[many]) - sizes[many]
    alone = order[at[sizes == 1]]
    return Sides(np.minimum(one, other), np.maximum(one, other), crowded, np.asarray(crowds), alone)


def repeated(triangles: Indices, sides: Sides) -> Rows:
    """Which triangles have come before with the same winding: a surface drawn twice, none of
    whose edges would be an edge of two."""
    starts, across = triangles.ravel(), triangles[:, _BEFORE].ravel()
    alike = np.flatnonzero(starts.take(sides.one) == starts.take(sides.other))
    twice = across.take(sides.one.take(alike)) == across.take(sides.other.take(alike))
    pairs = alike[twice]
    if not len(pairs) and not len(sides.crowded):
        return np.empty(0, np.intp)
    doubtful = (sides.crowded, sides.one[pairs], sides.other[pairs])
    suspects = np.unique(np.concatenate(doubtful) // 3)
    corners = triangles[suspects]
    turn = corners.argmin(axis=1)[:, None] + np.arange(3)
    corners = np.take_along_axis(corners, turn % 3, axis=1)
    order = np.lexsort(corners.T)  # stable: the one that came first stays first
    ordered = corners[order]
    same = np.flatnonzero((ordered[1:] == ordered[:-1]).all(axis=1))
    return np.asarray(suspects[order[same + 1]])


def adjacency(triangles: Indices, true: Flags, sides: Sides) -> Adjacency:
    """Who meets at which edge, after turning triangles to agree.

    triangles (T, 3), wound as the app sent them, and true (T, 3), for the side from each corner.
    """
    count = 3 * len(triangles)
    flags = true.ravel().copy()
    if len(sides.crowded):
        sizes = np.diff(sides.crowds, append=len(sides.crowded))
        flags[sides.crowded] = np.repeat(
            np.logical_or.reduceat(flags[sides.crowded], sides.crowds), sizes
        )
    flags[sides.one] |= flags.take(sides.other)
    mate = np.full(count, -1, np.int32)
    mate[sides.one] = sides.other
    hidden = np.zeros(count, np.bool_)
    hidden[sides.other] = True
    manifold = np.ones(count, np.bool_)
    manifold[sides.crowded] = False
    a = np.flatnonzero(~hidden).astype(np.int32)
    b = mate[a]

    faces = np.stack((a // 3, b // 3), axis=1)  # -1 // 3 is -1
    met = np.flatnonzero(b >= 0)
    starts, ends = triangles.ravel(), triangles[:, _NEXT].ravel()
    against = starts.take(a.take(met)) == starts.take(b.take(met))
    first, second = faces.take(met, axis=0).T
    turn = turned(len(triangles), first, second, against)
    twisted = np.zeros(len(a), np.bool_)
    twisted[met] = against ^ turn[first] ^ turn[second]

    edges = np.stack((starts.take(a), ends.take(a)), axis=1)
    halves = np.stack((a, b), axis=1)
    opposite = np.empty_like(edges)
    across = triangles[:, _BEFORE].ravel()
    opposite[:, 0] = across.take(a)
    if turn.any():
        back = turn[faces[:, 0]]
        edges[back] = edges[back][:, ::-1]
        triangles = triangles.copy()
        triangles[turn] = triangles[turn][:, (0, 2, 1)]
        # Of what was the side from corner k the end is now its start: corner 2 - k.
        round_ = turn[faces] & (halves >= 0)
        halves[round_] = (6 * faces + 2 - halves)[round_]
    opposite[:, 1] = np.where(b >= 0, across.take(b), edges[:, 0])
    return Adjacency(
        triangles, edges, faces, opposite, halves, flags[a], manifold[a], turn, twisted
    )
