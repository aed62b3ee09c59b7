"""Surfaces as programs make them, restyled (`scenery`)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import numpy as np
import pygame
import pytest

from glshim.outputs.gl.frame.behind import brightness_behind
from tests.golden import restyled, scenery
from tests.golden.restyled import Picture
from tests.golden.scenery import HEIGHT, WIDTH


@pytest.fixture(scope="module", autouse=True)
def window() -> Iterator[None]:
    with restyled.window():
        yield


def shown(scene: str, style: str = "", frames: int = 1) -> Picture:
    """(HEIGHT, WIDTH, 3) of 0..255, the last frame, from below upwards."""
    return restyled.shown(partial(scenery.draw, scene), style, frames)


@pytest.mark.parametrize("style", ["cartoon", "technical", "sketch:hatching=1,tint=0"])
def test_a_normal_in_the_plane_of_its_floor_says_nothing(style: str) -> None:
    """It is glNormal's default, in beginners' programs: stripes of rounding noise."""
    bad, good = (shown(f"floor_with_{normal}", style) for normal in ("gls_normal", "its_own"))
    differs = np.abs(bad - good).max(axis=2) > 24
    assert differs.mean() < 0.08


@pytest.mark.parametrize("style", ["cartoon", "technical"])
@pytest.mark.parametrize("way", ["material", "material_in_a_list", "a_list_that_says_how"])
def test_a_chequered_floor_keeps_its_cheques(way: str, style: str) -> None:
    """However its colours come inside one primitive."""
    scene = f"chequers_{'in' if way.startswith('a_') else 'of'}_{way}"
    found, plain = shown(scene, style), shown("chequers_of_colour", style)
    assert len(np.unique(plain[: HEIGHT // 2].reshape(-1, 3), axis=0)) > 2
    assert np.abs(found - plain).max() <= 1


PAPERS = ("technical", "sketch", "hiddenline", "blueprint")


@pytest.mark.parametrize("style", PAPERS)
@pytest.mark.parametrize("way", ["writes", "test"])
def test_what_has_no_depth_does_not_vanish_on_paper(way: str, style: str) -> None:
    """A road does not float: grass lies about it, in the very first frame."""
    found = shown(f"road_without_depth_{way}", style)
    grass, sky = found[40:60, 360:390], found[285:, 90:110]
    assert np.abs(grass.mean(axis=(0, 1)) - sky.mean(axis=(0, 1))).max() > 12


def test_what_is_blended_is_blended_with_the_paper() -> None:
    """A pane on black, which is dark there, covers as much of white paper."""
    plain, found = shown("blended"), shown("blended", "technical")
    pane = (slice(110, 180), slice(230, 300))
    shade = np.array((0.2, 0.5, 0.9))
    assert np.abs(plain[pane].max(axis=(0, 1)) - 255 * 0.4 * shade).max() < 60
    wanted = 255 * (0.4 * shade + 0.6)
    assert np.abs(np.median(found[pane], axis=(0, 1)) - wanted).max() < 8


def test_a_picture_without_solids_keeps_its_background() -> None:
    """A menu on its own ground: paper comes with what it lies behind."""
    assert (shown("menu", "technical") == shown("menu")).all()


def test_a_picture_behind_all_is_scenery() -> None:
    """From the first frame on, in which nobody knows before that it is no menu."""
    found = shown("on_a_picture", "technical")
    assert np.abs(shown("on_a_picture", "technical", frames=2) - found).max() < 8
    assert np.abs(np.median(found[200:, :80], axis=(0, 1)) - (40, 140, 60)).max() < 8


def test_a_backdrop_is_no_scenery() -> None:
    """Colours across the window, drawn flat, are the background that paper stands for."""
    found = shown("before_a_backdrop", "technical")
    assert found[280:, :40].min() > 240


def test_each_draw_is_lit_by_the_lights_that_stood_then() -> None:
    found = shown("lamps_that_change", "cartoon")
    left, right, view = found[150, 140], found[150, 260], found[250, 50]
    for seen, channel in ((left, 0), (right, 1), (view, 2)):
        assert np.argmax(seen) == channel and seen[channel] > 2 * np.delete(seen, channel).max()


def test_lamps_of_several_colours_leave_no_patches() -> None:
    """Neighbours on a smooth ball differ by their band alone: no step from hue to hue."""
    found = shown("coloured_lamps", "cartoon").astype(float)
    ball = found[100:200, 150:250]
    hue = ball / ball.max(axis=2, keepdims=True)
    assert np.abs(np.diff(hue, axis=1)).max() < 0.12
    assert np.ptp(hue[..., 0]) > 0.2  # the lamps are seen


def test_what_is_not_lit_keeps_its_colour_among_what_is() -> None:
    """A sun is no planet: neither the look's light nor its hatching falls on it."""
    plain, comic = shown("a_sun_without_light"), shown("a_sun_without_light", "comic")
    sun, planet = (slice(130, 170), slice(180, 220)), (slice(135, 165), slice(300, 320))
    assert (comic[sun] == plain[sun]).all()
    assert (comic[planet] != plain[planet]).any()
    hatched = shown("a_sun_without_light", "sketch")
    assert np.ptp(hatched[sun].sum(axis=2)) < 60 < np.ptp(hatched[planet].sum(axis=2))


def test_hatching_goes_by_the_lights_of_the_draw() -> None:
    """Not by those that stand when the frame is shown: the program has put them away."""
    found = shown("coarse_balls", "sketch:tint=0").astype(float).sum(axis=2)
    for middle in (122, 279):  # smooth and flat; the light comes from the upper right
        dark = found[90:130, middle - 55 : middle - 25]
        bright = found[170:205, middle + 10 : middle + 40]
        assert dark.mean() < bright.mean() - 20


def test_how_bright_it_is_behind_is_seen_in_the_picture() -> None:
    """Not in the colour that it was cleared with: a backdrop lies over that."""
    found = {}
    for scene in ("before_a_backdrop", "a_sun_without_light", "menu"):
        scenery.draw(scene)
        found[scene] = brightness_behind((0, 0, WIDTH, HEIGHT))
        pygame.display.flip()
    assert found["a_sun_without_light"] == 0.0
    assert found["before_a_backdrop"] == pytest.approx(0.4, abs=0.1)
    assert found["menu"] == pytest.approx(scenery.SKY[2], abs=0.01)


@pytest.mark.parametrize("style", ["cartoon", "technical", "sketch", "pencil"])
def test_glass_is_seen_and_seen_through(style: str) -> None:
    """Without depth: it has an outline, and the floor and the box behind keep theirs."""
    found = shown("glass_without_depth", style).sum(axis=2)
    rim = found[150, 290:315]
    assert rim.min() < np.median(rim) - 150
    behind = found[140:165, 230]  # the far edge of the floor
    assert behind.min() < np.median(behind) - 100


@pytest.mark.parametrize("style", ["cartoon", "technical"])
def test_fog_stays(style: str) -> None:
    """Boxes are the paler the farther away."""
    found = shown("in_fog", style).astype(int)
    faces = [found[130, 20], found[165, 140], found[195, 215]]
    strength = [int(np.ptp(face)) for face in faces]
    assert strength[0] > strength[1] > strength[2]
