"""Flaws of the paper's method (`python -m tests.flaws OUT` shows them): style raskar has none of
them, and the measures see them in the method as printed."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.outputs.gl.backend import Backend
from tests import look
from tests.flaws import scenes
from tests.flaws.render import both
from tests.flaws.scenes import FURTHER, SCENES, SIZE


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


@pytest.mark.parametrize("make", [*SCENES, *FURTHER], ids=lambda make: make.__name__)
def test_before_has_the_flaw_and_after_has_not(backend, make):
    scene = make()
    _, before, _, after = both(backend, scene)
    assert scene.faults(before) > 0
    assert scene.faults(after) == 0


@pytest.mark.parametrize("make", [scenes.ball, scenes.cube])
def test_no_crack_at_40_px_from_anywhere(backend, make):
    """Twelve directions; a pixel without ink within the width is one too many."""
    cracks = {}
    for k, direction in enumerate(look.directions(12)):
        scene = make(direction)
        _, _, _, after = both(backend, scene)
        cracks[k] = scene.faults(after)
    assert not any(cracks.values()), cracks


EYES = [(-1.21, -6, -1.116), (1.191, -6, -1.248), (-0.593, -6, 0.682), (-1.757, -6, 0.781),
        (2.755, -6, 0.121), (2.3, -6, 1.9)]  # fmt: skip


@pytest.mark.parametrize("gap", [0.001, 0.005, 0.02, 0.05])
@pytest.mark.parametrize("shape", ["slab", "ball", "can"])
def test_a_wall_close_behind_takes_nothing_from_an_outline(backend, shape, gap):
    """Full width all round, where two segments meet, too."""
    gaps = {}
    for eye in EYES:
        scene = scenes.before_wall(shape, gap, eye)
        _, _, _, after = both(backend, scene)
        gaps[eye] = scene.faults(after)
    assert not any(gaps.values()), gaps


def test_one_visible_width_round_the_rim_of_a_can(backend):
    """Ridge in front, silhouette at the back, measured across at many places of both."""
    scene = scenes.thickness()
    _, before, _, after = both(backend, scene)
    found = scenes.rim_widths(after, 8.0)
    assert len(found) > 30
    assert np.ptp(found) <= 1.0, found
    assert np.ptp(scenes.rim_widths(before, 8.0)) > 4.0


def test_one_width_along_a_beam_that_passes_the_viewer(backend):
    """Both its ridge and its silhouettes, up to the border of the window."""
    scene = scenes.near()
    _, before, _, after = both(backend, scene)
    found = scenes.beam_widths(after, 10.0)
    assert len(found) > 30
    assert np.abs(found - 10.0).max() <= 0.75
    assert np.abs(scenes.beam_widths(before, 10.0) - 10.0).max() > 4.0
