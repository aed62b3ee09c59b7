"""Drawn ink against true places: precision, recall and isolated dots of one picture.

Ink is a pixel whose colour moved at least a tenth of the way to the ink's. With width the width
of a place's line in pixels:

* an ink pixel is right when its centre lies within width + 1 of a place that is not HIDDEN;
* a SURE place is found when the centre of an ink pixel lies within width + 1 of it. `close` is
  the same within 1.5 pixels, whatever the width: stricter than the score asks;
* a dot is an 8-connected component of fewer than 6 ink pixels that the picture's border does not
  cut, unless what is true there (places not HIDDEN that lie together, within width + 1 of it)
  is itself so short: its length times its width is less than 6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests import oracle
from tests.score.sight import BESIDE, HIDDEN, SURE, UNSURE, Places

LEAST_ALPHA = 0.1
SLACK = 1.0
CLOSE = 1.5
DOT = 6


@dataclass(frozen=True)
class Verdict:
    """One picture judged."""

    ink: int
    right: int
    sure: int
    found: int
    close: int
    unsure: int
    beside: int
    dots: list[tuple[int, int]]
    """Column and row from the lower left of one pixel of each."""
    stray_at: np.ndarray
    """(h, w) bool: ink that is wrong."""
    missed_at: np.ndarray
    """(M, 2) pixels: SURE places without ink."""

    @property
    def precision(self) -> float:
        return self.right / self.ink if self.ink else 1.0

    @property
    def recall(self) -> float:
        return self.found / self.sure if self.sure else 1.0


def inked(before, after) -> np.ndarray:
    """(h, w) bool from pictures (h, w, 3) uint8 without and with black ink."""
    paper = before.astype(np.float32)
    return ((paper - after) >= LEAST_ALPHA * np.maximum(paper, 1)).any(axis=2)


def judge(ink, truths: Sequence[tuple[Places, float]]) -> Verdict:
    """Ink (h, w) against places and the width of their lines."""
    allowed = np.zeros(ink.shape, bool)
    sure = found = close = unsure = beside = 0
    missed = []
    reached: dict[float, np.ndarray] = {}
    for places, width in truths:
        may = places.sight != HIDDEN
        allowed |= oracle.near(places.points[may], ink.shape, width + SLACK)
        points = places.points[places.sight == SURE, :2]
        for radius in (width + SLACK, CLOSE):
            if radius not in reached:
                reached[radius] = _distance_field(ink, radius)
        hit = _reaches(reached[width + SLACK], ink, points, width + SLACK)
        sure += len(points)
        unsure += int((places.sight == UNSURE).sum())
        beside += int((places.sight == BESIDE).sum())
        found += int(hit.sum())
        close += int(_reaches(reached[CLOSE], ink, points, CLOSE).sum())
        missed.append(points[~hit])
    stray = ink & ~allowed
    return Verdict(
        int(ink.sum()),
        int((ink & allowed).sum()),
        sure,
        found,
        close,
        unsure,
        beside,
        _dots(ink, truths),
        stray,
        np.concatenate([np.empty((0, 2)), *missed]),
    )


def _distance_field(ink, radius):
    """(h, w) bool: pixels of which some place may lie within radius of an ink pixel's centre."""
    grown = np.pad(ink, int(np.ceil(radius)) + 1)
    reach = int(np.ceil(radius)) + 1
    near = np.zeros_like(ink)
    height, width = ink.shape
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if np.hypot(max(abs(dx) - 0.5, 0), max(abs(dy) - 0.5, 0)) <= radius:
                near |= grown[reach + dy :, reach + dx :][:height, :width]
    return near


def _reaches(near, ink, points, radius):
    """(N,) whether the centre of an ink pixel lies within radius of each point (N, 2)."""
    at = np.floor(points).astype(int)
    hit = near[at[:, 1], at[:, 0]]
    some = np.flatnonzero(hit)
    done = np.zeros(len(some), bool)
    reach = int(np.ceil(radius)) + 1
    padded = np.pad(ink, reach)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            left = np.flatnonzero(~done)
            place = some[left]
            centre = at[place] + (dx + 0.5, dy + 0.5)
            there = padded[at[place, 1] + dy + reach, at[place, 0] + dx + reach]
            done[left] = there & (np.linalg.norm(points[place] - centre, axis=1) <= radius)
    hit[some] = done
    return hit


def components(mask) -> np.ndarray:
    """(h, w) intp: -1 off the mask, else a number for each 8-connected component."""
    height, width = mask.shape
    number = np.full((height + 2, width + 2), -1)
    number[1:-1, 1:-1][mask] = np.arange(mask.sum())
    links = []
    for dy, dx in ((0, 1), (1, -1), (1, 0), (1, 1)):
        one = number[1:-1, 1:-1]
        other = number[1 + dy : 1 + dy + height, 1 + dx : 1 + dx + width]
        both = (one >= 0) & (other >= 0)
        links.append(np.stack([one[both], other[both]]))
    one, other = np.concatenate(links, axis=1)
    label = np.arange(int(mask.sum()))
    while True:
        least = np.minimum(label[one], label[other])
        new = label.copy()
        np.minimum.at(new, label[one], least)
        np.minimum.at(new, label[other], least)
        new = new[new]
        if (new == label).all():
            break
        label = new
    out = np.full(mask.shape, -1)
    out[mask] = label
    return out


def _dots(ink, truths) -> list[tuple[int, int]]:
    label = components(ink)
    sizes = np.bincount(label[ink], minlength=1)
    border = np.concatenate([label[0], label[-1], label[:, 0], label[:, -1]])
    small = (sizes > 0) & (sizes < DOT)
    small[border[border >= 0]] = False
    found = []
    if not small.any():
        return found
    true = [(p.points[p.sight != HIDDEN], p.length[p.sight != HIDDEN], w) for p, w in truths]
    together = np.zeros(ink.shape, bool)
    for points, _, _ in true:
        at = np.floor(points[:, :2]).astype(int)
        together[at[:, 1], at[:, 0]] = True
    run = components(together)
    area = np.zeros(max(int(run.max()) + 1, 1))
    for points, length, width in true:
        at = np.floor(points[:, :2]).astype(int)
        np.add.at(area, run[at[:, 1], at[:, 0]], length * width)
    for dot in np.flatnonzero(small):
        rows, columns = np.nonzero(label == dot)
        centre = np.array((columns.mean(), rows.mean())) + 0.5
        runs: set[int] = set()
        for points, _, width in true:
            near = np.linalg.norm(points[:, :2] - centre, axis=1) <= width + SLACK
            at = np.floor(points[near, :2]).astype(int)
            runs |= set(run[at[:, 1], at[:, 0]].tolist())
        if not runs or area[list(runs)].max() >= DOT:
            found.append((int(columns[0]), int(rows[0])))
    return found
