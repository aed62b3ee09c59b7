"""Strokes of a hand, measured in pictures: they hold still or change when they shall, lie on the
object, cover as they say, and none is missing."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np
import pytest
from glshim_stylers.brush import Brush
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.pencil import Pencil
from glshim_stylers.shared.hand import Hand, strokes
from glshim_stylers.sketch import Sketch
from PIL import Image

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.media.hand import hand
from glshim.styling.protocol import Layer, Styler
from glshim.styling.textures.brushes import BRUSHES, brush
from glshim.styling.wishes import Pattern
from tests import look
from tests.coherence import patterns
from tests.golden.test_legacy import widened
from tests.sweep import some

SIZE = 400


def plain(width=2.0, **changed):
    """A hand with a medium that does as it is told."""
    return Hand(60.0, hand(width, **changed))


PLAIN = plain()
"""Lines of two pixels that do not stray, swell or overshoot."""
MOVED = plain(wobble=2.0, pressure=0.3, taper=10.0)
STYLES = (Sketch(), Brush(), Pencil())


@dataclass(frozen=True)
class Lines(Styler):
    """What a hand draws, on the app's own picture."""

    name: ClassVar[str] = "lines"
    hand: Hand = PLAIN

    def draws(self, layer):
        return strokes(self.hand, layer)


@pytest.fixture(scope="module")
def teapot():
    return look.teapot()


@pytest.fixture(scope="module")
def _window():
    with look.window(SIZE, SIZE):
        yield


@pytest.fixture
def backend(_window):
    """One that remembers no frame."""
    return Backend.attach()


def camera_at(direction, parallel=False):
    lens = look.orthographic() if parallel else look.perspective()
    return Camera(look.look_at(5.0 * np.asarray(direction, float)), lens, (0, 0, SIZE, SIZE))


VIEWS = [camera_at(way, bool(k % 2)) for k, way in enumerate(look.directions(4))]


def frame(backend, style, time, *items):
    """Picture without and with the style."""
    look.clear()
    for batch, camera in items:
        look.draw_base(batch, camera)
    before = look.pixels()
    backend.render(style.draws(Layer(tuple(items), time=time)))
    return before, look.pixels()


def by_hand(backend, hand, *items):
    """(H, W) ink of black strokes."""
    return look.ink(*frame(backend, Lines(hand), 0.0, *items))


@pytest.mark.parametrize("style", STYLES, ids=lambda style: style.name)
@pytest.mark.parametrize("name", ["cube", "torus"])
def test_a_still_scene_is_drawn_the_same_to_the_byte_at_any_time(backend, style, name):
    item = look.MESHES[name](), VIEWS[0]
    first = frame(backend, style, 0.0, item)[1]
    for time in (0.016, 0.4, 1.0, 77.7, 1e6):
        assert np.array_equal(frame(backend, style, time, item)[1], first), time


@pytest.mark.parametrize("make", some([Sketch, Brush, Pencil], 1))
def test_strokes_boil_at_their_own_rate_whatever_the_frame_rate(_window, make):
    """New ones at ticks, and at no other time; at a time the same, however many frames before."""
    style, item = make(boil=8.0), (look.torus(), VIEWS[1])
    found = {}
    for rate in (60, 24, 10):
        backend = Backend.attach()
        times = np.arange(int(rate * 0.6)) / rate
        pictures = [frame(backend, style, float(time), item)[1] for time in times]
        ticks = np.floor(times * 8.0)
        for (one, other), same in zip(
            itertools.pairwise(pictures), np.diff(ticks) == 0, strict=True
        ):
            assert np.array_equal(one, other) == same
        for tick, picture in zip(ticks, pictures, strict=True):
            assert np.array_equal(found.setdefault(tick, picture), picture), (rate, tick)
    assert len(found) == 5


@pytest.mark.parametrize("step", [1.0, 4.0])
def test_the_motion_of_a_hand_lies_on_a_turning_object_as_patterns_do(_window, teapot, step):
    """By `tests.coherence`: pixels a frame by which what repeats along strokes moves against the
    surface, for strokes that begin anywhere and end at corners, and for plain ones."""

    def moved(corner, name="coherent"):
        method = patterns.Method(teapot, name, smooth=True)
        pattern = Pattern((patterns.LENGTH,) * 8, 0.0, corner)
        method.wanted = replace(method.wanted, pattern=pattern)
        return patterns.mean_shift(method, frames=24, step=step)

    ours, plain, afresh = moved(0.7), moved(None), moved(0.7, "arc length")
    assert ours[1] < 1.15 * plain[1] + 0.05, (ours, plain)
    assert ours[1] < 0.6 * afresh[1], (ours, afresh)


@pytest.mark.parametrize("count", [2, 3, 6])
@pytest.mark.parametrize("opacity", [0.25, 0.6])
def test_strokes_over_each_other_cover_as_sheets_do(backend, count, opacity):
    """Where they coincide: 1 - (1 - a)^n, to the rounding of each sheet."""
    item = look.cube(), VIEWS[0]
    one = by_hand(backend, plain(5.0), item)
    often = replace(plain(5.0, opacity=opacity), strokes=count)
    found = by_hand(backend, often, item)
    full = one > 0.999
    assert full.sum() > 1000
    assert found[full] == pytest.approx(1.0 - (1.0 - opacity) ** count, abs=0.012)
    assert found[one == 0.0].max() == 0.0


@pytest.mark.parametrize("view", range(len(VIEWS)))
@pytest.mark.parametrize("name", [*look.MESHES, "teapot"])
def test_no_line_is_missing_and_none_is_added(backend, teapot, name, view):
    """Ink of a hand that does not move, within a pixel of that of edge_mesh, and vice versa."""
    batch = teapot if name == "teapot" else look.MESHES[name]()
    camera = replace(VIEWS[view], front_ccw=name != "teapot")
    widths = {f"{kind}_width": 2.0 for kind in ("contour", "ridge", "valley", "boundary")}
    reference = look.ink(*frame(backend, EdgeMesh(**widths), 0.0, (batch, camera)))
    mine = by_hand(backend, PLAIN, (batch, camera))
    assert (mine > 0.5).sum() > 300
    inks = mine > 0.3, reference > 0.3
    for ink, known in (inks, inks[::-1]):
        stray = ink & ~widened(known)
        # A flap of a mesh, seen edge-on, ends a pixel sooner in one of them.
        assert stray.sum() <= 0.004 * ink.sum(), (stray.sum(), ink.sum())


def test_strokes_go_on_beyond_corners_as_far_as_they_say(backend):
    """Seen along an axis a cube's outline is a square: what lies outside of it, in line with its
    sides, is overshoot."""
    camera = Camera(look.look_at((0, 0, 5), up=(0, 1, 0)), look.orthographic(), (0, 0, SIZE, SIZE))
    item = look.cube(half=1.0), camera
    none = by_hand(backend, PLAIN, item)
    corner = 100  # pixels from the rim of the window
    assert none[: corner - 3].max() == 0.0
    longest = []
    for seed in range(5):
        beyond = replace(plain(overshoot=20.0, overshoot_share=1.0), seed=seed)
        ink = by_hand(backend, beyond, item)
        assert (ink[none > 0.9] > 0.9).all()
        below = np.flatnonzero(ink[:corner].max(axis=1) > 0.3)
        beside = np.flatnonzero(ink[:, :corner].max(axis=0) > 0.3)
        for past in (below, beside):
            assert np.array_equal(past, np.arange(past[0], corner))  # in one piece
            longest.append(corner - past[0])
        # All of it is in line with the sides.
        beyond = ink[: corner - 4].max(axis=0) > 0.3
        at = np.flatnonzero(beyond)
        assert (np.minimum(abs(at + 0.5 - 100), abs(at + 0.5 - 300)) < 2.5).all()
    assert min(longest) >= 8 and max(longest) <= 33
    assert len(set(longest)) > 3  # no two alike


def test_loops_have_no_end_to_go_beyond(backend):
    """The outline of a sphere."""
    item = look.sphere(48, 24), VIEWS[1]
    still = by_hand(backend, PLAIN, item)
    assert np.array_equal(by_hand(backend, plain(overshoot=30.0, taper=40.0), item), still)


def test_a_hand_strays_by_as_much_as_it_says(backend):
    """Of a sphere's outline; and both ways."""
    item = look.sphere(96, 48), camera_at((1, 0.2, 0.3), parallel=True)
    middle = np.array((SIZE, SIZE)) / 2

    def radii(hand):
        y, x = np.nonzero(by_hand(backend, hand, item) > 0.5)
        return np.hypot(x + 0.5 - middle[0], y + 0.5 - middle[1])

    steady = radii(PLAIN)
    assert np.ptp(steady) < 4.0
    for wobble in (3.0, 8.0):
        strayed = radii(plain(wobble=wobble)) - steady.mean()
        assert 0.4 * wobble < strayed.max() < 1.3 * wobble + 2.0
        assert -0.4 * wobble > strayed.min() > -1.3 * wobble - 2.0
        assert abs(strayed.mean()) < 0.4 * wobble


def test_another_seed_is_another_hand(backend):
    item = look.torus(), VIEWS[0]
    hands = [by_hand(backend, replace(MOVED, seed=seed), item) for seed in (0, 0, 1, 2)]
    assert np.array_equal(hands[0], hands[1])
    for one, other in ((0, 2), (0, 3), (2, 3)):
        assert ((hands[one] > 0.5) != (hands[other] > 0.5)).sum() > 300


@pytest.mark.parametrize("name", BRUSHES)
def test_every_brush_leaves_ink_along_every_line(backend, name):
    """Of a cube's edges, no stretch of 40 pixels is bare, at a fine width and at a wide one."""
    item = look.cube(), VIEWS[2]
    lines = by_hand(backend, PLAIN, item) > 0.5
    for width in (3.0, 7.0, 24.0):
        style = Brush(brush=name, width=width, inner=1.0, jitter=0.0, tint=0.0, paper="#ffffff",
                      ink="#000000", opacity=1.0)  # fmt: skip
        after = frame(backend, style, 0.0, item)[1]
        dark = after.max(axis=2) < 200
        places = np.argwhere(lines)
        inked = np.argwhere(dark)
        near = [np.abs(inked - place).max(axis=1).min() for place in places[::7]]
        assert max(near) <= 20, (name, width, max(near))
        assert np.mean(near) < 3.0, (name, width)


def test_a_short_picture_repeats_more_often_than_the_motion_of_the_hand(backend, tmp_path):
    """A dash and a gap, 16 pixels together: so are they around a sphere, however it strays."""
    path = tmp_path / "dash.png"
    dash = np.full((8, 32), 255, np.uint8)
    dash[:, :16] = 0
    Image.fromarray(dash).save(path)
    camera = camera_at((1, 0.2, 0.3), parallel=True)
    for jitter in (0.0, 3.0):
        style = Brush(brush=str(path), width=4, inner=1, jitter=jitter, tint=0, paper="#ffffff",
                      ink="#000000", opacity=1)  # fmt: skip
        after = frame(backend, style, 0.0, (look.sphere(96, 48), camera))[1]
        y, x = np.mgrid[:SIZE, :SIZE] + 0.5 - SIZE / 2
        around = np.round((np.arctan2(y, x) % (2 * np.pi)) * 180 / np.pi, 6)
        ring = np.abs(np.hypot(x, y) - 120) < 10
        dark = np.bincount(around[ring].astype(int), after.max(axis=2)[ring] < 128, 360) > 2
        dashes = (dark & ~np.roll(dark, 1)).sum()
        assert abs(dashes - 2 * np.pi * 120 / 16) < 6


def test_brushes_look_unlike_each_other(backend):
    """Mean grey, and how it varies along and across a stroke, tell nine apart."""
    inks = [brush(name, 16.0)[0].pixels[..., 3] / 255.0 for name in BRUSHES]
    for i, one in enumerate(inks):
        for other in inks[:i]:
            assert np.abs(one - other).mean() > 0.1
        assert 0.15 < one.mean() < 0.97
        seam = np.abs(one[:, 0] - one[:, -1]).mean()
        assert seam <= 2.0 * np.abs(np.diff(one, axis=1)).mean() + 0.02  # it tiles
        assert one[0].mean() < 0.5 and one[-1].mean() < 0.5  # it ends at its rims
