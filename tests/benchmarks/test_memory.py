"""A short version of `python -m tests.benchmarks --memory`."""

from itertools import product

import pytest

from tests.sweep import some

from .measure import remembered

FRAMES = 400
SLACK = 3 * 2**20  # bytes that may come and go; 200 frames that leak a mesh leave more


SCENES = ("immediate, 7k vertices", "fresh lists", "fresh buffers", "fresh shapes in C")


@pytest.mark.parametrize(("scene", "mode"), some(tuple(product(SCENES, ("none", "raskar"))), 3))
def test_memory_stays_flat(scene: str, mode: str, display: str) -> None:
    sizes = remembered(scene, FRAMES, mode, display)
    assert sizes[-1] - sizes[len(sizes) // 2] < SLACK, sizes
