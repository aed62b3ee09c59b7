"""Where style crease's lines belong (Hajagos 2012). Independent of `glshim.geometry`, in float64.

* creases: edges whose two polygons turn by CREASE_ANGLE degrees or more, and open edges;
* smooth: where n . c is zero, n interpolated linearly over each triangle from normals at its
  corners, c towards the viewer. The normal of a corner is the mean of those of the triangles that
  it hangs together with around its vertex, not across creases, weighted by their angles there.

The meshes that are scored come without normals of an app's. Their windings agree.
"""

from __future__ import annotations

import numpy as np

from glshim.model.camera import Camera
from tests.score.truth import Body, Lines, eye_space, window_space

CREASE_ANGLE = 40.0
_TIE = 0.5
"""Degrees about it within which rounding, and how a polygon is cut, decide."""


def lines(mesh: Body, camera: Camera) -> dict[str, Lines]:
    """Both kinds, seen or hidden."""
    area = _areas(mesh)
    total = np.zeros((mesh.count, 3))
    np.add.at(total, mesh.owner, area)
    normal = total / np.maximum(np.linalg.norm(total, axis=1), 1e-300)[:, None]
    eye = eye_space(mesh.points, camera)
    return {
        "creases": _creases(mesh, normal, window_space(eye, camera)),
        "smooth": _smooth(mesh, area, normal, eye, camera),
    }


def _areas(mesh: Body) -> np.ndarray:
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a)


def _pairs(ends, count):
    """The rows of (E, 2) that are one edge: the first of each edge, the second or -1."""
    code = ends.min(axis=1).astype(np.int64) * count + ends.max(axis=1)
    order = np.argsort(code, kind="stable")
    starts = np.flatnonzero(np.r_[True, code[order][1:] != code[order][:-1]])
    size = np.diff(starts, append=len(order))
    second = order[np.minimum(starts + 1, len(order) - 1)]
    return order[starts], np.where(size == 2, second, -1), size


def _turn(normal, one, other) -> np.ndarray:
    """Degrees between normals."""
    n, m = normal[one], normal[other]
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(n, m), axis=1), (n * m).sum(axis=1)))


def _creases(mesh: Body, normal, window) -> Lines:
    one, other, size = _pairs(mesh.sides, len(mesh.points))
    polygons = np.stack([mesh.polygon[one], np.where(other < 0, -1, mesh.polygon[other])], axis=1)
    turn = np.where(size == 2, _turn(normal, polygons[:, 0], polygons[:, 1]), 180.0)
    keep = turn >= CREASE_ANGLE - _TIE
    tie = (turn <= CREASE_ANGLE + _TIE) | (size > 2)
    return Lines(window[mesh.sides[one]][keep], polygons[keep], tie[keep])


def _smooth(mesh: Body, area, normal, eye, camera: Camera) -> Lines:
    corners = _corner_normals(mesh, area, normal)
    turned = corners @ np.linalg.inv(camera.modelview[:3, :3])  # normals turn by the inverse
    parallel = not camera.projection[3, :3].any()
    places = eye[mesh.triangles]
    value = turned[..., 2] if parallel else -(turned * places).sum(axis=2)
    above = value >= 0.0
    mixed = np.flatnonzero(above.any(axis=1) & ~above.all(axis=1))
    sign, v, p = above[mixed], value[mixed], places[mixed]
    lone = np.where(sign.sum(axis=1) == 1, sign.argmax(axis=1), (~sign).argmax(axis=1))
    rows = np.arange(len(mixed))
    ends = []
    for step in (1, 2):
        far = (lone + step) % 3
        share = (v[rows, lone] / (v[rows, lone] - v[rows, far]))[:, None]
        ends.append(p[rows, lone] + share * (p[rows, far] - p[rows, lone]))
    segments = window_space(np.stack(ends, axis=1), camera)
    owner = np.stack([mesh.owner[mixed]] * 2, axis=1)
    return Lines(segments, owner, np.zeros(len(mixed), bool), through=True)


def _corner_normals(mesh: Body, area, normal) -> np.ndarray:
    """(T, 3, 3) unit normals."""
    triangles = mesh.triangles
    count = len(triangles)
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    one, other, _ = _pairs(sides, len(mesh.points))
    one, other = one[other >= 0], other[other >= 0]
    same = mesh.owner[one // 3] == mesh.owner[other // 3]
    flat = same | (_turn(normal, mesh.owner[one // 3], mesh.owner[other // 3]) < CREASE_ANGLE)
    one, other = one[flat], other[flat]
    after = (np.arange(3 * count).reshape(-1, 3)[:, (1, 2, 0)]).ravel()
    # The corner that a side starts from is the one at which the other triangle's ends.
    links = np.concatenate([np.c_[one, after[other]], np.c_[after[one], other]])
    label = np.arange(3 * count)
    while True:
        before = label.copy()
        least = np.minimum(label[links[:, 0]], label[links[:, 1]])
        np.minimum.at(label, links[:, 0], least)
        np.minimum.at(label, links[:, 1], least)
        if (label == before).all():
            break
    p = mesh.points[triangles]
    u, w = np.roll(p, -1, axis=1) - p, np.roll(p, 1, axis=1) - p
    angle = np.arctan2(np.linalg.norm(np.cross(u, w), axis=2), (u * w).sum(axis=2)).ravel()
    unit = area / np.maximum(np.linalg.norm(area, axis=1), 1e-300)[:, None]
    total = np.zeros((3 * count, 3))
    np.add.at(total, label, angle[:, None] * np.repeat(unit, 3, axis=0))
    found = total[label]
    return (found / np.maximum(np.linalg.norm(found, axis=1), 1e-300)[:, None]).reshape(-1, 3, 3)
