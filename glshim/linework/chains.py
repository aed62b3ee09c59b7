"""Strokes: which line goes on where another ends, and how far along its stroke each lies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.geometry.edges.edges import cell
from glshim.geometry.window import cut, window
from glshim.model.arrays import Complexes, Doubles, Flags, Floats, Rows
from glshim.model.camera import Camera
from glshim.model.vectors import unit
from glshim.styling.wishes import Pattern

_CELLS = ((1 << 20, 0.5), (1 << 18, 0.23), (1 << 16, 0.71))
"""Cells per axis in which ends count as one, and the shift of the cells, for each round."""
_MOST = 4
"""Sides that may begin at one place and are compared for the straightest way on."""
_APART = 6
"""Ends at one place are compared with so many others."""
_STRAIGHT = 0.3
"""Least cosine of the turn, in space, at which one crease goes on as another."""
_LEAST = 0.5
"""Share of its sides' length that a loop has at least in its middle."""


def link(a: Floats, b: Floats) -> Rows:
    """(L,) for each side a to b (L, 3) the side that begins where it ends, -1 where none does.

    Of several the one that turns least.
    """
    following = np.full(len(a), -1, np.intp)
    low, extent = _box(a, b)
    along = unit(b.astype(np.float64) - a)
    for cells, shift in _CELLS:
        lost = np.flatnonzero(following < 0)
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
            following[lost[better]], best[better] = candidate[better], straight[better]
            at = at + 1
    return following


@dataclass(frozen=True, slots=True, eq=False)
class Walk:
    """Where lines lie along their strokes, and strokes along a pattern."""

    begin: Doubles
    """(L,) repeats of the pattern at each line's a, counted from where its stroke begins; 0 without
    a pattern."""
    finish: Doubles
    """(L,) at b."""
    stroke: Rows
    """(L,) number of the stroke; -1 without a pattern."""
    loop: Doubles
    """(L,) repeats around the stroke, if that is a loop; else 0."""
    places: tuple[Complexes, Complexes]
    """(L,), (L,) both ends in the window, pixels."""


def measure(a: Floats, b: Floats, group: Rows, camera: Camera, pattern: Pattern) -> Walk:
    """Lines a to b (L, 3) in eye space as strokes.

    group (L,): 0 silhouettes, which run on as they wind; others, which run on both ways. Lengths
    are pixels in the window, of what the near plane and the app's clip planes leave. On loops
    the pattern is stretched so that it closes, and it begins where the loop, taken as an ellipse,
    is highest: this moves as smoothly as the loop does.
    """
    starts, finishes, loops = np.zeros(len(a)), np.zeros(len(a)), np.zeros(len(a))
    strokes = np.full(len(a), -1, np.intp)
    ends, _, left = cut(a.astype(np.float64), b.astype(np.float64), camera)
    places = [window(end, camera)[:, 0] + 1j * window(end, camera)[:, 1] for end in ends]
    steps = np.where(left, places[1] - places[0], 0.0)
    steps[~np.isfinite(steps)] = 0.0
    for kind, length in enumerate(pattern.lengths):
        some = np.flatnonzero(group == kind)
        if length <= 0.0 or not len(some):
            continue
        mates = _mates(a[some], b[some], directed=kind == 0)
        if kind == 0:
            after = mates[1::2] // 2
            begin, finish, stroke, loop = _walked(after, steps[some], length, pattern.middle)
            starts[some], finishes[some], loops[some] = begin, finish, loop
            strokes[some] = stroke + strokes.max() + 1
            continue
        # Every crease twice, once a direction: half 2i runs from a to b, half 2i + 1 back.
        halves = np.stack([steps[some], -steps[some]], axis=1).ravel()
        after = mates.reshape(-1, 2)[:, ::-1].ravel()
        begin, finish, stroke, loop = _walked(after, halves, length, 0.0)
        # Of a stroke and the same one back, that on which its first crease runs forward.
        forth = _first_of(stroke) % 2 == 0
        ahead = forth[stroke[0::2]]
        starts[some] = np.where(ahead, begin[0::2], finish[1::2])
        finishes[some] = np.where(ahead, finish[0::2], begin[1::2])
        loops[some] = loop[0::2]
        strokes[some] = np.where(ahead, stroke[0::2], stroke[1::2]) + strokes.max() + 1
    return Walk(starts, finishes, strokes, loops, (places[0], places[1]))


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


def _walked(
    after: Rows, steps: Complexes, length: float, middle: float
) -> tuple[Doubles, Doubles, Rows, Doubles]:
    """Of lines that run on as after says (each once at most, -1: ends), (L,) repeats of a pattern
    at the beginning and at the end of each, (L,) the stroke that it belongs to, from 0, and (L,)
    the repeats around that if it is a loop, else 0.

    steps: from end to end in the window; length of the pattern and middle: as in `Pattern`.
    """
    sizes = np.abs(steps)
    heading = steps / np.maximum(sizes, 1e-9)
    goes_on = after >= 0
    corner = np.zeros(len(after))
    turn = np.angle(heading[after[goes_on]] * heading[goes_on].conj())
    corner[goes_on] = middle * np.where(turn < -3.1, -turn, turn)
    before = np.full(len(after), -1, np.intp)
    before[after[goes_on]] = np.flatnonzero(goes_on)
    first, closed = _heads(before)
    stroke_of, stroke = np.unique(first, return_inverse=True)
    count = len(stroke_of)

    def total(values: Doubles) -> Doubles:
        return np.asarray(np.bincount(stroke, values, count), np.float64)

    # A stroke that bends around a point nearer than its middle is measured on its sides.
    bent = total(sizes + corner) >= _LEAST * total(sizes)
    advance = sizes + np.where(bent[stroke], corner, 0.0)
    before[first[closed]] = -1
    at = _sums(before, advance)
    whole = np.where(closed[stroke_of], np.maximum(total(advance), 1e-9), 0.0)
    repeats = np.maximum(np.rint(whole / length), 1.0)
    rate = np.where(whole > 0.0, repeats / np.maximum(whole, 1e-9), 1.0 / length)
    # Elliptic Fourier descriptors of each loop: e^{iws} and e^{-iws} in its heading over s.
    pace = (2.0 * np.pi / np.where(whole > 0.0, whole, 1.0))[stroke]
    zero = np.zeros(count)
    strength = zero
    for way in (-1j, 1j):
        share = heading * (np.exp(way * pace * (at + sizes)) - np.exp(way * pace * at)) / way
        sum_ = total(share.real) + 1j * total(share.imag)
        # At the top a loop that winds counter-clockwise heads for -1, one that does not for 1.
        top = np.angle(-sum_.conj() if way == -1j else sum_) * whole / (2.0 * np.pi)
        zero = np.where(np.abs(sum_) > strength, top, zero)
        strength = np.maximum(strength, np.abs(sum_))
    begin = (at - np.where(whole > 0.0, zero, 0.0)[stroke]) * rate[stroke]
    loop = np.where(whole > 0.0, repeats, 0.0)[stroke]
    return begin, begin + sizes * rate[stroke], stroke, loop


def _heads(before: Rows) -> tuple[Rows, Flags]:
    """(L,) the first of each stroke, on a loop the least; and whether it is a loop."""
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


def _sums(before: Rows, values: Doubles) -> Doubles:
    """(L,) the sum of values over all that come before each on its stroke; no loops."""
    back = before.copy()
    sums = np.where(back >= 0, values[back], 0.0)
    while True:
        live = np.flatnonzero(back >= 0)
        if not len(live):
            return sums
        there = back[live]
        sums[live] += sums[there]
        back[live] = back[there]


def _first_of(stroke: Rows) -> Rows:
    """(S,) the least line of each stroke, of lines numbered twice."""
    least = np.full(int(stroke.max()) + 1, len(stroke))
    np.minimum.at(least, stroke, np.arange(len(stroke)))
    return least


def _box(a: Floats, b: Floats) -> tuple[Doubles, float]:
    """(1, 3) the least corner of lines a to b (L, 3), and their extent."""
    low = np.minimum(a.min(axis=0), b.min(axis=0)).astype(np.float64)
    extent = (np.maximum(a.max(axis=0), b.max(axis=0)) - low).max()
    return low[None], float(max(extent, 1e-300))
