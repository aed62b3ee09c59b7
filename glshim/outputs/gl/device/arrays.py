"""The arrays of the context itself, for draws of our own: vertex array objects have names of the
driver's choice, so we make none."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.driver.ask import integer
from glshim.driver.context import version
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_COLOR_ARRAY,
    GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY,
    GL_INDEX_ARRAY,
    GL_MAX_TEXTURE_COORDS,
    GL_MAX_TEXTURE_UNITS,
    GL_MAX_VERTEX_ATTRIBS,
    GL_NORMAL_ARRAY,
    GL_SECONDARY_COLOR_ARRAY,
    GL_TEXTURE0,
    GL_TEXTURE_COORD_ARRAY,
    GL_VERTEX_ARRAY,
)

_ARRAYS = (
    GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY,
)  # fmt: skip


def put_the_apps_arrays_away() -> None:
    """They may be shorter than what is drawn now. Asks nothing that a version does not have but
    for arrays that it does not know."""
    number = version() or (1, 1)
    if number >= (1, 5):
        gl.glBindBuffer(GL_ARRAY_BUFFER, 0)
    for array in _ARRAYS:
        gl.glDisableClientState(array)
    if number >= (1, 3):
        units = integer(GL_MAX_TEXTURE_UNITS)
        if number >= (2, 0):
            units = max(units, integer(GL_MAX_TEXTURE_COORDS))
        for unit in range(units):
            gl.glClientActiveTexture(GL_TEXTURE0 + unit)
            gl.glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    else:
        gl.glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    if number >= (2, 0):
        for location in range(integer(GL_MAX_VERTEX_ATTRIBS)):
            gl.glDisableVertexAttribArray(location)


def put_away(locations: Iterable[int]) -> None:
    """Generic attributes that a draw of ours used, in OpenGL 3.3."""
    for location in locations:
        gl.glDisableVertexAttribArray(location)
        gl.glVertexAttribDivisor(location, 0)
