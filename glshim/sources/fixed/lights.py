"""The app's lights, read from the driver."""

from __future__ import annotations

import ctypes

from glshim.model.lights import Light, Lighting, Shade
from glshim.spec.driver import gl

_FIRST, _LEAST = 0x4000, 8
"""GL_LIGHT0, and the lights that every driver has; few apps use one beyond them."""
_AMBIENT, _DIFFUSE, _SPECULAR, _POSITION = 0x1200, 0x1201, 0x1202, 0x1203
_SPOT_DIRECTION, _SPOT_EXPONENT, _SPOT_CUTOFF, _ATTENUATION = 0x1204, 0x1205, 0x1206, 0x1207
_MODEL_AMBIENT = 0x0B53


def lighting() -> Lighting:
    """The lights that are on, as the driver holds them now: positions and directions in eye space.
    Outside glBegin/glEnd."""
    numbers = [_FIRST + k for k in range(_LEAST) if gl.glIsEnabled(_FIRST + k)]
    values = (ctypes.c_float * 4)()
    gl.glGetFloatv(_MODEL_AMBIENT, ctypes.addressof(values))
    return Lighting(tuple(map(_light, numbers)), (values[0], values[1], values[2]))


def _light(number: int) -> Light:
    values = (ctypes.c_float * 4)()

    def ask(name: int) -> tuple[float, float, float, float]:
        gl.glGetLightfv(number, name, ctypes.addressof(values))
        return values[0], values[1], values[2], values[3]

    def shade(name: int) -> Shade:
        return ask(name)[:3]

    constant, linear, quadratic = (ask(_ATTENUATION + k)[0] for k in range(3))
    return Light(
        ask(_POSITION), shade(_AMBIENT), shade(_DIFFUSE), shade(_SPECULAR),
        (constant, linear, quadratic), shade(_SPOT_DIRECTION), ask(_SPOT_CUTOFF)[0],
        ask(_SPOT_EXPONENT)[0],
    )  # fmt: skip
