"""Soft tones: graphite, or crayon, rubbed into the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache

from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, Weld
from glshim.styling.protocol import Colour, Layer

from ..shared.hand.paper import laid
from ..shared.tones import tone_shader


@dataclass(frozen=True, slots=True)
class Rubbing:
    """Paper, and what is rubbed into it."""

    paper: Colour
    ink: Colour
    strength: float = 0.7
    """Of the tone, 0..1; 0: bare paper."""
    coloured: float = 0.0
    """Share of the program's own colours in it, 0..1."""
    weld: Weld = field(default_factory=Weld)
    """Of the meshes that hold it."""


@cache
def _shader() -> MeshShader:
    return tone_shader("rubbing", glsl(__file__, "rubbing.frag"), on_object=True)


def rubbed(look: Rubbing, layer: Layer) -> Iterator[Pass]:
    """Paper with tones rubbed into it."""
    yield from laid(_shader(), layer, {
        "paper": look.paper, "ink": look.ink, "strength": look.strength, "coloured": look.coloured,
    }, look.weld)  # fmt: skip
