"""Surfaces painted in dabs of the program's own colours."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import floor

from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, Weld
from glshim.styling.protocol import Colour, Layer

from ..shared.hand.paper import laid
from ..shared.tones import tone_shader


@dataclass(frozen=True, slots=True)
class Paint:
    """What lies under the strokes."""

    paper: Colour
    tint: float = 1.0
    """How much the paint covers, 0..1; 0: bare paper."""
    dab: float = 14.0
    """Pixels of a dab's length, about."""
    boil: float = 0.0
    """Times a second that the dabs are laid anew."""
    seed: int = 0
    tolerance: float = 0.0
    """Object units at which corners are one."""


@cache
def _shader() -> MeshShader:
    return tone_shader("paint", glsl(__file__, "paint.frag"), on_object=True)


def painted(paint: Paint, layer: Layer) -> Iterator[Pass]:
    """Paper with dabs on it."""
    tick = floor(layer.time * paint.boil) % 61
    yield from laid(_shader(), layer, {
        "paper": paint.paper, "ink": (0.0, 0.0, 0.0), "tint": paint.tint, "dab": paint.dab,
        "dab_seed": float(tick + 61 * (paint.seed % 61)),
    }, Weld(paint.tolerance))  # fmt: skip
