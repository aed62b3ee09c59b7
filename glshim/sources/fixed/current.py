"""What the fixed-function pipeline holds for vertices that say nothing themselves."""

from __future__ import annotations

from glshim.driver.ask import is_enabled, of_material, reals
from glshim.model.batch import Wanted
from glshim.sources.state import DrawState
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import (
    GL_COLOR_MATERIAL,
    GL_CURRENT_COLOR,
    GL_CURRENT_NORMAL,
    GL_DIFFUSE,
    GL_FRONT,
    GL_LIGHTING,
)


def colour() -> bytes:
    """The record of a glColor4f with the colour that vertices have until they are given another:
    the material's where lighting knows no other. Outside glBegin/glEnd."""
    if is_enabled(GL_LIGHTING) and not is_enabled(GL_COLOR_MATERIAL):
        shade = of_material(GL_FRONT, GL_DIFFUSE)
    else:
        shade = reals(GL_CURRENT_COLOR, 4)
    row = BY_NAME["glColor4f"]
    return row.pack.pack(*shade, row.tag)


def normal() -> bytes:
    """The record of a glNormal3f with the normal that vertices have until they are given another.
    Outside glBegin/glEnd."""
    row = BY_NAME["glNormal3f"]
    return row.pack.pack(*reals(GL_CURRENT_NORMAL, 4)[:3], row.tag)


def normal_of(state: DrawState | None, wanted: Wanted) -> bytes:
    """The record of the normal that holds where a draw says none, if wanted. A style that wants
    lights takes it for none where nothing is lit: it is left over from something else."""
    if not wanted.normals or state is None:
        return b""
    return b"" if wanted.lights and not state.camera.lit else normal()
