"""Paint whose diffuse materials alone change within a list: the fixed function under lamps from all
sides, whose light is the same on every surface, but for a twelfth.

Between glBegin and glEnd of a list nobody hears the calls when it is drawn, so that the ambient
material cannot be kept equal (`flood`).
"""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from math import hypot

from glshim.driver.ask import integer, is_enabled, of_light, reals
from glshim.driver.functions import gl
from glshim.model.lights import MaterialChange
from glshim.outputs.gl.device.matrices import matrices_kept
from glshim.spec.constants import (
    GL_AMBIENT,
    GL_DIFFUSE,
    GL_LIGHT0,
    GL_LIGHT_MODEL_AMBIENT,
    GL_MATRIX_MODE,
    GL_MODELVIEW,
    GL_NORMALIZE,
    GL_POSITION,
    GL_SPECULAR,
    GL_SPOT_CUTOFF,
)

_LAMPS = (
    (-0.068, -0.590, 0.314), (0.361, -0.327, -0.113), (-0.455, 0.033, 0.180),
    (0.031, 0.216, 0.407), (0.004, -0.113, -0.131), (0.392, 0.466, 0.172),
    (0.186, 0.128, -0.430), (-0.452, 0.186, -0.396),
)  # fmt: skip
"""Directions to lamps as long as they are bright: as many as every driver has. What falls on a
surface is between 0.91 and 1.09 whichever way that looks (found by a search; their sum is zero)."""
_BLACK = (0.0, 0.0, 0.0, 1.0)
_COLOURS = (GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR)


class AllAround:
    """Of one draw. Make it before that, outside primitives."""

    def __init__(self) -> None:
        self._lights = [GL_LIGHT0 + k for k in range(len(_LAMPS))]
        self._on = [light for light in self._lights if is_enabled(light)]
        self._normalises = is_enabled(GL_NORMALIZE)
        self._ambient = reals(GL_LIGHT_MODEL_AMBIENT, 4)
        names = (*_COLOURS, GL_POSITION, GL_SPOT_CUTOFF)
        self._own = {
            (light, name): of_light(light, name) for light in self._lights for name in names
        }

    def begin(self) -> None:
        """Light it, outside primitives."""
        said: dict[tuple[int, int], tuple[float, ...]] = {}
        for light, way in zip(self._lights, _LAMPS, strict=True):
            bright = hypot(*way)
            said[light, GL_AMBIENT] = said[light, GL_SPECULAR] = _BLACK
            said[light, GL_DIFFUSE] = (bright, bright, bright, 1.0)
            said[light, GL_POSITION] = (*way, 0.0)
            said[light, GL_SPOT_CUTOFF] = (180.0,)
        _say(said)
        for light in self._lights:
            gl.glEnable(light)
        gl.glEnable(GL_NORMALIZE)
        gl.glLightModelfv(GL_LIGHT_MODEL_AMBIENT, _floats(_BLACK))

    def say(self, change: MaterialChange) -> None:
        """It shows by itself."""

    def end(self) -> None:
        """After the draw: all is the app's again."""
        gl.glLightModelfv(GL_LIGHT_MODEL_AMBIENT, _floats(self._ambient))
        if not self._normalises:
            gl.glDisable(GL_NORMALIZE)
        for light in self._lights:
            if light not in self._on:
                gl.glDisable(light)
        _say(self._own)


def _say(values: Mapping[tuple[int, int], tuple[float, ...]]) -> None:
    """Of lights; positions in eye space."""
    mode = integer(GL_MATRIX_MODE)
    with matrices_kept():
        gl.glMatrixMode(GL_MODELVIEW)
        gl.glLoadIdentity()
        for (light, name), value in values.items():
            gl.glLightfv(light, name, _floats(value))
    gl.glMatrixMode(mode)


def _floats(values: tuple[float, ...]) -> ctypes.Array[ctypes.c_float]:
    return (ctypes.c_float * len(values))(*values)
