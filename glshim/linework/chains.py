"""Chains: lines joined end to end, as values for outputs that draw curves rather than lines.

`chained` joins the records of lines (`glshim.model.lines.Line`), `Chains.in_eye_space` and
`Chains.in_window` give their points. Silhouettes run on as they wind, all others to either side;
where several lines meet, those that go on straightest are joined. A crease does not go on as one
that turns by more than 72 degrees, and lines of unlike groups never do.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.geometry.window import cut, window
from glshim.linework.joins import heads, least_of, next_lines, sums
from glshim.model.arrays import Doubles, Flags, Floats, Rows
from glshim.model.camera import Camera
from glshim.model.lines import Line, group_of


@dataclass(frozen=True, slots=True, eq=False)
class Polylines:
    """S open or closed polylines, one after the other."""

    points: Doubles
    """(P, 3) eye space, or pixels of the framebuffer (y upwards) and window depth."""
    lines: Rows
    """(P,) the record of the line from each point to the next; at the end of an open polyline that
    of the line before."""
    starts: Rows
    """(S + 1,) the first point of each; the last entry is P."""
    closed: Flags
    """(S,) the last point is joined to the first, which is not repeated."""
    group: Rows
    """(S,) group of the lines, see `glshim.model.lines.GROUPS`."""

    def __len__(self) -> int:
        return len(self.closed)


@dataclass(frozen=True, slots=True, eq=False)
class Chains:
    """S chains of L lines, each line in one of them."""

    lines: Rows
    """(L,) rows of the records, chain after chain, in the order in which they join."""
    forward: Flags
    """(L,) whether each of `lines` runs from its a to its b along its chain."""
    starts: Rows
    """(S + 1,) where each chain begins in `lines`; the last entry is L."""
    closed: Flags
    """(S,) its last line ends where its first begins."""
    group: Rows
    """(S,) group of its lines, see `glshim.model.lines.GROUPS`."""

    def __len__(self) -> int:
        return len(self.closed)

    @property
    def chain(self) -> Rows:
        """(L,) the chain of each of `lines`."""
        return np.repeat(np.arange(len(self)), np.diff(self.starts))

    def in_eye_space(self, records: Floats) -> Polylines:
        """The chains of records (L, 21), unbroken."""
        begin, end = (records[:, side].astype(np.float64) for side in (Line.A, Line.B))
        all_ = np.ones(len(records), np.bool_)
        return self._polylines(begin, end, all_, all_, all_)

    def in_window(self, records: Floats, camera: Camera) -> Polylines:
        """The chains of records (L, 21) as a camera shows them, broken where the near plane or the
        app's clip planes cut them. What lies outside the window is not cut off."""
        begin, end = (records[:, side].astype(np.float64) for side in (Line.A, Line.B))
        (a, b), whole_b, left = cut(begin, end, camera)
        whole_a = (a == begin).all(axis=1)
        return self._polylines(window(a, camera), window(b, camera), left, whole_a, whole_b)

    def _polylines(
        self, a: Doubles, b: Doubles, left: Flags, whole_a: Flags, whole_b: Flags
    ) -> Polylines:
        """Of the ends (L, 3) of lines, of which some are left, some with their own a or b."""
        chain, sizes = self.chain, np.diff(self.starts)
        closed, first = self.closed[chain], self.starts[:-1][chain]
        place = np.arange(len(chain)) - first
        onward = first + (place + 1) % sizes[chain]
        reached = np.where(self.forward, whole_b[self.lines], whole_a[self.lines])
        begun = np.where(self.forward, whole_a[self.lines], whole_b[self.lines])
        kept = left[self.lines]
        joined = kept & reached & (kept & begun)[onward] & (closed | (onward > first))
        # A loop that is broken begins behind a break.
        broken = np.full(len(self), -1, np.intp)
        broken[chain[~joined]] = place[~joined]
        loop = self.closed & (broken < 0)
        order = np.lexsort(((place - broken[chain] - 1) % sizes[chain], chain))
        order = order[kept[order]]
        chain, joined = chain[order], joined[order]
        fresh = np.append(True, ~joined[:-1] | (chain[1:] != chain[:-1]))[: len(order)]
        heads_at = np.flatnonzero(fresh)
        open_ = ~loop[chain[heads_at]]

        lines, forward = self.lines[order], self.forward[order, None]
        begin, end = np.where(forward, a[lines], b[lines]), np.where(forward, b[lines], a[lines])
        starts = np.append(heads_at, len(order)) + np.append(0, np.cumsum(open_))
        run = np.cumsum(fresh) - 1
        at = np.arange(len(order)) + (np.cumsum(open_) - open_)[run]
        points, owner = np.empty((starts[-1], 3)), np.empty(starts[-1], np.intp)
        points[at], owner[at] = begin, lines
        tail = np.append(heads_at[1:], len(order))[open_] - 1
        points[at[tail] + 1], owner[at[tail] + 1] = end[tail], lines[tail]
        return Polylines(points, owner, starts, ~open_, self.group[chain[heads_at]])


def chained(records: Floats) -> Chains:
    """The chains that lines of records (L, 21) make."""
    a, b, group = records[:, Line.A], records[:, Line.B], group_of(records)
    lines, forward, starts, closed, groups = [], [], [], [], []
    done = 0
    for number in np.unique(group).tolist():
        rows = np.flatnonzero(group == number)
        after = next_lines(a[rows], b[rows], directed=number == 0)
        order, firsts, loops = _in_order(after)
        if number == 0:
            lines.append(rows[order])
            forward.append(np.ones(len(order), np.bool_))
        else:
            # Every chain is there twice, once a direction: that on which its least line is forward.
            chain = np.repeat(np.arange(len(loops)), np.diff(firsts, append=len(order)))
            numbers = np.empty(len(order), np.intp)
            numbers[order] = chain
            ahead = least_of(numbers) % 2 == 0
            order, chain, loops = order[ahead[chain]], chain[ahead[chain]], loops[ahead]
            firsts = np.flatnonzero(np.append(True, chain[1:] != chain[:-1]))
            lines.append(rows[order // 2])
            forward.append(order % 2 == 0)
        starts.append(firsts + done)
        closed.append(loops)
        groups.append(np.full(len(loops), number))
        done += len(rows)
    if not lines:
        nothing, none = np.empty(0, np.intp), np.empty(0, np.bool_)
        return Chains(nothing, none, np.zeros(1, np.intp), none, nothing)
    return Chains(
        np.concatenate(lines), np.concatenate(forward), np.append(np.concatenate(starts), done),
        np.concatenate(closed), np.concatenate(groups),
    )  # fmt: skip


def _in_order(after: Rows) -> tuple[Rows, Rows, Flags]:
    """(L,) lines, each chain from its first line on; (S,) where chains begin there; and (S,) which
    are loops. after (L,): as `next_lines` gives it."""
    goes_on = after >= 0
    before = np.full(len(after), -1, np.intp)
    before[after[goes_on]] = np.flatnonzero(goes_on)
    first, loops = heads(before)
    before[first[loops]] = -1
    place = sums(before, np.ones(len(after)))
    order = np.lexsort((place, first))
    starts = np.flatnonzero(place[order] == 0.0)
    return order, starts, loops[order[starts]]
