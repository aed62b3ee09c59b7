"""Ridges are drawn for folds up to the threshold and valleys for folds beyond it, whole or not at
all. The full sweep is `python -m tests.decision`."""

from __future__ import annotations

import pytest

from glshim.render.backend import Backend
from tests import look
from tests.decision.folds import VARIANTS, View
from tests.decision.sweep import DISTANCES, NONE, SIZE, WHOLE, picture
from tests.decision.table import COUNTS, quick_angles, row
from tests.styles import KNOWN, only

ASKED = [("ridge", 120.0), ("valley", 240.0), ("ridge", 200.0), ("valley", 181.0)]


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize(("kind", "threshold"), ASKED)
def test_no_wrong_decision_and_no_line_in_part(backend, kind, threshold, variant):
    """A seeded part of the sweep, both sides of the threshold among it."""
    if f"{kind}s" not in KNOWN:
        pytest.skip(f"no {kind}s")
    for distance in DISTANCES:
        found = row(backend, kind, threshold, variant, distance, quick_angles(threshold), 30)
        counts = {name: getattr(found, name) for name in COUNTS}
        assert not any(counts.values()), (distance, counts, found.faults[:5])


def test_the_measure_tells_whole_from_none_and_from_part(backend):
    """A wide line, a line switched off, and one that the window's scissor cuts in two."""
    view, near = View(90.0, 5.0, 3.0, 90.0), DISTANCES[0]
    _, found, share = picture(backend, only("ridges", ridge_width=4), [view], near, "one batch")
    assert (found, share) == ([WHOLE], [1.0])
    _, found, share = picture(backend, only(), [view], near, "one batch")
    assert (found, share) == ([NONE], [0.0])
