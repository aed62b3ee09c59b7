"""Strokes: which side of an outline goes on where another ends, and how far along each begins."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float32]
Indices = NDArray[np.intp]

_CELLS = ((1 << 20, 0.5), (1 << 18, 0.23), (1 << 16, 0.71))
"""Cells per axis in which ends count as one, and the shift of the cells, for each round."""
_MOST = 4
"""Sides that may begin at one place and are compared for the straightest way on."""


def link(a: Floats, b: Floats) -> Indices:
    """(L,) for each side a to b (L, 3) the side that begins where it ends, -1 where none does.

    Of several the one that turns least.
    """
    following = np.full(len(a), -1, np.intp)
    low = np.minimum(a.min(axis=0), b.min(axis=0)).astype(np.float64)
    extent = float(max((np.maximum(a.max(axis=0), b.max(axis=0)) - low).max(), 1e-300))
    along = b.astype(np.float64) - a
    along /= np.maximum(np.sqrt(np.einsum("li,li->l", along, along)), 1e-300)[:, None]
    for cells, shift in _CELLS:
        lost = np.flatnonzero(following < 0)
        if not len(lost):
            break
        begins = _names(a, low, (cells - 2) / extent, shift)
        ends = _names(b[lost], low, (cells - 2) / extent, shift)
        order = np.argsort(begins, kind="stable")
        ordered = begins[order]
        at = np.searchsorted(ordered, ends)
        best = np.full(len(lost), -2.0)
        for _ in range(_MOST):
            there = np.minimum(at, len(order) - 1)
            candidate = order[there]
            straight = np.einsum("li,li->l", along[lost], along[candidate])
            better = (at < len(order)) & (ordered[there] == ends) & (straight > best)
            better &= candidate != lost
            following[lost[better]], best[better] = candidate[better], straight[better]
            at = at + 1
    return following


def _names(points: Floats, low: NDArray[np.float64], scale: float, shift: float) -> Indices:
    """(N,) one number for the cell of each point (N, 3)."""
    x, y, z = ((points.astype(np.float64) - low) * scale + shift).astype(np.int64).T
    return np.asarray((x << np.int64(42)) | (y << np.int64(21)) | z)
