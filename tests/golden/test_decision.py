"""Ridges are drawn for folds up to the threshold and valleys for folds beyond it, whole or not at
all. The full sweep is `python -m tests.decision`."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from glshim.outputs.gl.backend import Backend
from tests import look
from tests.decision.folds import VARIANTS
from tests.decision.sweep import BROKEN, DISTANCES, NONE, SIZE, WHOLE, classify
from tests.decision.table import COUNTS, quick_angles, row
from tests.sweep import some

ASKED = [("ridge", 120.0), ("valley", 240.0), ("ridge", 200.0), ("valley", 181.0)]


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


@pytest.mark.parametrize(("asked", "variant"), some(tuple(product(ASKED, VARIANTS)), 7))
def test_no_wrong_decision_and_no_line_in_part(backend, asked, variant):
    """A seeded part of the sweep, both sides of the threshold among it."""
    kind, threshold = asked
    for distance in DISTANCES:
        found = row(backend, kind, threshold, variant, distance, quick_angles(threshold), 30)
        counts = {name: getattr(found, name) for name in COUNTS}
        assert not any(counts.values()), (distance, counts, found.faults[:5])


def test_the_count_sees_a_threshold_that_is_off(backend):
    """Ridges drawn up to 117 and up to 123 degrees where 120 is asked for."""
    folds, near = [118.0, 122.0, 240.0], DISTANCES[0]
    low = row(backend, "ridge", 120.0, "one batch", near, folds, 20, ridge_angle=117.0)
    high = row(backend, "ridge", 120.0, "one batch", near, folds, 20, ridge_angle=123.0)
    assert (low.missing > 0, low.extra) == (True, 0)
    assert (high.missing, high.extra > 0) == (0, True)


@pytest.mark.parametrize(
    ("gap", "expected"), [(slice(0, 0), WHOLE), (slice(0, SIZE), NONE), (slice(50, 52), BROKEN)]
)
def test_the_measure_tells_whole_from_none_and_from_part(gap, expected):
    """A drawn line of 4 px, without gap, without line, and with a gap of 2 px."""
    before = np.full((SIZE, SIZE, 3), 204, np.uint8)
    after = before.copy()
    after[30:34, 10:80] = 0
    after[:, gap] = 204
    ends = np.array([[(10.0, 32.0), (80.0, 32.0)]])
    found, _ = classify(before, after, ends, np.array([20.0]), DISTANCES[0].tiles)
    assert found == [expected]
