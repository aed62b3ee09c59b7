"""Folds of two quads, the directions that they are seen from, and what must be drawn on them.

A fold lies along x. Its faces hang down into -z at half its angle on either side, so that the
material between them is around -z: 180 degrees is flat, less a ridge as +z sees it, more a valley.
Only the fold is a true edge: the outer sides carry no lines.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera

Kind = Literal["ridge", "valley"]
Variant = Literal["one batch", "two objects", "in pieces"]
VARIANTS: tuple[Variant, ...] = ("one batch", "two objects", "in pieces")

DIRECTIONS = 50
HALF_LENGTH, DEPTH = 0.45, 0.35
"""Of the fold and of each face, in object units."""
BAND = 1.0
"""Degrees around the threshold, exclusive, in which the picture may flicker."""
_STEEPEST = 55.0
"""Degrees by which the line of sight leaves the plane across the fold, at most."""
_PIECES = 4


@dataclass(frozen=True)
class View:
    """One fold seen from one direction. All in degrees."""

    angle: float
    """Of the material, 0..360."""
    azimuth: float
    """Of the viewer around the fold: 0 above it, 180 inside the material."""
    elevation: float
    """Of the viewer out of the plane across the fold."""
    roll: float
    """Of the picture."""

    @property
    def seen(self) -> float | None:
        """The angle that the viewer sees, in degrees: the material's where both faces show their
        front, the other one where both show their back, None where one shows each."""
        half, azimuth = np.radians(self.angle / 2), np.radians(self.azimuth)
        front = np.sin(half + azimuth) > 0, np.sin(half - azimuth) > 0
        if front[0] != front[1]:
            return None
        return self.angle if front[0] else 360.0 - self.angle

    @property
    def narrowest(self) -> float:
        """The sine under which the more edge-on of the two faces is seen."""
        half, azimuth = np.radians(self.angle / 2), np.radians(self.azimuth)
        sines = np.abs([np.sin(half + azimuth), np.sin(half - azimuth)])
        return float(sines.min() * np.cos(np.radians(self.elevation)))

    def in_band(self, threshold: float) -> bool:
        """Whether the angle seen lies within `BAND` of the threshold."""
        return self.seen is not None and abs(self.seen - threshold) < BAND

    def drawn(self, kind: Kind, threshold: float) -> bool:
        """Whether a line belongs there."""
        if self.seen is None:
            return False
        return self.seen <= threshold if kind == "ridge" else self.seen > threshold


def views(angle: float, count: int = DIRECTIONS) -> list[View]:
    """A fold of an angle from count directions: 22 of 50 where both fronts show, 22 where both
    backs do, 6 where one of each does, each spread evenly over all such directions.

    At 1 degree both faces show from a wedge of directions 1 degree wide, hidden from the rest.
    """
    half = min(angle / 2, 180 - angle / 2)
    one_each = 0 if half >= 90 else round(count * 0.12)
    fronts = (count - one_each + 1) // 2
    made = []
    for k in range(count):
        i = k + 61 * angle  # another part of the sequence for each fold
        across, up, roll = ((0.5 + i * step) % 1 for step in (0.8191725, 0.6710436, 0.5497005))
        if k < count - one_each:
            azimuth = (2 * across - 1) * half + (0 if k < fronts else 180)
        else:
            azimuth = half + across * (180 - 2 * half) + (180 if k % 2 else 0)
        made.append(View(angle, azimuth, (2 * up - 1) * _STEEPEST, 360 * roll))
    return made


def placed(view: View, at: np.ndarray, projection: np.ndarray, port: tuple[int, int, int, int]):
    """The camera under which the middle of the fold stands at a point in eye space and the viewer
    in the view's direction from it."""
    azimuth, elevation = np.radians(view.azimuth), np.radians(view.elevation)
    towards = np.array([np.sin(elevation), np.cos(elevation) * np.sin(azimuth),
                        np.cos(elevation) * np.cos(azimuth)])  # fmt: skip
    roll = np.radians(view.roll)
    ours, theirs = _frame(towards, (1.0, 0.0, 0.0)), _frame(-at, (0.31, 0.95, 0.05))
    turn = np.array([[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]])
    modelview = np.eye(4)
    modelview[:3, :3] = theirs.T @ turn @ ours
    modelview[:3, 3] = at
    return Camera(modelview, projection, port)


def items(view: View, camera: Camera, variant: Variant) -> list[tuple[PolygonBatch, Camera]]:
    """The fold as batches: both faces in one, each an object with a modelview of its own, or both
    in one and cut across into pieces."""
    pieces = _PIECES if variant == "in pieces" else 1
    x = np.linspace(-HALF_LENGTH, HALF_LENGTH, pieces + 1)
    half = np.radians(view.angle / 2)
    away, down = DEPTH * np.sin(half), -DEPTH * np.cos(half)
    rows = [np.c_[x, np.full_like(x, y), np.full_like(x, z)]
            for y, z in ((0, 0), (away, down), (-away, down))]  # fmt: skip
    points, count = np.concatenate(rows), pieces + 1
    right = [(k, k + 1, count + k + 1, count + k) for k in range(pieces)]
    left = [(k + 1, k, 2 * count + k, 2 * count + k + 1) for k in range(pieces)]
    if variant != "two objects":
        return [(_faces(points, right + left), camera)]
    own = np.eye(4)  # the second object's coordinates
    own[:3, :3] = _frame(np.array((0.3, -0.5, 0.8)), (0.0, 1.0, 0.2))
    own[:3, 3] = (0.7, -0.2, 0.4)
    there = (points - own[:3, 3]) @ own[:3, :3]
    other = replace(camera, modelview=camera.modelview @ own)
    return [(_faces(points, right), camera), (_faces(there, left), other)]


def _faces(points: np.ndarray, quads: list[tuple[int, ...]]) -> PolygonBatch:
    """Quads whose first side alone is a true edge."""
    corners = np.array(quads, np.int32)
    first = np.zeros(corners.shape, bool)
    first[:, 0] = True
    starts = np.arange(len(quads) + 1, dtype=np.int32) * 4
    return PolygonBatch(points.astype(np.float32), corners.ravel(), starts, first.ravel())


def _frame(towards: np.ndarray, near: tuple[float, float, float]) -> np.ndarray:
    """(3, 3) orthonormal rows: the unit vector towards, then one close to another vector."""
    x = towards / np.linalg.norm(towards)
    y = np.asarray(near) - np.dot(near, x) * x
    y /= np.linalg.norm(y)
    return np.array([x, y, np.cross(x, y)])
