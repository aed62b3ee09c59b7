"""Triangles cut at vertices that lie on their sides, so that every side has one neighbour."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.recovery.adjacency import Sides
from glshim.geometry.recovery.fans import Fans
from glshim.geometry.recovery.junctions import LOOSE, PARTED, ROUNDING, Junctions, Lone, junctions
from glshim.geometry.recovery.welding import weld
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.vectors import dot


@dataclass(frozen=True, slots=True, eq=False)
class Blend:
    """Corners of triangles that lie between two corners of a batch."""

    beyond: Indices
    """(T, 3) the corner of the batch towards which each lies."""
    share: Floats
    """(T, 3) how far towards it, of the way."""

    def of(self, normals: Floats, found: Floats) -> Floats:
        """(T, 3, 3) normals (C, 3) at the corners; found: of those from which each lies away."""
        share = self.share[:, :, None]
        return np.asarray(found + share * (normals[self.beyond] - found), np.float32)

    def turned(self, turn: Flags) -> Blend:
        """With triangles (T,) turned round."""
        rows = turn[:, None]
        return Blend(*(np.where(rows, part[:, (0, 2, 1)], part)
                       for part in (self.beyond, self.share)))  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Joints:
    """Vertices that lie on sides."""

    vertices: Indices
    """(J, 3) the ends of a side, and the one on it."""
    along: Doubles
    """(J,) where on the side that is."""
    apart: float
    """How far off the side it may be, over the side's length."""

    def hold(self, positions: Floats) -> bool:
        """Whether they do so in other positions (V, 3)."""
        a, b, on = (positions.take(k, axis=0).astype(np.float64) for k in self.vertices.T)
        off, side = on - a - self.along[:, None] * (b - a), b - a
        limit = np.maximum(self.apart**2 * dot(side, side), (ROUNDING * np.abs(on).max()) ** 2)
        return bool((dot(off, off) <= limit).all())


class Cut(NamedTuple):
    """Triangles of which no side has another's vertex on it."""

    drawn: Fans
    blend: Blend | None
    """With `Fans.corners`."""
    joints: Joints


def rims_welded(triangles: Indices, positions: Floats, sides: Sides) -> Indices | None:
    """(V,) the vertex that each of positions (V, 3) is one with, where it ends a side that has no
    neighbour, and rounding alone parts it from others that do; None where it parts none."""
    lone = sides.alone
    if len(lone) < 2:
        return None
    following = lone - lone % 3 + (lone + 1) % 3
    rim = np.unique(triangles.ravel()[np.concatenate((lone, following))])
    places = positions[rim]
    with np.errstate(over="ignore"):
        extent = float((places.max(axis=0) - places.min(axis=0)).max())
    if not np.isfinite(extent):
        return None
    first, vertex = weld(places, extent * PARTED)
    if len(first) == len(rim):
        return None
    found = np.arange(len(positions), dtype=np.int32)
    found[rim] = rim[first[vertex]]
    return found


def cut_at_junctions(
    drawn: Fans, positions: Floats, sides: Sides, tolerance: float
) -> Cut | None:
    """The triangles, cut where sides that have no neighbour run along several others; None where
    none does. positions (V, 3); sides as `meet` finds them."""
    lone = sides.alone
    if len(lone) < 3:
        return None
    triangle, k = np.divmod(lone, 3)
    corners = drawn.triangles[triangle]
    at = np.arange(len(lone))
    ends = np.stack((corners[at, k], corners[at, (k + 1) % 3]), axis=1)
    polygon = drawn.polygon[triangle]
    found = junctions(Lone(positions.astype(np.float64), ends, polygon), tolerance)
    # Of a sliver a vertex may lie on two sides, or be the corner across.
    own = drawn.triangles[triangle[found.side]]
    key = triangle[found.side] * np.int64(len(positions)) + found.vertex
    once = np.sort(np.unique(key, return_index=True)[1])
    found = found.take(once[~(own[once] == found.vertex[once, None]).any(axis=1)])
    if not len(found.side):
        return None
    joints = np.concatenate((ends[found.side], found.vertex[:, None]), axis=1, dtype=np.int32)
    cut, blend = _cut(drawn, Junctions(lone[found.side], found.vertex, found.along))
    return Cut(cut, blend, Joints(joints, found.along, LOOSE))


def _cut(drawn: Fans, at: Junctions) -> tuple[Fans, Blend | None]:
    """Triangles cut at junctions on their sides, 3 t + k."""
    own = np.unique(at.side // 3)
    rest = np.delete(np.arange(len(drawn.triangles)), own)
    tri, true = drawn.triangles[own].astype(np.int32), drawn.true[own]
    parent = own
    # Of each corner: the triangle's corners that it lies between, and where.
    base = 3 * own[:, None] + np.arange(3)
    low, high, share = base, base, np.zeros(base.shape)
    number = np.searchsorted(own, at.side // 3)
    side, vertex, along = at.side % 3, at.vertex.astype(np.int32), at.along
    begin, end = at.side, at.side - side + (side + 1) % 3
    while len(number):
        order = np.lexsort((along, side, number))
        number, side, vertex, along = number[order], side[order], vertex[order], along[order]
        begin, end = begin[order], end[order]
        starts = np.flatnonzero(np.concatenate(([True], number[1:] != number[:-1])))
        counts = np.diff(starts, append=len(number))
        chosen = starts + counts // 2  # the middle one: as many rounds as its logarithm
        t, k, p, where = number[chosen], side[chosen], vertex[chosen], along[chosen]
        first, second = _halves(tri[t], k, p)
        flags, others = _flags(true[t], k)
        lows, highs = _halves(low[t], k, begin[chosen]), _halves(high[t], k, end[chosen])
        shares = _halves(share[t], k, where)
        fresh = len(tri) + np.arange(len(t))
        # What is left lies on one half or the other.
        mine = np.repeat(np.arange(len(t)), counts)
        left = np.ones(len(number), np.bool_)
        left[chosen] = False
        turn = (side - k[mine]) % 3
        later = (turn == 1) | ((turn == 0) & (along > where[mine]))
        number = np.where(later, fresh[mine], number)[left]
        side = turn[left]  # both halves begin at the cut side: 0, 1 of the second, 2 of the first
        vertex, along, begin, end = vertex[left], along[left], begin[left], end[left]
        tri[t], true[t] = first, flags
        tri, true = np.concatenate((tri, second)), np.concatenate((true, others))
        parent = np.concatenate((parent, parent[t]))
        low[t], high[t], share[t] = lows[0], highs[0], shares[0]
        low, high = np.concatenate((low, lows[1])), np.concatenate((high, highs[1]))
        share = np.concatenate((share, shares[1]))
    triangles = np.concatenate((drawn.triangles[rest], tri))
    polygon = np.concatenate((drawn.polygon[rest], drawn.polygon[parent]))
    flags = np.concatenate((drawn.true[rest], true))
    if drawn.corners is None:
        return Fans(triangles, polygon, flags, None), None
    kept, all_corners = drawn.corners[rest], drawn.corners.ravel()
    corners = np.concatenate((kept, all_corners[low]))
    beyond = np.concatenate((kept, all_corners[high]))
    towards = np.concatenate((np.zeros(kept.shape), share)).astype(np.float32)
    return Fans(triangles, polygon, flags, corners), Blend(beyond, towards)


def _halves(rows: NDArray[Any], k: Rows, new: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Of triangles (N, 3) with a new corner on side k, both parts: they begin at that side."""
    at = np.arange(len(rows))
    start, end, across = (rows[at, (k + step) % 3] for step in range(3))
    return np.stack((start, new, across), axis=1), np.stack((new, end, across), axis=1)


def _flags(true: Flags, k: Rows) -> tuple[Flags, Flags]:
    """Which sides of both parts are true ones of the polygon (N, 3): the cut is none."""
    at = np.arange(len(true))
    own, after, before = (true[at, (k + step) % 3] for step in range(3))
    cut = np.zeros(len(true), np.bool_)
    return np.stack((own, cut, before), axis=1), np.stack((own, after, cut), axis=1)
