"""The truth of the picture score on shapes whose lines can be counted by hand."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.model.camera import Camera
from tests import look
from tests.score import ink, meshes, sight, truth

ABOVE = (3.0, 2.0, 2.5)


def camera(eye=ABOVE, parallel=True, up=(0.1, 0.2, 1)) -> Camera:
    projection = look.orthographic(2.0) if parallel else look.perspective()
    return Camera(look.look_at(eye, up=up), projection, (0, 0, 200, 200))


def lines(batch, view) -> dict[str, truth.Lines]:
    return truth.lines(truth.body(batch), view, ridge_angle=120.0, valley_angle=240.0)


def seen(batch, view, kind) -> np.ndarray:
    """(N, 3) places of a kind that are surely seen."""
    mesh = truth.body(batch)
    found = sight.places(sight.Scene(mesh, view), truth.lines(mesh, view, 120.0, 240.0)[kind])
    return found.points[found.sight == sight.SURE]


@pytest.mark.parametrize("parallel", [True, False])
def test_a_cube_has_six_silhouettes_and_three_ridges_in_sight(parallel):
    view = camera(parallel=parallel)
    found = lines(look.cube(), view)
    counts = {kind: len(some.ends) for kind, some in found.items()}
    # Seen from inside, the three edges behind are hollow. They are hidden.
    assert counts == {"silhouettes": 6, "ridges": 3, "valleys": 3, "intersections": 0}
    scene = sight.Scene(truth.body(look.cube()), view)
    for kind, expected in (("silhouettes", sight.SURE), ("ridges", sight.SURE),
                           ("valleys", sight.HIDDEN)):  # fmt: skip
        places = sight.places(scene, found[kind])
        lengths = np.linalg.norm(np.diff(found[kind].ends[:, :, :2], axis=1)[:, 0], axis=1)
        total = places.length[places.sight == expected].sum()
        assert total == pytest.approx(lengths.sum(), rel=0.05)


def test_two_crossing_squares_meet_in_one_known_segment():
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    upright = [(0.1, -0.5, -1), (0.1, 0.7, -1), (0.1, 0.7, 1), (0.1, -0.5, 1)]
    batch = look.batch(points + upright, [[0, 1, 2, 3], [4, 5, 6, 7]])
    mesh = truth.body(batch)
    ends = np.sort(mesh.crossed.reshape(-1, 3), axis=0)
    assert np.allclose(ends[[0, -1]], [(0.1, -0.5, 0), (0.1, 0.7, 0)], atol=1e-6)
    length = np.linalg.norm(mesh.crossed[:, 1] - mesh.crossed[:, 0], axis=1).sum()
    assert length == pytest.approx(1.2, abs=1e-6)  # no part of it twice
    assert len(seen(batch, camera(), "intersections")) > 50


@pytest.mark.parametrize(
    "lower", [[(0, -1, 0), (0, 1, 0), (0, 1, -1)], [(0, -1, 0.01), (0, 1, 0.01), (0, 1, 1)]]
)
def test_touching_and_missing_are_not_crossing(lower):
    floor = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    batch = look.batch(floor + lower, [[0, 1, 2, 3], [4, 5, 6]])
    assert not len(truth.body(batch).crossed)


@pytest.mark.parametrize(("slope", "kind"), [(1.0, "valleys"), (-1.0, "ridges"), (0.3, None)])
def test_a_folded_sheet_is_a_valley_from_inside_and_a_ridge_from_behind(slope, kind):
    points = [(-1, -1, slope), (0, -1, 0), (1, -1, slope), (1, 1, slope), (0, 1, 0), (-1, 1, slope)]
    sheet = look.batch(points, [[0, 1, 4, 5], [1, 2, 3, 4]])
    other = {"valleys": "ridges", "ridges": "valleys", None: None}[kind]
    for eye, expected in (((0.3, 0.2, 5), kind), ((0.3, 0.2, -5), other)):
        view = camera(eye, up=(0, 1, 0))
        folds = {k for k in ("ridges", "valleys") if len(seen(sheet, view, k))}
        assert folds == ({expected} if expected else set())
        assert len(lines(sheet, view)["silhouettes"].ends) == 6  # its open sides


def test_a_screen_hides_what_is_behind_and_leaves_its_rim_undecided():
    """A short fold seen from above, half of it under a square: hidden, undecided, seen."""
    roof = [(-1, -1, -0.7), (0, -1, 0), (1, -1, -0.7), (1, 1, -0.7), (0, 1, 0), (-1, 1, -0.7)]
    square = [(-0.5, 0, 1), (0.5, 0, 1), (0.5, 2, 1), (-0.5, 2, 1)]
    batch = look.batch(roof + square, [[0, 1, 4, 5], [1, 2, 3, 4], [6, 7, 8, 9]])
    view = camera((0, 0, 5), up=(0, 1, 0))
    mesh = truth.body(batch)
    places = sight.places(sight.Scene(mesh, view), lines(batch, view)["ridges"])
    y = (places.points[:, 1] - 100) / 50  # 200 pixels are 4 units
    assert (places.sight[y > 0.03] == sight.HIDDEN).all()
    assert (places.sight[y < -0.03] == sight.SURE).all()
    assert {sight.BESIDE, sight.UNSURE} == set(places.sight[np.abs(y) < 0.02 / 2].tolist())


def test_corners_are_welded_by_nearness():
    points = np.array([(0, 0, 0), (1, 0, 0), (1 + 5e-7, 0, 0), (0.5, 0, 0), (0.49999, 0, 0)])
    name = truth.weld(points)
    assert name[1] == name[2]
    assert len(set(name.tolist())) == 4


@pytest.mark.parametrize("name", ["gear", "part", "scan"])
def test_the_scored_solids_are_closed_and_wound_outwards(name):
    mesh = truth.body(meshes.MESHES[name]())
    corners = mesh.points[mesh.triangles]
    assert np.einsum("ti,ti->t", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() > 0
    sides = {tuple(side) for side in mesh.sides.tolist()}
    assert len(sides) == len(mesh.sides)
    assert all((b, a) in sides for a, b in sides)


def test_judging_ink():
    """A line of ink: right, missed, stray, and a dot; short true lines may be dots."""
    drawn = np.zeros((60, 60), bool)
    drawn[30, 10:40] = True
    x = np.arange(10.25, 50, 0.5)
    points = np.stack([x, np.full_like(x, 30.5), np.zeros_like(x)], axis=1)
    places = sight.Places(points, np.full(len(x), sight.SURE), np.full(len(x), 0.5))
    verdict = ink.judge(drawn, [(places, 2.0)])
    assert (verdict.precision, verdict.dots) == (1.0, [])
    assert verdict.recall == pytest.approx((42.5 - 10) / 40, abs=0.02)
    drawn[40:42, 20] = True
    verdict = ink.judge(drawn, [(places, 2.0)])
    assert verdict.ink - verdict.right == 2
    assert verdict.dots == [(20, 40)]
    short = sight.Places(np.array([(20.5, 40.5, 0.0)]), np.array([sight.SURE]), np.array([0.5]))
    assert ink.judge(drawn, [(places, 2.0), (short, 2.0)]).dots == []
    drawn[58:, 50] = True  # cut by the border
    assert ink.judge(drawn, [(places, 2.0), (short, 2.0)]).dots == []


def test_components_are_eight_connected():
    mask = np.array([[1, 0, 0, 1], [0, 1, 0, 1], [1, 0, 0, 0]], bool)
    label = ink.components(mask)
    assert len(np.unique(label[mask])) == 2
    assert label[0, 0] == label[1, 1] == label[2, 0] != label[0, 3] == label[1, 3]
