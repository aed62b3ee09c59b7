"""Plans, tiles and mappings of shots; bitmaps magnified; styles of a gallery."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.errors import StyleError
from glshim.running.shots.bitmaps import magnified
from glshim.running.shots.mapping import Mapping
from glshim.running.shots.plan import MOST_AREA, Plan, parse_scale, parse_size, tiles_of
from glshim.styling import registry
from glshim.styling.enlarging import enlarged
from glshim.styling.options import options_of

SIDES = st.integers(1, 9000)


@settings(deadline=None)
@given(SIDES, SIDES, st.floats(0.2, 12.0), st.integers(64, 9000))
def test_tiles_cover_the_sheet_once(width: int, height: int, scale: float, side: int) -> None:
    tiles = tiles_of((width, height), scale, side)
    xs = sorted({tile.inner[0] for tile in tiles} | {tile.inner[2] for tile in tiles})
    ys = sorted({tile.inner[1] for tile in tiles} | {tile.inner[3] for tile in tiles})
    covered = np.zeros((len(ys) - 1, len(xs) - 1), int)
    for tile in tiles:
        left, low, right, top = tile.inner
        assert tile.x <= left < right <= tile.x + tile.width
        assert tile.y <= low < top <= tile.y + tile.height
        assert tile.width == tiles[0].width <= side and tile.height == tiles[0].height <= side
        assert tile.width * tile.height <= MOST_AREA
        covered[ys.index(low) : ys.index(top), xs.index(left) : xs.index(right)] += 1
    assert (xs[0], ys[0], xs[-1], ys[-1]) == (0, 0, width, height)
    assert (covered == 1).all()


def test_tiles_share_a_margin() -> None:
    first, second = tiles_of((1000, 300), 2.0, 600)
    assert first.x + first.width - second.x >= 96
    assert first.inner[2] == second.inner[0]


BOX = st.tuples(*[st.integers(-300, 900)] * 2, *[st.integers(0, 900)] * 2)


@settings(deadline=None)
@given(BOX, st.floats(0.3, 20.0), st.tuples(st.integers(0, 5000), st.integers(0, 5000)))
def test_a_box_comes_back_as_it_was_said(box: tuple[int, ...], scale: float, origin: tuple[int, int]
                                         ) -> None:
    sheet = max(round(640 * scale), 1), max(round(480 * scale), 1)
    mapping = Mapping((640, 480), sheet, origin)
    assert mapping.rect_back(mapping.rect(box)) == box
    if scale >= 2.0:  # also one that the mapping was never told
        assert Mapping((640, 480), sheet, origin).rect_back(mapping.rect(box)) == box


def test_boxes_that_touch_go_on_touching() -> None:
    mapping = Mapping((640, 480), (1600, 1200), (0, 0))
    left, right = mapping.rect((0, 0, 213, 480)), mapping.rect((213, 0, 427, 480))
    assert left[0] + left[2] == right[0] and right[0] + right[2] == 1600
    assert mapping.length_back(np.float32(mapping.length(1.5))) == 1.5


@pytest.mark.parametrize(
    ("window", "size", "sheet"),
    [((640, 480), (6400, 4800), (6400, 4800)), ((640, 480), (5000, 5000), (5000, 3750)),
     ((641, 481), (2000, 1501), (2000, 1501)), ((300, 300), (50, 20), (20, 20))],
)  # fmt: skip
def test_a_size_holds_the_whole_window(
    window: tuple[int, int], size: tuple[int, int], sheet: tuple[int, int]
) -> None:
    assert Plan("out.png", 3, size).sheet_for(window) == sheet


def test_a_plan_goes_through_the_environment() -> None:
    plan = Plan("/tmp/a b.png", 7, (60, 40), 1.0, 512)
    assert Plan.of_text(plan.as_text()) == plan


@pytest.mark.parametrize("text", ["", "0x40", "40", "40x", "-4x4", "4x4x4", "1e3x5"])
def test_a_size_that_is_none_is_refused(text: str) -> None:
    assert parse_size(" 60x40 ") == (60, 40)
    with pytest.raises(StyleError, match="not a valid size"):
        parse_size(text)


@pytest.mark.parametrize("text", ["", "0", "-1", "nan", "inf", "big"])
def test_a_scale_that_is_none_is_refused(text: str) -> None:
    assert parse_scale("2.5") == 2.5
    with pytest.raises(StyleError, match="not a valid scale"):
        parse_scale(text)


def test_bits_become_blocks() -> None:
    bits = np.array([[1, 0], [0, 1]], np.uint8)
    assert (magnified(bits, 3.0, 2.0) == np.kron(bits, np.ones((2, 3)))).all()
    assert magnified(bits, 1.0, 1.0).tolist() == bits.tolist()
    assert magnified(bits, 1.5, 1.5).shape == (3, 3)


def test_lengths_in_pixels_grow_past_their_range_and_nothing_else_does() -> None:
    for name in ("raskar", "edge_mesh", "crease", "fins", "fur", "two_pass"):
        styler = registry.load(name)()
        larger = enlarged(styler, 100.0)
        for option in options_of(type(styler)):
            before, after = getattr(styler, option.name), getattr(larger, option.name)
            grows = option.unit == "px" and before is not None
            assert after == (before * 100.0 if grows else before), option.name
