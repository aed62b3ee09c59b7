"""The app's lights, read from the driver."""

from __future__ import annotations

from functools import partial

from glshim.driver.ask import is_enabled, of_light, reals
from glshim.model.lights import Light, Lighting
from glshim.spec.constants import (
    GL_AMBIENT,
    GL_CONSTANT_ATTENUATION,
    GL_DIFFUSE,
    GL_LIGHT0,
    GL_LIGHT_MODEL_AMBIENT,
    GL_LINEAR_ATTENUATION,
    GL_POSITION,
    GL_QUADRATIC_ATTENUATION,
    GL_SPECULAR,
    GL_SPOT_CUTOFF,
    GL_SPOT_DIRECTION,
    GL_SPOT_EXPONENT,
)

_LEAST = 8
"""The lights that every driver has; few apps use one beyond them."""


def light() -> tuple[float, float, float, float]:
    """Where GL_LIGHT0 is in eye space, homogeneous: a direction towards it where w = 0. It stays
    there when lighting is off."""
    return of_light(GL_LIGHT0, GL_POSITION)


def lighting() -> Lighting:
    """The lights that are on, as the driver holds them now: positions and directions in eye space.
    Outside glBegin/glEnd."""
    numbers = [GL_LIGHT0 + k for k in range(_LEAST) if is_enabled(GL_LIGHT0 + k)]
    red, green, blue, _ = reals(GL_LIGHT_MODEL_AMBIENT, 4)
    return Lighting(tuple(map(_light, numbers)), (red, green, blue))


def _light(number: int) -> Light:
    ask = partial(of_light, number)
    return Light(
        ask(GL_POSITION), ask(GL_AMBIENT)[:3], ask(GL_DIFFUSE)[:3], ask(GL_SPECULAR)[:3],
        (
            ask(GL_CONSTANT_ATTENUATION)[0], ask(GL_LINEAR_ATTENUATION)[0],
            ask(GL_QUADRATIC_ATTENUATION)[0],
        ),
        ask(GL_SPOT_DIRECTION)[:3], ask(GL_SPOT_CUTOFF)[0], ask(GL_SPOT_EXPONENT)[0],
    )  # fmt: skip
