"""Dimensions: arrows along straight edges, and how long those are."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib.resources import files

import numpy as np

from glshim.styling.pictures import Image
from glshim.styling.protocol import Colour, Layer, Lines, Medium, Shader
from stylers.hand import Hand, features, pattern, uniforms

_CHARACTERS = "0123456789."
_WIDE, _HIGH = 28, 44
"""Texels of a character: four times the pixels that it is drawn with."""
LEAST = 44.0
"""Pixels of an edge that has a dimension."""


@cache
def _shader() -> Shader:
    raskar, here = files("stylers.raskar"), files(__package__)
    stroke, trace = ((raskar / f"{name}.glsl").read_text("utf-8") for name in ("stroke", "trace"))
    common, vertex, fragment = (
        (here / f"{name}.glsl").read_text("utf-8")
        for name in ("dimension", "dimension.vert", "dimension.frag")
    )
    return Shader(
        "dimension", stroke + trace + common + vertex, stroke + common + fragment, vertices=4
    )


@cache
def characters() -> Image:
    """Digits and the point side by side, white."""
    from PIL import Image as Pillow
    from PIL import ImageDraw, ImageFont

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
    drawn = {
        **uniforms(hand), "frequency": frequency, "least": LEAST, "rule": ink, "opacity": 0.85,
    }  # fmt: skip
    medium = Medium(_shader(), drawn, characters(), pattern(hand))
    yield Lines(layer.bodies, features(hand), medium, coat=coat)
