"""Where polygons cross: segments common to the interiors of two triangles, in float64."""

from __future__ import annotations

import numpy as np

_GRAIN = 1e-9
"""Over the size of the scene: what counts as touching, and the shortest crossing."""


def crossings(triangles, owner, corners) -> tuple[np.ndarray, np.ndarray]:
    """(S, 2, 3) segments where triangles (T, 3, 3) of different owners cross, and (S, 2) owners.

    owner (T,) is the polygon of each triangle, corners (T, 3) the welded corners: polygons that
    share a side do not cross, those that share one corner cross only away from it. A triangle
    crosses a plane when it has corners strictly on both sides; touching is not crossing.
    """
    none = np.empty((0, 2, 3)), np.empty((0, 2), np.intp)
    if not len(triangles):
        return none
    size = float(np.ptp(triangles.reshape(-1, 3), axis=0).max())
    grain = _GRAIN * size
    first, second = _overlapping(triangles)
    keep = owner[first] != owner[second]
    shared = (corners[first][:, :, None] == corners[second][:, None, :]).sum(axis=(1, 2))
    first, second = first[keep & (shared < 2)], second[keep & (shared < 2)]
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normals, axis=1)
    normals /= np.maximum(length, 1e-300)[:, None]
    sound = length > grain * size
    heights = []
    good = sound[first] & sound[second]
    for one, other in ((first, second), (second, first)):
        from_plane = triangles[one] - triangles[other][:, :1]
        height = np.einsum("pci,pi->pc", from_plane, normals[other])
        heights.append(height)
        good &= (height.max(axis=1) > grain) & (height.min(axis=1) < -grain)
    first, second = first[good], second[good]
    if not len(first):
        return none
    along = np.cross(normals[first], normals[second])
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-300)[:, None]
    ends = [
        _cut(triangles[t], height[good], along)
        for t, height in zip((first, second), heights, strict=True)
    ]
    low = np.where((ends[0][1] > ends[1][1])[:, None], ends[0][0], ends[1][0])
    high = np.where((ends[0][3] < ends[1][3])[:, None], ends[0][2], ends[1][2])
    long = np.einsum("pi,pi->p", high - low, along) > 10 * grain
    segments = np.stack([low, high], axis=1)[long]
    return segments, np.stack([owner[first], owner[second]], axis=1)[long]


def _cut(corners, height, along):
    """The segment in which triangles (P, 3, 3) cut a plane over which their corners lie at
    height (P, 3): low end, its place along the line, high end, its place."""
    rows = np.arange(len(corners))
    above = height > 0
    lone_above = above.sum(axis=1) == 1
    lone = np.where(lone_above, above.argmax(axis=1), (~above).argmax(axis=1))
    points = []
    for step in (1, 2):
        other = (lone + step) % 3
        at, to = height[rows, lone], height[rows, other]
        share = (at / (at - to))[:, None]
        points.append(corners[rows, lone] * (1 - share) + corners[rows, other] * share)
    places = [np.einsum("pi,pi->p", p, along) for p in points]
    swap = places[0] > places[1]
    low = np.where(swap[:, None], points[1], points[0])
    high = np.where(swap[:, None], points[0], points[1])
    return low, np.minimum(*places), high, np.maximum(*places)


def _overlapping(triangles) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (i < j) of triangles whose boxes overlap, by a grid of cells."""
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    extent = high - low
    origin = low.min(axis=0)
    cell = max(float(np.median(extent.max(axis=1))) * 1.5, float((high.max(0) - origin).max()) / 96)
    first = np.floor((low - origin) / cell).astype(np.int64)
    spans = np.floor((high - origin) / cell).astype(np.int64) - first + 1
    counts = spans.prod(axis=1)
    which = np.repeat(np.arange(len(triangles)), counts)
    within = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
    span, base = spans[which], first[which]
    x = base[:, 0] + within % span[:, 0]
    y = base[:, 1] + within // span[:, 0] % span[:, 1]
    z = base[:, 2] + within // (span[:, 0] * span[:, 1])
    key = (x << 42) | (y << 21) | z
    order = np.argsort(key, kind="stable")
    key, which = key[order], which[order]
    starts = np.flatnonzero(np.r_[True, key[1:] != key[:-1]])
    ends = np.append(starts[1:], len(key))
    later = np.repeat(ends, ends - starts) - np.arange(len(key)) - 1  # partners after each
    one = np.repeat(np.arange(len(key)), later)
    other = one + 1 + np.arange(len(one)) - np.repeat(np.cumsum(later) - later, later)
    one, other = which[one], which[other]
    apart = (low[one] > high[other]).any(axis=1) | (low[other] > high[one]).any(axis=1)
    one, other = one[~apart], other[~apart]
    one, other = np.minimum(one, other), np.maximum(one, other)
    code = np.unique(one.astype(np.int64) * len(triangles) + other)
    return np.divmod(code, len(triangles))
