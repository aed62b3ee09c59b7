"""What textures of strokes are put together from: places, rims, and noise that tiles along."""

from __future__ import annotations

import numpy as np
from numpy import fft
from numpy.random import Generator
from numpy.typing import NDArray

Doubles = NDArray[np.float64]
"""An array of float64."""

MOST = 4096
"""Columns at most: every driver takes them."""
_SHARP = 64
"""Rows at least of a texture with clean rims; more would only be averaged."""


def sharp(width: float, length: float) -> tuple[int, int]:
    """Rows and columns of a texture with clean rims, for a width and a length in pixels."""
    rows = max(_SHARP, min(2 ** int(np.ceil(np.log2(2.0 * width))), 256))
    return rows, int(np.clip(round(rows * length / width), 4, MOST))


def places(width: float, length: float) -> tuple[Doubles, Doubles, float]:
    """Pixels along (1, columns) and across (rows, 1) from the middle of an image, and pixels a
    texel."""
    rows, columns = sharp(width, length)
    along = ((np.arange(columns) + 0.5) / columns - 0.5) * length
    across = ((np.arange(rows) + 0.5) / rows - 0.5) * width
    return along[None, :], across[:, None], max(length / columns, width / rows)


def inside(distance: Doubles, grain: float) -> Doubles:
    """Ink, 0..1, of a shape with a clean rim, from the distance to it (less than 0 inside)."""
    return np.clip(0.5 - distance / grain, 0.0, 1.0)


def noise(
    chance: Generator, shape: tuple[int, int], size: tuple[float, float]
) -> Doubles:
    """Smooth noise of a size in texels (across, along) that tiles; mean 0, deviation 1."""
    waves = fft.fft2(chance.standard_normal(shape))
    down, along = (fft.fftfreq(n) for n in shape)
    blur = np.exp(-2.0 * ((np.pi * size[0] * down[:, None] / 2.0) ** 2
                          + (np.pi * size[1] * along[None, :] / 2.0) ** 2))  # fmt: skip
    found = fft.ifft2(waves * blur).real
    return np.asarray((found - found.mean()) / max(float(found.std()), 1e-12))


def even(values: Doubles) -> Doubles:
    """The same with all values in 0..1 equally common."""
    rank = np.empty(values.size)
    order = np.argsort(values, axis=None, kind="stable")
    rank[order] = (np.arange(values.size) + 0.5) / values.size
    return rank.reshape(values.shape)
