"""From polygons to edge records: what the GPU, and the numpy reference of it, start from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch

Floats = NDArray[np.float32]

RECORD = 13
"""Floats of one record: a, b, c (3 each), plane (4)."""
_SLIVER = 1e-6
"""Area over squared extent below which float32 corners say nothing about a normal."""


@dataclass(frozen=True, slots=True, eq=False)
class Edges:
    """The true edges of the sound polygons of a batch, one record a side. Object space."""

    records: Floats
    """(E, 13) float32: the side from ``a`` (0:3) to ``b`` (3:6); the polygon's next corner
    ``c`` (6:9), where the line turns; and the polygon's plane (9:13), the unit normal of the
    winding (Newell) and minus its product with the centroid."""

    def __len__(self) -> int:
        return len(self.records)


def join(batches: Sequence[PolygonBatch]) -> PolygonBatch:
    """Batches in one object space as one batch without a key. One or more."""
    if len(batches) == 1:
        return batches[0]
    vertices = np.cumsum([0] + [len(b.positions) for b in batches[:-1]])
    counts = [len(b.corners) for b in batches]
    corners = np.cumsum([0, *counts])
    polygons = [b.polygon_count for b in batches]
    starts = np.concatenate([b.starts[:-1] for b in batches]) + np.repeat(corners[:-1], polygons)
    return PolygonBatch(
        np.concatenate([b.positions for b in batches]),
        (np.concatenate([b.corners for b in batches]) + np.repeat(vertices, counts)).astype(
            np.int32
        ),
        np.append(starts, corners[-1]).astype(np.int32),
        np.concatenate([b.boundary for b in batches]),
    )


def edges(batch: PolygonBatch) -> Edges:
    """The records of a batch.

    Polygons without a plane are left out: fewer than 3 distinct corners, zero area, NaN or
    infinite corners. Sides of zero length and sides that are no true edges (`boundary`) give
    no record. Normals are Newell's (exact area vectors of non-planar and concave polygons).
    """
    sides = np.diff(batch.starts)
    sizes = np.unique(sides)
    parts = []
    for size in sizes[sizes >= 3].tolist():
        if len(sizes) == 1:
            at = batch.corners.reshape(-1, size)
            flags = batch.boundary.reshape(-1, size)
        else:
            first = batch.starts[:-1][sides == size]
            index = first[:, None] + np.arange(size, dtype=np.int32)
            at, flags = batch.corners[index], batch.boundary[index]
        parts.append(_same_size(batch.positions[at], flags))
    if len(parts) == 1:
        return Edges(parts[0])
    return Edges(np.concatenate(parts) if parts else np.empty((0, RECORD), np.float32))


def _same_size(points: Floats, flags: NDArray[np.bool_]) -> Floats:
    """Records of polygons with equally many corners. points (P, n, 3), flags (P, n)."""
    count, size = flags.shape
    records = np.empty((count, size, RECORD), np.float32)
    with np.errstate(invalid="ignore", over="ignore"):
        centre = points.mean(axis=1, dtype=np.float64)
        spokes = points - centre[:, None, :]
        normal = _area_vector(spokes)
        length = np.sqrt(np.einsum("pi,pi->p", normal, normal))
        extent = np.einsum("pni,pni->p", spokes, spokes)
        sound = (length > _SLIVER * extent) & np.isfinite(extent)
        normal /= np.where(sound, length, 1.0)[:, None]
        for corner in range(size):
            records[:, corner, 0:3] = points[:, corner]
            records[:, corner, 3:6] = points[:, (corner + 1) % size]
            records[:, corner, 6:9] = points[:, (corner + 2) % size]
        records[:, :, 9:12] = normal[:, None, :]
        records[:, :, 12] = -np.einsum("pi,pi->p", normal, centre)[:, None]
        still = (records[..., 0:3] == records[..., 3:6]).all(axis=2)
    if still.any():  # a repeated corner: the line turns at the next distinct one
        turn = np.roll(still, -1, axis=1)
        after = np.roll(points, -3, axis=1)
        records[turn, 6:9] = after[turn]
    keep = flags & ~still & sound[:, None]
    flat = records.reshape(-1, RECORD)
    return flat if keep.all() else flat[keep.ravel()]


def _area_vector(spokes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Twice the area vectors of polygons (P, n, 3) about their centroids (Newell)."""
    size = spokes.shape[1]
    if size == 3:
        return _cross(spokes[:, 1] - spokes[:, 0], spokes[:, 2] - spokes[:, 0])
    if size == 4:
        return _cross(spokes[:, 2] - spokes[:, 0], spokes[:, 3] - spokes[:, 1])
    total = _cross(spokes[:, -1], spokes[:, 0])
    for corner in range(size - 1):
        total += _cross(spokes[:, corner], spokes[:, corner + 1])
    return total


def _cross(u: NDArray[np.float64], v: NDArray[np.float64]) -> NDArray[np.float64]:
    out = np.empty_like(u)
    out[:, 0] = u[:, 1] * v[:, 2] - u[:, 2] * v[:, 1]
    out[:, 1] = u[:, 2] * v[:, 0] - u[:, 0] * v[:, 2]
    out[:, 2] = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    return out
