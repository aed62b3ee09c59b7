"""Which lines join end to end, and the polylines that they make for outputs."""

from __future__ import annotations

import numpy as np
import pytest
from glshim_stylers.raskar import Raskar

from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.window import window
from glshim.linework.chains import chained
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.linework.finder import LineFinder
from glshim.linework.groups import grouped
from glshim.model.camera import Camera
from glshim.model.lines import CONTOUR, GROUPS, RECORD, RIDGE, VALLEY, Line, group_of, no_lines
from glshim.styling.lines import Lines, Medium
from glshim.styling.values import Layer
from glshim.styling.wishes import Features
from tests import look

SIZE = (0, 0, 400, 400)
FLAT = Camera(np.eye(4), look.orthographic(2.0), SIZE)
"""100 pixels a unit."""
ALL = Features(contours=True, ridge_angle=np.radians(120), valley_angle=np.radians(240))


def sides(points, *, closed=False, kind=RIDGE, z=-5.0):
    """Records of the sides of a polyline."""
    points = np.c_[np.asarray(points, float), np.full(len(points), z)]
    a, b = (points, np.roll(points, -1, 0)) if closed else (points[:-1], points[1:])
    records = np.zeros((len(a), RECORD), np.float32)
    records[:, Line.A], records[:, Line.B], records[:, Line.KIND] = a, b, kind
    return records


def mixed(records, seed, *, turn=True):
    """In another order, and some the other way round."""
    random = np.random.default_rng(seed)
    records = records[random.permutation(len(records))]
    if turn:
        back = random.random(len(records)) < 0.5
        records[back] = np.c_[records[back, Line.B], records[back, Line.A], records[back, 6:]]
    return records


def circle(count):
    angle = 2 * np.pi * np.arange(count) / count
    return np.c_[np.cos(angle), np.sin(angle)]


def joined(records, chains):
    """Asserts that each line is in one chain and each goes on where the one before it ends."""
    assert sorted(chains.lines.tolist()) == list(range(len(records)))
    assert chains.starts[-1] == len(records) and (np.diff(chains.starts) > 0).all()
    assert len(chains.closed) == len(chains.group) == len(chains.starts) - 1
    begin, end = ends_of(records, chains)
    for first, stop, loop, group in zip(
        chains.starts[:-1], chains.starts[1:], chains.closed, chains.group, strict=True
    ):
        assert np.allclose(end[first : stop - 1], begin[first + 1 : stop], atol=1e-5)
        if loop:
            assert np.allclose(end[stop - 1], begin[first], atol=1e-5)
        assert (group_of(records[chains.lines[first:stop]]) == group).all()


def ends_of(records, chains):
    some, forward = records[chains.lines], chains.forward[:, None]
    a, b = some[:, Line.A], some[:, Line.B]
    return np.where(forward, a, b), np.where(forward, b, a)


def parts(lines):
    """The points of each polyline."""
    return np.split(lines.points, lines.starts[1:-1])


@pytest.mark.parametrize("seed", range(6))
def test_an_open_polyline_is_one_chain(seed):
    points = [(-1.5, 0), (-1.0, 0), (-0.5, 0.5), (0.5, 0.5), (0.9, 0.2), (1.5, -0.3)]
    records = mixed(sides(points), seed)
    chains = chained(records)
    joined(records, chains)
    assert len(chains) == 1 and not chains.closed[0] and chains.group.tolist() == [1]
    (found,) = parts(chains.in_eye_space(records))
    wanted = np.c_[points, np.full(len(points), -5.0)]
    assert np.allclose(found, wanted) or np.allclose(found, wanted[::-1])


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kind", [CONTOUR, RIDGE])
def test_a_loop_is_one_closed_chain(seed, kind):
    records = mixed(sides(circle(24), closed=True, kind=kind), seed, turn=kind == RIDGE)
    chains = chained(records)
    joined(records, chains)
    assert chains.closed.tolist() == [True]
    lines = chains.in_window(records, FLAT)
    assert len(lines) == 1 and lines.closed[0] and len(lines.points) == 24
    assert np.allclose(np.hypot(*(lines.points[:, :2] - 200).T), 100, atol=1e-3)
    steps = np.diff(np.unwrap(np.arctan2(*(lines.points[:, 1::-1] - 200).T)))
    assert np.allclose(np.abs(steps), 2 * np.pi / 24, atol=1e-4) and len(set(np.sign(steps))) == 1
    assert kind == RIDGE or (chains.forward.all() and steps[0] > 0)


def test_silhouettes_run_as_they_wind_and_never_against_each_other():
    one, other = sides([(-1, 0), (0, 0)], kind=CONTOUR), sides([(1, 0), (0, 0)], kind=CONTOUR)
    assert len(chained(np.concatenate((one, other)))) == 2
    one[:, Line.KIND] = other[:, Line.KIND] = RIDGE
    assert len(chained(np.concatenate((one, other)))) == 1


@pytest.mark.parametrize("seed", range(4))
def test_at_a_branch_the_straightest_go_on(seed):
    """A T: the bar is one chain, the stem another."""
    bar, stem = sides([(-1, 0), (0, 0), (1, 0.1)]), sides([(0, 0), (0, -1)])
    records = mixed(np.concatenate((bar, stem)), seed)
    chains = chained(records)
    joined(records, chains)
    assert sorted(np.diff(chains.starts)) == [1, 2]
    lengths = {len(part): part for part in parts(chains.in_eye_space(records))}
    assert lengths[2][:, 1].min() == -1.0 and abs(lengths[3][:, 0]).max() == 1.0


def test_creases_are_not_joined_around_a_sharp_corner():
    assert len(chained(sides([(-1, 0), (0, 0), (0.5, 1)]))) == 1
    assert len(chained(sides([(-1, 0), (0, 0), (0, 1)]))) == 2


def test_lines_of_unlike_groups_are_never_joined():
    points = [(-1, 0), (0, 0), (1, 0)]
    records = sides(points)
    records[1, Line.KIND] = VALLEY
    chains = chained(records)
    joined(records, chains)
    assert chains.group.tolist() == [1, 2] and not chains.closed.any()


def test_no_lines_are_no_chains():
    chains = chained(no_lines())
    for lines in (chains.in_eye_space(no_lines()), chains.in_window(no_lines(), FLAT)):
        assert len(chains) == len(lines) == 0
        assert lines.points.shape == (0, 3) and lines.starts.tolist() == [0]


def records_of(make, camera, wanted=ALL):
    return feature_lines([(EdgeLines(mesh(make())), camera.modelview)], camera, wanted)[0]


def test_the_outline_of_a_cube_is_one_loop_of_six_and_the_ridges_within_it_three():
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), SIZE)
    records = records_of(look.cube, camera)
    chains = chained(records)
    joined(records, chains)
    outline = chains.group == 0
    assert np.diff(chains.starts)[outline].tolist() == [6] and chains.closed[outline].all()
    ridges = chains.group == 1
    assert np.diff(chains.starts)[ridges].sum() == 3 + 3  # hidden ones, too
    lines = chains.in_window(records, camera)
    (loop,) = (part for part, closed in zip(parts(lines), lines.closed, strict=True) if closed)
    corners = window(look.cube().positions @ camera.modelview[:3, :3].T.astype(np.float64)
                     + camera.modelview[:3, 3], camera)  # fmt: skip
    nearest = np.abs(loop[:, None] - corners).max(axis=2).min(axis=1)
    assert nearest.max() < 1e-2


@pytest.mark.parametrize("make", [look.torus, look.cylinder, look.bowl])
def test_chains_of_meshes_join_whatever_the_viewer(make):
    for direction in look.directions(6):
        camera = Camera(look.look_at(5 * direction), look.perspective(), SIZE)
        records = records_of(make, camera)
        chains = chained(records)
        joined(records, chains)
        assert len(chains) < len(records) / 3
        lines = chains.in_window(records, camera)
        assert np.isfinite(lines.points).all() and (lines.group < GROUPS).all()
        open_points = len(records) + int((~lines.closed).sum())
        assert len(lines.points) == open_points  # nothing is cut


def test_a_loop_through_the_near_plane_is_cut_open():
    """A square around the viewer's feet: what lies behind the viewer is cut off, and what is left
    goes on through the corner at which the loop was begun."""
    camera = Camera(np.eye(4), look.perspective(), SIZE)
    square = np.array([(1.0, -1, -4), (1, -1, 4), (-1, -1, 4), (-1, -1, -4)])
    for shift in range(4):
        corners = np.roll(square, shift, axis=0)
        records = sides(corners[:, :2], closed=True, kind=CONTOUR)
        records[:, Line.A], records[:, Line.B] = corners, np.roll(corners, -1, axis=0)
        chains = chained(records)
        assert chains.closed.tolist() == [True]
        lines = chains.in_window(records, camera)
        assert lines.closed.tolist() == [False] and len(lines.points) == 4
        assert len(set(lines.lines.tolist())) == 3


def test_clip_planes_break_a_chain_into_polylines():
    camera = Camera(np.eye(4), look.orthographic(2.0), SIZE, clip_planes=((0, 1.0, 0, 0),))
    records = sides([(-1, 1), (-0.5, -1), (0, 1), (0.5, -1), (1, 1)], kind=CONTOUR)
    lines = chained(records).in_window(records, camera)
    assert np.diff(lines.starts).tolist() == [2, 3, 2] and not lines.closed.any()
    assert lines.points[:, 1].min() == pytest.approx(200.0)


@pytest.mark.parametrize("style", [Raskar(), None])
def test_what_a_styler_gives_becomes_polylines_without_an_output(style):
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), SIZE)
    layer = Layer(((look.cube(), camera), (look.torus(), camera.under(np.eye(4)))))
    given = (
        list(style.draws(layer)) if style
        else [Lines(layer.bodies, ALL, Medium(next(iter(Raskar().draws(layer))).medium.shader))]
    )  # fmt: skip
    finder, count = LineFinder(1 << 20), 0
    for group in grouped(given):
        records = finder.records(group)
        lines = chained(records).in_window(records, group.camera)
        count += len(lines)
        assert set(lines.group) <= set(group_of(records))
    assert count > 4
