"""How far along its stroke each line lies, and how far along a pattern that repeats on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.geometry.window import cut, window
from glshim.linework.joins import heads, least_of, next_lines, sums
from glshim.model.arrays import Complexes, Doubles, Floats, Rows
from glshim.model.camera import Camera
from glshim.styling.wishes import Pattern

_LEAST = 0.5
"""Share of its sides' length that a loop has at least in its middle."""


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
        after = next_lines(a[some], b[some], directed=kind == 0)
        if kind == 0:
            begin, finish, stroke, loop = _walked(after, steps[some], length, pattern.middle)
            starts[some], finishes[some], loops[some] = begin, finish, loop
            strokes[some] = stroke + strokes.max() + 1
            continue
        # Every crease twice, once a direction: half 2i runs from a to b, half 2i + 1 back.
        halves = np.stack([steps[some], -steps[some]], axis=1).ravel()
        begin, finish, stroke, loop = _walked(after, halves, length, 0.0)
        # Of a stroke and the same one back, that on which its first crease runs forward.
        forth = least_of(stroke) % 2 == 0
        ahead = forth[stroke[0::2]]
        starts[some] = np.where(ahead, begin[0::2], finish[1::2])
        finishes[some] = np.where(ahead, finish[0::2], begin[1::2])
        loops[some] = loop[0::2]
        strokes[some] = np.where(ahead, stroke[0::2], stroke[1::2]) + strokes.max() + 1
    return Walk(starts, finishes, strokes, loops, (places[0], places[1]))


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
    first, closed = heads(before)
    stroke_of, stroke = np.unique(first, return_inverse=True)
    count = len(stroke_of)

    def total(values: Doubles) -> Doubles:
        return np.asarray(np.bincount(stroke, values, count), np.float64)

    # A stroke that bends around a point nearer than its middle is measured on its sides.
    bent = total(sizes + corner) >= _LEAST * total(sizes)
    advance = sizes + np.where(bent[stroke], corner, 0.0)
    before[first[closed]] = -1
    at = sums(before, advance)
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
