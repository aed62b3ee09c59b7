"""`tests.coherence` tells what moves with the surfaces from what does not."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.styling.texts import parse_style
from tests import look
from tests.coherence import pixels, strokes
from tests.coherence.carry import Carrier, clear, draw_base
from tests.coherence.motions import MOTIONS
from tests.coherence.report import Studio
from tests.coherence.subjects import HEIGHT, WIDTH, colours, solids

FRAMES = solids()
SHADES = colours(FRAMES[0])


@pytest.fixture(scope="module")
def carrier():
    with look.window(WIDTH, HEIGHT):
        yield Carrier(WIDTH, HEIGHT)


def shown(frame):
    clear(0.8)
    draw_base(frame, SHADES, "app")
    return look.pixels(WIDTH, HEIGHT), look.depths(WIDTH, HEIGHT)


@pytest.fixture(scope="module", params=["turn", "apart"])
def pair(request, carrier):
    """Two frames of a motion: pictures, depths, and where the first one's pixels go."""
    one, other = (MOTIONS[request.param](FRAMES, k) for k in (0, 1))
    (a, near), (b, depth) = shown(one), shown(other)
    return a, b, (near, depth), carrier.motion(one, other, depth), request.param


def test_paint_on_surfaces_is_carried_along(pair):
    a, b, depths, motion, name = pair
    assert motion.seen.mean() > 0.3
    assert pixels.flicker((a, b), motion, depths) < 0.3
    assert pixels.flicker((a, np.roll(b, 9, (0, 1))), motion, depths) > 1.0, name


def test_a_pattern_on_the_screen_drifts_as_far_as_surfaces_move(pair):
    a, b, _, motion, name = pair
    noise = np.kron(np.random.default_rng(3).uniform(0, 60, (HEIGHT // 4, WIDTH // 4)),
                    np.ones((4, 4)))[..., None]  # fmt: skip
    step = motion.there - np.indices(motion.body.shape)[::-1].transpose(1, 2, 0) - 0.5
    moved = np.hypot(*step[motion.seen].T)
    still = pixels.Drift()
    still.add(a + noise, b + noise, a, motion)
    assert still.mean == pytest.approx(moved.mean(), abs=0.9), name
    warped = pixels._sampled(noise[..., 0], motion)[0]
    held = pixels.Drift()
    held.add(a + warped[..., None], b + noise, a, motion)
    assert held.mean < 0.3


def test_a_line_that_goes_is_told_and_one_that_is_carried_is_not(pair):
    _, _, (near, _), motion, _ = pair
    lines = np.zeros((HEIGHT, WIDTH), np.bool_)
    lines[HEIGHT // 2 : HEIGHT // 2 + 2, 100:300] = True
    then = np.zeros_like(lines)
    kept = lines & motion.seen
    x, y = (motion.there[kept][:, k].astype(int) for k in (0, 1))
    then[y, x] = True
    missed, told = pixels.lost(kept, then, motion, near)
    assert told > 80
    assert missed == 0
    then[:, 200:] = False
    missed, told = pixels.lost(kept, then, motion, near)
    assert 0.25 * told < missed < 0.75 * told


@pytest.mark.parametrize("text", ["brush", "pencil", "watercolour"])
def test_patterns_of_surfaces_lie_on_the_object(carrier, text):
    """They stay within a third of the pixels by which surfaces move; where nothing is known of
    these, as before, they stand still on the screen."""
    style = parse_style(text)
    one, other = (MOTIONS["pan"](FRAMES, k) for k in (0, 1))
    found = []
    for holds in (True, False):
        studio = Studio(style, FRAMES)
        pictures = [studio.surfaces(frame, holds=holds) for frame in (one, other)]
        drift = pixels.Drift()
        depth = look.depths(WIDTH, HEIGHT)
        drift.add(*pictures, shown(one)[0], carrier.motion(one, other, depth))
        found.append(drift.mean)
    held, still = found
    assert still > 1.9
    assert held < 0.9


@pytest.mark.parametrize("motion", ["turn", "pan"])
@pytest.mark.parametrize("text", ["sketch", "raskar:dash=16", "two_pass:dash=16"])
def test_patterns_of_strokes_go_with_them(carrier, text, motion):
    """The floor's open sides, too, and what becomes an outline."""
    studio = Studio(parse_style(text), FRAMES)
    one, other = (studio.shown(MOTIONS[motion](FRAMES, k)) for k in (0, 1))
    kept = strokes.Kept()
    ahead = carrier.motion(one.frame, other.frame, other.depth)
    kept.add(one.samples, other.samples, ahead, one.depth)
    assert kept.patterned > 300
    assert kept.drift / kept.patterned < 0.3


def test_a_skeleton_is_as_long_as_its_stroke():
    bar = np.zeros((40, 120), np.bool_)
    bar[15:22, 10:110] = True
    assert pixels.skeleton(bar).sum() == pytest.approx(100, abs=8)
