"""Paint whose materials change within a draw: the fixed function under ambient light alone.

A program of ours reads one material a draw. Between glBegin and glEnd, and in display lists, the
app may change materials from vertex to vertex, or turn on that they follow its colours; the fixed
function keeps up. White light from everywhere shows what the ambient material is: the app's diffuse
one, which most calls set along with it.
"""

from __future__ import annotations

import ctypes

from glshim.driver.ask import is_enabled, of_material, reals
from glshim.driver.functions import gl
from glshim.model.lights import MaterialChange
from glshim.spec.constants import (
    GL_AMBIENT,
    GL_BACK,
    GL_COLOR_MATERIAL,
    GL_DIFFUSE,
    GL_FRONT,
    GL_FRONT_AND_BACK,
    GL_LIGHT0,
    GL_LIGHT_MODEL_AMBIENT,
)

_LIGHTS = 8
"""That every driver has."""
_FACES = (GL_FRONT, GL_BACK)
Shade = tuple[float, ...]
"""Red, green, blue, alpha."""


class Flood:
    """Of one draw. Make it before that, outside primitives."""

    def __init__(self, *, mirrors: bool) -> None:
        """mirrors: every change of a diffuse material is said (`say`), and made the ambient one,
        too; else the app's calls do that by themselves."""
        self._on = [GL_LIGHT0 + k for k in range(_LIGHTS) if is_enabled(GL_LIGHT0 + k)]
        self._light = reals(GL_LIGHT_MODEL_AMBIENT, 4)
        self._diffuse: dict[int, Shade] = {}
        self._ambient: dict[int, Shade] = {}
        """The app's, by face; empty where nothing is mirrored."""
        if mirrors and not is_enabled(GL_COLOR_MATERIAL):
            self._diffuse = {face: of_material(face, GL_DIFFUSE) for face in _FACES}
            self._ambient = {face: of_material(face, GL_AMBIENT) for face in _FACES}

    def begin(self) -> None:
        """Light it, outside primitives."""
        for light in self._on:
            gl.glDisable(light)
        gl.glLightModelfv(GL_LIGHT_MODEL_AMBIENT, _four((1.0, 1.0, 1.0, 1.0)))
        for face, shade in self._diffuse.items():
            gl.glMaterialfv(face, GL_AMBIENT, _four(shade))

    def say(self, change: MaterialChange) -> None:
        """The app has changed a material inside the primitive."""
        for face in _FACES if change.face == GL_FRONT_AND_BACK else (change.face,):
            if face not in self._diffuse:
                continue
            if change.parameter != GL_DIFFUSE:
                self._ambient[face] = change.colour
            if change.parameter != GL_AMBIENT:
                self._diffuse[face] = change.colour
            gl.glMaterialfv(face, GL_AMBIENT, _four(self._diffuse[face]))

    def end(self) -> None:
        """After the draw: all is the app's again."""
        for face, shade in self._ambient.items():
            gl.glMaterialfv(face, GL_AMBIENT, _four(shade))
        gl.glLightModelfv(GL_LIGHT_MODEL_AMBIENT, _four(self._light))
        for light in self._on:
            gl.glEnable(light)


def _four(shade: Shade) -> ctypes.Array[ctypes.c_float]:
    return (ctypes.c_float * 4)(*shade)
