"""Nine pictures of strokes, as NPRQuake's brush has: charcoal (two), pens (three kinds, two each)
and a pencil.

Each function gives the ink (rows, columns), 0..1, of a stroke for a width and a length in pixels;
columns run along the stroke and tile, rows go across it. What wears and skips does so in pixels, as
paper and hairs do, not in shares of the width.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.random import default_rng

from glshim.styling.pictures import Image, is_coloured, read_image
from glshim.styling.textures.fields import MOST, Doubles, even, noise

_SEED = 2001
_FINE = 2.0
"""Texels a pixel."""
_LEAST = 420.0
"""Pixels of a picture at least: shorter ones are seen to repeat."""


class _Sheet:
    """What strokes of a width and a length are put together from. All noise has mean 0, deviation
    1 and sizes in pixels."""

    def __init__(self, width: float, length: float, seed: int) -> None:
        self._chance = default_rng(_SEED + seed)
        self.rows = int(np.clip(np.ceil(_FINE * width), 12, 160))
        self.columns = int(np.clip(round(_FINE * length), 64, MOST))
        self._down, self._along = self.rows / width, self.columns / length
        self.width = width
        self.firm = float(np.clip((10.0 - width) / 7.0, 0.0, 1.0))
        """0..1: how much less a fine stroke is worn, which would break into dots."""
        # From -1 at one rim to 1 at the other.
        self.across = ((np.arange(self.rows) + 0.5) / self.rows * 2.0 - 1.0)[:, None]

    def line(self, pixels: float) -> Doubles:
        """(1, columns) that varies along."""
        return noise(self._chance, (1, self.columns), (1.0, pixels * self._along))

    def field(self, across: float, along: float) -> Doubles:
        """(rows, columns)."""
        size = (across * self._down, along * self._along)
        return noise(self._chance, (self.rows, self.columns), size)

    def tooth(self) -> Doubles:
        """(rows, columns) paper: 0..1, all equally common."""
        return even(self.field(1.1, 1.1) + 0.7 * self.field(2.4, 2.4))

    def body(self, low: Doubles | float, high: Doubles | float, soft: float) -> Doubles:
        """Ink between two rims, -1..1, that fades over so many pixels."""
        reach = self.width / 2.0
        depth = np.minimum(self.across - low, high - self.across) * reach
        return np.asarray(np.clip(depth / soft + 0.5, 0.0, 1.0))


def charcoal1(sheet: _Sheet) -> Doubles:
    """A soft stick on its side: it leaves ink on the paper's tooth."""
    ragged, wander = sheet.line(2.5), sheet.line(16.0)
    body = sheet.body(-0.82 + 0.1 * wander + 0.07 * ragged,
                      0.82 + 0.1 * wander + 0.07 * sheet.line(2.5), 0.28 * sheet.width)  # fmt: skip
    press = 0.74 + 0.3 * sheet.firm + 0.1 * sheet.line(40.0) + 0.08 * sheet.field(4.0, 18.0)
    worn = sheet.tooth() * 0.75 + 0.25 * even(sheet.field(0.8, 7.0))
    return np.clip((body * press - worn) / 0.3 + 0.45, 0.0, 1.0) * (0.5 + 0.5 * body)


def charcoal2(sheet: _Sheet) -> Doubles:
    """The edge of a stick, pressed: a dark core that wanders, and dust about it."""
    middle = 0.16 * sheet.line(50.0)
    half = 0.42 + 0.09 * sheet.line(24.0)
    core = sheet.body(middle - half, middle + half, max(1.0, 0.16 * sheet.width))
    dust = np.exp(-((sheet.across - middle) ** 2) / 0.32) * (1.0 - np.abs(sheet.across) ** 6)
    tooth = sheet.tooth()
    rubbed = np.clip((core * 1.15 - tooth) / 0.35 + 0.4, 0.0, 1.0)
    return np.maximum(rubbed * core, 0.42 * dust * np.clip(1.25 - tooth, 0.0, 1.0) ** 2)


def pen1a(sheet: _Sheet) -> Doubles:
    """A fibre pen, firm: solid, with rims that hardly waver."""
    low, high = (side * (0.84 + 0.05 * sheet.line(22.0) + 0.03 * sheet.line(4.0))
                 for side in (-1.0, 1.0))  # fmt: skip
    return sheet.body(low, high, 0.9) * (0.94 + 0.03 * np.tanh(sheet.field(2.0, 9.0)))


def pen1b(sheet: _Sheet) -> Doubles:
    """The same, swift: it thins, and skips where the paper lies low."""
    half = 0.72 + 0.12 * np.tanh(sheet.line(60.0)) + 0.05 * sheet.line(5.0)
    body = sheet.body(-half, half, 1.0)
    swift = np.clip(0.5 + 0.5 * sheet.line(70.0), 0.0, 1.0)
    skipped = even(sheet.field(0.9, 11.0) + 0.5 * sheet.field(1.4, 1.4))
    return body * np.clip((1.05 + 0.4 * sheet.firm - 0.5 * swift - skipped) / 0.2 + 0.35, 0.0, 1.0)


def pen2a(sheet: _Sheet) -> Doubles:
    """A brush full of ink: solid, swelling and thinning as the hand bears down."""
    swell = 0.72 + 0.2 * np.tanh(sheet.line(85.0))
    low = -swell - 0.04 * sheet.line(7.0)
    high = swell + 0.04 * sheet.line(7.0)
    pool = 1.0 - 0.16 * np.clip(sheet.field(0.35 * sheet.width, 60.0), 0.0, 1.5)
    return sheet.body(low, high, 1.0) * np.clip(pool, 0.0, 1.0)


def pen2b(sheet: _Sheet) -> Doubles:
    """A brush that runs dry: its hairs leave streaks, most of all at one rim."""
    hair = max(0.8, sheet.width / 16.0)
    streak = even(sheet.field(hair, 150.0) + 0.55 * sheet.field(0.7 * hair, 28.0))
    lean = 0.5 + 0.5 * sheet.across * np.tanh(1.4 * sheet.line(170.0))
    dry = (0.44 + 0.22 * np.tanh(sheet.line(120.0))) * (0.45 + 0.85 * lean)
    dry *= 1.0 - 0.7 * sheet.firm
    swell = 0.82 + 0.1 * np.tanh(sheet.line(90.0))
    frayed = 0.05 * sheet.line(6.0) + 0.07 * sheet.line(30.0)
    body = sheet.body(-swell + frayed, swell + 0.05 * sheet.line(6.0), 1.2)
    left = np.clip((streak - dry) / 0.22 + 0.5, 0.0, 1.0)
    grain = 1.0 - 0.5 * np.clip(sheet.tooth() - 0.6, 0.0, 1.0) * (left < 0.95)
    return body * left * grain


def pen3a(sheet: _Sheet) -> Doubles:
    """A broad nib at a slant: thick and thin by turns, the ink gathers at its rims."""
    turn = 0.5 + 0.5 * np.tanh(1.2 * sheet.line(55.0))
    middle = 0.22 * np.tanh(sheet.line(70.0))
    half = 0.26 + 0.46 * turn
    body = sheet.body(middle - half, middle + half, 0.9)
    reach = sheet.width / 2.0
    depth = np.minimum(sheet.across - middle + half, middle + half - sheet.across) * reach
    rim = np.exp(-np.maximum(depth, 0.0) / max(0.8, 0.07 * sheet.width))
    return body * np.clip(0.72 + 0.3 * rim + 0.06 * sheet.field(3.0, 20.0), 0.0, 1.0)


def pen3b(sheet: _Sheet) -> Doubles:
    """A marker: a flat band, one can see through it, with streaks of its felt."""
    low, high = (side * (0.9 + 0.025 * sheet.line(14.0)) for side in (-1.0, 1.0))
    felt = sheet.field(max(0.9, sheet.width / 10.0), 240.0)
    band = np.clip(0.62 + 0.11 * felt + 0.05 * sheet.field(3.0, 30.0), 0.0, 1.0)
    rim = np.clip((np.abs(sheet.across) - 0.74) / 0.16, 0.0, 1.0)
    return sheet.body(low, high, 1.2) * np.clip(band + 0.22 * rim, 0.0, 1.0)


def pencil(sheet: _Sheet) -> Doubles:
    """A soft pencil: graphite on the tooth, darkest in the middle."""
    middle = 0.12 * sheet.line(40.0)
    bell = np.exp(-((sheet.across - middle) ** 2) / 0.28) * (1.0 - sheet.across**4)
    press = 0.86 + 0.2 * sheet.firm + 0.1 * sheet.line(30.0) + 0.05 * sheet.line(5.0)
    return np.clip((bell * press - 0.8 * sheet.tooth()) / 0.5 + 0.42, 0.0, 1.0) * bell**0.5


_MADE: dict[str, Callable[[_Sheet], Doubles]] = {
    made.__name__: made
    for made in (charcoal1, charcoal2, pen1a, pen1b, pen2a, pen2b, pen3a, pen3b, pencil)
}
BRUSHES = tuple(_MADE)
"""The brushes made here, by name."""


def brush(name: str, width: float, length: float = 0.0) -> tuple[Image, float, bool]:
    """The picture of a brush, or of a file, for strokes of a width in pixels; the pixels along
    after which it repeats (length, or where that is 0 what suits); and whether it has colours of
    its own."""
    if name in _MADE:
        length = length or max(_LEAST, 24.0 * width)
        return _image(name, width, length), length, False
    image = read_image(name)
    height, columns = image.pixels.shape[:2]
    return image, length or width * columns / height, is_coloured(image)


@lru_cache(maxsize=64)
def _image(name: str, width: float, length: float) -> Image:
    ink = _MADE[name](_Sheet(width, length, BRUSHES.index(name)))
    pixels = np.full((*ink.shape, 4), 255, np.uint8)
    pixels[..., 3] = np.rint(np.clip(ink, 0.0, 1.0) * 255.0).astype(np.uint8)
    return Image(pixels)
