"""Normals as an app gives them: in recorded streams, in calls that are not recorded, in arrays.

Object space, never normalised. A zero normal stands for one that is not known.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.arguments import integer_of
from glshim.model.batch import PolygonBatch
from glshim.sources.fixed.pointers import dtype_of, numbers_at
from glshim.spec.attributes import (
    BY_NAME,
    KIND,
    NORMAL,
    NORMALS,
    RECORD_BYTES,
    VERTEX,
    NormalCall,
    decode,
)
from glshim.spec.constants import (
    GL_BYTE,
    GL_DOUBLE,
    GL_FLOAT,
    GL_HALF_FLOAT,
    GL_INT,
    GL_INT_2_10_10_10_REV,
    GL_SHORT,
    GL_UNSIGNED_INT_2_10_10_10_REV,
)
from glshim.spec.roles import INSIDE, Role, role_of
from glshim.system.interrupts import is_ours

Floats = NDArray[np.float32]

DTYPES: Mapping[int, type[np.generic]] = {
    GL_BYTE: np.int8, GL_SHORT: np.int16, GL_INT: np.int32, GL_FLOAT: np.float32,
    GL_DOUBLE: np.float64, GL_HALF_FLOAT: np.float16,
}  # fmt: skip
"""By the type of a normal array."""
_PACKED = (GL_INT_2_10_10_10_REV, GL_UNSIGNED_INT_2_10_10_10_REV)
"""A normal in 32 bits, 10 a component."""

_OTHERS = (Role.IN_PRIMITIVE, Role.MATERIAL)
"""Legal inside a primitive, and never about the normal."""
_ROW = BY_NAME["glNormal3f"]
UNKNOWN = _ROW.pack.pack(0.0, 0.0, 0.0, _ROW.tag)
"""The record of a normal that is not known."""


def mapped(values: NDArray[Any]) -> Floats:
    """Normals as floats, whatever their shape; integers are mapped linearly onto [-1, 1] (OpenGL
    2.1, section 2.14, table 2.9)."""
    if values.dtype.kind == "i":
        most = 2.0 ** (8 * values.dtype.itemsize) - 1.0
        return np.asarray((2.0 * values.astype(np.float64) + 1.0) / most, np.float32)
    with np.errstate(over="ignore"):
        return np.asarray(values, np.float32)


def _unpacked(value: int, type_: int) -> Floats:
    """(3,) a packed normal (OpenGL 4.2, section 2.1.6, equations 2.1 and 2.2)."""
    parts = np.array([value >> shift & 1023 for shift in (0, 10, 20)], np.float32)
    if type_ == GL_UNSIGNED_INT_2_10_10_10_REV:
        return parts / np.float32(1023.0)
    signed = np.where(parts > 511.0, parts - 1024.0, parts)
    return np.asarray(np.maximum(signed / 511.0, -1.0), np.float32)


def record(normal: NDArray[np.float32]) -> bytes:
    """The record of a normal (3,)."""
    return _ROW.pack.pack(*normal.tolist(), _ROW.tag)


def said(name: str, args: tuple[Any, ...]) -> bytes:
    """The record of a call that is legal inside a primitive and sets the normal alone; UNKNOWN for
    others that may set it, empty for those that do not."""
    call = NORMALS.get(name)
    if call is None:
        role = role_of(name)
        return UNKNOWN if role in INSIDE and role not in _OTHERS else b""
    try:
        if not call.packed:
            return record(mapped(_values(call, args, 3)))
        type_ = integer_of(args[0])
        (packed,) = _values(call, args[1:], 1).tolist()
    except Exception as error:  # the driver took what we cannot read
        if not is_ours(error):
            raise
        return UNKNOWN
    return record(_unpacked(packed, type_)) if type_ in _PACKED else UNKNOWN


def _values(call: NormalCall, args: tuple[Any, ...], count: int) -> NDArray[Any]:
    """(count,) the numbers that the driver took: arguments, or what a vector form points to."""
    if call.vector:
        return numbers_at(args[0], call.letters, count)
    wide = np.array([integer_of(value) for value in args[:count]], np.int64)
    return wide.astype(dtype_of(call.letters))  # wraps, as C does


def normals(stream: bytes) -> Floats | None:
    """(V, 3) the normal of each vertex of a stream, zero before the first; None without any."""
    tags, values = decode(stream)
    kinds = KIND[tags]
    given = np.flatnonzero(kinds == NORMAL)
    if not len(given):
        return None
    table = np.concatenate((np.zeros((1, 3), np.float32), values[given, :3]))
    found: Floats = table[np.searchsorted(given, np.flatnonzero(kinds == VERTEX))]
    return found


def after(stream: bytes, before: bytes) -> bytes:
    """The record of the normal that holds when a stream is over, from that before it."""
    given = np.flatnonzero(KIND[decode(stream)[0]] == NORMAL)
    if not len(given):
        return before
    at = int(given[-1]) * RECORD_BYTES
    return stream[at : at + RECORD_BYTES]


def throughout(batch: PolygonBatch, current: bytes) -> PolygonBatch:
    """A batch whose corners all have the normal of a record."""
    if current == UNKNOWN:
        return batch
    normal = np.frombuffer(current, np.float32, 3)
    key = None if batch.key is None else (batch.key, normal.tobytes())
    return replace(batch, normals=np.broadcast_to(normal, (len(batch.corners), 3)), key=key)


def transformed(normals: Floats, linear: NDArray[np.float64]) -> Floats:
    """Normals (C, 3) where a linear map (3, 3) takes their surface: by its inverse transpose.
    Not known, and zero, where that does not exist."""
    determinant = np.linalg.det(linear)
    if determinant == 0.0 or not np.isfinite(determinant):
        return np.zeros_like(normals)
    with np.errstate(over="ignore", invalid="ignore"):
        return (normals @ np.linalg.inv(linear)).astype(np.float32)
