"""The app's polygons in its own paints, without its light: what a styler lights anew.

A program replaces the vertex stage alone, so that texture environments, fog and alpha test stay
the fixed function's. It reads GL's current colour and material, which display lists change as ever.
"""

from __future__ import annotations

import ctypes
from importlib.resources import files

from glshim.outputs.gl.device.programs import compiled
from glshim.spec.ask import integer
from glshim.spec.driver import gl

_LIGHTING, _COLOR_MATERIAL, _TWO_SIDE, _PROGRAM_TWO_SIDE = 0x0B50, 0x0B57, 0x0B52, 0x8643
_FACE, _PARAMETER = 0x0B55, 0x0B56
_BACK, _FRONT, _DIFFUSE, _AMBIENT_AND_DIFFUSE = 0x0405, 0x0404, 0x1201, 0x1602
_FOG_SOURCE, _FOG_COORDINATE = 0x8450, 0x8451
_NORMALIZE, _RESCALE = 0x0BA1, 0x803A
_ACTIVE, _TEXTURE_0, _UNITS = 0x84E0, 0x84C0, 4
"""Units whose coordinates are handed on; those beyond have none."""
_COORDINATES, _SWITCHES, _MODE = 0x2000, 0x0C60, 0x2500
_MADE = {0x2401: 1, 0x2400: 2, 0x2402: 3, 0x8512: 4, 0x8511: 5}
"""Object, eye, sphere, reflection and normal map, as ``paint.vert.glsl`` numbers them."""
_NAMES = ("lit", "tracked", "two_sided", "fog_given", "made", "normalised")


class Paint:
    """A program of one context, in use during the app's draws."""

    def __init__(self, *, textures: bool) -> None:
        """textures: whether the app's textures stay on; without them its fog goes, too."""
        self._textures = textures
        shaders = files("glshim.outputs.gl") / "shaders"
        vertex = (shaders / "paint.vert.glsl").read_text("utf-8")
        fragment = "" if textures else (shaders / "paint.frag.glsl").read_text("utf-8")
        self._program = compiled("paint", vertex, fragment)
        self._at = {
            name: int(gl.glGetUniformLocation(self._program, name.encode())) for name in _NAMES
        }
        self._made = (ctypes.c_int * (4 * _UNITS))()
        self._turned_on = False

    def begin(self) -> bool:
        """Before the app's draw; whether it is painted: what is drawn without light is paint as it
        is, but for its textures."""
        lit = bool(gl.glIsEnabled(_LIGHTING))
        if not lit and self._textures:
            return False
        gl.glUseProgram(self._program)
        two_sided = bool(lit and integer(_TWO_SIDE))
        gl.glUniform1i(self._at["lit"], int(lit))
        gl.glUniform1i(self._at["tracked"], _tracked() if lit else 0)
        gl.glUniform1i(self._at["two_sided"], int(two_sided))
        if self._textures:
            gl.glUniform1i(self._at["fog_given"], int(integer(_FOG_SOURCE) == _FOG_COORDINATE))
            unit, scaled = bool(gl.glIsEnabled(_NORMALIZE)), bool(gl.glIsEnabled(_RESCALE))
            gl.glUniform1i(self._at["normalised"], 1 if unit else 2 * scaled)
            self._ask_for_made()
            gl.glUniform4iv(self._at["made"], _UNITS, ctypes.addressof(self._made))
        self._turned_on = two_sided and not gl.glIsEnabled(_PROGRAM_TWO_SIDE)
        if self._turned_on:
            gl.glEnable(_PROGRAM_TWO_SIDE)
        return True

    def end(self) -> None:
        """After a draw that is painted."""
        gl.glUseProgram(0)
        if self._turned_on:
            gl.glDisable(_PROGRAM_TWO_SIDE)

    def release(self) -> None:
        """Delete the program. In its context, outside glBegin/glEnd."""
        gl.glDeleteProgram(self._program)

    def _ask_for_made(self) -> None:
        """Which texture coordinates GL makes by itself (glTexGen), unit by unit."""
        active = integer(_ACTIVE)
        mode = ctypes.c_int()
        for unit in range(_UNITS):
            gl.glActiveTexture(_TEXTURE_0 + unit)
            for k in range(4):
                made = 0
                if gl.glIsEnabled(_SWITCHES + k):
                    gl.glGetTexGeniv(_COORDINATES + k, _MODE, ctypes.addressof(mode))
                    made = _MADE.get(mode.value, 0)
                self._made[4 * unit + k] = made
        gl.glActiveTexture(active)


def _tracked() -> int:
    """Bits of the faces whose diffuse material is the current colour: 1 front, 2 back."""
    if not gl.glIsEnabled(_COLOR_MATERIAL):
        return 0
    if integer(_PARAMETER) not in (_DIFFUSE, _AMBIENT_AND_DIFFUSE):
        return 0
    return {_FRONT: 1, _BACK: 2}.get(integer(_FACE), 3)
