"""A short version of `python -m tests.benchmarks --memory`."""

import pytest

from .measure import remembered

FRAMES = 400
SLACK = 3 * 2**20  # bytes that may come and go; 200 frames that leak a mesh leave more


@pytest.mark.parametrize("mode", ["none", "raskar"])
@pytest.mark.parametrize("scene", ["immediate, 7k vertices", "fresh lists",
                                   "fresh buffers", "fresh shapes in C"])
def test_memory_stays_flat(scene: str, mode: str, display: str) -> None:
    sizes = remembered(scene, FRAMES, mode, display)
    assert sizes[-1] - sizes[len(sizes) // 2] < SLACK, sizes
