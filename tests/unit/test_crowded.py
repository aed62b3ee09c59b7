"""Lines among many, in the window."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.linework.crowded import crowded
from glshim.model.camera import Camera
from glshim.model.lines import CROWDED, RECORD, RIDGE, SHARED, Line, group_of, kind_of
from tests.look import orthographic

CAMERA = Camera(np.eye(4), orthographic(2.0), (0, 0, 400, 400))


def records(*places: float) -> np.ndarray:
    """Parallel lines of 100 pixels, at places across them in pixels."""
    found = np.zeros((len(places), RECORD), np.float32)
    found[:, Line.A] = [(-0.5, place / 100.0, -5.0) for place in places]
    found[:, Line.B] = [(0.5, place / 100.0, -5.0) for place in places]
    found[:, Line.KIND] = RIDGE + SHARED
    return found


def marks(found: np.ndarray) -> list[bool]:
    assert (kind_of(found) == RIDGE).all()
    assert (group_of(found) == 1).all()
    return [bool(kind >= CROWDED) for kind in found[:, Line.KIND]]


def test_lines_far_apart_are_not_crowded() -> None:
    assert not any(marks(crowded(records(*range(-80, 80, 20)), CAMERA)))


def test_a_thicket_is_and_what_stands_beside_it_is_not() -> None:
    found = marks(crowded(records(*range(0, 30, 3), 80), CAMERA))
    assert all(found[2:8])
    assert not found[-1]


def test_a_line_that_goes_far_beyond_the_window_counts_once() -> None:
    found = records(-40, 40)
    found[:, Line.A.start] *= 1e4
    assert not any(marks(crowded(found, CAMERA)))


@pytest.mark.parametrize("odd", [np.nan, np.inf, 1e30])
def test_lines_that_no_window_holds(odd: float) -> None:
    given = records(0, 1, 2)
    given[1, Line.A] = odd
    assert len(crowded(given, CAMERA)) == 3
    assert len(crowded(given[:0], CAMERA)) == 0
