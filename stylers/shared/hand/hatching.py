"""Hatching by the light, held by the surfaces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import groupby
from math import floor, isfinite, radians

from glshim.geometry.crease.creases import Criterion
from glshim.model.lights import Light
from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.values import Colour, Layer, Uniform

from ..shading import FOG, SEEN_NORMAL, Lit, by_light, fog_uniforms, lamp_uniforms
from ..tones import grain

ON = -1
"""The coat: over the paper, under the lines."""
CREASES = Criterion("angle", radians(50.0), radians(1.0))
"""Light breaks where triangles meet at an angle. Facets of what is round, flat as an app may shade
them, have the mean of their normals: a hand does not hatch facet by facet."""
_STATE = State(depth="lequal", blend="off", offset=(-1.0, -4.0))
_UPPER_LEFT = Light((-0.45, 0.7, 0.55, 0.0))
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
    its lights on white."""
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
    text = SEEN_NORMAL + FOG + fragment
    return MeshShader("hatch", vertex, text, needs=("app_colour", "rest"))


def hatched(look: Hatching, layer: Layer) -> Iterator[Pass]:
    """Passes over all surfaces, by the lights that each was drawn under."""
    if look.darkness <= 0.0:
        return
    lit, unlit = by_light(layer, "head")
    for some in lit:
        yield from _hatched(look, layer, some)
    if layer.lighting is None:  # the program lights nothing, or the style did not ask
        yield from _hatched(look, layer, Lit((Light(layer.light),), unlit))
    else:
        yield from _hatched(look, layer, Lit((), unlit))


def _hatched(look: Hatching, layer: Layer, some: Lit) -> Iterator[Pass]:
    """What is lit alike; without lamps it is as dark as its picture."""
    if not some.bodies:
        return
    lights = [_placed(light) for light in some.lights if max(light.diffuse) > 0.0]
    lamps = lamp_uniforms(tuple(lights), some.bodies)
    uniforms: dict[str, Uniform] = {
        **{name: lamps[name] for name in ("lamps", "lamp_place", "lamp_shade")},
        "ink": look.ink, "apart": look.apart, "darkness": look.darkness,
        "by_picture": look.by_picture if lights else 1.0, "jitter": look.jitter,
        "soft": look.soft, "coloured": look.coloured,
        "jitter_seed": float(floor(layer.time * look.boil) % 61),
    }  # fmt: skip
    for _, bodies in groupby(some.bodies, lambda body: body.camera.fog):
        seen = tuple(bodies)
        yield Pass(
            seen, _shader(), "surface", state=_STATE, image=grain(),
            uniforms={**uniforms, **fog_uniforms(seen[0].camera)},
            weld=Weld(look.tolerance, CREASES), coat=ON,
        )  # fmt: skip


def _placed(light: Light) -> Light:
    """A light that shines from the viewer, as GL's own do until an app places them, would leave
    nothing dark."""
    position = light.position
    placed = any(position[:3]) and all(map(isfinite, position))
    return light if placed and position != (0.0, 0.0, 1.0, 0.0) else _UPPER_LEFT
