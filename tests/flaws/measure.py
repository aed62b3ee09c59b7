"""What is wrong with a picture of lines, as a number: 0 where nothing is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from tests import look, oracle

_FINE = 0.125
"""Pixels between samples of an area."""


@dataclass(frozen=True)
class Picture:
    """A frame with lines, and what it stands on. Rows from the bottom."""

    ink: np.ndarray
    """(h, w) 0..1: how dark lines made each pixel."""
    depth: np.ndarray
    """(h, w) window depth of the frame without lines."""
    solid: np.ndarray
    """(h, w) bool: pixels that one of the objects with lines covers."""
    items: Sequence[tuple[PolygonBatch, Camera]]
    """The objects whose lines are asked about."""
    ridge_angle: float

    @property
    def truths(self) -> list[oracle.Truth]:
        """Where lines belong, for each object."""
        return [
            oracle.truth(look.polygons_of(b), b.positions, camera, self.ridge_angle)
            for b, camera in self.items
        ]

    def segments(self, kind: str) -> np.ndarray:
        """(S, 2, 3) the segments of a kind ("outlines", "ridges") that are seen at every sample."""
        found = []
        for segment in np.concatenate([getattr(truth, kind) for truth in self.truths]):
            points, _ = oracle.samples([segment], 1.0)
            size = self.ink.shape[::-1]
            if not ((points[:, :2] >= 0) & (points[:, :2] < size)).all():
                continue
            if oracle.visible(points, self.depth, 1e-5, reach=1).mean() > 0.98:
                found.append(segment)
        return np.array(found).reshape(-1, 2, 3)


def in_part(picture: Picture) -> int:
    """Ridges with ink along some of their length but not all of it (whole-or-none)."""
    broken = 0
    for a, b in picture.segments("ridges")[:, :, :2]:
        length = np.hypot(*(b - a))
        t = np.linspace(4, length - 4, 200)[:, None] / length
        column, row = np.floor(a + t * (b - a)).astype(int).T
        share = (picture.ink[row, column] > 0.5).mean()
        broken += 0.01 < share < 0.99
    return broken


def gaps_around(picture: Picture, width: float) -> int:
    """Pixels without ink outside a convex object, within its silhouette's width in pixels."""
    solid = picture.solid
    padded = np.pad(solid, 1)
    inner = padded[:-2, 1:-1] & padded[2:, 1:-1] & padded[1:-1, :-2] & padded[1:-1, 2:]
    rim = np.argwhere(solid & ~inner)[:, ::-1] + 0.5
    owed = oracle.near(rim, solid.shape, width - 1.5) & ~solid
    return int((owed & (picture.ink < 0.5)).sum())


def gaps_along(picture: Picture, width: float, *, beside: bool = False) -> int:
    """Pixels of the objects without ink that lie square off a ridge within half its width; with
    beside, those beside the objects, too."""
    height, wide = picture.ink.shape
    rows, columns = np.mgrid[:height, :wide] + 0.5
    owed = np.zeros(picture.ink.shape, bool)
    for a, b in picture.segments("ridges")[:, :, :2]:
        length = np.hypot(*(b - a))
        along = (b - a) / length
        way = (columns - a[0]) * along[0] + (rows - a[1]) * along[1]
        off = np.abs((columns - a[0]) * along[1] - (rows - a[1]) * along[0])
        owed |= (off < width / 2 - 1.5) & (way > 0) & (way < length)
    return int((owed & (picture.solid | beside) & (picture.ink < 0.5)).sum())


def gaps_at_corners(picture: Picture, width: float) -> int:
    """Pixels of the objects without ink within half a ridge's width of where two ridges meet."""
    ends = np.round(picture.segments("ridges").reshape(-1, 3)[:, :2], 2)
    corners, count = np.unique(ends, axis=0, return_counts=True)
    owed = oracle.near(corners[count >= 2], picture.ink.shape, width / 2 - 1.5)
    return int((owed & picture.solid & (picture.ink < 0.5)).sum())


def widths(
    picture: Picture, lines: np.ndarray, width: float, others: np.ndarray, span: float = 6.0
) -> np.ndarray:
    """(N,) pixels of ink across lines (S, 2, 2+), every span pixels, each as the area of ink over
    a piece of that length; where one of others is not near."""
    found = []
    points, _ = oracle.samples(others)
    reach = 1.5 * width + 2
    for a, b in lines[:, :, :2]:
        length = np.hypot(*(b - a))
        along = (b - a) / max(length, 1e-9)
        for start in np.arange(0.0, max(length - span, 0.0) + 1e-9, span):
            piece = min(span, length)
            middle = a + along * (start + piece / 2)
            room = np.hypot(*(points[:, :2] - middle).T).min() if len(points) else np.inf
            if room < reach + width + span / 2:
                continue
            if not ((middle > reach) & (middle < np.array(picture.ink.shape[::-1]) - reach)).all():
                continue
            u = start + np.arange(_FINE / 2, piece, _FINE)
            v = np.arange(-reach, reach, _FINE) + _FINE / 2
            at = a + u[:, None, None] * along + v[None, :, None] * (-along[1], along[0])
            at = np.clip(np.floor(at).astype(int), 0, np.array(picture.ink.shape[::-1]) - 1)
            found.append(picture.ink[at[..., 1], at[..., 0]].sum() * _FINE**2 / piece)
    return np.array(found)
