"""Where lines belong, from connectivity: the truth that pictures are held to.

Independent of `glshim.geometry`: corners are welded by value, edges looked up in a dict, facing is
the signed area of the projected polygon, angles come from float64 normals in eye space, and
visibility from the depth buffer of the frame.
"""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np


@dataclass
class Truth:
    """Segments in pixels, (S, 2, 3): x, y, window depth at both ends."""

    silhouettes: np.ndarray
    """All of them."""
    outlines: np.ndarray
    """Those where the front-facing polygon is the nearer one: a solid cannot hide them itself."""
    ridges: np.ndarray


def _window(points, camera):
    x, y, width, height = camera.viewport
    clip = np.c_[points, np.ones(len(points))] @ (camera.projection @ camera.modelview).T
    ndc = clip[:, :3] / clip[:, 3:]
    return np.c_[
        x + (ndc[:, 0] + 1) * width / 2, y + (ndc[:, 1] + 1) * height / 2, (ndc[:, 2] + 1) / 2
    ]


def _newell(points, rings):
    """Middle and normal (R, 3) of rings of indices, the normal as long as twice the area."""
    middles, normals = np.zeros((2, len(rings), 3))
    sizes = np.array([len(ring) for ring in rings])
    for size in set(sizes[sizes > 2]):
        same = np.flatnonzero(sizes == size)
        corners = points[np.array([rings[k] for k in same])]
        middles[same] = corners.mean(axis=1)
        spokes = corners - middles[same, None]
        normals[same] = np.cross(spokes, np.roll(spokes, -1, axis=1)).sum(axis=1)
    return middles, normals


def truth(polygons, points, camera, ridge_angle=120.0, weld=1e-5) -> Truth:
    """Classify every edge of polygons (lists of corner indices into points, object space).

    Silhouettes: edges between polygons of unlike facing, and open edges. Ridges: edges between
    two front-facing polygons whose dihedral angle is at most ridge_angle degrees.
    """
    points = np.asarray(points, np.float64)
    eye = points @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
    window = _window(points, camera)
    names = np.unique(np.round(points / weld), axis=0, return_inverse=True)[1].ravel().tolist()
    rings = [[i for k, i in enumerate(polygon) if names[i] != names[polygon[k - 1]]]
             for polygon in polygons]  # fmt: skip
    middles, normals = _newell(eye, rings)
    lengths = np.linalg.norm(normals, axis=1)
    fronts = (_newell(window * (1, 1, 0), rings)[1][:, 2] > 0) == camera.front_ccw
    meeting = defaultdict(list)
    for ring, middle, normal, length, front in zip(
        rings, middles, normals, lengths, fronts, strict=True
    ):
        if length < 1e-9:
            continue
        for i, j in zip(ring, ring[1:] + ring[:1], strict=True):
            meeting[frozenset((names[i], names[j]))].append((i, j, normal / length, front, middle))
    silhouettes, outlines, ridges = [], [], []
    for sides in meeting.values():
        if len(sides) != 2:
            silhouettes.append(window[[sides[0][0], sides[0][1]]])
            outlines.append(silhouettes[-1])
            continue
        one, other = sorted(sides, key=lambda side: not side[3])  # a front-facing one first
        i, j, normal, front, _ = one
        seen = _seen(normal, eye[i], camera) if front else normal
        hollow = (other[4] - eye[i]) @ seen > 0
        if other[3] != front:
            silhouettes.append(window[[i, j]])
            if not hollow:
                outlines.append(silhouettes[-1])
        elif front:
            other_seen = _seen(other[2], eye[i], camera)
            angle = np.degrees(np.arccos(np.clip(seen @ other_seen, -1, 1)))
            if (180 + angle if hollow else 180 - angle) <= ridge_angle:
                ridges.append(window[[i, j]])
    shape = (-1, 2, 3)
    return Truth(*(np.array(found).reshape(shape) for found in (silhouettes, outlines, ridges)))


def _seen(normal, at, camera):
    """The normal of a front-facing polygon turned to the viewer."""
    towards = (0, 0, 1) if camera.projection[3, 3] else -at
    return normal if normal @ np.asarray(towards) > 0 else -normal


def samples(segments, step=0.5):
    """Points along segments, (N, 3), and the unit direction on the screen of each, (N, 2)."""
    points, along = [], []
    for a, b in segments:
        length = np.hypot(*(b - a)[:2])
        if length == 0:
            continue
        at = np.linspace(0, 1, max(int(np.ceil(length / step)) + 1, 2))[:, None]
        points.append(a + at * (b - a))
        along.append(np.tile((b - a)[:2] / length, (len(at), 1)))
    if not points:
        return np.empty((0, 3)), np.empty((0, 2))
    return np.concatenate(points), np.concatenate(along)


def visible(points, depth, slack, reach=1):
    """Whether points (N, 3) are seen in a (h, w) depth buffer, somewhere within reach pixels."""
    height, width = depth.shape
    x, y = np.floor(points[:, 0]).astype(int), np.floor(points[:, 1]).astype(int)
    seen = np.zeros(len(points), bool)
    for dx in range(-reach, reach + 1):
        for dy in range(-reach, reach + 1):
            inside = (x + dx >= 0) & (x + dx < width) & (y + dy >= 0) & (y + dy < height)
            there = depth[np.clip(y + dy, 0, height - 1), np.clip(x + dx, 0, width - 1)]
            seen |= inside & (points[:, 2] <= there + slack)
    return seen


def near(points, shape, radius):
    """(h, w) bool: pixels whose centre lies within radius of one of points (N, 2+)."""
    height, width = shape
    within = np.zeros((height, width), bool)
    points = np.unique(np.round(points[:, :2] * 4), axis=0) / 4
    reach = int(np.ceil(radius)) + 1
    steps = np.arange(-reach, reach + 1)
    for at in range(0, len(points), 1024):
        part = points[at : at + 1024]
        base = np.floor(part).astype(int)
        columns = base[:, 0, None] + steps
        rows = base[:, 1, None] + steps
        square = (
            (((columns + 0.5 - part[:, 0, None]) ** 2)[:, None, :])
            + (((rows + 0.5 - part[:, 1, None]) ** 2)[:, :, None])
        )
        hit, row, column = np.nonzero(square <= radius * radius)
        row, column = rows[hit, row], columns[hit, column]
        inside = (row >= 0) & (row < height) & (column >= 0) & (column < width)
        within[row[inside], column[inside]] = True
    return within
