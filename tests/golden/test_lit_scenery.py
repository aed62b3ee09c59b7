"""The tones of surfaces as programs light them, or do not (`lit_scenery`)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
import pytest

from tests.golden import lit_scenery, restyled, scenery
from tests.golden.restyled import Picture


@pytest.fixture(scope="module", autouse=True)
def window() -> Iterator[None]:
    with restyled.window():
        yield


def shown(scene: Callable[[], None], style: str = "", frames: int = 1) -> Picture:
    return restyled.shown(partial(scenery.draw, scene), style, frames)


LEFT, RIGHT = (150, 110), (150, 290)


@pytest.mark.parametrize("style", ["cartoon", "technical:light=app"])
def test_what_looks_away_from_the_lamps_is_dark(style: str) -> None:
    """By the normal that the program sends: GL lights one side of a surface."""
    plain, found = shown(lit_scenery.sheets), shown(lit_scenery.sheets, style)
    assert plain[LEFT].sum() > 2 * plain[RIGHT].sum()
    assert found[LEFT].sum() > 1.25 * found[RIGHT].sum()


@pytest.mark.parametrize("style", ["cartoon", "technical:light=app"])
def test_where_both_sides_are_lit_so_are_they(style: str) -> None:
    found = shown(lit_scenery.sheets_of_two_sides, style)
    assert np.abs(found[LEFT] - found[RIGHT]).max() <= 1


@pytest.mark.parametrize("mode", lit_scenery.FOGS)
@pytest.mark.parametrize("style", ["cartoon", "technical", "fins:fill=cel"])
def test_fog_lies_over_light(mode: str, style: str) -> None:
    """As much of each surface is seen as in plain; on paper, the sky's fog is paper."""
    pictures = {
        (fog, how): shown(partial(lit_scenery.in_fog, fog), how).astype(float)
        for fog in (mode, None)
        for how in ("", style)
    }
    mist = 255 * np.array(lit_scenery.MIST)
    seen, paint = pictures[mode, ""] - mist, pictures[None, ""] - mist
    share = ((seen * paint).sum(axis=2) / np.maximum((paint * paint).sum(axis=2), 1.0))[..., None]
    behind = np.full(3, 255.0) if style == "technical" else mist
    wanted = share * pictures[None, style] + (1.0 - share) * behind
    ground = np.s_[5:225, 250:395]
    off = np.abs(pictures[mode, style] - wanted)[ground].max(axis=2)
    assert share[ground].min() < 0.05
    assert share[ground].max() > 0.3
    assert (off > 5).mean() < 0.01
