"""How far along its stroke each line lies."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.edges.edges import edges
from glshim.geometry.edges.gather import Placement
from glshim.linework.patterns import lay_pattern
from glshim.linework.polygon_lines import polygon_lines
from glshim.linework.walk import measure
from glshim.model.camera import Camera
from glshim.model.lines import OUTLINES, Line
from glshim.styling.wishes import Choice, Pattern
from tests import look

SIZE = 400
FLAT = Camera(np.eye(4), look.orthographic(2.0), (0, 0, SIZE, SIZE))
"""100 pixels a unit."""
SILHOUETTES, RIDGES = 0, 1


def pattern(length: float, middle: float = 0.0) -> Pattern:
    return Pattern((length, length, length, length), middle)


def polyline(points, *, closed: bool, shuffle: int | None = None):
    """Sides between points of the plane at z = -5, in an order of their own."""
    points = np.c_[np.asarray(points, float), np.full(len(points), -5.0)]
    a, b = (points, np.roll(points, -1, 0)) if closed else (points[:-1], points[1:])
    order = np.arange(len(a))
    if shuffle is not None:
        np.random.default_rng(shuffle).shuffle(order)
    return a[order].astype(np.float32), b[order].astype(np.float32)


def repeats(a, b, length, *, group=SILHOUETTES, middle=0.0, camera=FLAT):
    return wrapped(measure(a, b, np.full(len(a), group), camera, pattern(length, middle)))


def wrapped(walk):
    """Repeats at both ends of lines, from the beginning of a repeat."""
    turns = np.floor(walk.begin)
    return walk.begin - turns, walk.finish - turns


def circle(count: int, radius: float = 1.0, at=(0.0, 0.0)):
    angle = 2 * np.pi * np.arange(count) / count
    return np.c_[at[0] + radius * np.cos(angle), at[1] + radius * np.sin(angle)]


def pixels(a, b):
    return np.hypot(*(b - a)[:, :2].T) * SIZE / 4


def apart(one, other):
    """Distance on a circle of one repeat."""
    return np.abs((np.asarray(one) - other + 0.5) % 1.0 - 0.5)


def joints(a, b, start, finish, tolerance=1e-5):
    """How far the pattern jumps wherever one line ends and another begins."""
    found = []
    for i in range(len(a)):
        for j in np.flatnonzero(np.abs(a - b[i]).max(axis=1) < tolerance):
            found.append(float(apart(start[j], finish[i])))
    return np.array(found)


def test_an_open_chain_counts_pixels_from_its_beginning():
    points = [(-1.5, 0), (-1.0, 0), (-0.5, 0.5), (0.5, 0.5), (0.5, -1.0)]
    a, b = polyline(points, closed=False)
    start, finish = repeats(a, b, 1000.0)
    size = pixels(a, b)
    assert np.allclose(start * 1000, np.cumsum(size) - size, atol=1e-2)
    assert np.allclose(finish * 1000, np.cumsum(size), atol=1e-2)


@pytest.mark.parametrize("seed", range(4))
def test_the_order_of_the_lines_does_not_matter(seed):
    points = np.cumsum(np.random.default_rng(7).uniform(0.01, 0.05, (60, 2)), axis=0) - 1
    sorted_, mixed = (polyline(points, closed=False, shuffle=s) for s in (None, seed))
    straight, shuffled = (repeats(*sides, 37.0)[0] for sides in (sorted_, mixed))
    by_place = np.argsort(mixed[0][:, 0])
    assert apart(straight, shuffled[by_place]).max() < 1e-3


@pytest.mark.parametrize("shape", ["square", "circle", "clockwise"])
@pytest.mark.parametrize("length", [7.0, 32.0, 333.0])
@pytest.mark.parametrize("middle", [0.0, 7.5])
def test_loops_hold_whole_repeats_and_close(shape, length, middle):
    points = {
        "square": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
        "circle": circle(50),
        "clockwise": circle(50)[::-1],
    }[shape]
    a, b = polyline(points, closed=True, shuffle=3)
    start, finish = repeats(a, b, length, middle=middle)
    assert ((start >= 0.0) & (start < 1.0)).all()
    if middle == 0.0:  # else the wedge of a corner lies between
        assert joints(a, b, start, finish).max() < 1e-3
    size = pixels(a, b).sum() + 2 * np.pi * middle * (-1 if shape == "clockwise" else 1)
    count = max(round(size / length), 1)
    assert np.allclose((finish - start) / pixels(a, b), count / size, rtol=1e-3)


def test_corners_take_an_arc_in_the_middle_of_the_stroke():
    a, b = polyline([(-1, -1), (1, -1), (1, 1), (-1, 1)], closed=True)
    middle, length = 20.0, 40.0
    start, finish = repeats(a, b, length, middle=middle)
    size = 800 + 2 * np.pi * middle
    rate = round(size / length) / size
    arc = 0.5 * np.pi * middle * rate
    assert apart(np.roll(start, -1), finish + arc).max() < 1e-4


def test_several_chains_do_not_mix():
    square, ring = circle(4, 0.5, (-1, 0)), circle(40, 0.4, (1, 0))
    one, other = polyline(square, closed=True), polyline(ring, closed=True)
    open_ = polyline([(-1.9, 1.5), (1.9, 1.5)], closed=False)
    both = [np.concatenate(part) for part in zip(one, open_, other, strict=True)]
    start, finish = repeats(*both, 10.0)
    alone = [repeats(*sides, 10.0) for sides in (one, open_, other)]
    assert apart(start, np.concatenate([s for s, _ in alone])).max() < 1e-4
    assert apart(finish, np.concatenate([f for _, f in alone])).max() < 1e-4


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("seed", range(5))
def test_creases_run_on_whichever_way_each_points(closed, seed):
    a, b = polyline(circle(40), closed=closed, shuffle=seed)
    turned = np.random.default_rng(seed).random(len(a)) < 0.5
    a[turned], b[turned] = b[turned].copy(), a[turned].copy()
    start, finish = repeats(a, b, 23.0, group=RIDGES)
    u = np.where(turned, finish, start), np.where(turned, start, finish)
    ways = np.sign(u[1] - u[0])
    assert (ways == ways[0]).all(), "one direction all along"
    ends = np.where(turned[:, None], b, a), np.where(turned[:, None], a, b)
    assert joints(*ends, *u).max() < 1e-3


def test_creases_break_at_sharp_corners_and_go_straight_over_a_crossing():
    spokes = [((-1, 0), (0, 0)), ((0, 0), (1, 0)), ((0, -1), (0, 0)), ((0, 1), (0, 0))]
    ends = np.array([[(*p, -5.0) for p in spoke] for spoke in spokes], np.float32)
    start, finish = repeats(ends[:, 0], ends[:, 1], 33.0, group=RIDGES)
    assert apart(finish[0], start[1]) < 1e-4
    assert apart(finish[2], finish[3]) < 1e-4
    assert np.sign(finish[2] - start[2]) != np.sign(finish[3] - start[3])


def test_a_length_of_nothing_means_no_pattern():
    a, b = polyline(circle(9), closed=True)
    start, finish = wrapped(
        measure(a, b, np.zeros(9, int), FLAT, Pattern((0.0, 9.0, 9.0, 9.0)))
    )
    assert not start.any() and not finish.any()


def test_what_lies_before_the_near_plane_is_not_counted():
    camera = Camera(np.eye(4), look.perspective(90, near=1.0), (0, 0, SIZE, SIZE))
    a = np.array([(0.5, 0, -2.0), (0.5, 0, 4.0)], np.float32)
    b = np.array([(0.5, 0, 4.0), (0.5, 0, 8.0)], np.float32)
    start, finish = repeats(a, b, 1000.0, camera=camera)
    assert np.allclose(1000 * (finish - start), [50.0, 0.0], atol=1e-3)  # x / -z: 0.25 to 0.5


def test_a_loop_begins_where_it_is_highest_wherever_its_first_side_lies():
    """However a circle is cut into sides, the pattern lies on it in the same way."""
    found = []
    for turn in np.linspace(0, 0.2, 9):
        angle = 2 * np.pi * (np.arange(40) / 40 + turn)
        a, b = polyline(np.c_[np.cos(angle), np.sin(angle)], closed=True, shuffle=int(turn * 40))
        start, _ = repeats(a, b, 20.0)
        place = np.arctan2(a[:, 1], a[:, 0]) / (2 * np.pi) * 31
        found.append(start - place)
    offsets = np.concatenate(found)
    assert apart(offsets, offsets[0]).max() < 0.01


@pytest.mark.parametrize("name", ["torus", "sphere", "cylinder"])
def test_outlines_of_a_closed_mesh_are_loops_without_a_jump(name):
    mesh = edges(look.MESHES[name]())
    for direction in look.directions(6):
        camera = Camera(look.look_at(5 * direction), look.perspective(), (0, 0, SIZE, SIZE))
        choice = Choice(silhouettes=True)
        parts = [(mesh, Placement.one(camera.modelview, len(mesh.planes)))]
        found = polygon_lines(parts, camera, choice)
        one = (("it", camera.modelview),)
        lay_pattern(found, np.zeros(len(found), int), one, camera, pattern(12.0))
        found = found[np.isin(found[:, Line.KIND], OUTLINES)]
        columns = (Line.A, Line.B, Line.BEGIN, Line.FINISH)
        jumps = joints(*(found[:, column] for column in columns))
        assert len(jumps) >= len(found)
        assert (jumps > 0.01).mean() < 0.02


def test_without_a_pattern_nothing_is_measured():
    mesh = edges(look.torus())
    camera = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, SIZE, SIZE))
    found = polygon_lines(
        [(mesh, Placement.one(camera.modelview, len(mesh.planes)))], camera,
        Choice(silhouettes=True, ridge_angle=2.0),
    )
    assert not found[:, Line.REPEATS].any() and not found[:, Line.REST].any()
