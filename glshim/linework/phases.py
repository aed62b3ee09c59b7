"""Shifts of a pattern along strokes, from what samples of them want."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from glshim.linework.walk import Walk
from glshim.model.arrays import Complexes, Doubles, Rows

_STIFFNESS = 12.0**2
"""Square of the pixels over which a pattern gives way to what was there."""
_ROUNDS = 60
_NEARBY = 12.0
"""Pixels from a line to a sample that tells how its pattern is stretched."""


class Chain:
    """The ends of lines as nodes of their strokes: what ends where another begins is one node."""

    def __init__(self, walk: Walk) -> None:
        on = np.flatnonzero(walk.stroke >= 0)
        low = np.minimum(walk.begin, walk.finish)[on]
        order = on[np.lexsort((low, walk.stroke[on]))]
        stroke = walk.stroke[order]
        first = np.flatnonzero(np.append(True, stroke[1:] != stroke[:-1]))
        last = np.append(first[1:], len(order)) - 1
        ends = np.arange(1, len(order) + 1)
        loops = walk.loop[order[first]] > 0.0
        ends[last] = np.where(loops, first, len(order) + np.arange(len(first)))
        self.count = len(order) + len(first)
        self._order, self._stroke_starts, self._loops = order, first, loops
        self._from, self._to = np.arange(len(order)), ends
        self._row = np.full(len(walk.stroke), -1, np.intp)
        self._row[order] = self._from
        size = np.abs(walk.places[1] - walk.places[0])[order]
        self._size = np.where(np.isfinite(size), size, 1.0)
        self._spring = _STIFFNESS / np.maximum(self._size, 0.5)
        self._stroke = stroke
        self._forward = (walk.begin <= walk.finish)[order]

    def nearby(self, line: Rows, share: Doubles, values: Doubles) -> Doubles:
        """(L,) for lines the value of the sample (N,) nearest to their middle on their stroke, 0
        where that is not near."""
        row = self._row[line]
        end = np.cumsum(self._size)
        along = np.where(self._forward[row], share, 1.0 - share)
        at = end[row] - (1.0 - along) * self._size[row]
        order = np.argsort(at, kind="stable")
        at, row = at[order], row[order]
        middle = end - 0.5 * self._size
        after = np.minimum(np.searchsorted(at, middle), len(at) - 1)
        before = np.maximum(after - 1, 0)
        nearest = np.where(middle - at[before] < np.abs(at[after] - middle), before, after)
        near = np.abs(at[nearest] - middle) <= np.maximum(_NEARBY, 0.5 * self._size)
        near &= self._stroke[row[nearest]] == self._stroke
        found = np.zeros(len(self._row))
        found[self._order] = np.where(near, values[order][nearest], 0.0)
        return found

    def fitted(
        self, line: Rows, share: Doubles, weight: Doubles, wanted: Doubles, gain: Doubles
    ) -> tuple[Doubles, Doubles]:
        """(L,), (L,) the shift at both ends of all lines: of samples (N,) on lines, so far along
        them, what shift is wanted, modulo one, and (L,) how much more of it lines are expected to
        have at their later end than at the other."""
        row = self._row[line]
        along = np.where(self._forward[row], share, 1.0 - share)
        low, high = self._from[row], self._to[row]
        gain = gain[self._order]
        turn_on = np.exp(2j * np.pi * gain)
        goal = np.exp(2j * np.pi * (wanted - along * gain[row]))

        def summed(nodes: Rows, values: Complexes) -> Complexes:
            real, imaginary = (np.bincount(nodes, part, self.count)
                               for part in (values.real, values.imag))  # fmt: skip
            return np.asarray(real + 1j * imaginary)

        def gathered(values: Complexes) -> Complexes:
            """To the nodes: of samples, by how near they are."""
            later = summed(high, along * values * turn_on[row])
            return summed(low, (1.0 - along) * values) + later

        def applied(z: Complexes) -> Complexes:
            back = z[self._to] * turn_on.conj()
            pull = self._spring * (back - z[self._from])
            out = gathered(weight * ((1.0 - along) * z[low] + along * back[row])) + 1e-9 * z
            return out + summed(self._to, pull * turn_on) - summed(self._from, pull)

        z = _solved(applied, gathered(weight * goal))
        turn = np.angle(z) / (2.0 * np.pi)
        # Unwrapped along each stroke from its first node.
        jump = turn[self._to] - turn[self._from]
        jump -= np.rint(jump - gain)
        total = np.cumsum(jump)
        before = total - jump
        base = turn[self._from[self._stroke_starts]] - before[self._stroke_starts]
        counts = np.diff(self._stroke_starts, append=len(self._order))
        before += np.repeat(base, counts)
        after = before + jump
        shifts = np.zeros((2, len(self._row)))
        shifts[0, self._order] = np.where(self._forward, before, after)
        shifts[1, self._order] = np.where(self._forward, after, before)
        return shifts[0], shifts[1]


def _solved(applied: Callable[[Complexes], Complexes], right: Complexes) -> Complexes:
    """Conjugate gradients, as far as a phase needs."""
    z = np.zeros_like(right)
    rest = right.copy()
    way, size = rest.copy(), float(np.vdot(rest, rest).real)
    goal = 1e-6 * size
    for _ in range(_ROUNDS):
        if size <= goal:
            break
        moved = applied(way)
        pace = size / max(float(np.vdot(way, moved).real), 1e-300)
        z += pace * way
        rest -= pace * moved
        size, before = float(np.vdot(rest, rest).real), size
        way = rest + size / max(before, 1e-300) * way
    return z
