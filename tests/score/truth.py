"""Where lines belong, from connectivity. Independent of `glshim.geometry`.

Corners are welded by value; every polygon's facing is the sign of its area in the window; normals
are Newell's, in eye space, turned to the viewer; all in float64. Kinds of line:

* silhouettes: edges whose polygons all lie on one side of them in the window, that is, edges
  between a front-facing and a back-facing polygon where windings agree, and open edges;
* ridges: edges whose two polygons lie on either side of them in the window, with a dihedral angle
  of at most ridge_angle; valleys: of more than valley_angle. The angle is the one behind the
  surface as the viewer sees it, so a sheet seen from behind counts as it looks from there;
* intersections: segments common to the interiors of two polygons that share no edge, and no
  corner there (`crossings`).

`Lines.doubtful` marks what rounding or an ill-formed mesh decides: an angle within 0.1 degrees of
its threshold, and folds on edges of three and more polygons. A line that is doubtful may be drawn
or not. Everything lies in front of the near plane; polygons are convex.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from tests.score.crossings import crossings

KINDS = ("silhouettes", "ridges", "valleys", "intersections")
RIDGE_ANGLE, VALLEY_ANGLE = 120.0, 240.0
_TIE = 0.1
"""Degrees about a threshold within which rounding decides."""


@dataclass(frozen=True)
class Lines:
    """Segments of one kind."""

    ends: np.ndarray
    """(S, 2, 3) x and y in pixels, window depth, at both ends."""
    polygons: np.ndarray
    """(S, 2) the polygons that meet there, -1 for none."""
    doubtful: np.ndarray
    """(S,) bool."""
    through: bool = False
    """Whether the polygons lie on both sides of their line (intersections)."""


@dataclass(frozen=True)
class Body:
    """A mesh prepared once, for any camera. Object space."""

    points: np.ndarray
    """(N, 3) welded corners."""
    triangles: np.ndarray
    """(T, 3) corner indices; polygons as fans."""
    owner: np.ndarray
    """(T,) the polygon of each triangle."""
    sides: np.ndarray
    """(E, 2) corner indices as the polygon winds, polygon by polygon."""
    polygon: np.ndarray
    """(E,) the polygon of each side."""
    count: int
    """Polygons."""
    crossed: np.ndarray
    """(X, 2, 3) crossings."""
    crossers: np.ndarray
    """(X, 2) their polygons."""


def weld(points, grain=2e-6) -> np.ndarray:
    """(N,) a number for each point, equal for points nearer than grain times the extent."""
    points = np.asarray(points, np.float64)
    scaled = points / (grain * max(float(np.ptp(points, axis=0).max()), 1e-300))
    label = np.arange(len(points))
    groups = [
        np.unique(np.floor(scaled + shift).astype(np.int64), axis=0, return_inverse=True)[1].ravel()
        for shift in (0.0, 0.5)
    ]
    while True:
        before = label
        for group in groups:
            least = np.full(group.max() + 1, len(points))
            np.minimum.at(least, group, label)
            label = least[group]
        if (label == before).all():
            return label


def body(batch: PolygonBatch) -> Body:
    """Weld, drop polygons without area and repeated corners, and find the crossings."""
    name = weld(batch.positions)
    points = np.asarray(batch.positions, np.float64)
    corners, sizes = name[batch.corners], np.diff(batch.starts)
    polygon = np.repeat(np.arange(len(sizes)), sizes)
    following = np.arange(len(corners)) + 1
    following[batch.starts[1:][sizes > 0] - 1] = batch.starts[:-1][sizes > 0]
    keep = corners != corners[following]
    corners, polygon = corners[keep], polygon[keep]  # the last of repeated corners stays
    sizes = np.bincount(polygon, minlength=len(sizes))
    starts = np.cumsum(sizes) - sizes
    last = starts + sizes - 1
    fans = np.arange(len(corners))
    inner = (fans > starts[polygon]) & (fans < last[polygon])
    middle = fans[inner]
    triangles = corners[np.stack([starts[polygon[middle]], middle, middle + 1], axis=1)]
    owner = polygon[middle]
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area = np.cross(b - a, c - a)
    total = np.zeros((len(sizes), 3))
    np.add.at(total, owner, area)
    longest = np.maximum(np.linalg.norm(b - a, axis=1), np.linalg.norm(c - a, axis=1))
    extent = np.zeros(len(sizes))
    np.maximum.at(extent, owner, longest)
    grain = 2e-6 * float(np.ptp(points, axis=0).max())
    sound = np.linalg.norm(total, axis=1) > grain * extent
    sound &= sizes >= 3
    triangles, owner = triangles[sound[owner]], owner[sound[owner]]
    following = np.arange(len(corners)) + 1
    following[last[sizes > 0]] = starts[sizes > 0]
    sides = np.stack([corners, corners[following]], axis=1)[sound[polygon]]
    crossed, crossers = crossings(points[triangles], owner, triangles)
    return Body(
        points, triangles, owner, sides, polygon[sound[polygon]], len(sizes), crossed, crossers
    )


def eye_space(points, camera: Camera) -> np.ndarray:
    return points @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]


def window_space(eye, camera: Camera) -> np.ndarray:
    """(..., 3) pixels and window depth of points in eye space."""
    x, y, width, height = camera.viewport
    near, far = camera.depth_range
    clip = eye @ camera.projection[:, :3].T + camera.projection[:, 3]
    ndc = clip[..., :3] / clip[..., 3:]
    low = np.array((x, y, near))
    return low + (ndc + 1) / 2 * (width, height, far - near)


def lines(
    mesh: Body,
    camera: Camera,
    ridge_angle: float = RIDGE_ANGLE,
    valley_angle: float = VALLEY_ANGLE,
) -> dict[str, Lines]:
    """The lines of each of `KINDS`, seen or hidden."""
    eye = eye_space(mesh.points, camera)
    window = window_space(eye, camera)
    normal, middle, ccw = _planes(mesh, eye, window)
    ends = mesh.sides
    low, high = ends.min(axis=1), ends.max(axis=1)
    code = low.astype(np.int64) * len(mesh.points) + high
    order = np.argsort(code, kind="stable")
    starts = np.flatnonzero(np.r_[True, code[order][1:] != code[order][:-1]])
    counts = np.diff(starts, append=len(order))
    left = ccw[mesh.polygon] == (ends[:, 0] == low)
    lefts = np.add.reduceat(left[order], starts) if len(order) else np.empty(0, np.intp)
    contour = (lefts == 0) | (lefts == counts)
    one = order[starts]
    other = order[np.minimum(starts + 1, len(order) - 1)]
    meeting = np.stack([mesh.polygon[one], mesh.polygon[other]], axis=1)
    meeting[counts == 1, 1] = -1
    segments = window[np.stack([low[one], high[one]], axis=1)]
    pair = (mesh.polygon[one], mesh.polygon[other])
    angle = _fold(eye[ends[one, 0]], normal, middle, pair, camera)
    crowd = ~contour & (counts > 2)
    folded = ~contour & (counts == 2)
    ridge = folded & (angle <= ridge_angle + _TIE)
    valley = folded & (angle > valley_angle - _TIE)
    found = {"silhouettes": Lines(segments[contour], meeting[contour], counts[contour] < 0)}
    for kind, folds, limit in (
        ("ridges", ridge, ridge_angle),
        ("valleys", valley, valley_angle),
    ):
        tie = crowd | (np.abs(angle - limit) <= _TIE)
        which = folds | crowd
        found[kind] = Lines(segments[which], meeting[which], tie[which])
    crossed = window_space(eye_space(mesh.crossed, camera), camera)
    found["intersections"] = Lines(crossed, mesh.crossers, np.zeros(len(crossed), bool), True)
    return found


def _planes(mesh: Body, eye, window):
    """(P, 3) unit normals as wound and (P, 3) middles, in eye space; (P,) whether polygons wind
    counter-clockwise in the window."""
    area, flat = np.zeros((mesh.count, 3)), np.zeros(mesh.count)
    middle, weight = np.zeros((mesh.count, 3)), np.zeros(mesh.count)
    a, b, c = (eye[mesh.triangles[:, k]] for k in range(3))
    np.add.at(area, mesh.owner, np.cross(b - a, c - a))
    np.add.at(middle, mesh.owner, (a + b + c) / 3)
    np.add.at(weight, mesh.owner, 1.0)
    a, b, c = (window[mesh.triangles[:, k], :2] for k in range(3))
    u, v = b - a, c - a
    np.add.at(flat, mesh.owner, u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    normal = area / np.maximum(np.linalg.norm(area, axis=1), 1e-300)[:, None]
    return normal, middle / np.maximum(weight, 1)[:, None], flat > 0


def _fold(at, normal, middle, pair, camera):
    """(G,) degrees between the polygons of a pair (G,), (G,) that meet at points at (G, 3) in eye
    space, measured behind the surface that is seen."""
    parallel = not camera.projection[3, :3].any()
    towards = np.array((0.0, 0.0, 1.0)) if parallel else -at
    seen = []
    for polygon in pair:
        n = normal[polygon]
        seen.append(n * np.where((n * towards).sum(axis=1) < 0, -1.0, 1.0)[:, None])
    bend = np.degrees(
        np.arctan2(np.linalg.norm(np.cross(*seen), axis=1), (seen[0] * seen[1]).sum(axis=1))
    )
    hollow = ((middle[pair[1]] - at) * seen[0]).sum(axis=1) > 0
    return np.where(hollow, 180 + bend, 180 - bend)
