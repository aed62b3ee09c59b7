"""The app's polygons in its own paints, without its light: what a styler lights anew.

A program replaces the vertex stage alone, so that texture environments, fog and alpha test stay
the fixed function's. It reads GL's current colour and material, which display lists change as ever.
"""

from __future__ import annotations

import ctypes
from typing import Any

from glshim.driver.ask import integer, is_enabled
from glshim.driver.functions import gl
from glshim.outputs.gl.device.devices import Device
from glshim.outputs.gl.device.programs import shader_text
from glshim.spec.constants import (
    GL_ACTIVE_TEXTURE,
    GL_AMBIENT_AND_DIFFUSE,
    GL_BACK,
    GL_COLOR_MATERIAL,
    GL_COLOR_MATERIAL_FACE,
    GL_COLOR_MATERIAL_PARAMETER,
    GL_DIFFUSE,
    GL_EYE_LINEAR,
    GL_FOG_COORD,
    GL_FOG_COORD_SRC,
    GL_FRONT,
    GL_LIGHT_MODEL_TWO_SIDE,
    GL_LIGHTING,
    GL_NORMAL_MAP,
    GL_NORMALIZE,
    GL_OBJECT_LINEAR,
    GL_REFLECTION_MAP,
    GL_RESCALE_NORMAL,
    GL_S,
    GL_SPHERE_MAP,
    GL_TEXTURE0,
    GL_TEXTURE_GEN_MODE,
    GL_TEXTURE_GEN_S,
    GL_VERTEX_PROGRAM_TWO_SIDE,
)

_UNITS = 4
"""Units whose coordinates are handed on; those beyond have none."""
_MADE = {
    GL_OBJECT_LINEAR: 1, GL_EYE_LINEAR: 2, GL_SPHERE_MAP: 3, GL_REFLECTION_MAP: 4,
    GL_NORMAL_MAP: 5,
}  # fmt: skip
"""How coordinates are made, as ``paint.vert.glsl`` numbers it."""


class Paint:
    """A program of one context, in use during the app's draws."""

    def __init__(self, device: Device, *, textures: bool) -> None:
        """textures: whether the app's textures stay on; without them its fog goes, too."""
        self._textures = textures
        fragment = "" if textures else shader_text("paint.frag.glsl")
        self._program = device.program("paint", shader_text("paint.vert.glsl"), fragment)
        self._turned_on = False

    def begin(self) -> bool:
        """Before the app's draw; whether it is painted: what is drawn without light is paint as it
        is, but for its textures."""
        self._turned_on = False
        lit = is_enabled(GL_LIGHTING)
        if not lit and self._textures:
            return False
        two_sided = lit and bool(integer(GL_LIGHT_MODEL_TWO_SIDE))
        values: dict[str, Any] = {"lit": lit, "two_sided": two_sided}
        values["tracked"] = _tracked() if lit else 0
        if self._textures:
            unit, scaled = is_enabled(GL_NORMALIZE), is_enabled(GL_RESCALE_NORMAL)
            values |= {
                "fog_given": integer(GL_FOG_COORD_SRC) == GL_FOG_COORD,
                "normalised": 1 if unit else 2 * scaled, "made": _made(),
            }  # fmt: skip
        self._turned_on = two_sided and not is_enabled(GL_VERTEX_PROGRAM_TWO_SIDE)
        self._program.use(values)
        if self._turned_on:
            gl.glEnable(GL_VERTEX_PROGRAM_TWO_SIDE)
        return True

    def end(self) -> None:
        """After a draw that is painted."""
        gl.glUseProgram(0)
        if self._turned_on:
            gl.glDisable(GL_VERTEX_PROGRAM_TWO_SIDE)

    def release(self) -> None:
        """Delete the program. In its context, outside glBegin/glEnd."""
        self._program.release()


def _made() -> tuple[int, ...]:
    """How GL makes texture coordinates by itself (glTexGen), four of each unit."""
    active = integer(GL_ACTIVE_TEXTURE)
    found = []
    mode = ctypes.c_int()
    try:
        for unit in range(_UNITS):
            gl.glActiveTexture(GL_TEXTURE0 + unit)
            for k in range(4):
                made = 0
                if is_enabled(GL_TEXTURE_GEN_S + k):
                    gl.glGetTexGeniv(GL_S + k, GL_TEXTURE_GEN_MODE, ctypes.addressof(mode))
                    made = _MADE.get(mode.value, 0)
                found.append(made)
    finally:
        gl.glActiveTexture(active)
    return tuple(found)


def _tracked() -> int:
    """Bits of the faces whose diffuse material is the current colour: 1 front, 2 back."""
    if not is_enabled(GL_COLOR_MATERIAL):
        return 0
    if integer(GL_COLOR_MATERIAL_PARAMETER) not in (GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE):
        return 0
    return {GL_FRONT: 1, GL_BACK: 2}.get(integer(GL_COLOR_MATERIAL_FACE), 3)
