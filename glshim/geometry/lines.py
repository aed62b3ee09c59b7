"""Which sides of which polygons become lines under a camera, and what kind of line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera, cofactors
from glshim.geometry.edges import Doubles, Edges, Flags, Indices
from glshim.geometry.gather import Places

RING, RIDGE, LONE_RIDGE, FIN = range(4)
"""Kinds of line. RING: the enlargement of a polygon beyond a side (Raskar 2001, section 2.1).
RIDGE: the quad at the threshold angle, where the neighbour is known to fold below it (2.2).
LONE_RIDGE: that quad where no neighbour is known: depth decides. FIN: a ring that leans back so
steeply that nearly every surface near the edge hides it. It outlines open sides, where a neighbour
may be there after all (a seam, a T-junction, the next batch), and folds that are hollow on the
winding side: hidden in a solid, visible in a sheet or where the windings are inside out."""

RECORD = 15
"""Floats of one record: a, b, c (3 each), plane (4), kind, winding in the window (+1 or -1)."""

_ANGLE_GRAIN = 1e-3
"""Radians by which a fold may miss the threshold for rounding: a hexagonal nut has 120 degrees."""


@dataclass(frozen=True, slots=True)
class Choice:
    """Which lines a style wants."""

    silhouettes: bool
    ridge_angle: float | None
    """Greatest dihedral angle of a ridge in radians, or None for no ridges."""


def choose(
    edges: Edges, camera: Camera, choice: Choice, places: Places | None = None
) -> NDArray[np.float32]:
    """(L, 15) float32 records of the lines to draw, object space; see `RECORD`.

    With places, parts that stand each in its own: the camera's modelview counts for nothing, and
    the records are in eye space.

    Per side, as in the paper: a ring where its polygon is back-facing, a ridge quad where it is
    front-facing. Where another side lies on the same edge, what that polygon hides anyway is
    left out: a ring stays only where all polygons of the edge lie on one side of it in the
    window (the occluding contour, whatever the windings), a ridge only where they lie on both
    and fold at most by the threshold.
    """
    if places is None:
        ccw = edges.planes @ camera.object_centre > 0.0
    else:
        centres = places.centres(camera)[places.polygon]
        ccw = np.einsum("pi,pi->p", edges.planes, centres) > 0.0
    ccw_side = ccw[edges.polygon]
    front = ccw_side == camera.front_ccw
    left = ccw_side == edges.forward
    found: list[tuple[int, Indices]] = []
    ridges = choice.ridge_angle is not None and choice.ridge_angle > 0.0

    singles = edges.singles
    ahead = front[singles]
    if choice.silhouettes:
        found.append((FIN, singles))
    if ridges:
        found.append((LONE_RIDGE, singles[ahead]))

    first, second = edges.pairs
    across = left[first] != left[second]
    if choice.silhouettes:
        one, other = first[~across], second[~across]
        behind = ~front[one], ~front[other]
        found.append((RING, one[behind[0] | ~behind[1]]))
        found.append((RING, other[behind[1]]))
    if choice.ridge_angle is not None and ridges:
        fold = _seen_folds(edges, camera, across, ccw_side, places)
        sharp = np.flatnonzero(across)[fold <= choice.ridge_angle + _ANGLE_GRAIN]
        found += [(RIDGE, first[sharp]), (RIDGE, second[sharp])]

    sides, edge = edges.crowds
    if len(sides):
        total = np.bincount(edge)
        lefts = np.bincount(edge, left[sides])
        contour = ((lefts == 0) | (lefts == total))[edge]
        if choice.silhouettes:
            none_behind = (np.bincount(edge, ~front[sides]) == 0)[edge]
            found.append((RING, sides[contour & (~front[sides] | none_behind)]))
        if ridges:
            found.append((LONE_RIDGE, sides[~contour & front[sides]]))
    return _records(edges, found, ccw_side, places)


def _seen_folds(
    edges: Edges, camera: Camera, across: Flags, ccw: Flags, places: Places | None
) -> Doubles:
    """Dihedral angles (radians, eye space) as the viewer sees them, of the pairs in across."""
    first, second = (sides[across] for sides in edges.pairs)
    fold, flipped = edges.folds[across], np.array(camera.mirrored)
    modelviews = camera.modelview[None] if places is None else places.modelviews
    skewed = ~_are_similarities(modelviews)
    plainly = np.array(np.linalg.det(camera.projection) > 0.0)
    if places is not None:
        owner = places.polygon[edges.polygon[first]]
        flipped = places.mirrored(camera)[owner]
        skewed = skewed[owner]
        if skewed.any():
            linear = places.modelviews[owner[skewed], :3, :3]
            fold[skewed] = edges.fold(first[skewed], second[skewed], linear)
            flipped = np.where(skewed, plainly, flipped)
    elif skewed[0]:
        fold, flipped = edges.fold(first, second, camera.modelview[:3, :3]), plainly
    return np.where(ccw[first] != flipped, fold, 2.0 * np.pi - fold)


def _are_similarities(modelviews: Doubles) -> Flags:
    """(M,) whether angles in object space are angles in eye space."""
    linear = modelviews[:, :3, :3]
    square = linear.transpose(0, 2, 1) @ linear
    scale = np.trace(square, axis1=1, axis2=2)[:, None, None] / 3.0
    off = np.abs(square - scale * np.eye(3)).max(axis=(1, 2))
    return np.asarray(off <= 1e-6 * scale[:, 0, 0])


def _records(
    edges: Edges, found: list[tuple[int, Indices]], ccw: Flags, places: Places | None
) -> NDArray[np.float32]:
    rows = np.concatenate([sides for _, sides in found]) if found else np.empty(0, np.intp)
    records = np.empty((len(rows), RECORD), np.float32)
    records[:, :9] = edges.sides[rows]
    records[:, 9:13] = edges.planes[edges.polygon[rows]]
    records[:, 13] = np.repeat([kind for kind, _ in found], [len(sides) for _, sides in found])
    records[:, 14] = np.where(ccw[rows], 1.0, -1.0)
    if places is not None:
        _move(records, places.modelviews, places.polygon[edges.polygon[rows]])
    return records


def _move(records: NDArray[np.float32], modelviews: Doubles, owner: NDArray[np.int32]) -> None:
    """Take records from object space to eye space under the modelview of each one's owner."""
    turn = modelviews[:, :3, :3].transpose(0, 2, 1).astype(np.float32)[owner]
    shift = modelviews[:, None, :3, 3].astype(np.float32)[owner]
    corners = records[:, :9].reshape(-1, 3, 3) @ turn + shift
    records[:, :9] = corners.reshape(-1, 9)
    normals = (cofactors(modelviews)[owner] @ records[:, 9:12, None])[:, :, 0]
    normals /= np.maximum(np.sqrt(np.einsum("li,li->l", normals, normals)), 1e-300)[:, None]
    records[:, 9:12] = normals
    records[:, 12] = -np.einsum("li,li->l", normals, corners[:, 0])
