"""Surfaces lit anew: normals and depths into the G-buffer first, light pixel by pixel after that.

T. Saito, T. Takahashi, "Comprehensible Rendering of 3-D Shapes", SIGGRAPH 1990; P. Rideout,
"Silhouette Extraction", 2010, "The Spine Test", and the dragon.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import cos, isfinite, radians
from typing import NamedTuple

import numpy as np

from glshim.geometry.crease.creases import Criterion
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.model.fog import Fog
from glshim.model.lights import Light, Lighting
from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.screen import SCREEN
from glshim.styling.values import Body, Colour, Layer, Uniform

UNDER = -1
"""The coat: lines go over it."""
MOST_LAMPS = 8
MOST_LIGHTINGS = 8
"""Of a layer: each costs a pass over the window; what comes after them is lit as the last."""
_CREASES = Criterion("either", radians(50.0), radians(1.0))
"""Light breaks where the app's normals do, or where triangles meet at an angle: a cube that came
without normals is not round."""
_ALIKE = 0.1
"""Of a channel: fog is meant to be the background that looks like that."""
_NEAREST = State(depth="less", writes_depth=True, blend="off")
_OVER_ALL = State(depth="always", blend="off")
NEAR_ENOUGH = 16.0
"""Pixels for `screen_shader` over paint: where a large quad is bent, light is missed as a hole, and
what an app lays on a surface may well be lit with it."""
UNLIT = 0.85
"""Brightness of the darkest tone of what an app draws in plain colours, without any light: they are
meant as they are."""
UPPER_LEFT = Light((-0.45, 0.65, 0.9, 0.0))
"""A light behind the viewer's left shoulder: it goes where the viewer goes."""


SEEN_NORMAL = glsl(__file__, "seen_normal")
"""GLSL of a fragment: the normal by which it is lit."""
FOG = glsl(__file__, "fog")
"""GLSL of the app's fog; its uniforms are `fog_uniforms`."""
_BUFFER = MeshShader(
    "surface buffer", glsl(__file__, "buffer.vert"), SEEN_NORMAL + glsl(__file__, "buffer.frag"),
    needs=(),
)  # fmt: skip


def screen_shader(
    name: str, fragment: str, *, lamps: bool = True, bent: float = 2.0
) -> MeshShader:
    """A shader that lights each pixel: a fragment text that follows ``pixel.glsl`` and, with lamps,
    ``lamps.glsl``. bent: pixels by which quads that are not flat may miss their triangles."""
    given = f"#define BENT {bent}\n" + FOG + glsl(__file__, "pixel", *(("lamps",) if lamps else ()))
    return MeshShader(name, SCREEN, given + fragment, needs=("app_colour", "gbuffer"))


def lit_passes(
    shader: MeshShader, lens: tuple[Body, ...], uniforms: Mapping[str, Uniform], tolerance: float,
    *, both_sides: bool = True, paper: Paper | None = None,
) -> Iterator[Pass]:
    """For bodies that are seen through one lens (`lenses`) the G-buffer, and a shader of
    `screen_shader` over the pixels of their window. tolerance: object units at which corners are
    one; both_sides: whether normals that look away from the viewer are turned for the light, too;
    paper: what replaces the app's background, of which fog may be."""
    for gleams in (False, True):
        alike = tuple(body for body in lens if body.camera.gleams is gleams)
        if alike:
            yield Pass(
                alike, _BUFFER, "surface", state=_NEAREST, weld=Weld(tolerance, _CREASES),
                buffer=True, coat=UNDER,
                uniforms={"gleams": float(gleams), "both_sides": float(both_sides)},
            )  # fmt: skip
    uniforms = {**uniforms, **fog_uniforms(lens[0].camera, paper)}
    yield Pass(lens[:1], shader, "screen", state=_OVER_ALL, uniforms=uniforms, coat=UNDER)


def fog_uniforms(camera: Camera, paper: Paper | None = None) -> dict[str, Uniform]:
    """Fog as ``fog.glsl`` has it. paper: what replaces the app's background."""
    fog = camera.fog if camera.affine() is camera else None
    if fog is None:
        nothing = (0.0, 0.0, 0.0)
        return {"fog": 0, "fog_terms": nothing, "fog_colour": nothing, "fog_seen": nothing}
    seen = fog.colour
    if paper is not None and np.abs(np.subtract(seen, paper.over)).max() < _ALIKE:
        seen = paper.colour
    return {
        "fog": int(fog.mode), "fog_terms": (fog.density, fog.start, fog.end),
        "fog_colour": fog.colour, "fog_seen": seen,
    }  # fmt: skip


def lenses(found: tuple[Body, ...]) -> list[tuple[Body, ...]]:
    """Bodies by all of their cameras but the modelview, and by fog: of their places on the screen
    one lens gives back places in eye space."""
    alike: dict[object, list[Body]] = {}
    for body in found:
        camera = body.camera.affine()
        fog = camera.fog if camera is body.camera else None  # else nothing is known of eye space
        key = camera.projection.tobytes(), camera.viewport, camera.depth_range, camera.scissor, fog
        alike.setdefault(key, []).append(body)
    return [tuple(some) for some in alike.values()]


class Paper(NamedTuple):
    """What replaces the app's background."""

    colour: Colour
    over: Colour
    """The app's own."""


def paper_of(layer: Layer, colour: str | Colour) -> Paper | None:
    """Of an option ``paper`` where it lies behind a layer; None: the background is the app's."""
    if isinstance(colour, str) or not layer.backed:
        return None
    return Paper(colour, layer.own_background)


class Lit(NamedTuple):
    """Bodies that the app lit alike."""

    lights: tuple[Light, ...]
    bodies: tuple[Body, ...]
    both_sides: bool = True
    """GL_LIGHT_MODEL_TWO_SIDE; else the app lights the side that a normal looks to."""
    tint: Colour = (1.0, 1.0, 1.0)
    """Of the light."""


def by_light(layer: Layer, shade_unlit: str) -> tuple[list[Lit], tuple[Body, ...]]:
    """The bodies that the app lit, by the lights that shone when they were drawn, and those of the
    others that are shaded, each parted by whether they gleam, and by fog. shade_unlit: ``head``,
    ``off``, or ``auto``: where the app lit nothing, what has no textures; a wall with a light map
    has its light in them."""
    lit: dict[Lighting | None, list[tuple[PolygonBatch, Camera]]] = {}
    for item in layer.items:
        if item[1].lit:
            lighting = item[1].lighting or layer.lighting
            if lighting not in lit and len(lit) == MOST_LIGHTINGS:
                lighting = next(reversed(lit))
            lit.setdefault(lighting, []).append(item)
    found = [
        Lit(one.lights, _alike(layer, items), one.both_sides, one.tint)
        for one, items in ((each or Lighting(), items) for each, items in lit.items())
    ]
    if shade_unlit == "off" or (shade_unlit == "auto" and layer.lighting is not None):
        return found, ()
    plain = shade_unlit != "auto"
    unlit = [item for item in layer.items if not item[1].lit and (plain or not item[1].textured)]
    return found, _alike(layer, unlit)


def by_tint(lit: Iterable[Lit]) -> Iterator[Lit]:
    """The same, for a style with a light of its own: by the colour of the app's alone."""
    alike: dict[Colour, tuple[Body, ...]] = {}
    for some in lit:
        alike[some.tint] = alike.get(some.tint, ()) + some.bodies
    for tint, bodies in alike.items():
        yield Lit((UPPER_LEFT,), bodies, tint=tint)


def all_of(lit: Iterable[Lit]) -> tuple[Body, ...]:
    """Their bodies, whatever lights them."""
    return tuple(body for some in lit for body in some.bodies)


def _alike(layer: Layer, items: Sequence[tuple[PolygonBatch, Camera]]) -> tuple[Body, ...]:
    parts: dict[tuple[bool, Fog | None], list[tuple[PolygonBatch, Camera]]] = {}
    for item in items:
        parts.setdefault((item[1].gleams, item[1].fog), []).append(item)
    order = sorted(parts, key=lambda part: part[0])
    return tuple(body for part in order for body in replace(layer, items=tuple(parts[part])).bodies)


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
