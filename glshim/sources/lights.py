"""The app's lights, read from the driver."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import partial

from glshim.driver.ask import integer, is_enabled, of_light, reals
from glshim.driver.functions import quick
from glshim.model.lights import Light, Lighting
from glshim.spec.constants import (
    GL_AMBIENT,
    GL_CONSTANT_ATTENUATION,
    GL_DIFFUSE,
    GL_LIGHT0,
    GL_LIGHT_MODEL_AMBIENT,
    GL_LIGHT_MODEL_TWO_SIDE,
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
    both_sides = bool(integer(GL_LIGHT_MODEL_TWO_SIDE))
    return Lighting(tuple(map(_light, numbers)), (red, green, blue), both_sides)


class LampReader:
    """Tells draws apart by the lights that are on: which, where, and of what colour."""

    def __init__(self) -> None:
        self._on = (ctypes.c_int32 * (_LEAST + 1))()
        """Which are on, and whether both sides are lit."""
        self._values = [(ctypes.c_float * 8)() for _ in range(_LEAST)]
        self._switches: list[Callable[[], None]] = []
        self._lamps: list[list[Callable[[], None]]] = []

    def read(self) -> bytes:
        """Equal for equal ones. Outside glBegin/glEnd; the first time in a context of the fixed
        function."""
        for get in self._switches or self._prepare():
            get()
        found = [bytes(self._on)]
        for on, gets, values in zip(self._on, self._lamps, self._values, strict=False):
            if on:
                for get in gets:
                    get()
                found.append(bytes(values))
        return b"".join(found)

    def _prepare(self) -> list[Callable[[], None]]:
        integers, of_lights = quick("glGetIntegerv"), quick("glGetLightfv")
        for k, values in enumerate(self._values):
            at = ctypes.c_void_p(ctypes.addressof(self._on) + 4 * k)
            self._switches.append(partial(integers, GL_LIGHT0 + k, at))
            places = [ctypes.c_void_p(ctypes.addressof(values) + 16 * row) for row in (0, 1)]
            self._lamps.append(
                [partial(of_lights, GL_LIGHT0 + k, name, place)
                 for name, place in zip((GL_POSITION, GL_DIFFUSE), places, strict=True)]
            )  # fmt: skip
        at = ctypes.c_void_p(ctypes.addressof(self._on) + 4 * _LEAST)
        self._switches.append(partial(integers, GL_LIGHT_MODEL_TWO_SIDE, at))
        return self._switches


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
