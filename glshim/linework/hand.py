"""Where a hand that draws strokes lifts the pen: at their ends, and at corners.

NPRQuake draws every polygon's side as a stroke of its own, which overshoots its ends. On a mesh a
side may be a pixel long, so here a stroke is what a hand would draw in one go: a chain of lines
(`glshim.linework.walk`) from one corner on the screen to the next.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from glshim.linework.walk import Walk
from glshim.model.arrays import Complexes, Doubles, Flags, Rows
from glshim.model.lines import ENDLESS

_SPAN = 8.0
"""Pixels before and after a place over which the direction of a stroke is taken: a contour along
the edges of a fine mesh zigzags from one to the next."""
_GAP = 1.5
"""Pixels between the end of a line and the beginning of the next at which the pen is lifted: the
near plane has cut out what lay there."""

_STRAIGHT = 60.0
_SHARE = 0.25
"""Pixels before an end over which a straight run is straight, and the share of its stroke at least;
all of a shorter one. Sides of a coarse curve may be long."""
_LEAST = 6.0
"""Pixels of a straight run."""
_OFF = 0.15
"""Pixels by which it strays at most: what is straight in space is so in the window."""
_BENT = 0.05
"""Pixels; more than the `AT_END` of ``hand.glsl``."""
_GOLDEN = 0.6180339887498949
"""Multiples of it, less their whole parts, are far apart."""


def lifts(walk: Walk, corner: float, *, straight: bool = False) -> tuple[Doubles, Doubles]:
    """(L,) pixels of its stroke before each line's a, and (L,) after its b; 0 for lines without a
    stroke, `ENDLESS` on loops without a corner.

    corner: radians; where a stroke turns by more the pen is lifted. straight: ends that strokes do
    not run into straight on lie `_BENT` pixels further off, so that nothing goes on beyond them.
    """
    before, after = np.zeros(len(walk.stroke)), np.zeros(len(walk.stroke))
    on = np.flatnonzero(walk.stroke >= 0)
    if not len(on):
        return before, after
    order = on[np.lexsort((np.minimum(walk.begin, walk.finish)[on], walk.stroke[on]))]
    run = _Run(walk, order)
    lifted = run.lifted(corner)
    # Pieces between lifts, and how long they are.
    piece = np.cumsum(np.append(True, lifted[:-1])) - 1
    starts = np.flatnonzero(np.append(True, lifted[:-1]))
    base = (run.total - run.size)[starts]
    length = np.bincount(piece, run.size)
    begun = run.total - run.size - base[piece]
    rest = length[piece] - begun - run.size
    # On a loop that is not lifted where it closes its last piece goes on in its first.
    head, tail = piece[run.first], piece[run.last]
    joined = run.loop & ~run.open_seam
    whole = joined & (head == tail)
    part = joined & ~whole
    extra_before, extra_after = np.zeros(len(length)), np.zeros(len(length))
    extra_before[head[part]], extra_after[tail[part]] = length[tail[part]], length[head[part]]
    extra_before[head[whole]] = extra_after[head[whole]] = ENDLESS
    if straight:
        joins = (head[part], tail[part])
        free = run.straight(base, np.asarray(length, float), joins)
        extra_before[~free[0]] += _BENT
        extra_after[~free[1]] += _BENT
    begun = np.maximum(begun + extra_before[piece], 0.0)
    rest = np.maximum(rest + extra_after[piece], 0.0)
    before[order] = np.where(run.forward, begun, rest)
    after[order] = np.where(run.forward, rest, begun)
    return before, after


def begun_anywhere(walk: Walk) -> Walk:
    """The same strokes, each from a place of its own in the pattern: all edges of a cube would else
    be drawn with the same motion of the hand."""
    start = np.where(walk.stroke >= 0, walk.stroke * _GOLDEN % 1.0, 0.0)
    return replace(walk, begin=walk.begin + start, finish=walk.finish + start)


def own_numbers(rows: Rows) -> Doubles:
    """(N,) in 0..1 for edges by their rows (N,): not 0, and near rows are apart."""
    return np.asarray((rows + 1) * _GOLDEN % 1.0)


class _Run:
    """Lines one after the other along their strokes, all strokes in a row."""

    def __init__(self, walk: Walk, order: Rows) -> None:
        stroke = walk.stroke[order]
        self.forward: Flags = (walk.begin <= walk.finish)[order]
        z = [np.where(np.isfinite(end[order]), end[order], 0.0) for end in walk.places]
        self._from = np.where(self.forward, z[0], z[1])
        self._to = np.where(self.forward, z[1], z[0])
        self.size: Doubles = np.abs(self._to - self._from)
        self.total: Doubles = np.cumsum(self.size)
        self.last: Rows = np.flatnonzero(np.append(stroke[1:] != stroke[:-1], True))
        self.first: Rows = np.append(0, self.last[:-1] + 1)
        self.loop: Flags = walk.loop[order[self.first]] > 0.0
        lengths = np.diff(np.append(self.first, len(order)))
        self._number = np.repeat(np.arange(len(self.first)), lengths)
        self.open_seam: Flags = np.zeros(len(self.first), np.bool_)
        """Whether the pen is lifted where a loop closes."""

    def lifted(self, corner: float) -> Flags:
        """(L,) whether the pen is lifted at the end of each line; at the last of each stroke it
        always is."""
        count = len(self.size)
        following = np.arange(1, count + 1)
        following[self.last] = np.where(self.loop, self.first, self.last)
        turn = self._turns(following)
        gap = np.abs(self._from[following] - self._to) > _GAP
        gap[self.last[~self.loop]] = True
        found: Flags = self._sharpest(turn, corner) | gap
        self.open_seam = found[self.last].copy()
        found[self.last] = True
        return found

    def _turns(self, following: Rows) -> Doubles:
        """(L,) radians by which strokes turn at the ends of lines, taken over `_SPAN`."""
        low = (self.total - self.size)[self.first]
        high = self.total[self.last]
        back = self._place(np.maximum(self.total - _SPAN, low[self._number]))
        ahead_from = (self.total - self.size)[following]
        ahead = self._place(np.minimum(ahead_from + _SPAN, high[self._number]))
        come, go = self._to - back, ahead - self._to
        turns = np.abs(np.angle(go * come.conj()))
        # A hook at the end of a chain is no stroke of its own, and less than a zigzag.
        left = np.minimum(self.total - low[self._number], high[self._number] - ahead_from)
        return np.where(self.loop[self._number] | (left >= 0.5 * _SPAN), turns, 0.0)

    def _place(self, along: Doubles) -> Complexes:
        """(N,) places in the window, pixels, so far along the row of strokes."""
        line = np.minimum(np.searchsorted(self.total, along), len(self.size) - 1)
        share = 1.0 - (self.total[line] - along) / np.maximum(self.size[line], 1e-9)
        share = np.clip(share, 0.0, 1.0)
        return np.asarray(self._from[line] + share * (self._to - self._from)[line])

    def straight(
        self, base: Doubles, length: Doubles, joins: tuple[Rows, Rows]
    ) -> tuple[Flags, Flags]:
        """(P,), (P,) whether pieces of the row, from a place on, run straight from their beginning,
        and into their end: a curve of any size turns off over a few pixels, a straight run by less
        than can be seen. joins: pieces, and those that they are the rest of, before them."""
        head, tail = joins
        end, whole = base + length, length.copy()
        back, on = np.zeros(len(base)), np.zeros(len(base))
        back[head], on[tail] = (end[tail] - base[head]), (base[head] - end[tail])
        whole[head] = whole[tail] = length[head] + length[tail]
        over = np.minimum(whole, np.maximum(_STRAIGHT, _SHARE * whole))
        off = np.linspace(1e-6, 1.0, 9) * (over - 1e-6)[:, None]
        first, last = base[:, None] + off, end[:, None] - off
        first += np.where(first > end[:, None], on[:, None], 0.0)
        last += np.where(last < base[:, None], back[:, None], 0.0)
        return self._is_straight(first, over), self._is_straight(last, over)

    def _is_straight(self, along: Doubles, over: Doubles) -> Flags:
        """(P,) whether places (P, N) along the row of strokes lie on lines, so many pixels long."""
        places = self._place(along.ravel()).reshape(along.shape)
        chord = places[:, -1] - places[:, 0]
        size = np.maximum(np.abs(chord), 1e-9)
        off = np.abs(((places - places[:, :1]) * chord.conj()[:, None]).imag) / size[:, None]
        return np.asarray((off.max(axis=1) <= _OFF) & (over >= _LEAST))

    def _sharpest(self, turn: Doubles, corner: float) -> Flags:
        """(L,) of ends of lines that turn by more than a corner and lie together the sharpest."""
        found = np.zeros(len(turn), np.bool_)
        sharp = np.flatnonzero(turn > corner)
        if not len(sharp):
            return found
        apart = np.diff(self.total[sharp]) > _SPAN
        apart |= self._number[sharp[1:]] != self._number[sharp[:-1]]
        cluster = np.cumsum(np.append(True, apart)) - 1
        rank = np.lexsort((sharp, -turn[sharp], cluster))
        best = rank[np.append(True, np.diff(cluster[rank]) > 0)]
        found[sharp[best]] = True
        return found
