"""What strokes are drawn with: textures made here, and picture files.

Columns run along a stroke, rows across it, the last one on the inside. Made for a width and a
length in pixels, so that dots are round and the tooth of the paper is as coarse on wide lines as
on fine ones.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from glshim.styling.pictures import Image, is_coloured, read_image

Doubles = NDArray[np.float64]

_MOST = 4096
_SHARP = 64
"""Rows at least of a texture with clean rims; more would only be averaged."""
_SEED = 2001


def made(name: str, width: float, length: float) -> tuple[Image, float, bool]:
    """The image of a texture for lines of a width in pixels, the pixels after which it repeats
    (length, or where that is 0 what suits), and whether it has colours of its own."""
    if name in _MADE:
        make, suits = _MADE[name]
        length = length or suits(width)
        return _image(make, width, length), length, False
    image = read_image(name)
    height, columns = image.pixels.shape[:2]
    return image, length or width * columns / height, is_coloured(image)


@lru_cache(maxsize=16)
def _image(make: Callable[[float, float], Doubles], width: float, length: float) -> Image:
    ink = make(width, length)
    pixels = np.full((*ink.shape, 4), 255, np.uint8)
    pixels[..., 3] = np.rint(np.clip(ink, 0.0, 1.0) * 255.0).astype(np.uint8)
    return Image(pixels)


def _dotted(width: float, length: float) -> Doubles:
    """One round dot as wide as the line, or less where dots would touch."""
    along, across, grain = _places(width, length)
    radius = min(width, 0.8 * length) / 2.0
    return _inside(np.hypot(along, across) - radius, grain)


def _dashed(width: float, length: float) -> Doubles:
    """One dash with rounded corners."""
    along, across, grain = _places(width, length)
    half, round_ = 0.3 * length, min(0.35 * width, 0.2 * length)
    x = np.maximum(np.abs(along) - half + round_, 0.0)
    y = np.maximum(np.abs(across) - width / 2.0 + round_, 0.0)
    return _inside(np.hypot(x, y) - round_, grain)


def _charcoal(width: float, length: float) -> Doubles:
    """A stick dragged over rough paper: it leaves ink on the paper's tooth, and more of it where it
    is pressed; the rim is uneven, most of all outside."""
    rows = int(np.clip(np.ceil(2.0 * width), 8, 256))
    columns = int(np.clip(round(rows * length / width), 16, _MOST))
    fine = rows / width  # texels a pixel
    chance = np.random.default_rng(_SEED)
    tooth = _even(
        _noise(chance, (rows, columns), (1.1 * fine, 1.1 * fine))
        + 0.7 * _noise(chance, (rows, columns), (0.6 * fine, 5.0 * fine))
        + 0.5 * _noise(chance, (rows, columns), (2.6 * fine, 2.6 * fine))
    )
    firm = float(np.clip((8.0 - width) / 6.0, 0.0, 1.0))  # a fine line would break into dashes
    pressure = 0.86 + 0.2 * firm + 0.1 * _noise(chance, (1, columns), (1.0, 14.0 * fine))
    across = (np.arange(rows)[:, None] + 0.5) / rows  # 0 outside, 1 inside
    wander = _noise(chance, (1, columns), (1.0, 9.0 * fine))
    ragged = _noise(chance, (1, columns), (1.0, 2.0 * fine))
    outer = 0.2 + 0.07 * wander + 0.05 * ragged
    inner = 0.06 + 0.03 * _noise(chance, (1, columns), (1.0, 4.0 * fine))
    soft = max(0.3, 1.2 / width)
    body = np.clip((across - outer) / soft + 0.5, 0.0, 1.0)
    body *= np.clip((1.0 - across - inner) / (0.5 * soft) + 0.5, 0.0, 1.0)
    return np.clip((body * pressure - tooth) / 0.22 + 0.35, 0.0, 1.0) * (0.55 + 0.45 * body)


_MADE: dict[str, tuple[Callable[[float, float], Doubles], Callable[[float], float]]] = {
    "dotted": (_dotted, lambda width: 2.0 * width),
    "dashed": (_dashed, lambda width: 5.0 * width),
    "charcoal": (_charcoal, lambda width: max(256.0, 24.0 * width)),
}
MADE = tuple(_MADE)
"""The textures made here, by name."""


def _places(width: float, length: float) -> tuple[Doubles, Doubles, float]:
    """Pixels along and across from the middle of an image, and pixels a texel."""
    rows = max(_SHARP, min(2 ** int(np.ceil(np.log2(2.0 * width))), 256))
    columns = int(np.clip(round(rows * length / width), 4, _MOST))
    along = ((np.arange(columns) + 0.5) / columns - 0.5) * length
    across = ((np.arange(rows) + 0.5) / rows - 0.5) * width
    return along[None, :], across[:, None], max(length / columns, width / rows)


def _inside(distance: Doubles, grain: float) -> Doubles:
    return np.clip(0.5 - distance / grain, 0.0, 1.0)


def _noise(
    chance: np.random.Generator, shape: tuple[int, int], size: tuple[float, float]
) -> Doubles:
    """Smooth noise of a size in texels (across, along) that tiles; mean 0, deviation 1."""
    waves = np.fft.fft2(chance.standard_normal(shape))
    down, along = (np.fft.fftfreq(n) for n in shape)
    blur = np.exp(-2.0 * ((np.pi * size[0] * down[:, None] / 2.0) ** 2
                          + (np.pi * size[1] * along[None, :] / 2.0) ** 2))  # fmt: skip
    found = np.fft.ifft2(waves * blur).real
    return np.asarray((found - found.mean()) / max(float(found.std()), 1e-12))


def _even(noise: Doubles) -> Doubles:
    """The same with all values in 0..1 equally common."""
    rank = np.empty(noise.size)
    rank[np.argsort(noise, axis=None, kind="stable")] = (np.arange(noise.size) + 0.5) / noise.size
    return rank.reshape(noise.shape)
