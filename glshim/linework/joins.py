"""Which lines end where others begin: ends that fall into one cell of space meet."""

from __future__ import annotations

import numpy as np

from glshim.geometry.edges.edges import cell
from glshim.model.arrays import Doubles, Flags, Floats, Rows
from glshim.model.vectors import unit

_CELLS = ((1 << 20, 0.5), (1 << 18, 0.23), (1 << 16, 0.71))
"""Cells per axis in which ends count as one, and the shift of the cells, for each round."""
_MOST = 4
"""Sides that may begin at one place and are compared for the straightest way on."""
_APART = 6
"""Ends at one place are compared with so many others."""
_STRAIGHT = 0.3
"""Least cosine of the turn, in space, at which one crease goes on as another."""


def link(a: Floats, b: Floats) -> Rows:
    """(L,) for each side a to b (L, 3) the side that begins where it ends, -1 where none does.

    Of several the one that turns least.
    """
    onward = np.full(len(a), -1, np.intp)
    low, extent = _box(a, b)
    along = unit(b.astype(np.float64) - a)
    for cells, shift in _CELLS:
        lost = np.flatnonzero(onward < 0)
        if not len(lost):
            break
        begins = cell(a, low, (cells - 2) / extent, shift)
        ends = cell(b[lost], low, (cells - 2) / extent, shift)
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
            onward[lost[better]], best[better] = candidate[better], straight[better]
            at = at + 1
    return onward


def next_lines(a: Floats, b: Floats, *, directed: bool) -> Rows:
    """What goes on where each of lines a to b (L, 3) ends, -1 where nothing does; each once.

    directed: (L,) lines, that begin where others end. Else (2 L,) halves: 2 i is line i from a to
    b, 2 i + 1 the same line back, and of what follows one the way back follows the other way.
    """
    mates = _mates(a, b, directed=directed)
    if directed:
        return mates[1::2] // 2
    return mates.reshape(-1, 2)[:, ::-1].ravel()


def _mates(a: Floats, b: Floats, *, directed: bool) -> Rows:
    """(2 L,) for the ends of lines (a of line i is end 2i, b 2i + 1) the end of another line at the
    same place that goes on straightest, -1 where none does; each other's. directed: b on a only."""
    count = len(a)
    low, extent = _box(a, b)
    along = unit(b.astype(np.float64) - a)
    away = np.stack([along, -along], axis=1).reshape(-1, 3)
    ends = np.stack([a, b], axis=1).reshape(-1, 3)
    mates = np.full(2 * count, -1, np.intp)
    for cells, shift in _CELLS:
        lost = np.flatnonzero(mates < 0)
        names = cell(ends[lost], low, (cells - 2) / extent, shift)
        order = np.argsort(names, kind="stable")
        names, lost = names[order], lost[order]
        found = [np.flatnonzero(names[k:] == names[:-k]) for k in range(1, _APART + 1)]
        one = lost[np.concatenate(found)]
        other = lost[np.concatenate([at + k for k, at in enumerate(found, start=1)])]
        straight = -np.einsum("pi,pi->p", away[one], away[other])
        fits = one // 2 != other // 2
        fits &= one % 2 != other % 2 if directed else straight >= _STRAIGHT
        # The straightest first; equals in an order that does not depend on their direction.
        rank = np.lexsort((np.maximum(one, other), np.minimum(one, other), -straight.round(6)))
        rank = rank[fits[rank]]
        one, other = one[rank], other[rank]
        while len(one):
            best = np.full(2 * count, len(one))
            for side in (one, other):
                np.minimum.at(best, side, np.arange(len(one)))
            taken = np.flatnonzero(best[one] == best[other])
            mates[one[taken]], mates[other[taken]] = other[taken], one[taken]
            free = (mates[one] < 0) & (mates[other] < 0)
            one, other = one[free], other[free]
    return mates


def heads(before: Rows) -> tuple[Rows, Flags]:
    """(L,) the first line of the chain of each, on a loop the least; and whether it is a loop.

    before (L,): the line that each goes on from, -1 where it begins a chain."""
    back, least = before.copy(), np.arange(len(before))
    first = least.copy()
    for _ in range(max(len(before), 1).bit_length()):
        live = np.flatnonzero(back >= 0)
        if not len(live):
            break
        there = back[live]
        first[live] = first[there]
        least[live] = np.minimum(least[live], least[there])
        back[live] = back[there]
    closed = back >= 0
    return np.where(closed, least, first), closed


def sums(before: Rows, values: Doubles) -> Doubles:
    """(L,) the sum of values over all that come before each on its chain; no loops."""
    back = before.copy()
    sums = np.where(back >= 0, values[back], 0.0)
    while True:
        live = np.flatnonzero(back >= 0)
        if not len(live):
            return sums
        there = back[live]
        sums[live] += sums[there]
        back[live] = back[there]


def least_of(chain: Rows) -> Rows:
    """(S,) the least member of each chain, of members numbered (L,)."""
    least = np.full(int(chain.max()) + 1, len(chain))
    np.minimum.at(least, chain, np.arange(len(chain)))
    return least


def _box(a: Floats, b: Floats) -> tuple[Doubles, float]:
    """(1, 3) the least corner of lines a to b (L, 3), and their extent."""
    low = np.minimum(a.min(axis=0), b.min(axis=0)).astype(np.float64)
    extent = (np.maximum(a.max(axis=0), b.max(axis=0)) - low).max()
    return low[None], float(max(extent, 1e-300))
