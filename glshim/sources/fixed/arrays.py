"""The arrays that a draw takes its positions and normals from, as the client's state has them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.driver.ask import (
    integer,
    is_enabled,
    of_attribute,
    of_binding,
    pointer_of,
    pointer_of_attribute,
)
from glshim.driver.context import version
from glshim.spec.constants import (
    GL_DOUBLE,
    GL_FLOAT,
    GL_HALF_FLOAT,
    GL_INT,
    GL_NORMAL_ARRAY,
    GL_NORMAL_ARRAY_BUFFER_BINDING,
    GL_NORMAL_ARRAY_POINTER,
    GL_NORMAL_ARRAY_STRIDE,
    GL_NORMAL_ARRAY_TYPE,
    GL_SHORT,
    GL_VERTEX_ARRAY,
    GL_VERTEX_ARRAY_BUFFER_BINDING,
    GL_VERTEX_ARRAY_POINTER,
    GL_VERTEX_ARRAY_SIZE,
    GL_VERTEX_ARRAY_STRIDE,
    GL_VERTEX_ARRAY_TYPE,
    GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
    GL_VERTEX_ATTRIB_ARRAY_DIVISOR,
    GL_VERTEX_ATTRIB_ARRAY_ENABLED,
    GL_VERTEX_ATTRIB_ARRAY_INTEGER,
    GL_VERTEX_ATTRIB_ARRAY_LONG,
    GL_VERTEX_ATTRIB_ARRAY_NORMALIZED,
    GL_VERTEX_ATTRIB_ARRAY_SIZE,
    GL_VERTEX_ATTRIB_ARRAY_STRIDE,
    GL_VERTEX_ATTRIB_ARRAY_TYPE,
    GL_VERTEX_ATTRIB_BINDING,
    GL_VERTEX_ATTRIB_RELATIVE_OFFSET,
    GL_VERTEX_BINDING_OFFSET,
    GL_VERTEX_BINDING_STRIDE,
)

DTYPES = {
    GL_SHORT: np.int16, GL_INT: np.int32, GL_FLOAT: np.float32, GL_DOUBLE: np.float64,
    GL_HALF_FLOAT: np.float16,
}  # fmt: skip
"""By the type of an array of positions."""
_POSITION = 0
"""The generic attribute that takes the place of the vertex array in a compatibility profile."""


class Unfetchable(Exception):
    """The positions of this draw cannot be had; the text says why."""


@dataclass(frozen=True, slots=True)
class Array:
    """Where the elements of one array are."""

    size: int
    """Numbers of an element."""
    type: int
    stride: int
    """Bytes from one element to the next; 0 where they are packed."""
    buffer: int
    """0 for the program's own memory."""
    address: int
    """Of the first element; in a buffer its offset."""


def vertex_array() -> Array:
    """The array of positions. Raises Unfetchable."""
    if of_attribute(_POSITION, GL_VERTEX_ATTRIB_ARRAY_ENABLED):
        array = _generic_array()
    elif is_enabled(GL_VERTEX_ARRAY):
        array = Array(
            integer(GL_VERTEX_ARRAY_SIZE),
            integer(GL_VERTEX_ARRAY_TYPE),
            integer(GL_VERTEX_ARRAY_STRIDE),
            integer(GL_VERTEX_ARRAY_BUFFER_BINDING),
            pointer_of(GL_VERTEX_ARRAY_POINTER),
        )
    else:
        raise Unfetchable("positions are not in the fixed-function vertex array")
    if array.type not in DTYPES:
        raise Unfetchable(f"vertex type {array.type:#x}")
    return array


def normal_array() -> Array | None:
    """The array of normals, None when it is off."""
    if not is_enabled(GL_NORMAL_ARRAY):
        return None
    return Array(
        3,
        integer(GL_NORMAL_ARRAY_TYPE),
        integer(GL_NORMAL_ARRAY_STRIDE),
        integer(GL_NORMAL_ARRAY_BUFFER_BINDING),
        pointer_of(GL_NORMAL_ARRAY_POINTER),
    )


def _generic_array() -> Array:
    """Generic attribute 0, where it does what a vertex array does."""
    if any(of_attribute(_POSITION, name) for name in _oddities()):
        raise Unfetchable("generic attribute 0 is not read as a vertex array is")
    array = Array(
        of_attribute(_POSITION, GL_VERTEX_ATTRIB_ARRAY_SIZE),
        of_attribute(_POSITION, GL_VERTEX_ATTRIB_ARRAY_TYPE),
        of_attribute(_POSITION, GL_VERTEX_ATTRIB_ARRAY_STRIDE),
        of_attribute(_POSITION, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING),
        pointer_of_attribute(_POSITION),
    )
    if not 1 <= array.size <= 4:
        raise Unfetchable(f"vertex size {array.size:#x}")
    if array.buffer and (version() or (2, 1)) >= (4, 3) and array.type in DTYPES:
        stride = array.stride or array.size * np.dtype(DTYPES[array.type]).itemsize
        bound = (
            of_binding(_POSITION, GL_VERTEX_BINDING_OFFSET),
            of_binding(_POSITION, GL_VERTEX_BINDING_STRIDE),
        )
        if bound != (array.address, stride):
            raise Unfetchable("generic attribute 0 has a buffer binding of its own")
    return array


def _oddities() -> tuple[int, ...]:
    """What makes a generic attribute another thing than a fixed one, as this version knows it."""
    number = version() or (2, 1)
    since = (
        (GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, (2, 0)), (GL_VERTEX_ATTRIB_ARRAY_INTEGER, (3, 0)),
        (GL_VERTEX_ATTRIB_ARRAY_DIVISOR, (3, 3)), (GL_VERTEX_ATTRIB_ARRAY_LONG, (4, 1)),
        (GL_VERTEX_ATTRIB_BINDING, (4, 3)), (GL_VERTEX_ATTRIB_RELATIVE_OFFSET, (4, 3)),
    )  # fmt: skip
    return tuple(name for name, first in since if number >= first)
