"""Normals as an app gives them: in recorded streams, in calls that are not recorded, in arrays.

Object space, never normalised. A zero normal stands for one that is not known.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from ctypes import string_at
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch
from glshim.spec.attributes import BY_NAME, KIND, NORMAL, RECORD_BYTES, VERTEX, decode

Floats = NDArray[np.float32]

DTYPES: Mapping[int, type[np.generic]] = {
    0x1400: np.int8, 0x1402: np.int16, 0x1404: np.int32, 0x1406: np.float32, 0x140A: np.float64,
    0x140B: np.float16,
}  # fmt: skip
"""By the type of a normal array."""
_SIGNED, _UNSIGNED = 0x8D9F, 0x8368
"""GL_INT_2_10_10_10_REV and its unsigned kin: a normal in 32 bits, 10 a component."""

_ROW = BY_NAME["glNormal3f"]
UNKNOWN = _ROW.pack.pack(0.0, 0.0, 0.0, _ROW.tag)
"""The record of a normal that is not known."""
_VECTORS: Mapping[str, tuple[str, type[np.generic]]] = {
    "b": ("GLbyteArray", np.int8), "s": ("GLshortArray", np.int16), "i": ("GLintArray", np.int32),
    "ui": ("GLuintArray", np.uint32),
}  # fmt: skip


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
    if type_ == _UNSIGNED:
        return parts / np.float32(1023.0)
    signed = np.where(parts > 511.0, parts - 1024.0, parts)
    return np.asarray(np.maximum(signed / 511.0, -1.0), np.float32)


def record(normal: NDArray[np.float32]) -> bytes:
    """The record of a normal (3,)."""
    return _ROW.pack.pack(*normal.tolist(), _ROW.tag)


def said(name: str, args: tuple[Any, ...]) -> bytes:
    """The record of a call of glNormal3b, 3s, 3i or P3ui, vector forms included; UNKNOWN for other
    calls that may set the normal, empty for those that do not."""
    match = re.fullmatch(r"gl(?:Normal3([bsi])|NormalP3(ui))(v?)", name)
    if match is None:
        return UNKNOWN if re.search("Normal|ArrayElement|Eval", name) else b""
    letters, vector = match[1] or match[2], bool(match[3])
    try:
        if match[1]:
            return record(mapped(_values(letters, vector, args[:3], 3)))
        type_ = _integer(args[0])
        (packed,) = _values(letters, vector, args[1:2], 1).tolist()
    except Exception:  # the driver took what we cannot read
        return UNKNOWN
    return record(_unpacked(packed, type_)) if type_ in (_SIGNED, _UNSIGNED) else UNKNOWN


def _values(letters: str, vector: bool, args: Sequence[Any], count: int) -> NDArray[Any]:
    """(count,) the numbers that the driver took: arguments, or what a vector form points to."""
    from OpenGL import arrays

    array, dtype = _VECTORS[letters]
    if not vector:
        wide = np.array([_integer(value) for value in args], np.int64)
        return wide.astype(dtype)  # wraps, as C does
    address = int(getattr(arrays, array).dataPointer(args[0]))
    return np.frombuffer(string_at(address, count * np.dtype(dtype).itemsize), dtype)


def _integer(value: Any) -> int:
    """A number, or one of ctypes'."""
    return int(getattr(value, "value", value))


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
