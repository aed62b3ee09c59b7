"""The demo programs in style raskar look as they were last looked at."""

from __future__ import annotations

import numpy as np
import pytest

from tests.golden import pictures

INK = np.array((0xE8, 0x64, 0x1B))


@pytest.mark.parametrize("name", pictures.programs())
def test_it_looks_as_it_was_last_looked_at(name: str, display: str) -> None:
    """To the pixel on the Mesa that drew the reference; elsewhere the same lines within a pixel."""
    found = pictures.painted(pictures.programs()[name], display, pictures.STYLE)
    wanted = pictures.stored(name)
    assert found.shape == wanted.shape
    if pictures.renderer(display) == pictures.recorded():
        different = (found != wanted).any(axis=2)
        assert not different.any(), f"{different.sum()} pixels differ"
    ink, known = ((picture == INK).all(axis=2) for picture in (found, wanted))
    assert 0.01 < ink.mean() < 0.3
    assert (ink & ~_wide(known)).sum() <= 0.03 * ink.sum()
    assert (known & ~_wide(ink)).sum() <= 0.03 * known.sum()


def _wide(mask: np.ndarray) -> np.ndarray:
    """A mask and the pixels around it."""
    padded = np.pad(mask, 1)
    height, width = mask.shape
    steps = [(i, j) for i in range(3) for j in range(3)]
    return np.any([padded[i : i + height, j : j + width] for i, j in steps], axis=0)


def test_the_references_are_small() -> None:
    sizes = [path.stat().st_size for path in pictures.FOLDER.iterdir()]
    assert sum(sizes) < 320_000
