"""Boxes of pixels: what is left of them."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from glshim.model.boxes import SLIVER, Box, boxes_of, covers, overlap, without

_SIDE = 40
BOXES = st.tuples(*[st.integers(0, 24)] * 2, *[st.integers(4, 16)] * 2)


def painted(*boxes: Box) -> np.ndarray:
    found = np.zeros((_SIDE, _SIDE), int)
    for x, y, width, height in boxes:
        found[y : y + height, x : x + width] += 1
    return found


@given(BOXES, BOXES)
def test_what_is_left_is_the_rest_but_for_slivers(box: Box, hole: Box) -> None:
    left = without((box,), hole)
    rest = painted(box) > painted(hole)
    there = painted(*left)
    assert there.max() <= 1
    if overlap(box, hole):
        assert not (there > rest).any()
        lost = rest & (there == 0)
        assert lost.sum() <= 4 * SLIVER * 16
    else:
        assert left == [box]


def test_views_that_share_a_border_lie_apart() -> None:
    assert without(((0, 0, 50, 80),), (49, 0, 50, 80)) == [(0, 0, 50, 80)]
    assert not overlap((0, 0, 50, 80), (49, 0, 50, 80))
    assert covers((0, 0, 100, 80), (1, 1, 99, 80))
    assert not covers((0, 0, 100, 80), (10, 10, 100, 10))


def test_the_boxes_of_a_mask_are_its_pixels():
    chance = np.random.default_rng(3)
    for share in (0.0, 0.2, 0.9, 1.0):
        mask = chance.random((13, 17)) < share
        mask[4:9, 3:11] = True
        found = np.zeros(mask.shape, int)
        for x, y, width, height in boxes_of(mask):
            found[y : y + height, x : x + width] += 1
        assert (found == mask).all()
    assert boxes_of(np.ones((5, 7), bool)) == [(0, 0, 7, 5)]
