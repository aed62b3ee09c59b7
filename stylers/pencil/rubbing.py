"""Soft tones: graphite, or crayon, rubbed into the paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from glshim.styling.passes import MeshShader, Pass, State
from glshim.styling.protocol import Colour, Layer, Uniform
from stylers.edge_mesh.tones import grain
from stylers.hand.paper import UNDER, windows

_STATE = State(depth="always", blend="off")


@dataclass(frozen=True, slots=True)
class Rubbing:
    """Paper, and what is rubbed into it."""

    paper: Colour
    ink: Colour
    strength: float = 0.7
    """Of the tone, 0..1; 0: bare paper."""
    coloured: float = 0.0
    """Share of the program's own colours in it, 0..1."""


@cache
def _shader() -> MeshShader:
    tones, here = files("stylers.edge_mesh"), files(__package__)
    vertex, tone = ((tones / f"{name}.glsl").read_text("utf-8") for name in ("recede.vert", "tone"))
    return MeshShader("rubbing", vertex, tone + (here / "rubbing.frag.glsl").read_text("utf-8"))


def rubbed(look: Rubbing, layer: Layer) -> Iterator[Pass]:
    """One pass over every window. A layer over another lies on that one's paper, but for the
    surfaces of a view of its own."""
    if layer.over and not layer.fresh:
        return
    uniforms: dict[str, Uniform] = {
        "paper": look.paper, "behind": int(not layer.over), "ink": look.ink,
        "strength": look.strength, "coloured": look.coloured,
    }  # fmt: skip
    yield Pass(
        _shader(), windows(layer), "screen", state=_STATE, uniforms=uniforms, image=grain(),
        sheet=UNDER,
    )  # fmt: skip
