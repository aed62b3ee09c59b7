"""Dimensions: arrows along straight edges, and how long those are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
from PIL import Image as Pillow
from PIL import ImageDraw, ImageFont

from glshim.styling.glsl import glsl
from glshim.styling.lines import Shader
from glshim.styling.media.ink import STROKE, TRACE
from glshim.styling.pictures import Image
from glshim.styling.protocol import Colour, Layer, Lines

from ..shared.hand import Hand, features

_CHARACTERS = "0123456789."
_WIDE, _HIGH = 28, 44
"""Texels of a character: four times the pixels that it is drawn with."""
LEAST = 44.0
"""Pixels of an edge that has a dimension."""


_SHADER = Shader(
    "dimension", TRACE + glsl(__file__, "dimension", "dimension.vert"),
    STROKE + glsl(__file__, "dimension", "dimension.frag"), vertices=4,
)  # fmt: skip


@cache
def characters() -> Image:
    """Digits and the point side by side, white."""
    sheet = Pillow.new("L", (_WIDE * len(_CHARACTERS), _HIGH))
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(40)
    for number, text in enumerate(_CHARACTERS):
        draw.text(((number + 0.5) * _WIDE, 0.9 * _HIGH), text, 255, font, anchor="ms")
    pixels = np.full((_HIGH, sheet.width, 4), 255, np.uint8)
    pixels[..., 3] = np.asarray(sheet)
    return Image(pixels)


def dimensions(
    hand: Hand, layer: Layer, *, frequency: float, ink: Colour, coat: int
) -> Iterator[Lines]:
    """Of the edges that the hand draws a share, with their lengths in the units of eye space: those
    of the program's world."""
    medium = replace(
        hand.medium,
        shader=_SHADER,
        uniforms={
            **hand.medium.uniforms, "frequency": frequency, "least": LEAST, "rule": ink,
            "opacity": 0.85,
        },
        image=characters(),
    )  # fmt: skip
    yield Lines(layer.bodies, features(hand), medium, coat=coat)
