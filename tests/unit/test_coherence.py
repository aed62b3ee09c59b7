"""Patterns that follow the frame before: cases whose answer is known."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from glshim.linework import coherence
from glshim.linework.coherence import Drawn, Past, follow, kept_with, latest
from glshim.linework.pairing import paired
from glshim.linework.walk import measure
from glshim.model.camera import Camera
from glshim.styling.wishes import Pattern
from tests import look

LENGTH = 40.0
PATTERN = Pattern((LENGTH,) * 8, 1.0)
CAMERA = Camera(np.eye(4), look.orthographic(200.0), (0, 0, 400, 400))
"""A unit of eye space is a pixel of the window; (0, 0) is its middle."""
STILL = (("it", np.eye(4)),)


def keep(frame):
    return coherence.keep(frame, CAMERA)


def line(*points, z=-10.0):
    """(L, 3), (L, 3) ends of the parts of a polyline."""
    at = np.c_[np.asarray(points, float), np.full(len(points), z)]
    return at[:-1], at[1:]


def cut(points, step=7.0):
    """A polyline with all of its parts cut in pieces."""
    found = [points[0]]
    for a, b in pairwise(np.asarray(points, float)):
        count = max(int(np.ceil(np.linalg.norm(b - a) / step)), 1)
        found += [a + (b - a) * k / count for k in range(1, count + 1)]
    return line(*found)


def circle(radius, count=60, turn=0.0):
    angles = np.arange(count + 1) % count * 2 * np.pi / count + turn
    return line(*np.c_[radius * np.cos(angles), radius * np.sin(angles)])


def together(*some):
    return tuple(np.concatenate(parts) for parts in zip(*some, strict=True))


def drawn(lines, group=1, *, objects=STILL, owner=None, past=None, edge=None):
    """Lines of a frame, with the phases that follow a past."""
    a, b = lines
    groups = np.full(len(a), group) if np.isscalar(group) else np.asarray(group)
    walk = measure(a.astype(np.float32), b.astype(np.float32), groups, CAMERA, PATTERN)
    owners = np.zeros(len(a), int) if owner is None else np.asarray(owner)
    edge = np.zeros(len(a)) if edge is None else np.asarray(edge, float)
    found = Drawn(walk, a, b, groups, owners, edge, objects)
    return found if past is None else replace(found, walk=follow(found, CAMERA, past))


def shifted(frame, by):
    """The same with all phases moved on."""
    walk = replace(frame.walk, begin=frame.walk.begin + by, finish=frame.walk.finish + by)
    return replace(frame, walk=walk)


def phase_at(frame, places):
    """Repeats at places (N, 2) next to a frame's lines, modulo one."""
    a, b = frame.a[:, None, :2], frame.b[:, None, :2]
    step = b - a
    share = ((places - a) * step).sum(axis=2) / np.maximum((step**2).sum(axis=2), 1e-9)
    share = np.clip(share, 0, 1)
    which = np.linalg.norm(a + share[..., None] * step - places, axis=2).argmin(axis=0)
    share = share[which, np.arange(len(places))]
    walk = frame.walk
    return np.mod(walk.begin[which] + share * (walk.finish - walk.begin)[which], 1.0)


def apart(one, other):
    """Pixels between phases."""
    off = np.asarray(one) - np.asarray(other)
    return np.abs(off - np.rint(off)) * LENGTH


def is_whole(frame):
    """Where lines of a stroke meet, the pattern runs on."""
    walk = frame.walk
    for i in range(len(frame.a)):
        for j in range(len(frame.a)):
            if i != j and walk.stroke[i] == walk.stroke[j] and (frame.b[i] == frame.a[j]).all():
                assert apart(walk.finish[i], walk.begin[j]) < 1e-6 * LENGTH


STRAIGHT = [(-150, -20), (150, 20)]


@pytest.mark.parametrize("begin", [0.0, 0.37, -5.2])
def test_what_stands_still_stays(begin):
    before = shifted(drawn(cut(STRAIGHT)), begin)
    after = drawn(cut(STRAIGHT), past=keep(before))
    assert apart(after.walk.begin, before.walk.begin).max() < 0.2
    assert apart(after.walk.finish, before.walk.finish).max() < 0.2


def test_still_frames_do_not_drift():
    first = frame = shifted(drawn(circle(80)), 0.37)
    for _ in range(30):
        frame = drawn(circle(80), past=keep(frame))
    assert apart(frame.walk.begin, first.walk.begin).max() < 0.5


@pytest.mark.parametrize("move", [(0, 4), (3, -5), (-8, 2)])
def test_a_line_that_moves_across_keeps_the_phase_of_what_is_nearest(move):
    """Against the screen: the part along the line moves by its own length, the one across not."""
    before = shifted(drawn(cut(STRAIGHT)), 0.21)
    after = drawn(cut([np.add(p, move) for p in STRAIGHT]), past=keep(before))
    x = np.linspace(-100, 100, 30)
    places = np.c_[x, x * 20 / 150]
    assert apart(phase_at(after, places + move), phase_at(before, places + move)).max() < 1.0


@pytest.mark.parametrize("move", [(0, 60, 0), (90, 30, 0)])
def test_a_line_that_moves_with_its_object_takes_its_pattern_along(move):
    """However far: the motion is known."""
    before = shifted(drawn(cut(STRAIGHT)), 0.21)
    pose = np.eye(4)
    pose[:3, 3] = move
    after = drawn(tuple(end + move for end in cut(STRAIGHT)), objects=(("it", pose),),
                  past=keep(before))  # fmt: skip
    assert apart(after.walk.begin, before.walk.begin).max() < 0.2


def test_an_end_that_grows_leaves_the_rest_where_it_was():
    before = shifted(drawn(cut([(-100, 0), (100, 0)])), 0.4)
    after = drawn(cut([(-130, 0), (140, 0)]), past=keep(before))
    x = np.linspace(-100, 100, 40)
    places = np.c_[x, 0 * x]
    assert apart(phase_at(after, places), phase_at(before, places)).max() < 0.5
    # And there it has its own length.
    ends = phase_at(after, np.array([(-130.0, 0), (-100, 0), (100, 0), (140, 0)]))
    assert apart(ends[1] - ends[0], 30 / LENGTH) < 1.0 and apart(ends[3] - ends[2], 1.0) < 1.0


def test_a_loop_that_grows_keeps_its_phase_and_closes():
    frame = shifted(drawn(circle(80)), 0.3)
    first = phase_at(frame, np.array([(0.0, 80)]))
    for radius in np.arange(80.5, 100, 0.5):
        frame = drawn(circle(radius), past=keep(frame))
        is_whole(frame)
        repeats = (frame.walk.finish - frame.walk.begin).sum()
        assert abs(repeats - round(repeats)) < 1e-6
    assert apart(phase_at(frame, np.array([(0.0, radius)])), first) < LENGTH / 4


def test_a_stroke_that_splits_and_meets_again():
    whole = [(-140, 0), (140, 0)]
    first = frame = shifted(drawn(cut(whole)), 0.15)
    parts = together(cut([(-140, 0), (-10, 0)]), cut([(10, 0), (140, 0)]))
    x = np.r_[np.linspace(-130, -20, 20), np.linspace(20, 130, 20)]
    places = np.c_[x, 0 * x]
    for _ in range(3):
        frame = drawn(parts, past=keep(frame))
        assert len(set(frame.walk.stroke)) == 2
        assert apart(phase_at(frame, places), phase_at(first, places)).max() < 0.5
    frame = drawn(cut(whole), past=keep(frame))
    assert apart(phase_at(frame, places), phase_at(first, places)).max() < 0.5


def test_two_that_disagree_merge_gently():
    """Each keeps its own phase far from where they meet; between, the pattern is stretched over
    some length, not torn."""
    one, other = drawn(cut([(-140, 0), (-1, 0)])), shifted(drawn(cut([(1, 0), (140, 0)])), 0.45)
    parts = together((one.a, one.b), (other.a, other.b))
    walk = drawn(parts).walk
    begin, finish = (np.concatenate(p) for p in ((one.walk.begin, other.walk.begin),
                                                 (one.walk.finish, other.walk.finish)))  # fmt: skip
    before = replace(drawn(parts), walk=replace(walk, begin=begin, finish=finish))
    after = drawn(cut([(-140, 0), (140, 0)]), past=keep(before))
    far = np.array([(-120.0, 0), (-80, 0), (80, 0), (120, 0)])
    assert apart(phase_at(after, far), phase_at(before, far)).max() < 2.0
    is_whole(after)
    paces = (after.walk.finish - after.walk.begin) / np.linalg.norm(after.b - after.a, axis=1)
    assert paces.min() > 0.3 / LENGTH and paces.max() < 2.5 / LENGTH


def test_without_a_past_nothing_changes():
    frame = drawn(cut(STRAIGHT))
    assert (follow(frame, CAMERA, keep(_nothing())).begin == frame.walk.begin).all()


def _nothing():
    """A frame of an object without lines."""
    frame = drawn(line((0, 0), (1, 0)))
    none = np.zeros(0, int)
    walk = replace(frame.walk, begin=np.zeros(0), finish=np.zeros(0), stroke=none,
                   loop=np.zeros(0), places=(np.zeros(0, complex),) * 2)  # fmt: skip
    return Drawn(walk, np.zeros((0, 3)), np.zeros((0, 3)), none, none, np.zeros(0), STILL)


def test_no_lines_follow_anything():
    assert len(follow(_nothing(), CAMERA, keep(drawn(cut(STRAIGHT)))).begin) == 0


@pytest.mark.parametrize("other", ["across", "back", "far", "depth"])
def test_what_is_something_else_is_not_followed(other):
    """A line across, an outline that winds the other way, one too far off or far behind."""
    before = shifted(drawn(cut([(-100, 0), (100, 0)])), 0.4)
    lines, group = cut([(-100, 1), (100, 1)]), 1
    if other == "across":
        lines = cut([(3, -100), (3, 100)])
    elif other == "back":
        lines, group = cut([(100, 1), (-100, 1)]), 0
        before = shifted(drawn(cut([(-100, 0), (100, 0)]), group=0), 0.4)
    elif other == "far":
        lines = cut([(-100, 13), (100, 13)])
    else:
        lines = tuple(end - (0, 0, 45.0) for end in lines)
    alone = drawn(lines, group=group)
    assert (drawn(lines, group=group, past=keep(before)).walk.begin == alone.walk.begin).all()


@pytest.mark.parametrize("group", [0, 2])
def test_a_crease_that_becomes_another_line_keeps_its_pattern(group):
    before = shifted(drawn(cut(STRAIGHT)), 0.37)
    after = drawn(cut(STRAIGHT), group=group, past=keep(before))
    assert apart(after.walk.begin, before.walk.begin).max() < 0.2


def test_a_crease_whose_lines_come_the_other_way_round_keeps_its_pattern():
    """Which way a crease runs is decided by the first of its lines."""
    before = shifted(drawn(cut(STRAIGHT)), 0.37)
    a, b = cut(STRAIGHT)
    after = drawn((b, a), past=keep(before))
    assert apart(after.walk.begin, before.walk.finish).max() < 0.2
    assert (after.walk.begin > after.walk.finish).all()


def test_of_lines_that_lie_together_each_stays_itself():
    one = cut(STRAIGHT)
    count = len(one[0])
    edge = np.arange(2 * count) + 1.0
    frame = drawn(together(one, one), group=np.repeat((1, 2), count), edge=edge)
    begin = np.r_[frame.walk.begin[:count], frame.walk.begin[count:] + 0.3]
    finish = np.r_[frame.walk.finish[:count], frame.walk.finish[count:] + 0.3]
    before = replace(frame, walk=replace(frame.walk, begin=begin, finish=finish))
    after = drawn(together(one, one), group=np.repeat((1, 2), count), edge=edge, past=keep(before))
    assert apart(after.walk.begin, begin).max() < 0.2


@pytest.mark.parametrize("step", [7.0, 400.0])
def test_a_pattern_that_is_stretched_moves_with_its_object_and_then_stands_still(step):
    """A long line of one piece, too, on which the pattern goes by many times."""
    wide = np.diag((1.3, 1.0, 1.0, 1.0))
    before = shifted(drawn(cut(STRAIGHT, step)), 0.21)
    lines = cut([(-195, -20), (195, 20)], 1.3 * step)
    frame = drawn(lines, objects=(("it", wide),), past=keep(before))
    assert apart(frame.walk.begin, before.walk.begin).max() < 0.2
    assert apart(frame.walk.finish, before.walk.finish).max() < 0.2
    for _ in range(20):
        frame = drawn(lines, objects=(("it", wide),), past=keep(frame))
    assert apart(frame.walk.begin, before.walk.begin).max() < 0.5


@pytest.mark.parametrize("degrees", [8, 40])
def test_what_has_turned_too_far_begins_anew(degrees):
    angle = np.radians(degrees)
    turn = np.eye(4)
    turn[:2, :2] = (np.cos(angle), -np.sin(angle)), (np.sin(angle), np.cos(angle))
    before = shifted(drawn(cut(STRAIGHT)), 0.37)
    lines = tuple(end @ turn[:3, :3].T for end in cut(STRAIGHT))
    after = drawn(lines, objects=(("it", turn),), past=keep(before))
    assert (apart(after.walk.begin, before.walk.begin).max() < 0.5) == (degrees < 15)


@pytest.mark.parametrize("factor", [1.04, 1 / 1.04])
def test_repeats_come_by_octaves_when_the_viewer_comes_near_or_goes(factor):
    """The pattern is never much longer or shorter on the screen than it should be, and where two
    repeats took the place of one, the ends of every other one lie where they lay."""
    size = 100.0 if factor > 1.0 else 1000.0
    frame, scale, jumps = drawn(cut([(-size, 0), (size, 0)], 30.0)), 1.0, 0
    for _ in range(50):
        past, pace = keep(frame), abs(frame.walk.finish[0] - frame.walk.begin[0])
        scale *= factor
        zoom = np.diag((scale, 1.0, 1.0, 1.0))
        lines = cut([(-size * scale, 0), (size * scale, 0)], 30.0 * scale)
        before = frame.walk.begin
        frame = drawn(lines, objects=(("it", zoom),), past=past)
        repeats = abs(frame.walk.finish - frame.walk.begin).sum()
        length = 2 * size * scale / repeats
        assert LENGTH / 2.0 < length < LENGTH * 2.0
        again = abs(frame.walk.finish[0] - frame.walk.begin[0]) / pace
        if 0.9 < again < 1.1:
            assert apart(frame.walk.begin, before).max() < 0.5
        elif again > 1.0:
            jumps += 1
            assert apart(frame.walk.begin, 2 * before).max() < 0.5
        else:
            jumps += 1
            assert apart(2 * frame.walk.begin, before).max() < 1.0
    assert jumps in (2, 3)


def test_lines_that_the_near_plane_cut_off_say_nothing():
    """Their places in the window are of no use."""
    behind = tuple(end + np.array((0, 0, 60.0)) for end in cut([(-100, 3), (100, 3)]))
    lens = Camera(np.eye(4), look.perspective(60.0), (0, 0, 400, 400))
    a, b = together(tuple(0.01 * end for end in cut([(-300, 0), (300, 0)], 100.0)), behind)
    groups, zeros = np.ones(len(a), int), np.zeros(len(a))
    walk = measure(a.astype(np.float32), b.astype(np.float32), groups, lens, PATTERN)
    frame = Drawn(walk, a, b, groups, zeros.astype(int), zeros, STILL)
    past = coherence.keep(frame, lens)
    assert len(past.points) and (past.points[:, 2] < 0).all()


def test_objects_that_vanish_leave_those_that_stay_alone():
    lines = together(cut([(-100, 0), (100, 0)]), cut([(-100, 60), (100, 60)]))
    owner = np.repeat((0, 1), len(lines[0]) // 2)
    both = (("gone", np.eye(4)), ("it", np.eye(4)))
    before = shifted(drawn(lines, objects=both, owner=owner), 0.3)
    after = drawn(cut([(-100, 60), (100, 60)]), past=keep(before))
    x = np.linspace(-90, 90, 20)
    places = np.c_[x, 0 * x + 60]
    assert apart(phase_at(after, places), phase_at(before, places)).max() < 0.5
    nobody = drawn(cut([(-100, 0), (100, 0)]), objects=(), owner=None)
    assert np.isfinite(follow(nobody, CAMERA, keep(before)).begin).all()


def moved(x):
    pose = np.eye(4)
    pose[0, 3] = x
    return pose


def test_objects_are_known_by_name_and_place_whatever_their_order():
    before = (("a", moved(0)), ("b", moved(5)), ("b", moved(9)), ("c", moved(1)))
    now = (("b", moved(9.2)), ("c", moved(70)), ("b", moved(5.1)), ("a", moved(-30)))
    assert paired(before, now) == {0: 3, 1: 2, 2: 0, 3: 1}
    assert paired(before, ()) == {} and paired((), now) == {}
    # Of fewer, the nearest; what is made anew goes on from what is gone.
    assert paired(before[1:3], (("b", moved(9.5)),)) == {1: 0}
    assert paired((("old", moved(0)), ("a", moved(2))), (("a", moved(2)), ("new", moved(0)))) == {
        0: 1, 1: 0,
    }  # fmt: skip
    many = tuple(("a", moved(k)) for k in range(300))
    assert paired(many, many) == {k: k for k in range(300)}
    broken = (("a", np.full((4, 4), np.nan)), ("a", moved(1)))
    assert paired(broken, (("a", moved(1)), ("a", moved(2))))[1] == 0


def test_an_order_of_drawing_that_changes_leaves_patterns_where_they_were():
    low, high = cut([(-100, 0), (100, 0)]), cut([(-100, 60), (100, 60)])
    poses = (moved(0.0), moved(3.0))
    frame = shifted(drawn(together(low, high), owner=np.repeat((0, 1), len(low[0])),
                          objects=(("it", poses[0]), ("it", poses[1]))), 0.3)  # fmt: skip
    after = drawn(together(high, low), owner=np.repeat((0, 1), len(low[0])),
                  objects=(("it", poses[1]), ("it", poses[0])), past=keep(frame))  # fmt: skip
    x = np.linspace(-90, 90, 20)
    for y in (0, 60):
        places = np.c_[x, 0 * x + y]
        assert apart(phase_at(after, places), phase_at(frame, places)).max() < 0.5


def past_of(*names) -> Past:
    return keep(drawn(cut(STRAIGHT), objects=tuple((name, np.eye(4)) for name in names)))


def test_layers_in_one_viewport_keep_their_own_past():
    scene, overlay = past_of("ground", "house"), past_of("compass")
    pasts = kept_with(overlay, (scene,), latest((scene,), ["compass"]))
    assert pasts == (overlay, scene)
    assert latest(pasts, ["house"]) is scene and latest(pasts, ["compass"]) is overlay
    again = past_of("house")
    pasts = kept_with(again, pasts, latest(pasts, ["house"]))
    assert pasts == (again, overlay)
    assert latest((), ["x"]) is None
    for k in range(10):  # a surface made anew each frame goes on from the latest
        assert latest(pasts, [k]) is pasts[0]
        pasts = kept_with(past_of(k), pasts, pasts[0])
    assert len(pasts) <= 4


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e30, -1e9])
def test_huge_and_broken_coordinates_harm_nobody_else(value):
    good = cut([(-100, 0), (100, 0)])
    # Records hold finite numbers only (tests/unit/test_feature_lines.py).
    bad = line((-100, 30), (100, value if np.isfinite(value) else 3e38))
    frames = [drawn(together(good, bad)), drawn(together(good, bad))]
    before = shifted(frames[0], 0.3)
    with np.errstate(all="ignore"):
        walk = follow(frames[1], CAMERA, keep(before))
    n = len(good[0])
    assert apart(walk.begin[:n], before.walk.begin[:n]).max() < 0.5
    pose = np.full((4, 4), value)
    lost = keep(drawn(good, objects=(("it", pose),)))
    with np.errstate(all="ignore"):
        assert np.isfinite(follow(drawn(good), CAMERA, lost).begin).all()


def test_the_result_is_deterministic_and_does_not_hang_on_the_order_of_lines():
    lines = together(circle(90), cut([(-150, -150), (0, 0), (150, -150)]))
    before = shifted(drawn(lines), 0.3)
    moved_on = tuple(end + np.array((2.0, 1.0, 0.0)) for end in lines)
    one, other = (drawn(moved_on, past=keep(before)) for _ in range(2))
    assert (one.walk.begin == other.walk.begin).all()
    order = np.random.default_rng(4).permutation(len(lines[0]))
    mixed = drawn(tuple(end[order] for end in moved_on), past=keep(before))
    assert apart(mixed.walk.begin, one.walk.begin[order]).max() < 0.1
    is_whole(one)


def test_lines_that_recede_stay_where_they_are():
    """In perspective a line's middle is not the middle of its picture."""
    lens = Camera(np.eye(4), look.perspective(60.0), (0, 0, 400, 400))
    a, b = np.array([[-1.0, -1, -2], [-1, 0.5, -1.2]]), np.array([[3.0, 1, -30], [2, 1, -9]])
    groups, owner = np.ones(2, int), np.zeros(2, int)
    walk = measure(a.astype(np.float32), b.astype(np.float32), groups, lens, PATTERN)
    first = frame = shifted(Drawn(walk, a, b, groups, owner, np.zeros(len(a)), STILL), 0.3)
    for _ in range(10):
        past = coherence.keep(frame, lens)
        frame = Drawn(walk, a, b, groups, owner, np.zeros(len(a)), STILL)
        frame = replace(frame, walk=follow(frame, lens, past))
    assert apart(frame.walk.begin, first.walk.begin).max() < 1e-3
    assert apart(frame.walk.finish, first.walk.finish).max() < 1e-3
