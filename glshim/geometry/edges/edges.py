"""From polygons to edges: the true sides of sound polygons, and which of them lie together."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from glshim.geometry.edges.pieces import pieces
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.batch import PolygonBatch, join
from glshim.model.camera import cofactors
from glshim.model.polygons import fan
from glshim.model.vectors import cross, unit

_GRAIN = 16 * float(np.finfo(np.float32).eps)
"""Length, over a polygon's largest coordinate, below which float32 corners say nothing: heights of
polygons under it are slivers without a normal, sides under it have no length."""
_CELLS = ((1 << 21, 0.5), (1 << 19, 0.87), (1 << 18, 0.23), (1 << 17, 0.61), (1 << 16, 0.37))
"""Cells per axis in which corners count as one when neighbours are looked for, and the shift of
the cells, for each round of looking."""


_SLIVER = 0.15
"""Part of a polygon's area below which a triangle of it is none of its own."""
_BENT = 2e-3
"""Height of a corner over its polygon's plane, as a part of the polygon's size, that bends it."""

_SPREAD = np.int64(-0x61C8864680B583EB)
"""An odd number that spreads keys over 64 bits."""


@dataclass(frozen=True, eq=False)
class Edges:
    """The true sides of the sound polygons of a batch. Object space.

    A side has its own polygon only; `pairs`, `crowds` and `singles` tell which sides lie on the
    same edge, whatever the windings.
    """

    sides: Floats
    """(E, 6): from ``a`` to ``b``, as the polygon winds."""
    polygon: Indices
    """(E,) row in planes of the side's polygon."""
    planes: Doubles
    """(P, 4): the unit normal of the winding (Newell), minus its product with the centroid."""
    creases: Doubles
    """(P, 3) unit normals that folds are measured by: of the whole polygon, where it is bent and
    held as the triangles that are drawn."""
    parents: Rows
    """(P,) numbers of those whole polygons."""
    order: Rows
    """(E,) sides sorted so that those of one edge are neighbours."""
    first: Rows
    """(G,) where each edge begins in order."""
    forward: Flags
    """(E,) direction of the side along its edge: two sides of consistent windings differ."""

    def __len__(self) -> int:
        return len(self.sides)

    @cached_property
    def counts(self) -> Rows:
        """(G,) number of sides on each edge."""
        ends = np.append(self.first[1:], len(self.order))
        counts: Rows = np.subtract(ends, self.first, dtype=np.intp)
        return counts

    @cached_property
    def singles(self) -> Rows:
        """(S,) sides that lie alone on their edge."""
        return self.order[self.first[np.flatnonzero(self.counts == 1)]]

    @cached_property
    def pairs(self) -> tuple[Rows, Rows]:
        """(N,), (N,) the two sides of each edge that has two."""
        at = self.first[self.counts == 2]
        return self.order[at], self.order[at + 1]

    @cached_property
    def crowds(self) -> tuple[Rows, Rows]:
        """Sides on edges with three and more: (C,) the sides, (C,) the edge of each, from 0."""
        counts = self.counts
        many = counts > 2
        within = np.repeat(many, counts)
        return self.order[within], np.repeat(np.arange(int(many.sum())), counts[many])

    @cached_property
    def folds(self) -> Doubles:
        """(N,) `dihedral` angle of each pair, seen from the winding side of its first."""
        return self.fold(*self.pairs)

    def fold(self, first: Rows, second: Rows, linear: Doubles | None = None) -> Doubles:
        """(N,) `dihedral` angles of pairs of sides, seen from the winding side of first, in
        object space or in the space that a linear part, (3, 3) or (N, 3, 3), leads to."""
        one, other = (self.creases[self.polygon[side]] for side in (first, second))
        other = np.where((self.forward[first] != self.forward[second])[:, None], other, -other)
        along = self.sides[first, 3:6].astype(np.float64) - self.sides[first, 0:3]
        if linear is not None:
            turn = cofactors(linear)
            one, other = (unit((turn @ normal[:, :, None])[:, :, 0]) for normal in (one, other))
            along = (linear @ along[:, :, None])[:, :, 0]
        return dihedral(along, one, other)

    @property
    def nbytes(self) -> int:
        """Memory of the arrays, for caches."""
        arrays = (self.sides, self.polygon, self.planes, self.creases, self.parents)
        met = (self.order, self.first, self.forward)
        return sum(a.nbytes for a in (*arrays, *met)) + 40 * len(self.first)


def dihedral(along: Doubles, first: Doubles, second: Doubles) -> Doubles:
    """The angle between polygons behind their normals (in the material), radians 0..2 pi.

    Raskar 2001, section 2.2: 180 degrees where they are coplanar, less on a ridge, more in a
    valley. All (N, 3), the normals unit; along is the shared side as the first polygon winds.
    """
    length = np.sqrt(np.einsum("ij,ij->i", along, along))
    lift = np.einsum("ij,ij->i", along, cross(first, second)) / np.maximum(length, 1e-300)
    return np.asarray(np.pi - np.arctan2(lift, np.einsum("ij,ij->i", first, second)))


def edges(batch: PolygonBatch) -> Edges:
    """The edges of a batch.

    Polygons without a plane are left out: fewer than 3 distinct corners, zero area, NaN or
    infinite corners. So are sides of zero length and those that are no true edges (`boundary`).
    Normals are Newell's (exact area vectors of non-planar and concave polygons).
    """
    return _edges(batch, None)[0]


def edges_of_each(batches: Sequence[PolygonBatch]) -> tuple[Edges, Indices]:
    """The edges of several batches, each in its own object space and without neighbours in the
    others, and (P,) the batch of every row in planes. One or more."""
    counts = [batch.polygon_count for batch in batches]
    return _edges(join(batches), np.repeat(np.arange(len(batches), dtype=np.int32), counts))


def _edges(
    batch: PolygonBatch, objects: Indices | None
) -> tuple[Edges, Indices]:
    """The edges, of objects (one number a polygon) kept apart, and each plane's object."""
    parts: list[tuple[Floats, Indices, Doubles]] = []
    owners: list[Indices] = []
    done = 0
    creases: list[Doubles] = []
    parents: list[Rows] = []
    for at, flags, numbers, normals in _by_size(batch):
        part = _same_size(batch.positions[at], flags)
        parts.append((part[0], part[1] + np.int32(done), part[2]))
        creases.append(part[2][:, :3] if normals is None else normals[part[3]])
        parents.append(numbers[part[3]])
        if objects is not None:
            owners.append(objects[parents[-1]])
        done += len(part[2])
    if not parts:
        parts.append((np.empty((0, 6), np.float32), np.empty(0, np.int32), np.empty((0, 4))))
    sides, polygon, planes = (
        parts[0] if len(parts) == 1 else (np.concatenate(a) for a in zip(*parts, strict=True))
    )
    owner = np.concatenate(owners) if owners else np.zeros(0, np.int32)
    whose = owner[polygon] if len(owner) else None
    sides, polygon, order, first, forward = joined(sides, polygon, whose)
    whole = np.concatenate(creases) if creases else np.empty((0, 3))
    numbers = np.concatenate(parents) if parents else np.empty(0, np.intp)
    return Edges(sides, polygon, planes, whole, numbers, order, first, forward), owner


_Group = tuple[Indices, Flags, Rows, Doubles | None]
"""Polygons with equally many corners: (P, n) indices into positions, (P, n) true sides, (P,) their
numbers in the batch, and (P, 3) unit normals of the whole polygons if these are parts."""


def _by_size(batch: PolygonBatch) -> list[_Group]:
    """The polygons of a batch that have three corners and more; bent ones as the triangles that
    drivers draw them in."""
    sizes = np.diff(batch.starts)
    kinds = np.unique(sizes)
    groups: list[_Group] = []
    for size in kinds[kinds >= 3].tolist():
        if len(kinds) == 1:
            at, flags = batch.corners.reshape(-1, size), batch.boundary.reshape(-1, size)
            polygon = np.arange(len(at), dtype=np.intp)
        else:
            polygon = np.flatnonzero(sizes == size)
            index = batch.starts[:-1][polygon][:, None] + np.arange(size, dtype=np.int32)
            at, flags = batch.corners[index], batch.boundary[index]
        if size > 3:
            bent, normals = _bent(batch.positions[at])
            if bent.any():
                groups.append(_fans(at[bent], flags[bent], polygon[bent], normals[bent]))
                at, flags, polygon = at[~bent], flags[~bent], polygon[~bent]
        groups.append((at, flags, polygon, None))
    return groups


def _bent(points: Floats) -> tuple[Flags, Doubles]:
    """(P,) whether the corners of polygons (P, n, 3) lie in no plane: outlines run along the
    diagonals at which a driver bends them. Not where a cut would leave a sliver without a normal
    of its own. And (P, 3) their unit normals (Newell)."""
    with np.errstate(invalid="ignore", over="ignore"):
        spokes = points[:, 1:].astype(np.float64) - points[:, :1]
        cuts = [cross(spokes[:, k], spokes[:, k + 1]) for k in range(spokes.shape[1] - 1)]
        normal = np.sum(cuts, axis=0)
        least = np.min([np.abs(cut).max(axis=1) for cut in cuts], axis=0)
        height = np.abs(np.einsum("pni,pi->pn", spokes, normal)).max(axis=1)
        reach = np.abs(spokes).max(axis=(1, 2))
        size = np.abs(normal).max(axis=1)
        bent = (height > _BENT * reach * size) & (least > _SLIVER * size)
        return np.asarray(bent), unit(normal)


def _fans(at: Indices, flags: Flags, polygon: Rows, normals: Doubles) -> _Group:
    """Polygons (P, n) as fans of triangles about their first corner; the cuts are true sides, but
    by the normals (P, 3) of the whole polygons no creases."""
    count, size = at.shape
    fans = size - 2
    corners = fan(size)
    sides = np.ones((count, fans, 3), np.bool_)
    sides[:, 0, 0], sides[:, -1, 2] = flags[:, 0], flags[:, -1]
    sides[:, :, 1] = flags[:, 1:-1]
    parts = at[:, corners].reshape(-1, 3), sides.reshape(-1, 3)
    return *parts, np.repeat(polygon, fans), np.repeat(normals, fans, axis=0)


def joined(
    sides: Floats, polygon: Indices, owner: Indices | None
) -> tuple[Floats, Indices, Rows, Rows, Flags]:
    """Sides (E, 6) of polygons (E,), cut where one runs along several others, and `neighbours`."""
    order, first, forward = neighbours(sides, owner)
    alone = order[first[np.diff(first, append=len(order)) == 1]]
    cut = pieces(sides, polygon, alone, owner)
    if cut is None:
        return sides, polygon, order, first, forward
    sides, parent = cut
    owner = None if owner is None else owner[parent]
    return sides, polygon[parent], *neighbours(sides, owner)


def neighbours(sides: Floats, owner: Indices | None) -> tuple[Rows, Rows, Flags]:
    """The fields order, first and forward of `Edges`, of sides (E, 6) in one space; those of
    unlike owners (E,) keep apart.

    Ends count as one when they fall into the same cell. Those that rounding parted (a seam
    computed twice) are looked for again in coarser cells that begin elsewhere.
    """
    if not len(sides):
        return np.empty(0, np.intp), np.empty(0, np.intp), np.empty(0, np.bool_)
    owner = np.zeros(1, np.int32) if owner is None else owner
    low, extent = _boxes(sides, owner)
    if len(low) > 1:
        low, extent = low[owner], extent[owner]
    key, forward = _edge_keys(sides, low, extent, *_CELLS[0])
    key += owner * _SPREAD
    order, first = _runs(key)
    for cells, shift in _CELLS[1:]:
        counts = np.diff(first, append=len(key))
        lone = order[first[counts == 1]]
        if len(lone) < 2:
            break
        whose = lone if len(low) > 1 else slice(None)
        again, ahead = _edge_keys(sides[lone], low[whose], extent[whose], cells, shift)
        again += (owner[lone] if len(owner) > 1 else owner) * _SPREAD
        found, at = _runs(again)
        sizes = np.diff(at, append=len(again))
        met = found[np.repeat(sizes > 1, sizes)]
        if len(met):
            key[lone[met]], forward[lone[met]] = again[met], ahead[met]
            order, first = _runs(key)
    return order, first, forward


def _boxes(sides: Floats, owner: Indices) -> tuple[Doubles, Doubles]:
    """(N, 3) the least corner and (N,) the extent of the sides of each owner."""
    if len(owner) == 1:
        ends = np.array(
            [(sides[:, k].min(), sides[:, k].max()) for k in range(6)], np.float64
        ).reshape(2, 3, 2)
        low, high = ends[None, :, :, 0].min(axis=1), ends[None, :, :, 1].max(axis=1)
    else:
        low, high = (np.full((int(owner.max()) + 1, 3), end) for end in (np.inf, -np.inf))
        for corners in (sides[:, :3], sides[:, 3:6]):
            np.minimum.at(low, owner, corners)
            np.maximum.at(high, owner, corners)
        low, high = (np.where(np.isfinite(end), end, 0.0) for end in (low, high))
    return low, np.maximum((high - low).max(axis=1), 1e-300)


def _runs(key: NDArray[np.int64]) -> tuple[Rows, Rows]:
    """A sorting order of key, and where in it each run of equals begins."""
    order = np.argsort(key)
    ordered = key[order]
    return order, np.flatnonzero(np.concatenate(([True], ordered[1:] != ordered[:-1])))


def _edge_keys(
    sides: Floats, low: Doubles, extent: Doubles, cells: int, shift: float
) -> tuple[NDArray[np.int64], Flags]:
    """(E,) a number for the edge of each side, equal from either end, and the direction on it."""
    scale = (cells - 2) / extent
    start, end = (cell(sides[:, at : at + 3], low, scale, shift) for at in (0, 3))
    lesser, greater = np.minimum(start, end), np.maximum(start, end)
    # 126 bits folded into 64; the odd multiplier spreads them, a clash is one in 2^64.
    key = lesser * _SPREAD ^ (greater + (lesser >> np.int64(29)))
    alone = start == end  # shorter than a cell: an edge of its own
    key[alone] = -np.flatnonzero(alone) - 1
    return key, start < end


def cell(
    points: Floats, low: Doubles, scale: Doubles | float, shift: float
) -> NDArray[np.int64]:
    """(E,) one number for the cell of each point (E, 3)."""
    x, y, z = (((points[:, k] - low[:, k]) * scale + shift).astype(np.int64) for k in range(3))
    return np.asarray((x << np.int64(42)) | (y << np.int64(21)) | z)


def _same_size(points: Floats, flags: Flags) -> tuple[Floats, Indices, Doubles, Flags]:
    """Sides, polygon rows and planes of polygons with equally many corners, and which are sound.

    points (P, n, 3), flags (P, n).
    """
    count, size = flags.shape
    with np.errstate(invalid="ignore", over="ignore"):
        exact = points.astype(np.float64)
        centre = exact[:, 0] + exact[:, 1]
        for corner in range(2, size):
            centre += exact[:, corner]
        centre /= size
        exact -= centre[:, None, :]
        normal = _area_vector(exact)
        length = np.sqrt(np.einsum("pi,pi->p", normal, normal))
        extent = np.einsum("pni,pni->p", exact, exact)
        grain = _GRAIN * (np.abs(centre).max(axis=1, initial=0.0) + np.sqrt(extent))
        sound = (length > grain * np.sqrt(extent)) & np.isfinite(extent)
    if not sound.all():
        points, flags, normal = points[sound], flags[sound], normal[sound]
        centre, length, grain = centre[sound], length[sound], grain[sound]
        count = len(flags)
    planes = np.empty((count, 4))
    np.divide(normal, length[:, None], out=planes[:, :3])
    planes[:, 3] = -np.einsum("pi,pi->p", planes[:, :3], centre)
    # Each side reads two corners in a row: overlapping views of the corners, the first repeated.
    rows = np.concatenate((points, points[:, :1]), axis=1)
    sides = np.array(sliding_window_view(rows.reshape(count, 3 * size + 3), 6, axis=1)[:, ::3])
    step = points - rows[:, 1 : size + 1]
    limit = grain.astype(np.float32)[:, None]
    still = (np.abs(step[..., 0]) <= limit) & (np.abs(step[..., 1]) <= limit)
    still &= np.abs(step[..., 2]) <= limit
    keep = (flags & ~still).ravel()
    polygon = np.repeat(np.arange(count, dtype=np.int32), size)
    flat = sides.reshape(-1, 6)
    if not keep.all():
        flat, polygon = flat[keep], polygon[keep]
    return flat, polygon, planes, sound


def _area_vector(spokes: Doubles) -> Doubles:
    """Twice the area vectors of polygons (P, n, 3) about their centroids (Newell)."""
    size = spokes.shape[1]
    if size == 3:
        return cross(spokes[:, 1] - spokes[:, 0], spokes[:, 2] - spokes[:, 0])
    if size == 4:
        return cross(spokes[:, 2] - spokes[:, 0], spokes[:, 3] - spokes[:, 1])
    total = cross(spokes[:, -1], spokes[:, 0])
    for corner in range(size - 1):
        total += cross(spokes[:, corner], spokes[:, corner + 1])
    return total
