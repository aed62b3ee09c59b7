"""Which lines lie on each other: edges of bodies that stand side by side.

Where what is seen goes on across such a line in one plane there is none (`flush_at` in
``stroke.glsl``); a line that lies alone in another body's plane (a tile on a floor) stays.
"""

from __future__ import annotations

import numpy as np

from glshim.geometry.edges.edges import neighbours
from glshim.geometry.edges.pieces import pieces
from glshim.model.arrays import Flags, Floats, Rows
from glshim.model.lines import RIDGE, RING, SHARED, VALLEY, Line, kind_of


def mark_shared(records: Floats, among: Floats | None = None) -> None:
    """Write into the kinds of records (L, 21) of sharp edges which lie on others, or on a part of
    others: of each other, or of among (M, 21), which holds them all."""
    sharp, every = _sharp(records), records if among is None else among
    sides = np.ascontiguousarray(every[_sharp(every), Line.ENDS])
    if not len(sharp) or len(sides) < 2:
        return
    shared = _on_others(sides)
    if not shared.any():
        return
    if among is None:
        records[sharp[shared], Line.KIND] += SHARED
        return
    own = np.concatenate((records[sharp, Line.ENDS], sides[shared]))
    order, first, _ = neighbours(own, None)
    edge = np.empty(len(own), np.intp)
    edge[order] = np.repeat(np.arange(len(first)), np.diff(first, append=len(own)))
    found = np.zeros(len(first), np.bool_)
    found[edge[len(sharp) :]] = True
    records[sharp[found[edge[: len(sharp)]]], Line.KIND] += SHARED


def _sharp(records: Floats) -> Rows:
    return np.flatnonzero(np.isin(kind_of(records), (RING, RIDGE, VALLEY)))


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
