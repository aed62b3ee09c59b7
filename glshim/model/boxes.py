"""Axis-parallel boxes of pixels."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Box = tuple[int, int, int, int]
"""x, y, width, height in pixels, origin at the lower left."""
SLIVER = 2
"""Pixels: what is no wider is nothing, for views that share a border."""


def overlap(a: Box, b: Box) -> bool:
    """Whether two boxes share more than a sliver."""
    across = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    up = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    return across > SLIVER and up > SLIVER


@dataclass(frozen=True, slots=True)
class Unbacked:
    """Where a background is to be laid."""

    boxes: tuple[Box, ...]
    free_depth: bool
    """What has depth there was drawn on the background, and stays; else it is an older picture's.
    """
    around: tuple[float, float, float] | None = None
    """Only what has this colour is background: a picture lies there, without depth."""


def covers(outer: Box, inner: Box) -> bool:
    """Whether all of a box but slivers lies in another."""
    return not without((inner,), outer)


def without(boxes: Iterable[Box], hole: Box) -> list[Box]:
    """What is left of boxes outside another one, as boxes, but for slivers."""
    x, y, right, top = hole[0], hole[1], hole[0] + hole[2], hole[1] + hole[3]
    found = []
    for box in boxes:
        if not overlap(box, hole):
            found.append(box)
            continue
        left, low, across, up = box
        below, above = max(y, low), min(top, low + up)
        parts = (
            (left, low, across, below - low), (left, above, across, low + up - above),
            (left, below, x - left, above - below),
            (right, below, left + across - right, above - below),
        )  # fmt: skip
        found += [part for part in parts if min(part[2:]) > SLIVER]
    return found


def boxes_of(mask: NDArray[np.bool_]) -> list[Box]:
    """The true parts of a picture (height, width), row 0 lowest, as boxes: runs of pixels, as high
    as rows are alike."""
    found: list[Box] = []
    changes = np.flatnonzero((mask[1:] != mask[:-1]).any(axis=1)) + 1
    bounds = [0, *changes.tolist(), len(mask)]
    for low, high in pairwise(bounds):
        row = np.concatenate(([False], mask[low], [False]))
        ends = np.flatnonzero(row[1:] != row[:-1]).tolist()
        found += [(a, low, b - a, high - low) for a, b in zip(ends[::2], ends[1::2], strict=True)]
    return found
