"""The app's lights as plain values, and what falls from them on a surface.

The OpenGL Specification, version 2.1, section 2.14.1 (Lighting).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from glshim.model.arrays import Doubles

_COOL, _WARM = np.array((0.35, 0.45, 0.85)), np.array((1.0, 0.9, 0.6))
"""What greys turn to in `gooch`."""
_COOL_LIGHT = 0.455
"""Luminance of `_COOL`."""
_DARK = 0.2
"""Colours darker than that count as greyer than they are."""
Shade = tuple[float, float, float]
"""Red, green, blue; lights may be brighter than 1."""


@dataclass(frozen=True, slots=True)
class Light:
    """A GL_LIGHT that is on, as the driver holds it."""

    position: tuple[float, float, float, float]
    """Eye space, homogeneous: a direction towards it where w = 0."""
    ambient: Shade = (0.0, 0.0, 0.0)
    diffuse: Shade = (1.0, 1.0, 1.0)
    specular: Shade = (1.0, 1.0, 1.0)
    attenuation: tuple[float, float, float] = (1.0, 0.0, 0.0)
    """Constant, linear and quadratic; only where w is not 0."""
    spot_direction: tuple[float, float, float] = (0.0, 0.0, -1.0)
    """Eye space."""
    spot_cutoff: float = 180.0
    """Degrees; 180: it shines all around."""
    spot_exponent: float = 0.0


@dataclass(frozen=True, slots=True)
class Lighting:
    """All lights that are on, in the order of their numbers."""

    lights: tuple[Light, ...] = ()
    ambient: Shade = (0.2, 0.2, 0.2)
    """GL_LIGHT_MODEL_AMBIENT."""
    both_sides: bool = False
    """GL_LIGHT_MODEL_TWO_SIDE: each side is lit by the normal that looks its way."""

    @property
    def tint(self) -> Shade:
        """The colour of all light together on white, the brightest channel 1."""
        shades = [shade for light in self.lights for shade in (light.diffuse, light.ambient)]
        sums = map(sum, zip(self.ambient, *shades, strict=True))
        red, green, blue = (min(max(of, 0.0), 1.0) for of in sums)
        most = max(red, green, blue)
        return (red / most, green / most, blue / most) if most > 0.0 else (1.0, 1.0, 1.0)


class Materials(Enum):
    """What materials do during a draw."""

    STAY = "they are as before it"
    VARY = "they change, or begin to follow the current colour"
    SAID = "they change, and each change is told"
    SHADE = "their diffuse colours change alone"


@dataclass(frozen=True, slots=True)
class MaterialChange:
    """A glMaterial call about colours."""

    face: int
    """GL_FRONT, GL_BACK or GL_FRONT_AND_BACK."""
    parameter: int
    """GL_AMBIENT, GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE or another one."""
    colour: tuple[float, float, float, float]


def incoming(
    lights: Sequence[Light], points: Doubles, normals: Doubles
) -> Doubles:
    """(N, 3) the diffuse light that falls on points (N, 3) with unit normals (N, 3), eye space:
    the sum over lights of attenuation, spot light effect, n . l and diffuse colour."""
    found = np.zeros((len(points), 3))
    for light in lights:
        place = np.asarray(light.position)
        way = place[:3] - place[3] * points
        distance = np.linalg.norm(way, axis=1)
        way = way / np.maximum(distance, 1e-30)[:, None]
        share = np.ones(len(points))
        if place[3] != 0.0:
            constant, linear, quadratic = light.attenuation
            reach = distance / abs(place[3])
            share /= np.maximum(constant + linear * reach + quadratic * reach**2, 1e-30)
        if light.spot_cutoff <= 90.0:
            axis = np.asarray(light.spot_direction)
            along = -way @ (axis / max(float(np.linalg.norm(axis)), 1e-30))
            inside = along >= np.cos(np.radians(light.spot_cutoff))
            share *= np.where(inside, np.maximum(along, 1e-30) ** light.spot_exponent, 0.0)
        level = np.maximum((normals * way).sum(axis=1), 0.0)
        found += (share * level)[:, None] * np.asarray(light.diffuse)
    return found


def banded(level: Doubles, bands: int) -> Doubles:
    """Brightness 0..1 in flat bands of equal width, the darkest 0 and the brightest 1.

    A. Lake et al., "Stylized Rendering Techniques for Scalable Real-Time 3D Animation", NPAR 2000,
    section 3: hard shading, with more than their two shades."""
    return np.minimum(np.floor(bands * np.clip(level, 0.0, 1.0)), bands - 1.0) / (bands - 1.0)


def gooch(
    paint: Doubles,
    toward: Doubles,
    *,
    blue: float,
    yellow: float,
    alpha: float,
    beta: float,
    hue: float = 0.0,
) -> Doubles:
    """(N, 3) cool-to-warm tones of paints (N, 3), by n . l (N,): warm towards the light. hue: share
    of their own hue that is kept: strong paints get lighter and darker, greys turn to slate and
    cream. 0: the paper's blue and yellow.

    A. Gooch, B. Gooch, P. Shirley, E. Cohen, "A Non-Photorealistic Lighting Model for Automatic
    Technical Illustration", SIGGRAPH 1998, equations 1 to 4."""
    most, least = paint.max(axis=1, keepdims=True), paint.min(axis=1, keepdims=True)
    strong = (most - least) / np.maximum(most, _DARK)
    own = paint / np.maximum(most, 1e-3)
    slate = (1.0 - strong) * _COOL + strong * _COOL_LIGHT * own
    cream = (1.0 - strong) * _WARM + strong * own
    toward_cool = (1.0 - hue) * np.array((0.0, 0.0, 1.0)) + hue * slate
    toward_warm = (1.0 - hue) * np.array((1.0, 1.0, 0.0)) + hue * cream
    cool = np.minimum(blue * toward_cool + alpha * paint, 1.0)
    warm = np.minimum(yellow * toward_warm + beta * paint, 1.0)
    share = ((1.0 + toward) / 2.0)[:, None]
    return np.asarray(share * warm + (1.0 - share) * cool)
