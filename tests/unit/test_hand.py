"""Where a hand lifts the pen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.recovery.mesh import mesh
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.linework.hand import begun_anywhere, lifts
from glshim.linework.walk import measure
from glshim.model.camera import Camera
from glshim.model.lines import ENDLESS, RECORD, Line, group_of
from glshim.styling.wishes import Features, Pattern
from tests import look
from tests.unit.test_walk import FLAT, circle, polyline

CORNER = np.radians(40.0)
WHOLE = Pattern((100.0,) * 8, 0.0, CORNER)
OUTLINE, CREASE = 0, 1


def walked(a, b, group=OUTLINE, camera=FLAT, length=100.0):
    """A unit of the plane is 100 pixels."""
    return measure(a, b, np.full(len(a), group), camera, Pattern((length,) * 8))


def drawn(a, b, group=OUTLINE, camera=FLAT):
    """Pixels of its stroke before each line, of the line, and after it."""
    before, after = lifts(walked(a, b, group, camera), CORNER)
    return before, 100.0 * np.hypot(*(b - a)[:, :2].T), after


SQUARE = ((-1, -1), (1, -1), (1, 1), (-1, 1))


@pytest.mark.parametrize("group", [OUTLINE, CREASE])
@pytest.mark.parametrize("shuffle", [None, 0, 1])
def test_the_sides_of_a_square_are_a_stroke_each(group, shuffle):
    before, size, after = drawn(*polyline(SQUARE, closed=True, shuffle=shuffle), group)
    assert size == pytest.approx(200.0)
    assert before == pytest.approx(0.0, abs=1e-3)
    assert after == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize("group", [OUTLINE, CREASE])
def test_sides_of_many_lines_are_a_stroke_each(group):
    points = np.concatenate(
        [
            np.linspace(one, other, 8, endpoint=False)
            for one, other in zip(SQUARE, SQUARE[1:] + SQUARE[:1], strict=True)
        ]
    )
    before, size, after = drawn(*polyline(points, closed=True, shuffle=3), group)
    assert before + size + after == pytest.approx(200.0, abs=1e-3)
    assert sorted(before.round(2)) == pytest.approx(sorted(4 * [25.0 * k for k in range(8)]))


@pytest.mark.parametrize("group", [OUTLINE, CREASE])
@pytest.mark.parametrize("count", [12, 40, 400])
def test_a_circle_is_drawn_in_one_go_without_an_end(group, count):
    before, _, after = drawn(*polyline(circle(count), closed=True, shuffle=5), group)
    assert (before >= ENDLESS).all() and (after >= ENDLESS).all()


def test_contours_that_zigzag_from_edge_to_edge_are_no_corners():
    """As on a fine mesh: steps of two pixels, at right angles."""
    steps = np.tile([[0.02, 0.0], [0.0, 0.02]], (60, 1))
    points = np.cumsum(steps, axis=0) - 1.0
    before, size, after = drawn(*polyline(points, closed=False, shuffle=1))
    assert before + size + after == pytest.approx(size.sum(), rel=1e-6)


def test_a_corner_that_is_rounded_by_a_fine_mesh_lifts_the_pen_once():
    bend = 0.03 * np.exp(1j * np.linspace(-np.pi / 2, 0.0, 6))  # a quarter of a circle, 3 pixels
    points = np.concatenate([[-1.0 - 0.03j], bend, [0.03 + 1.0j]])
    before, size, after = drawn(*polyline(np.c_[points.real, points.imag], closed=False))
    lengths = np.unique((before + size + after).round(3))
    assert len(lengths) == 2
    assert lengths.sum() == pytest.approx(size.sum(), rel=1e-4)


def test_a_short_hook_at_the_end_of_a_chain_is_no_stroke_of_its_own():
    """Three pixels of it; of twenty a hand would make one."""
    way = np.array((np.cos(np.pi / 3), np.sin(np.pi / 3)))
    for hook, strokes in ((0.03, 1), (0.2, 2)):
        a, b = polyline([(-1, 0), (1, 0), (1, 0) + hook * way], closed=False)
        before, size, after = drawn(a, b, CREASE)
        assert len(np.unique((before + size + after).round(2))) == strokes


@pytest.mark.parametrize("group", [OUTLINE, CREASE])
def test_an_open_chain_ends_at_its_ends(group):
    points = np.c_[np.linspace(-1.5, 1.5, 31), 0.1 * np.sin(np.linspace(0, 3, 31))]
    a, b = polyline(points, closed=False, shuffle=7)
    before, size, after = drawn(a, b, group)
    assert before + size + after == pytest.approx(size.sum(), rel=1e-6)
    assert (before < 1e-3).sum() == (after < 1e-3).sum() == 1
    along = np.where(a[:, 0] < b[:, 0], before, after)
    assert np.argsort(along).tolist() == np.argsort(a[:, 0]).tolist()


def test_creases_that_run_against_each_other_are_one_stroke():
    points = np.c_[np.linspace(-1, 1, 11), np.zeros(11)]
    a, b = polyline(points, closed=False)
    a[::2], b[::2] = b[::2].copy(), a[::2].copy()
    before, size, after = drawn(a, b, CREASE)
    assert before + size + after == pytest.approx(200.0, abs=1e-3)
    left = np.where(a[:, 0] < b[:, 0], before, after) + size / 2
    assert left == pytest.approx(100.0 + 50.0 * (a + b)[:, 0], abs=1e-3)


def test_a_loop_with_one_corner_is_one_stroke_from_there_and_back():
    """A drop: a circle drawn out into a tip."""
    touching = np.arccos(0.8 / 1.5)
    angle = np.linspace(touching, 2 * np.pi - touching, 80)
    points = np.concatenate([np.c_[np.cos(angle), np.sin(angle)] * 0.8, [[1.5, 0.0]]])
    a, b = polyline(points, closed=True, shuffle=11)
    before, size, after = drawn(a, b)
    assert before + size + after == pytest.approx(size.sum(), rel=1e-6)
    at_tip = np.isclose(a[:, 0], 1.5)
    assert at_tip.sum() == 1
    assert before[at_tip] == pytest.approx(0.0, abs=1e-3)
    assert after[np.isclose(b[:, 0], 1.5)] == pytest.approx(0.0, abs=1e-3)


def test_what_the_near_plane_cuts_out_parts_a_stroke():
    """A chain that comes towards the viewer, goes behind, and returns at another place."""
    points = np.array([[-0.9, 0, -8], [-0.5, 0, -4], [-0.2, 0, 0.5], [0.2, 0, 0.5], [0.5, 0, -4],
                       [0.9, 0, -8]], np.float32)  # fmt: skip
    camera = Camera(np.eye(4), look.perspective(), (0, 0, 400, 400))
    a, b = points[:-1], points[1:]
    walk = walked(a, b, OUTLINE, camera)
    before, after = lifts(walk, CORNER)
    size = np.abs(walk.places[1] - walk.places[0])
    total = before + size + after
    assert total[0] == pytest.approx(total[1])
    assert total[3] == pytest.approx(total[4])
    assert total[0] == pytest.approx(size[:2].sum(), rel=1e-4)
    assert total[3] == pytest.approx(size[3:].sum(), rel=1e-4)


def test_lines_without_a_pattern_have_no_stroke():
    a, b = polyline(SQUARE, closed=True)
    walk = measure(a, b, np.zeros(4, int), FLAT, Pattern((0.0,) * 8))
    assert (walk.stroke == -1).all()
    before, after = lifts(walk, CORNER)
    assert not before.any() and not after.any()
    assert (begun_anywhere(walk).begin == walk.begin).all()


def test_no_lines_have_no_strokes():
    wanted = Features(contours=True, ridge_angle=2.0, valley_angle=4.0, pattern=WHOLE)
    found, past = feature_lines([], FLAT, wanted)
    assert found.shape == (0, RECORD) and past is not None


def test_strokes_begin_anywhere_in_the_pattern_and_are_as_long_as_before():
    squares = [np.asarray(SQUARE) * 0.2 + (x, y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    a, b = (np.concatenate(ends) for ends in zip(*(polyline(s, closed=True) for s in squares),
                                                strict=True))  # fmt: skip
    walk = walked(a, b)
    moved = begun_anywhere(walk)
    assert moved.finish - moved.begin == pytest.approx(walk.finish - walk.begin)
    shift = (moved.begin - walk.begin) % 1.0
    first = [shift[walk.stroke == k][0] for k in range(9)]
    assert all((np.abs(shift[walk.stroke == k] - first[k]) < 1e-9).all() for k in range(9))
    assert np.diff(np.sort(first)).min() > 0.05  # no two have the same motion


WALKS = st.integers(2, 60).flatmap(
    lambda count: st.tuples(
        st.just(count), st.integers(0, 1 << 30), st.booleans(), st.sampled_from((OUTLINE, CREASE))
    )
)


@settings(max_examples=150, deadline=None)
@given(WALKS)
def test_all_lines_of_a_piece_agree_how_long_it_is(walk):
    """Before, itself and after: the same for lines that follow each other without a lift, and one
    ends where the next begins."""
    count, seed, closed, group = walk
    chance = np.random.default_rng(seed)
    turns = chance.uniform(-1.0, 1.0, count) * chance.choice((0.2, 2.5), count)
    steps = chance.uniform(0.02, 0.3, count) * np.exp(1j * np.cumsum(turns))
    path = np.cumsum(steps)
    path = (path - path.mean()) / max(np.abs(path - path.mean()).max() / 1.6, 1.0)
    closed = closed and count > 2
    a, b = polyline(np.c_[path.real, path.imag], closed=closed, shuffle=seed % 97)
    found = walked(a, b, group)
    before, after = lifts(found, CORNER)
    size = np.abs(found.places[1] - found.places[0])
    assert (before >= -1e-6).all() and (after >= -1e-6).all()
    assert np.isfinite(before).all() and np.isfinite(after).all()
    whole = (before >= ENDLESS) | (after >= ENDLESS)
    total = before + size + after
    assert (total[~whole] <= size.sum() + 1e-3).all()
    # Lengths of pieces add up to the length of all lines: each line counts with its share.
    pieces = np.sum(size[~whole] / total[~whole])
    assert pieces == pytest.approx(round(pieces), abs=1e-4)
    # Every piece has one beginning and one end, whichever way its lines run.
    ends = np.sum(before[~whole] < 1e-6) + np.sum(after[~whole] < 1e-6)
    assert ends == 2 * round(pieces)


@pytest.mark.parametrize("name", ["torus", "cube", "cylinder", "sphere", "bowl"])
def test_records_of_meshes_say_it(name):
    """With a corner; and not without."""
    batch = look.MESHES[name]()
    camera = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, 400, 400))
    wanted = Features(
        contours=True, ridge_angle=2.1, valley_angle=4.2, boundary=True, pattern=WHOLE
    )
    objects = [(EdgeLines(mesh(batch)), camera.modelview)]
    found, _ = feature_lines(objects, camera, wanted)
    plain, _ = feature_lines(
        objects, camera, replace(wanted, pattern=replace(wanted.pattern, corner=None))
    )
    assert found.shape == plain.shape and found.shape[1] == RECORD == 21
    assert not plain[:, Line.REST].any()
    assert (found[:, : Line.BEGIN] == plain[:, : Line.BEGIN]).all()
    assert (found[:, Line.REST] >= 0.0).all()
    assert (found[:, Line.NUMBER] >= 0.0).all() and (found[:, Line.NUMBER] < 1.0).all()
    if name == "cube":  # every edge is a stroke of its own: none runs on round a corner
        assert not found[group_of(found) > 0, 18:20].round(2).any()
    if name in ("torus", "sphere"):
        assert (found[group_of(found) == 0, 18:20] >= 50.0).mean() > 0.5


def free_ends(points, closed):
    """Ends of strokes beyond which something goes on, where only straight runs do."""
    a, b = polyline(points, closed=closed)
    walk = walked(a, b)
    before, after = lifts(walk, CORNER, straight=True)
    return int((before < 0.02).sum() + (after < 0.02).sum())


def arc(radius, turn, count):
    angles = np.linspace(0.0, turn, count)
    return radius * np.stack((np.cos(angles), np.sin(angles)), axis=1)


def test_straight_runs_go_on_beyond_their_corners():
    assert free_ends(SQUARE, closed=True) == 8
    assert free_ends(((-1, -1), (1, -1), (1, 1)), closed=False) == 4


@pytest.mark.parametrize("radius", [0.1, 0.6, 3.0])
@pytest.mark.parametrize("count", [12, 40])
def test_curves_do_not(radius, count):
    assert free_ends(arc(radius, 2.5, count), closed=False) == 0


def test_a_side_that_ends_round_goes_on_at_its_corner_alone():
    round_end = arc(0.5, 1.5, 24) + np.array((1.0, 0.0))
    points = np.concatenate((((1.5, -2.0),), round_end))
    assert free_ends(points, closed=False) == 1


def test_a_loop_that_begins_in_the_middle_of_a_curve_has_one_corner():
    """A drop: round but for its tip."""
    drop = np.concatenate((((0.0, -2.0),), arc(1.0, np.pi, 30)))
    assert free_ends(drop, closed=True) == 2
