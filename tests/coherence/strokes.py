"""Strokes from frame to frame: which stay themselves, and where their patterns go."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from glshim.geometry.window import window
from glshim.linework.chains import chained
from glshim.linework.groups import Group
from glshim.model.camera import Camera
from glshim.model.lines import LONE_RIDGE, LONE_VALLEY, Line, group_of, kind_of
from tests.coherence.carry import NEAR, Motion

STEP = 3.0
"""Pixels from sample to sample."""
REACH = 4
"""Pixels in which a sample of the other frame is the same place of a line."""
STRANGE = 3.0
"""Pixels by which one of another kind of line, or across, counts as farther away: where lines cross
or lie together each is compared with itself."""

_UNDECIDED = (LONE_RIDGE, LONE_VALLEY)
"""Whether these are lines the shader says."""


@dataclass(frozen=True)
class Samples:
    """Places along the strokes of a frame that are seen."""

    places: np.ndarray
    """(N, 2) pixels."""
    depth: np.ndarray
    """(N,) window depth."""
    stroke: np.ndarray
    """(N,) number of the stroke."""
    phase: np.ndarray
    """(N,) repeats of its pattern, NaN for none."""
    slope: np.ndarray
    """(N, 2) how these grow in a pixel."""
    length: np.ndarray
    """(N,) pixels of a repeat."""
    along: np.ndarray
    """(N, 2) unit direction of the line."""
    group: np.ndarray
    """(N,) of the line."""


def sampled(groups: Iterable[tuple[Group, np.ndarray]], depth: np.ndarray) -> Samples:
    """Of groups of lines with their records (L, 21), and the frame's depth (H, W)."""
    parts, strokes = [], 0
    for group, found in groups:
        records = found[~np.isin(kind_of(found), _UNDECIDED)]
        chains = chained(records)
        number = np.empty(len(records), np.intp)
        number[chains.lines] = chains.chain + strokes
        strokes += len(chains)
        parts.append(_along(records, number, group.camera, group.wanted.pattern, depth))
    if not parts:
        parts = [tuple(np.empty((0, *more)) for more in ((2,), (), (), (), (2,), (), (2,), ()))]
    joined = [np.concatenate(some) for some in zip(*parts, strict=True)]
    return Samples(*joined)


def _along(records, number, camera: Camera, pattern, depth) -> tuple[np.ndarray, ...]:
    with np.errstate(all="ignore"):
        a, b = (window(records[:, side].astype(float), camera) for side in (Line.A, Line.B))
        size = np.hypot(*(b - a)[:, :2].T)
    good = np.isfinite(size) & (size < 4000.0)
    counts = np.where(good, np.ceil(np.where(good, size, 0.0) / STEP), 0).astype(int)
    line = np.repeat(np.arange(len(records)), counts)
    begin = np.repeat(np.cumsum(counts) - counts, counts)
    share = (np.arange(len(line)) - begin + 0.5) / counts[line]
    place = a[line] + share[:, None] * (b - a)[line]
    height, width = depth.shape
    x, y = (np.floor(place[:, k]).astype(int) for k in (0, 1))
    within = (x > 0) & (y > 0) & (x < width - 1) & (y < height - 1)
    x, y = np.where(within, x, 1), np.where(within, y, 1)
    around = np.max([depth[y + j, x + i] for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)
    seen = within & (place[:, 2] <= around + NEAR * (1.0 - around) + 1e-6)
    line, share, place = line[seen], share[seen], place[seen]
    lengths = np.zeros(8) if pattern is None else np.resize(pattern.lengths, 8)
    group = group_of(records)[line]
    own = lengths[group]
    first, last = records[:, Line.BEGIN].astype(float), records[:, Line.FINISH].astype(float)
    phase = np.where(own > 0.0, first[line] + share * (last - first)[line], np.nan)
    step = (b - a)[line, :2]
    slope = ((last - first)[line] / np.maximum((step**2).sum(axis=1), 1e-9))[:, None] * step
    along = step / np.maximum(np.hypot(*step.T), 1e-9)[:, None]
    return place[:, :2], place[:, 2], number[line].astype(float), phase, slope, own, along, group


@dataclass
class Kept:
    """Sums over pairs of frames."""

    met: int = 0
    kept: int = 0
    drift: float = 0.0
    patterned: int = 0

    def add(self, before: Samples, now: Samples, motion: Motion, depth: np.ndarray) -> None:
        """motion: from the frame before, whose depth (H, W) is given."""
        if not len(before.places) or not len(now.places):
            return
        carried, known = _carried(before, motion, depth)
        nearest = _nearest(carried, before, now)
        met = np.flatnonzero(known & (nearest >= 0))
        old, new = before.stroke[met].astype(int), now.stroke[nearest[met]].astype(int)
        pairs, which, count = np.unique(
            np.stack((old, new)), axis=1, return_inverse=True, return_counts=True
        )
        most_old = np.zeros(old.max(initial=-1) + 1, int)
        most_new = np.zeros(new.max(initial=-1) + 1, int)
        np.maximum.at(most_old, pairs[0], count)
        np.maximum.at(most_new, pairs[1], count)
        mutual = (count == most_old[pairs[0]]) & (count == most_new[pairs[1]])
        same = mutual[which.ravel()]
        self.met += len(met)
        self.kept += int(count[mutual].sum())
        there = nearest[met]
        ahead = (now.slope[there] * (carried[met] - now.places[there])).sum(axis=1)
        apart = now.phase[there] + ahead - before.phase[met]
        apart = np.abs(apart - np.rint(apart)) * now.length[there]
        told = same & np.isfinite(apart) & (now.length[there] > 0.0)
        self.drift += float(apart[told].sum())
        self.patterned += int(told.sum())


def _carried(samples: Samples, motion: Motion, depth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(N, 2) where samples are then, with the pixel about them whose depth is nearest to theirs."""
    height, width = depth.shape
    x, y = (np.floor(samples.places[:, k]).astype(int) for k in (0, 1))
    best, step = np.full(len(x), np.inf), np.full((len(x), 2), np.nan)
    for i in (-2, -1, 0, 1, 2):
        for j in (-2, -1, 0, 1, 2):
            u, v = np.clip(x + i, 0, width - 1), np.clip(y + j, 0, height - 1)
            off = np.abs(depth[v, u] - samples.depth) + 1e-7 * (abs(i) + abs(j))
            there = motion.there[v, u]
            nearer = (off < best) & np.isfinite(there).all(axis=1)
            best = np.where(nearer, off, best)
            step[nearer] = (there - np.stack((u + 0.5, v + 0.5), axis=1))[nearer]
    return samples.places + np.nan_to_num(step), np.isfinite(step).all(axis=1)


def _nearest(carried: np.ndarray, before: Samples, now: Samples) -> np.ndarray:
    """(N,) the sample now that is nearest to where each was carried (N, 2), within `REACH`, or -1.
    """
    found = np.full(len(carried), -1)
    for first in range(0, len(carried), 256):
        some = slice(first, first + 256)
        away = np.hypot(*(carried[some, None] - now.places[None]).transpose(2, 0, 1))
        same = np.einsum("nk,mk->nm", before.along[some], now.along)
        group = before.group[some, None]
        same = np.where(group == 0, same, np.abs(same))  # creases run either way
        cost = away + STRANGE * ((same < 0.5) + 1.0 * (group != now.group[None]))
        cost[away > REACH] = np.inf
        best = cost.argmin(axis=1)
        found[some] = np.where(np.isfinite(cost[np.arange(len(best)), best]), best, -1)
    return found
