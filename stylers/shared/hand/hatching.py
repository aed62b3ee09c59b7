"""Hatching by the light, held by the surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import floor, isfinite, radians

from glshim.geometry.crease.creases import Criterion
from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.values import Colour, Layer, Uniform

from ..shading import SEEN_NORMAL
from ..tones import grain

ON = -1
"""The coat: over the paper, under the lines."""
_CREASES = Criterion("either", radians(50.0), radians(1.0))
"""Light breaks where the app's normals do, or where triangles meet at an angle."""
_STATE = State(depth="lequal", blend="off", offset=(-1.0, -4.0))
_UPPER_LEFT = (-0.45, 0.7, 0.55, 0.0)
"""Where light comes from that an app has not placed."""


@dataclass(frozen=True, slots=True)
class Hatching:
    """How dark places are hatched."""

    ink: Colour
    darkness: float = 1.0
    """0..1."""
    apart: float = 6.0
    """Pixels between strokes, about."""
    jitter: float = 3.0
    """Pixels by which strokes stray."""
    by_picture: float = 0.5
    """Share of the darkness that the program's picture says, its own light and paint; the rest is
    GL_LIGHT0 on white."""
    boil: float = 0.0
    """New jitter a second."""
    tolerance: float = 0.0
    soft: float = 0.0
    """0..1: strokes of a soft lead, which the tooth of the paper holds, instead of ink."""
    coloured: float = 0.0
    """Share of the program's own colours in the ink."""


@cache
def _shader() -> MeshShader:
    vertex, fragment = (glsl(__file__, f"hatch.{stage}") for stage in ("vert", "frag"))
    return MeshShader("hatch", vertex, SEEN_NORMAL + fragment, needs=("app_colour", "rest"))


def hatched(look: Hatching, layer: Layer) -> Iterator[Pass]:
    """One pass over all surfaces."""
    if look.darkness <= 0.0:
        return
    placed = any(layer.light[:3]) and all(map(isfinite, layer.light))
    light = layer.light if placed and layer.light != (0.0, 0.0, 1.0, 0.0) else _UPPER_LEFT
    uniforms: dict[str, Uniform] = {
        "lamp": light, "ink": look.ink, "apart": look.apart, "darkness": look.darkness,
        "by_picture": look.by_picture, "jitter": look.jitter,
        "soft": look.soft, "coloured": look.coloured,
        "jitter_seed": float(floor(layer.time * look.boil) % 61),
    }  # fmt: skip
    yield Pass(
        layer.bodies, _shader(), "surface", state=_STATE, uniforms=uniforms, image=grain(),
        weld=Weld(look.tolerance, _CREASES), coat=ON,
    )  # fmt: skip
