"""Paper under everything."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache

from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, Weld
from glshim.styling.protocol import Colour, Layer
from glshim.styling.values import Uniform

from ..tones import over_windows, tone_shader

_UNDER = -2
"""The coat: hatching and strokes go over it."""


@dataclass(frozen=True, slots=True)
class Paper:
    """What everything is drawn on."""

    colour: Colour
    tint: float = 0.0
    """Of the program's own colours on its surfaces, 0..1."""
    shade: float = 0.0
    """Of its brightness."""
    tooth: float = 1.0
    """Of the paper's grain."""
    grid: float = 0.0
    """Pixels from line to line of printed paper; 0: plain."""
    rule: Colour = (0.5, 0.5, 0.5)
    """Colour of these lines."""


@cache
def _shader() -> MeshShader:
    return tone_shader("paper", glsl(__file__, "under.frag"))


def under(paper: Paper, layer: Layer) -> Iterator[Pass]:
    """Paper under everything."""
    yield from laid(_shader(), layer, {
        "paper": paper.colour, "ink": (0.0, 0.0, 0.0), "tint": paper.tint, "shade": paper.shade,
        "grid": paper.grid, "tooth": paper.tooth, "rule": paper.rule,
    })  # fmt: skip


def laid(
    shader: MeshShader, layer: Layer, uniforms: Mapping[str, Uniform], weld: Weld | None = None
) -> Iterator[Pass]:
    """A `tone_shader` over every window, under all that is drawn by hand. A layer over another lies
    on that one's paper, but for the surfaces of a view of its own. weld: of meshes that hold
    patterns."""
    yield from over_windows(shader, layer, uniforms, _UNDER, weld=weld)
