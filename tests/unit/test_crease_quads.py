"""Quads of creases and silhouettes: widths on the screen, joins, folds, planes."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.crease.creases import Creases, creases
from glshim.geometry.crease.smoothing_groups import following
from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.references.crease_quads import crease_quads, silhouette_quads, silhouettes
from glshim.model.vectors import dot
from tests import look, surfaces
from tests.odd_meshes import beam, sent_by, zigzag

HALF = (200.0, 150.0)
SMOOTH = mesh(look.batch(*surfaces.torus(48, 24)[:2]))


def camera(seed: int, distance: float) -> tuple[np.ndarray, np.ndarray]:
    """(4, 4) object to clip and (4,) the eye, from anywhere; every third one is parallel."""
    random = np.random.default_rng(seed)
    back, up = random.normal(size=(2, 3))
    back /= np.linalg.norm(back)
    right = np.cross(up, back)
    right /= np.linalg.norm(right)
    spot = distance * back + 0.2 * random.normal(size=3)
    view = np.eye(4)
    view[:3, :3] = right, np.cross(back, right), back
    view[:3, 3] = -view[:3, :3] @ spot
    near, far, tan = 0.1, 20.0, 0.6
    aspect = HALF[0] / HALF[1]
    if seed % 3 == 0:
        size = tan * distance
        lens = np.diag((1 / (size * aspect), 1 / size, -2 / (far - near), 1.0))
        lens[2, 3] = -(far + near) / (far - near)
        return lens @ view, np.append(back, 0.0)
    lens = np.diag((1 / (tan * aspect), 1 / tan, -(far + near) / (far - near), 0.0))
    lens[2, 3], lens[3, 2] = -2 * far * near / (far - near), -1.0
    return lens @ view, np.append(spot, 1.0)


CREASED = {
    "cube": creases(mesh(look.cube())),
    "cylinder": creases(mesh(look.cylinder(24))),
    "bowl": creases(mesh(look.bowl(12, 6)), rule="angle", angle=3.0),
    "beam": creases(beam(12, 0.1), rule="angle", angle=1.0),
    "zigzag": creases(zigzag(12)),
    "torn": creases(SMOOTH, sent_by(SMOOTH, 0.3, 1), rule="normals", least=0.0),
}
VIEWS = [(seed, 4.0) for seed in range(9)] + [(seed, 1.3) for seed in range(1, 9)]


def place(clip: np.ndarray) -> np.ndarray:
    """(..., 2) pixels of clip positions (..., 4)."""
    return clip[..., :2] / clip[..., 3:] * HALF


def across(corners: np.ndarray) -> np.ndarray:
    """(Q, 2) how far the corners 3 and 2 of quads (Q, 4, 2) lie to the left of the side 0 to 1."""
    e = corners[:, 1] - corners[:, 0]
    e /= np.linalg.norm(e, axis=1, keepdims=True)
    left = np.stack((-e[:, 1], e[:, 0]), axis=1)
    return np.stack([dot(corners[:, k] - corners[:, 0], left) for k in (3, 2)], axis=1)


def corners_of(found: Creases, halves: np.ndarray) -> list[np.ndarray]:
    """Three of (Q, 3): where halfedges start and end, and the corner across."""
    after = following(len(found.triangles))
    corners = found.mesh.triangles.ravel()
    return [
        found.mesh.positions[corners[h]].astype(np.float64)
        for h in (halves, after[halves], after[after[halves]])
    ]


def seen(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    return points @ matrix[:, :3].T + matrix[:, 3]


@pytest.mark.parametrize("name", CREASED)
def test_insets_are_as_wide_as_asked_for_on_the_side_of_the_triangle(name: str) -> None:
    found, full = CREASED[name], 0
    for (seed, distance), width in zip(VIEWS, np.geomspace(1, 60, len(VIEWS)), strict=True):
        matrix, _ = camera(seed, distance)
        halves, quads = crease_quads(found, matrix, width, half=HALF)
        assert np.array_equal(halves, np.flatnonzero(found.sides))
        shown = quads.shown
        shown &= np.linalg.norm(np.diff(place(quads.clip)[:, :2], axis=1)[:, 0], axis=1) > 1e-3
        assert shown.any()
        corners = place(quads.clip[shown])
        assert (quads.clip[shown][..., 3] > 0.0).all()
        beside, reach = across(corners), quads.reach[shown]
        assert np.abs(np.abs(beside) - reach).max() < 1e-6
        assert (reach <= width).all()
        full += (reach == width).sum()
        # Inwards: the corner across lies on the same side, as far as it is before the viewer.
        third = seen(corners_of(found, halves[shown])[2], matrix)
        ahead = third[:, 3] > 0.05
        inner = across(np.concatenate((corners[:, :3], place(third)[:, None]), axis=1))[:, 0]
        plain = ahead & (np.abs(inner) > 1e-6)
        assert (inner[plain] * beside[plain, 0] >= 0.0).all()
    assert full > 0


@pytest.mark.parametrize("name", CREASED)
def test_no_quad_folds_at_any_width(name: str) -> None:
    found, bounded = CREASED[name], 0
    for seed, distance in VIEWS:
        matrix, _ = camera(seed, distance)
        for width in (1.0, 2.0, 4.0, 8.0, 16.0, 30.0, 60.0):
            _, quads = crease_quads(found, matrix, width, half=HALF)
            a, b, x_b, x_a = place(quads.clip[quads.shown]).transpose(1, 0, 2)
            assert (dot(x_b - x_a, b - a) >= -1e-6 * np.maximum(dot(b - a, b - a), 1.0)).all()
            short = quads.reach[quads.shown, 0] < width
            assert np.abs(x_a - x_b)[short].max(initial=0.0) < 1e-5  # a triangle at the crossing
            bounded += short.sum()
    assert bounded > 0


@pytest.mark.parametrize("name", CREASED)
def test_quads_that_follow_one_another_share_their_ends(name: str) -> None:
    found, shared = CREASED[name], 0
    after = following(len(found.triangles))
    incoming, outgoing = found.strips
    for seed, distance in VIEWS:
        matrix, _ = camera(seed, distance)
        halves, quads = crease_quads(found, matrix, 3.0, half=HALF)
        row = np.full(found.sides.size, -1)
        row[halves] = np.arange(len(halves))
        both = np.flatnonzero((incoming >= 0) & (outgoing >= 0))
        one, other = row[incoming[both]], row[outgoing[both]]
        assert (after[halves[one]] // 3 == halves[one] // 3).all()
        corners = place(quads.clip)
        side = np.sign(across(corners)[:, 0])
        # Seen from one side both, in front of the viewer, and with a bisector at all.
        m, n = (side[k, None] * unit_left(corners[k]) for k in (one, other))
        fine = quads.shown[one] & quads.shown[other] & (side[one] == side[other])
        fine &= dot(m, n) > -0.8
        before_viewer = seen(found.mesh.positions[found.vertices[both]].astype(float), matrix)
        fine &= before_viewer[:, 2] > -before_viewer[:, 3]
        u, v = quads.bisectors[one, 1], quads.bisectors[other, 0]
        assert np.abs(u - v)[fine].max(initial=0.0) < 1e-4  # differences are float32
        whole = fine & (quads.reach[one, 0] == 3.0) & (quads.reach[other, 0] == 3.0)
        assert np.abs(corners[one, 2] - corners[other, 3])[whole].max(initial=0.0) < 1e-3
        shared += whole.sum()
    assert shared > 20


def unit_left(corners: np.ndarray) -> np.ndarray:
    e = corners[:, 1] - corners[:, 0]
    e = e / np.maximum(np.linalg.norm(e, axis=1, keepdims=True), 1e-30)
    return np.stack((-e[:, 1], e[:, 0]), axis=1)


@pytest.mark.parametrize("name", CREASED)
def test_insets_lie_in_the_planes_of_the_triangles(name: str) -> None:
    found, planes = CREASED[name], 0
    for seed, distance in VIEWS:
        matrix, eye = camera(seed, distance)
        halves, quads = crease_quads(found, matrix, 6.0, half=HALF)
        normals = found.mesh.normals[halves // 3]
        origin = corners_of(found, halves)
        back = quads.clip @ np.linalg.inv(matrix).T
        back = back[..., :3] / back[..., 3:]
        for end, x in ((0, 3), (1, 2)):
            r = quads.insets[:, end]
            at = quads.shown & r.any(axis=1)
            planes += at.sum()
            assert np.abs(dot(back[at, x] - origin[0][at], normals[at])).max(initial=0.0) < 1e-4
            assert np.abs(np.linalg.norm(r[at], axis=1) - 1.0).max(initial=0.0) < 1e-9
            # r = n x (c x d): in the plane of the triangle and in that of d and the way to the eye.
            spot = back[:, end]
            c = eye[:3] - eye[3] * spot
            moved = place(quads.clip[:, end]) + quads.bisectors[:, end]
            target = np.concatenate(
                (moved / HALF * quads.clip[:, end, 3:], quads.clip[:, end, 2:]), axis=1
            )
            d = target @ np.linalg.inv(matrix).T
            d = d[:, :3] / d[:, 3:] - spot
            paper = np.cross(normals, np.cross(c, d))
            paper /= np.maximum(np.linalg.norm(paper, axis=1, keepdims=True), 1e-30)
            sine = np.linalg.norm(np.cross(paper, r), axis=1)
            assert sine[at].max(initial=0.0) < 1e-5
    assert planes > 100


def exact_torus() -> Creases:
    points, triangles = surfaces.torus(48, 24)[:2]
    m = mesh(look.batch(points, triangles))
    # The corners' own normals: welding may number them anew.
    table = {tuple(p): n for p, n in zip(points + 0.0, surfaces.torus_normals(48, 24), strict=True)}
    exact = np.array([table[tuple(p)] for p in m.positions], np.float32)
    return creases(m, exact[m.triangles], rule="normals")


def test_silhouettes_are_closed_curves_where_n_dot_c_is_zero() -> None:
    found = exact_torus()
    assert not found.sides.any()
    for seed, distance in VIEWS:
        _, eye = camera(seed, distance)
        lines = silhouettes(found, eye)
        starts, finishes = (lines.ends[:, k] for k in (0, 1))
        order = [np.lexsort(p.T) for p in (starts, finishes)]
        assert np.array_equal(starts[order[0]], finishes[order[1]])
        # Against the torus itself: its normal there is at right angles to the line of sight.
        ring = np.hypot(starts[:, 0], starts[:, 1])
        centre = starts * np.array((1.0, 1.0, 0.0)) / ring[:, None]
        n = (starts - centre) / np.linalg.norm(starts - centre, axis=1, keepdims=True)
        c = eye[:3] - eye[3] * starts
        c /= np.linalg.norm(c, axis=1, keepdims=True)
        assert np.abs(dot(n, c)).max() < 0.08
        assert lines.before.any(axis=1).all()
        assert lines.after.any(axis=1).all()
        step = finishes - starts
        row = {p.tobytes(): k for k, p in enumerate(finishes)}
        previous = [row[p.tobytes()] for p in starts]
        assert np.allclose(lines.before, step[previous], atol=1e-12)


def test_silhouettes_lead_with_the_front_on_the_left() -> None:
    found = exact_torus()
    matrix, eye = camera(1, 4.0)
    lines = silhouettes(found, eye)
    corners = found.mesh.positions[found.mesh.triangles[lines.triangles]].astype(float)
    along = lines.ends[:, 1] - lines.ends[:, 0]
    normals = found.mesh.normals[lines.triangles]
    left = np.cross(normals, along)
    alpha = np.einsum("tki,tki->tk", found.normals[found.triangles[lines.triangles]],
                      eye[:3] - corners)  # fmt: skip
    towards = np.einsum("tki,ti->tk", corners - lines.ends[:, :1], left)
    best = np.abs(towards).argmax(axis=1)[:, None]
    assert (np.take_along_axis(alpha * towards, best, axis=1) >= 0.0).all()
    # Open surfaces: silhouettes end at the rim, square.
    rows = found.mesh.positions[found.mesh.triangles].mean(axis=1)[:, 0] > 0.0
    half_torus = mesh(look.batch(found.mesh.positions, found.mesh.triangles[rows]))
    lines = silhouettes(creases(half_torus, rule="angle", angle=3.0), eye)
    assert (~lines.before.any(axis=1)).sum() == (~lines.after.any(axis=1)).sum() > 0
    quads = silhouette_quads(lines, matrix, 2.0, 2.0, half=HALF)
    ends = np.flatnonzero(~lines.before.any(axis=1))
    corners = place(quads.clip)
    across_ends = dot(corners[ends, 3] - corners[ends, 0], unit_left(corners[ends]))
    assert np.abs(across_ends - 4.0).max() < 1e-6


@pytest.mark.parametrize("width", [1.0, 5.0, 20.0, 60.0])
def test_silhouette_quads_are_wide_join_and_do_not_fold(width: float) -> None:
    found, joins = exact_torus(), 0
    for seed, distance in VIEWS:
        matrix, eye = camera(seed, distance)
        lines = silhouettes(found, eye)
        quads = silhouette_quads(lines, matrix, width, width / 2, half=HALF)
        corners = place(quads.clip)
        good = quads.shown & (seen(lines.ends, matrix)[..., 3] > 0.2).all(axis=1)
        ends = place(seen(lines.ends, matrix))
        way = ends[:, 1] - ends[:, 0]
        length = np.linalg.norm(way, axis=1)
        good &= length > 1e-3
        normal = np.stack((-way[:, 1], way[:, 0]), axis=1) / length[:, None]
        for k, end, side in ((0, 0, -1), (1, 1, -1), (2, 1, 1), (3, 0, 1)):
            beside = dot(corners[:, k] - ends[:, end], normal)
            assert np.abs(beside - side * quads.reach[:, int(side > 0)])[good].max() < 1e-6
        assert (quads.reach.max(axis=1) <= width).all()
        for near, far in ((0, 1), (3, 2)):
            on = dot(corners[:, far] - corners[:, near], way)
            assert (on[good] >= -1e-6 * np.maximum(length[good] ** 2, 1.0)).all()
        row = {p.tobytes(): k for k, p in enumerate(lines.ends[:, 1])}
        previous = np.array([row[p.tobytes()] for p in lines.ends[:, 0]])
        u, v = quads.bisectors[previous, 1], quads.bisectors[:, 0]
        gentle = good & good[previous] & (dot(normal, normal[previous]) > -0.8)
        assert np.abs(u - v)[gentle].max() < 1e-6
        joins += gentle.sum()
    assert joins > 500


def test_the_outer_side_is_where_normals_point() -> None:
    found = exact_torus()
    matrix, eye = camera(3, 4.0)
    lines = silhouettes(found, eye)
    quads = silhouette_quads(lines, matrix, 1.0, 3.0, half=HALF)
    ends = place(seen(lines.ends, matrix))
    tips = place(seen(lines.ends[:, 0] + 1e-3 * lines.normals[:, 0], matrix))
    out = dot(tips - ends[:, 0], unit_left(ends)) > 0.0
    wide = np.where(out, quads.reach[:, 1], quads.reach[:, 0])
    full = (quads.reach.max(axis=1) == 3.0) & (quads.reach.min(axis=1) == 1.0)
    assert full.mean() > 0.5
    assert (wide[full] == 3.0).mean() > 0.95


def test_an_eye_inside_and_no_creases_at_all() -> None:
    found = CREASED["cube"]
    matrix, _ = camera(1, 0.2)
    _, quads = crease_quads(found, matrix, 5.0, half=HALF)
    assert quads.shown.any()
    assert not quads.shown.all()
    assert np.isfinite(quads.clip[quads.shown]).all()
    none = creases(mesh(look.batch(*surfaces.icosphere(2))))
    halves, quads = crease_quads(none, matrix, 5.0, half=HALF)
    assert len(halves) == len(quads.clip) == 0
