"""Segments in which triangles pass through each other: known answers, and a slow check."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.linework import intersections
from glshim.model.lines import ENDLESS, INTERSECTION, RECORD, Line
from glshim.outputs.gl.device.triangles import triangles as fans
from tests import look


def moved(batch, matrix=None, shift=(0, 0, 0)):
    """(T, 3, 3) float64 triangles of a batch, placed; float32 in between, as apps have it."""
    points = fans(batch).astype(np.float64) @ (np.eye(3) if matrix is None else matrix).T + shift
    return points.astype(np.float32).astype(np.float64)


def turned(x, y, z):
    """A rotation by angles in radians about the axes."""
    out = np.eye(3)
    for k, a in enumerate((x, y, z)):
        turn = np.eye(3)
        i, j = (k + 1) % 3, (k + 2) % 3
        turn[i, i] = turn[j, j] = np.cos(a)
        turn[i, j], turn[j, i] = -np.sin(a), np.sin(a)
        out = turn @ out
    return out


def plate(cells=1, half=2.0):
    """A flat grid at z = 0."""
    return look._grid(
        lambda u, v: ((2 * u - 1) * half, (2 * v - 1) * half, 0.0), cells, cells, False, False
    )


def scene(*meshes, own=True):
    """All triangles, their neighbours (each mesh its own when own), and all pairs."""
    corners = np.concatenate(meshes)
    owner = np.repeat(np.arange(len(meshes), dtype=np.int32), [len(m) for m in meshes])
    beside = intersections.neighbours(corners.astype(np.float32), owner if own else None)
    first, second = np.triu_indices(len(corners), 1)
    low, high = corners.min(axis=1) - 1e-3, corners.max(axis=1) + 1e-3
    meet = ((low[first] <= high[second]) & (low[second] <= high[first])).all(axis=1)
    return corners, beside, np.stack((first, second), axis=1)[meet]


def found(*meshes, own=True):
    """(M, 2, 3) the segments among all pairs."""
    return intersections.segments(*scene(*meshes, own=own))[0]


def length(segments):
    return float(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1).sum())


def closed(segments, tolerance=1e-4):
    """Whether every end of a segment is also the end of another."""
    ends = segments.reshape(-1, 3)
    apart = np.linalg.norm(ends[:, None] - ends[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    return bool((apart.min(axis=1) < tolerance).all())


def test_two_squares_cross_in_one_line():
    upright = moved(plate(half=0.5), turned(np.pi / 2, 0, 0.3), (0.1, 0.2, 0.1))
    got = found(moved(plate()), upright)
    assert length(got) == pytest.approx(1.0, abs=1e-5)
    assert np.abs(got[:, :, 2]).max() < 1e-6


@pytest.mark.parametrize("cells", [1, 2, 5, 8])
@pytest.mark.parametrize("shift", [(0.13, 0.21), (0.0, 0.0), (0.1, 0.1), (0.5, -0.5)])
def test_a_cube_goes_through_a_plate(cells, shift):
    """Whatever lines of the plate its faces lie on."""
    got = found(moved(look.cube(0.5), shift=(*shift, 0.1)), moved(plate(cells)))
    assert length(got) == pytest.approx(4.0, abs=1e-4)
    assert closed(got)
    assert np.abs(np.abs(got[:, :, :2] - shift).max(axis=2) - 0.5).max() < 1e-5


@pytest.mark.parametrize("rings", [(24, 14), (24, 15), (48, 26)])
@pytest.mark.parametrize("cells", [1, 4, 7])
def test_a_sphere_half_sunk_in_a_floor(rings, cells):
    """Its equator is a row of sides, or lies between two."""
    got = found(moved(look.sphere(*rings, radius=1.0)), moved(plate(cells)))
    assert closed(got)
    radii = np.linalg.norm(got.reshape(-1, 3)[:, :2], axis=1)
    flat = np.cos(np.pi / rings[0]) * np.cos(np.pi / rings[1])
    assert radii.min() > flat - 0.01 and radii.max() < 1.0 + 1e-5
    assert length(got) == pytest.approx(2 * np.pi * radii.mean(), rel=0.012)
    steps = np.sort(np.arctan2(*got.mean(axis=1)[:, :2].T))
    assert np.diff(steps).max() < 2 * np.pi / rings[0] + 1e-3


@pytest.mark.parametrize("turn", [(0, 0, 0), (0.3, 0.5, 0.1), (0, 0, np.pi / 4)])
def test_a_cylinder_through_a_grid(turn):
    """Upright, its sides and the middle of its symmetric ring lie on lines of the grid."""
    got = found(moved(look.cylinder(24), turned(*turn)), moved(plate(8)))
    assert closed(got)
    assert length(got) == pytest.approx(24 * 2 * 0.7 * np.sin(np.pi / 24), rel=0.25)


def test_two_rings_of_a_chain_that_touch_each_other_deeply():
    a = moved(look.torus(36, 18))
    b = moved(look.torus(36, 18), turned(np.pi / 2, 0, 0), (0.5, 0, 0))
    got = found(a, b)
    assert closed(got) and length(got) > 4.0
    for centre, turn in (((0, 0, 0), np.eye(3)), ((0.5, 0, 0), turned(np.pi / 2, 0, 0))):
        local = (got.reshape(-1, 3) - centre) @ turn
        tube = np.hypot(np.linalg.norm(local[:, :2], axis=1) - 1.0, local[:, 2])
        assert np.abs(tube - 0.4).max() < 0.012


@pytest.mark.parametrize("miss", [0.0, 1e-8, -1e-8, 1e-7, -1e-7])
@pytest.mark.parametrize("cells", [1, 2, 9])
@pytest.mark.parametrize("own", [True, False])
def test_what_only_touches_gives_nothing(miss, cells, own):
    """Boxes on a floor, on each other and side by side; a cone's tip, a cylinder's line."""
    floor = moved(plate(cells))
    for shift in ((0, 0), (0.1, 0.2), (0.5, 0.5), (1.5, 0)):
        box = moved(look.cube(0.5), shift=(*shift, 0.5 + miss))
        assert not len(found(floor, box, own=own))
        assert not len(found(floor, box[2:], own=own))
        assert not len(found(box, box + np.array((0, 0, 1)), own=own))
        assert not len(found(box, box + np.array((1 + miss, 0.3, 0.2)), own=own))
        assert not len(found(box, box + np.array((1 + miss, 1, 0)), own=own))
    roll = moved(look.cylinder(24, radius=0.7), turned(np.pi / 2, 0, 0), (0, 0, 0.7 + miss))
    assert not len(found(floor, roll, own=own))
    ball = moved(look.sphere(24, 14, radius=1.0), shift=(0.1, 0, 1.0 + miss))
    assert not len(found(floor, ball, own=own))
    edge = moved(look.cube(0.5), turned(np.pi / 4, 0, 0), (0, 0, 0.5 * 2**0.5 + miss))
    assert not len(found(floor, edge, own=own))


def test_an_open_sheet_that_ends_at_a_wall_gives_nothing():
    sheet = moved(plate(3, 0.5), turned(np.pi / 2, 0, 0), (0.1, 0, 0.5))
    assert not len(found(moved(plate(1)), sheet))
    assert length(found(moved(plate(1)), sheet - (0, 0, 0.01))) == pytest.approx(1.0, abs=1e-4)


def test_coplanar_and_nearly_parallel_polygons_give_nothing():
    for turn, shift in (((0, 0, 0.4), 0.0), ((0.004, 0, 0), 0.0), ((0, 0, 0.4), 1e-7)):
        assert not len(found(moved(plate(3)), moved(plate(2, 1.0), turned(*turn), (0.2, 0, shift))))
    assert len(found(moved(plate()), moved(plate(2, 1.0), turned(0.02, 0, 0), (0.2, 0, 0))))


def test_equal_grids_that_cross_in_a_row_of_their_own_sides():
    """Corners coincide: four triangles of two meshes lie on each side."""
    for cells in (2, 4):
        got = found(moved(plate(cells)), moved(plate(cells), turned(np.pi / 2, 0, 0)))
        assert length(got) == pytest.approx(4.0, abs=1e-4)


def test_closed_meshes_do_not_cross_themselves():
    for make in (look.torus, look.sphere, look.bowl, look.cube, look.cylinder):
        assert not len(found(moved(make(), turned(0.3, 0.2, 0.1)), own=False))


def test_triangles_that_share_a_corner_may_cross():
    """One mesh: two triangles about the origin pass through each other from there on."""
    one = np.array([[(0, 0, 0), (2, -1, 0), (2, 1, 0)]], float)
    two = np.array([[(0, 0, 0), (1, 0.1, -1), (1, 0.1, 1)]], float)
    got = found(one, two, own=False)
    assert length(got) == pytest.approx(np.hypot(1, 0.1), abs=1e-6)
    apart = np.array([[(0, 0, 0), (-1, 0.1, -1), (-1, 0.1, 1)]], float)
    assert not len(found(one, apart, own=False))


def test_one_mesh_that_crosses_itself():
    """A band whose two ends pass through each other: one polygon strip."""
    s = np.linspace(-2.2, 2.2, 40)
    points = np.stack((s**3 - 3 * s, 0 * s, s**2), axis=1)  # crosses itself at s = +-sqrt(3)
    strip = look._grid(lambda u, v: points[round(u * 39)] + (0, v, 0), 39, 3, False, False)
    got = found(moved(strip, turned(0.2, 0.1, 0)), own=False)
    assert length(got) == pytest.approx(1.0, abs=1e-4)


def test_curves_are_followed_from_one_pair():
    """A dense sphere in a dense floor, from a single seed: all of the circle, nothing else."""
    corners, beside, pairs = scene(moved(look.sphere(48, 25, radius=1.0)), moved(plate(12)))
    _, rows = intersections.segments(corners, beside, pairs)
    traced = pairs[rows[:1]]
    for _ in range(8):
        traced = intersections.trace(corners, beside, traced)
    got, _ = intersections.segments(corners, beside, traced)
    assert len(got) == len(rows) and closed(got)
    assert len(traced) < 6 * len(rows)


def test_contact_is_not_followed_over_whole_meshes():
    corners, beside, pairs = scene(moved(look.sphere(48, 25)))
    assert len(intersections.trace(corners, beside, pairs[:50])) <= 50


def test_neighbours_of_a_tetrahedron():
    corners = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], np.float32)
    faces = corners[[(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]]
    beside = intersections.neighbours(faces)
    assert beside[0].tolist() == [3, 2, 1]
    assert (beside >= 0).all()
    assert intersections.neighbours(faces[1:])[0].tolist() == [-1, 1, 2]


def test_against_a_slow_check():
    random = np.random.default_rng(5)
    corners = random.uniform(-1, 1, (60, 3, 3))
    beside = np.full((60, 3), -1)
    pairs = np.stack(np.triu_indices(60, 1), axis=1)
    got, rows = intersections.segments(corners, beside, pairs)
    slow = {row: s for row, pair in enumerate(pairs) if (s := _slow(*corners[pair])) is not None}
    assert len(rows) > 100 and set(rows) == set(slow)
    for row, ends in zip(rows, got, strict=True):
        want = slow[row]
        assert min(np.abs(ends - want).max(), np.abs(ends[::-1] - want).max()) < 1e-8


def _slow(one, two):
    """The common segment of two triangles: where sides of either pierce the other."""
    points = []
    for a, b in ((one, two), (two, one)):
        for k in range(3):
            p, q = a[k], a[(k + 1) % 3]
            system = np.stack((b[1] - b[0], b[2] - b[0], p - q), axis=1)
            u, v, t = np.linalg.solve(system, p - b[0])
            if u >= 0 and v >= 0 and u + v <= 1 and 0 <= t <= 1:
                points.append(p + t * (q - p))
    return np.array(points) if len(points) == 2 else None


def test_records():
    corners, beside, pairs = scene(
        moved(plate()), moved(plate(half=0.5), turned(np.pi / 2, 0, 0), (0.1, 0.2, 0.1))
    )
    made = intersections.records(corners, beside, pairs)
    assert made.shape[1] == RECORD and made.dtype == np.float32
    assert (made[:, Line.B] == made[:, Line.ONWARD]).all()
    assert np.allclose(np.abs(made[:, Line.NORMAL]), (0, 0, 1), atol=1e-6)
    assert np.allclose(np.abs(made[:, Line.OTHER_NORMAL]), (0, 1, 0), atol=1e-6)
    assert (made[:, Line.KIND] == INTERSECTION).all()
    assert not made[:, Line.REPEATS].any() and not made[:, Line.NUMBER].any()
    assert (made[:, Line.REST] == ENDLESS).all()


def test_nothing_comes_of_nothing():
    empty = np.empty((0, 3, 3))
    beside = intersections.neighbours(empty.astype(np.float32))
    pairs = intersections.trace(empty, beside, np.empty((0, 2), np.intp))
    assert intersections.records(empty, beside, pairs).shape == (0, RECORD)
