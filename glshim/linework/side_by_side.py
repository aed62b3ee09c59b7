"""Which lines lie on each other: edges of bodies that stand side by side.

Where what is seen goes on across such a line in one plane there is none (`flush_at` in
``stroke.glsl``); a line that lies alone in another body's plane (a tile on a floor) stays.
"""

from __future__ import annotations

import numpy as np

from glshim.geometry.edges.edges import neighbours
from glshim.geometry.edges.pieces import pieces
from glshim.model.arrays import Flags, Floats
from glshim.model.lines import RIDGE, RING, SHARED, VALLEY, Line, kind_of


def mark(records: Floats, shared: Flags) -> None:
    """Write into the kinds of records (L, 21) of sharp edges which of them (L,) lie on others."""
    sharp = np.isin(kind_of(records), (RING, RIDGE, VALLEY))
    records[shared & sharp, Line.KIND] += SHARED


def mark_shared(records: Floats, besides: Floats | None = None) -> None:
    """Write into the kinds of records (L, 21) of sharp edges which lie on others, or on a part of
    others: of each other, or of the sides besides (M, 6)."""
    sharp = np.flatnonzero(np.isin(kind_of(records), (RING, RIDGE, VALLEY)))
    if not len(sharp):
        return
    sides = records[sharp, Line.ENDS]
    if besides is not None:
        sides = np.concatenate((sides, besides))
    if len(sides) > 1:
        shared = _on_others(np.ascontiguousarray(sides))[: len(sharp)]
        records[sharp[shared], Line.KIND] += SHARED


def _on_others(sides: Floats) -> Flags:
    """(N,) of sides (N, 6)."""
    shared = _met(sides)
    alone = np.flatnonzero(~shared)
    cut = pieces(sides, np.arange(len(sides), dtype=np.int32), alone, None)
    if cut is not None:
        parts, parent = cut
        shared[parent[_met(parts)]] = True
    return shared


def _met(sides: Floats) -> Flags:
    """(N,) which of sides (N, 6) another one equals."""
    order, first, _ = neighbours(sides, None)
    counts = np.diff(first, append=len(order))
    found = np.zeros(len(sides), np.bool_)
    found[order[np.repeat(counts > 1, counts)]] = True
    return found
