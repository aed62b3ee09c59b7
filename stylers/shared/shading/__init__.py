"""Surfaces lit anew: normals and depths into the G-buffer first, light pixel by pixel after that.

T. Saito, T. Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990; P. Rideout,
"Silhouette Extraction", 2010, "The Spine Test", and the dragon.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from math import cos, isfinite, radians

import numpy as np

from glshim.geometry.crease.creases import Criterion
from glshim.model.lights import Light
from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.screen import SCREEN
from glshim.styling.values import Body, Layer, Uniform

UNDER = -1
"""The coat: lines go over it."""
MOST_LAMPS = 8
_CREASES = Criterion("either", radians(50.0), radians(1.0))
"""Light breaks where the app's normals do, or where triangles meet at an angle: a cube that came
without normals is not round."""
_NEAREST = State(depth="less", writes_depth=True, blend="off")
_OVER_ALL = State(depth="always", blend="off")
NEAR_ENOUGH = 16.0
"""Pixels for `screen_shader` over paint: where a large quad is bent, light is missed as a hole, and
what an app lays on a surface may well be lit with it."""
UPPER_LEFT = Light((-0.45, 0.65, 0.9, 0.0))
"""A light behind the viewer's left shoulder: it goes where the viewer goes."""


SEEN_NORMAL = glsl(__file__, "seen_normal")
"""GLSL of a fragment: the normal by which it is lit."""
_BUFFER = MeshShader(
    "surface buffer", glsl(__file__, "buffer.vert"), SEEN_NORMAL + glsl(__file__, "buffer.frag"),
    needs=(),
)  # fmt: skip


def screen_shader(
    name: str, fragment: str, *, lamps: bool = True, bent: float = 2.0
) -> MeshShader:
    """A shader that lights each pixel: a fragment text that follows ``pixel.glsl`` and, with lamps,
    ``lamps.glsl``. bent: pixels by which quads that are not flat may miss their triangles."""
    given = f"#define BENT {bent}\n" + glsl(__file__, "pixel", *(("lamps",) if lamps else ()))
    return MeshShader(name, SCREEN, given + fragment, needs=("app_colour", "gbuffer"))


def lit_passes(
    shader: MeshShader, lens: tuple[Body, ...], uniforms: Mapping[str, Uniform], tolerance: float
) -> Iterator[Pass]:
    """For bodies that are seen through one lens (`lenses`) the G-buffer, and a shader of
    `screen_shader` over the pixels of their window. tolerance: object units at which corners are
    one."""
    for gleams in (False, True):
        alike = tuple(body for body in lens if body.camera.gleams is gleams)
        if alike:
            yield Pass(
                alike, _BUFFER, "surface", state=_NEAREST, weld=Weld(tolerance, _CREASES),
                buffer=True, coat=UNDER, uniforms={"gleams": float(gleams)},
            )  # fmt: skip
    yield Pass(lens[:1], shader, "screen", state=_OVER_ALL, uniforms=uniforms, coat=UNDER)


def lenses(found: tuple[Body, ...]) -> list[tuple[Body, ...]]:
    """Bodies by all of their cameras but the modelview: of their places on the screen one lens
    gives back places in eye space."""
    alike: dict[object, list[Body]] = {}
    for body in found:
        camera = body.camera.affine()
        key = camera.projection.tobytes(), camera.viewport, camera.depth_range, camera.scissor
        alike.setdefault(key, []).append(body)
    return [tuple(some) for some in alike.values()]


def by_light(layer: Layer, shade_unlit: str) -> tuple[tuple[Body, ...], tuple[Body, ...]]:
    """The bodies that the app lit, and those of the others that are shaded, each parted by whether
    they gleam. shade_unlit: ``head``, ``off``, or ``auto``: where the app lit nothing, what has no
    textures; a wall with a light map has its light in them."""

    def some(*, lit: bool, textured: Collection[bool]) -> tuple[Body, ...]:
        found: tuple[Body, ...] = ()
        for gleams in (False, True):
            items = tuple(
                item for item in layer.items
                if (item[1].lit, item[1].gleams) == (lit, gleams) and item[1].textured in textured
            )  # fmt: skip
            found += replace(layer, items=items).bodies
        return found

    lit = some(lit=True, textured=(False, True))
    if shade_unlit == "off" or (shade_unlit == "auto" and layer.lighting is not None):
        return lit, ()
    return lit, some(lit=False, textured=(False,) if shade_unlit == "auto" else (False, True))


def lamp_uniforms(lights: tuple[Light, ...], lens: tuple[Body, ...]) -> dict[str, Uniform]:
    """Lights as ``lamps.glsl`` has them. Where an app multiplies its perspective onto the modelview
    nothing is known of eye space: the viewer's own light then."""
    camera = lens[0].camera
    known = camera.affine() is camera
    sound = [light for light in lights[:MOST_LAMPS] if all(map(isfinite, _numbers(light)))]
    if not known:
        sound = [Light((0.0, 0.0, 0.0, 0.0))]
    padded = sound + [Light((0.0, 0.0, 0.0, 0.0))] * (MOST_LAMPS - len(sound))
    return {
        "lamps": len(sound),
        "lamp_place": tuple(light.position for light in padded),
        "lamp_shade": tuple(light.diffuse for light in padded),
        "lamp_gleam": tuple(light.specular for light in padded),
        "lamp_fade": tuple(light.attenuation for light in padded),
        "lamp_beam": tuple(map(_beam, padded)),
        "lamp_focus": tuple(light.spot_exponent for light in padded),
    }


def _beam(light: Light) -> tuple[float, ...]:
    way = np.asarray(light.spot_direction)
    unit = way / max(float(np.linalg.norm(way)), 1e-30)
    edge = cos(radians(light.spot_cutoff)) if light.spot_cutoff <= 90.0 else -1.0
    return (*unit.tolist(), max(edge, 0.0) if light.spot_cutoff <= 90.0 else edge)


def _numbers(light: Light) -> tuple[float, ...]:
    return (
        *light.position, *light.diffuse, *light.specular, *light.attenuation,
        *light.spot_direction, light.spot_cutoff, light.spot_exponent,
    )  # fmt: skip
