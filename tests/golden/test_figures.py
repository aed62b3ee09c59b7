"""The figures made again have something in each picture, and the looks are not alike."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from tests.figures.pictures import FIGURES, LOOKS
from tests.figures.shots import sheet
from tests.sweep import some

DRAWN = ("figure7", *some([name for name in FIGURES if name != "figure7"], 1))


@pytest.fixture(scope="module")
def tiles():
    return {name: FIGURES[name][0]() for name in DRAWN}


def values(tile, size=None) -> np.ndarray:
    return np.asarray(tile.resize(size) if size else tile, float)


@pytest.mark.parametrize("name", DRAWN)
def test_every_picture_of_a_figure_has_content_of_its_own(tiles, name):
    found = [values(tile) for tile in tiles[name]]
    for tile in found:
        middle = tile[tile.shape[0] // 6 : -tile.shape[0] // 6]
        assert (np.abs(middle - tile[2, 2]).max(axis=2) > 60).mean() > 0.01
    for one, other in combinations(found, 2):
        assert (np.abs(one - other).max(axis=2) > 60).mean() > 0.001
    assert sheet(tiles[name], FIGURES[name][1]).width <= 1220


def test_looks_are_what_they_are_called(tiles):
    look = dict(zip(LOOKS, map(values, tiles["figure7"]), strict=True))
    for one, other in combinations(LOOKS, 2):
        assert np.abs(look[one] - look[other]).mean() > 8.0
    colourful = {name: np.ptp(tile, axis=2).mean() for name, tile in look.items()}
    assert max(colourful["pen_and_ink"], colourful["charcoal"]) < 20
    assert min(colourful["anime"], colourful["watercolour"]) > 20
    grey = {name: tile.mean(axis=2) for name, tile in look.items()}
    between = {name: ((g > 60) & (g < 200)).mean() for name, g in grey.items()}
    assert between["pen_and_ink"] < 0.5 * between["charcoal"]  # lines, and not tones
    # A cel is flat almost everywhere, a wash almost nowhere.
    flat = {name: (np.abs(np.diff(g, axis=1)) < 1.5).mean() for name, g in grey.items()}
    assert flat["anime"] > 0.9
    assert flat["watercolour"] < 0.6
