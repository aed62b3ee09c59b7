"""What strokes are drawn with: textures made here, and picture files.

Columns run along a stroke and tile, rows across it, the first on the outside, the last one on the
inside (McGuire & Hughes 2004, section 4 and figure 6). Made for a width and a length in pixels: so
dots are round, and the tooth of the paper is as coarse on wide lines as on fine ones.

``python -m glshim.styling.textures OUT [WIDTH]`` writes them as PNGs to look at.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from glshim.styling.pictures import Image, is_coloured, read_image
from glshim.styling.textures.brushes import BRUSHES, brush
from glshim.styling.textures.fields import MOST, Doubles
from glshim.styling.textures.fur import cartoon_fur
from glshim.styling.textures.marks import dashed, dotted
from glshim.styling.textures.pens import charcoal, pen, watercolour

_Make = Callable[[float, float], Doubles]

_MADE: dict[str, tuple[_Make, Callable[[float], float]]] = {
    "dotted": (dotted, lambda width: 2.0 * width),
    "dashed": (dashed, lambda width: 5.0 * width),
    "pen": (pen, lambda width: max(256.0, 30.0 * width)),
    "charcoal": (charcoal, lambda width: max(256.0, 24.0 * width)),
    "watercolour": (watercolour, lambda width: max(256.0, 24.0 * width)),
    "cartoon_fur": (cartoon_fur, lambda width: 20.0 * width),
}
"""The function that makes the ink of a texture, and the length that suits a width, in pixels."""
MADE = tuple(_MADE)
"""The textures made here, by name."""
TEXTURES = (*MADE, *BRUSHES)
"""All that lines may be drawn with, by name."""
_GAP = 0.4
"""Share of a dash's length that is gap."""


def made(
    name: str, width: float, length: float = 0.0, dash: float = 0.0
) -> tuple[Image, float, bool]:
    """The image of a texture for lines of a width in pixels, the pixels after which it repeats
    (length, or where that is 0 what suits), and whether it has colours of its own. dash: pixels of
    a dash with the gap after it, about; 0: none. Without dashes the texture is not ``none``."""
    if name == "none":
        return _image(dashed, width, dash), dash, False
    if name in _MADE:
        make, suits = _MADE[name]
        length, coloured = length or suits(width), False
        image = _image(make, width, length)
    elif name in BRUSHES:
        image, length, coloured = brush(name, width, length)
    else:
        image = read_image(name)
        height, columns = image.pixels.shape[:2]
        length, coloured = length or width * columns / height, is_coloured(image)
    if dash <= 0.0:
        return image, length, coloured
    tiles = max(min(round(dash / length), MOST // image.pixels.shape[1]), 1)
    return _cut(image, tiles, max(round(tiles * length / dash), 1)), tiles * length, coloured


@lru_cache(maxsize=16)
def _cut(image: Image, tiles: int, dashes: int) -> Image:
    """Copies of an image side by side, cut into dashes."""
    pixels = np.tile(image.pixels, (1, tiles, 1))
    place = (np.arange(pixels.shape[1]) + 0.5) / pixels.shape[1] * dashes % 1.0
    pixels[:, np.abs(place - 0.5) > 0.5 * (1.0 - _GAP), 3] = 0
    return Image(pixels)


@lru_cache(maxsize=64)
def _image(make: _Make, width: float, length: float) -> Image:
    ink = make(width, length)
    pixels = np.full((*ink.shape, 4), 255, np.uint8)
    pixels[..., 3] = np.rint(np.clip(ink, 0.0, 1.0) * 255.0).astype(np.uint8)
    return Image(pixels)
