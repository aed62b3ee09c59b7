"""T-junctions: vertices of one polygon that lie on the side of another.

A side along several others' (results of CSG, patches tessellated apart) has a neighbour piece by
piece, once it is cut at their ends. Only sides that know no neighbour are looked at. Any one space.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.welding import distinct, mixed
from glshim.model.arrays import Doubles, Flags, Indices, Rows, within
from glshim.model.vectors import dot

_EXACT = 1e-3
"""Way of a vertex from a side, over the length of the shorter of the two that run along each
other, up to which it lies on it."""
LOOSE = 0.08
"""The same between two places at which the surfaces meet exactly: chords of one curve."""
ROUNDING = 16 * float(np.finfo(np.float32).eps)
"""Over the largest coordinate: what float32 corners miss a side by."""
PARTED = 2.0**-17
"""Over the extent of all open sides: how far it moves a corner that is computed twice."""
_CURVED = 0.6
"""How far a vertex off a chord may be from where its own sides say that the curve runs, over its
way from the chord."""
_ALONG = float(np.cos(np.radians(20.0)))
"""Cosine of the angle up to which sides run along each other."""
_CROWD = 64
"""Vertices of a cell that are looked at, at most."""


class Lone(NamedTuple):
    """Sides that know no neighbour."""

    points: Doubles
    """(V, 3) vertices."""
    ends: Indices
    """(S, 2) of each side."""
    polygon: Indices
    """(S,) that each is of."""
    owner: Indices | None = None
    """(S,) those of unlike owners keep apart, and have no vertex in common."""


class _Shape(NamedTuple):
    """Sides as vectors."""

    way: Doubles
    """(S, 3) from end to end."""
    length: Doubles
    """(S,)"""

    @classmethod
    def of(cls, lone: Lone) -> _Shape:
        way = lone.points[lone.ends[:, 1]] - lone.points[lone.ends[:, 0]]
        return cls(way, np.sqrt(dot(way, way)))


class Junctions(NamedTuple):
    """Vertices that lie on sides, ordered by side and along it."""

    side: Rows
    """(J,)"""
    vertex: Rows
    """(J,)"""
    along: Doubles
    """(J,) where on the side, of its length."""

    def take(self, rows: Rows) -> Junctions:
        """Some of them."""
        return Junctions(self.side[rows], self.vertex[rows], self.along[rows])


_NONE = Junctions(np.empty(0, np.intp), np.empty(0, np.intp), np.empty(0))


def junctions(lone: Lone, tolerance: float = 0.0) -> Junctions:
    """Which vertices lie on which sides, where other polygons' sides run along these.

    tolerance: absolute, that vertices were welded with.
    """
    with np.errstate(invalid="ignore", over="ignore"):
        shape = _Shape.of(lone)
        sound = np.flatnonzero((shape.length > 0.0) & np.isfinite(shape.length))
        if len(sound) < 3:
            return _NONE
        side, vertex = _near(lone, shape.length, sound)
    # Most are far off: an axis at a time, without a row for each.
    x, y, z = (axis.take(vertex) - axis.take(lone.ends[:, 0].take(side))
               for axis in np.ascontiguousarray(lone.points.T))  # fmt: skip
    u, v, w = (axis.take(side) for axis in np.ascontiguousarray(shape.way.T))
    square = (shape.length * shape.length).take(side)
    share = (x * u + y * v + z * w) / square
    far = x * x + y * y + z * z - share * share * square
    most = max(ROUNDING * float(np.abs(lone.points).max()), tolerance)
    near = (share > 0.0) & (share < 1.0) & (far <= LOOSE * LOOSE * square + most * most)
    key = distinct(side[near] * np.int64(len(lone.points)) + vertex[near])
    side, vertex = key // len(lone.points), key % len(lone.points)

    along, length = shape.way[side], shape.length[side]
    off = lone.points[vertex] - lone.points[lone.ends[side, 0]]
    share = dot(off, along) / length**2
    off -= share[:, None] * along
    apart = np.sqrt(dot(off, off))
    slack = ROUNDING * np.abs(lone.points[vertex]).max(axis=1, initial=0.0)
    slack = np.maximum(slack, tolerance)
    inside = np.minimum(share, 1.0 - share) * length > np.maximum(slack, _EXACT * length)
    kept = np.flatnonzero(inside & (apart <= np.maximum(slack, LOOSE * length)))
    if not len(kept):
        return _NONE
    found = Junctions(side[kept], vertex[kept], share[kept])
    rows = _meant(found, lone, shape, off[kept], slack[kept])
    return found.take(rows[np.lexsort((found.along[rows], found.side[rows]))])


def _near(lone: Lone, length: Doubles, sound: Rows) -> tuple[Rows, Rows]:
    """Pairs of a side and a vertex that may lie on it, some twice: those in the cells around
    places along the side."""
    points, ends = lone.points, lone.ends
    step = float(length[sound].sum()) / len(sound)
    of = np.zeros(len(ends), np.int64) if lone.owner is None else lone.owner.astype(np.int64)
    whose = np.full(len(points), -1, np.int64)
    whose[ends[sound]] = of[sound, None]
    used = np.flatnonzero(whose >= 0)
    bits = (4 * len(used)).bit_length()
    cell = _cells(np.floor(points[used] / step), whose[used], bits)
    held = used[np.argsort(cell)]
    begins = np.concatenate(([0], np.cumsum(np.bincount(cell, minlength=1 << bits))))
    # Places no further apart than half a cell: with what they miss a side by, vertices on it are
    # never further than half a cell from one, and so in one of the eight cells about it.
    counts = np.maximum(np.ceil(2.0 * length[sound] / step), 1.0).astype(np.intp)
    which = np.repeat(sound, counts)
    share = (within(counts) + 0.5) / np.repeat(counts, counts)
    a, b = points[ends[which, 0]], points[ends[which, 1]]
    corner = np.floor((a + share[:, None] * (b - a)) / step - 0.5)
    sides, vertices = [], []
    for around in product((0.0, 1.0), repeat=3):
        cell = _cells(corner + around, of[which], bits)
        low = begins.take(cell)
        found = np.minimum(begins.take(cell + 1) - low, _CROWD)
        sides.append(np.repeat(which, found))
        vertices.append(held.take(np.repeat(low, found) + within(found)))
    side, vertex = np.concatenate(sides), np.concatenate(vertices)
    own = (vertex == ends[side, 0]) | (vertex == ends[side, 1])
    return side[~own], vertex[~own]


def _cells(cells: Doubles, owner: Rows, bits: int) -> Rows:
    """(N,) a number of so many bits for each cell (N, 3) of an owner; some have the same."""
    x, y, z = cells.T.astype(np.int64)
    return np.asarray(mixed((x, y, z, owner)) >> np.uint64(64 - bits), np.intp)


def _meant(
    found: Junctions, lone: Lone, shape: _Shape, off: Doubles, slack: Doubles
) -> Rows:
    """Those at which a side of another polygon runs along: near enough, or, of curves, between two
    places where the surfaces meet exactly. off (J, 3): from the side to the vertex."""
    count = len(found.side)
    each = lone.ends.ravel()
    by_vertex = np.argsort(each, kind="stable")
    ordered = each[by_vertex]
    starts = np.searchsorted(ordered, found.vertex)
    counts = np.searchsorted(ordered, found.vertex, "right") - starts
    row = np.repeat(np.arange(count), counts)
    half = by_vertex[np.repeat(starts, counts) + within(counts)]
    one, other = found.side[row], half // 2
    lengths = shape.length[one] * shape.length[other]
    beside = np.abs(dot(shape.way[one], shape.way[other])) >= _ALONG * lengths
    own = np.bincount(row, lone.polygon[one] == lone.polygon[other], count) > 0
    beside &= ~own[row]
    apart = np.sqrt(dot(off, off))
    shorter = np.minimum(shape.length[one], shape.length[other])
    near = beside & (apart[row] <= np.maximum(slack[row], _EXACT * shorter))
    holds: Flags = np.bincount(row, near, count) > 0
    # Of curves: the two sides at the vertex turn by as much as it lies off the chord.
    loose = beside & ~holds[row] & (apart[row] <= LOOSE * shorter)
    row, half, one, other = row[loose], half[loose], one[loose], other[loose]
    first = np.flatnonzero(row[1:] == row[:-1])
    rows = row[first]
    if len(rows):
        bulge, reach = np.zeros((len(rows), 3)), np.ones(len(rows))
        for at in (first, first + 1):
            away = np.where(half[at] % 2 == 0, 1.0, -1.0)[:, None] * shape.way[other[at]]
            bulge -= away / 2.0
            reach *= shape.length[other[at]]
        share = found.along[rows]
        meant = share * (1.0 - share) * shape.length[one[first]] ** 2 / reach
        meant = meant[:, None] * bulge
        missed = off[rows] - meant
        curved = dot(missed, missed) <= _CURVED**2 * dot(meant, meant)
        degree = np.bincount(each)
        anchor = degree > 2  # more than two sides come together: surfaces share it
        anchor[found.vertex[holds]] = True
        first, rows = first[curved], rows[curved]
        links = [(one[at], other[at]) for at in (first, first + 1)]
        a, b = (np.concatenate(part).astype(np.int32) for part in zip(*links, strict=True))
        label = components(len(lone.ends), a, b).label
        holds[rows] |= _anchored(lone.ends, label, anchor)[one[first]]
    return np.flatnonzero(holds)


def _anchored(ends: Indices, label: Indices, anchor: Flags) -> Flags:
    """(S,) which sides are of a chain (label) between two anchors."""
    at = np.flatnonzero(anchor[ends.ravel()])
    key = label[at // 2] * np.int64(len(anchor)) + ends.ravel()[at]
    chains = np.bincount(np.unique(key) // len(anchor), minlength=len(ends))
    return np.asarray(chains[label] > 1)
