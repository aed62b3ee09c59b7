"""Surfaces painted in dabs of the program's own colours."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from math import floor

from glshim.styling.passes import MeshShader, Pass, State
from glshim.styling.protocol import Colour, Layer, Uniform
from stylers.edge_mesh.tones import grain
from stylers.hand.paper import UNDER, windows

_STATE = State(depth="always", blend="off")


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


@cache
def _shader() -> MeshShader:
    tones, here = files("stylers.edge_mesh"), files(__package__)
    vertex, tone = ((tones / f"{name}.glsl").read_text("utf-8") for name in ("recede.vert", "tone"))
    return MeshShader("paint", vertex, tone + (here / "paint.frag.glsl").read_text("utf-8"))


def painted(paint: Paint, layer: Layer) -> Iterator[Pass]:
    """One pass over every window. A layer over another lies on that one's paper, but for the
    surfaces of a view of its own."""
    if layer.over and not layer.fresh:
        return
    tick = floor(layer.time * paint.boil) % 61
    uniforms: dict[str, Uniform] = {
        "paper": paint.paper, "behind": int(not layer.over), "ink": (0.0, 0.0, 0.0),
        "tint": paint.tint, "dab": paint.dab, "dab_seed": float(tick + 61 * (paint.seed % 61)),
    }  # fmt: skip
    yield Pass(
        _shader(), windows(layer), "screen", state=_STATE, uniforms=uniforms, image=grain(),
        sheet=UNDER,
    )  # fmt: skip
