"""Vertex fetch: polygons from client arrays and buffer objects, as the draw call will read them."""

from __future__ import annotations

import ctypes
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch, Wanted, join
from glshim.model.caches import AgingCache
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.immediate import POLYGON_MODES, polygon_corners
from glshim.sources.fixed.pointers import address_of
from glshim.spec.ask import integer, is_enabled, of_buffer, pointer_of
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_ARRAY_BUFFER_BINDING,
    GL_BUFFER_MAPPED,
    GL_BUFFER_SIZE,
    GL_DOUBLE,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER_BINDING,
    GL_FLOAT,
    GL_HALF_FLOAT,
    GL_INT,
    GL_NORMAL_ARRAY,
    GL_NORMAL_ARRAY_BUFFER_BINDING,
    GL_NORMAL_ARRAY_POINTER,
    GL_NORMAL_ARRAY_STRIDE,
    GL_NORMAL_ARRAY_TYPE,
    GL_SHORT,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_SHORT,
    GL_VERTEX_ARRAY,
    GL_VERTEX_ARRAY_BUFFER_BINDING,
    GL_VERTEX_ARRAY_POINTER,
    GL_VERTEX_ARRAY_SIZE,
    GL_VERTEX_ARRAY_STRIDE,
    GL_VERTEX_ARRAY_TYPE,
)
from glshim.spec.context import restarts_primitives
from glshim.spec.draws import Signature, signature_of
from glshim.spec.driver import current_context, gl
from glshim.spec.roles import Role

_DTYPES = {
    GL_SHORT: np.int16, GL_INT: np.int32, GL_FLOAT: np.float32, GL_DOUBLE: np.float64,
    GL_HALF_FLOAT: np.float16,
}  # fmt: skip
_INDICES = {GL_UNSIGNED_BYTE: np.uint8, GL_UNSIGNED_SHORT: np.uint16, GL_UNSIGNED_INT: np.uint32}
_BINDINGS = {
    GL_ARRAY_BUFFER: GL_ARRAY_BUFFER_BINDING,
    GL_ELEMENT_ARRAY_BUFFER: GL_ELEMENT_ARRAY_BUFFER_BINDING,
}


class Unfetchable(Exception):
    """The positions of this draw cannot be had; the text says why."""


_EPOCHS = count()
"""No two fetchers share one: what was derived from keys outlives a style, and buffers may have been
written while none was installed."""


@dataclass(frozen=True, slots=True)
class _Pointer:
    size: int
    type: int
    stride: int
    buffer: int
    address: int


class VertexFetch:
    """Reads draws; what comes from unchanged buffers is assembled once."""

    def __init__(self) -> None:
        self._versions: dict[int, int] = {}
        self._epoch = next(_EPOCHS)
        self._kept: AgingCache[PolygonBatch] = AgingCache()

    def buffer_written(self, role: Role, args: tuple[Any, ...]) -> None:
        """A call of BUFFER_WRITES: the buffer's content has a new version; that of all buffers,
        where it cannot be told which."""
        first = args[0] if args and isinstance(args[0], int) else None
        if first is not None and role is Role.NAMED_BUFFER_WRITE:
            buffer = first
        elif first in _BINDINGS and role is not Role.BUFFERS_WRITE:
            buffer = integer(_BINDINGS[first])
        else:
            self._epoch = next(_EPOCHS)
            return
        self._versions[buffer] = self._versions.get(buffer, 0) + 1

    def batch(self, name: str, args: Sequence[Any], wanted: Wanted) -> PolygonBatch | None:
        """Polygons of an ARRAY_DRAW call, with what is wanted as far as it is in an array; None
        when it draws none. Raises Unfetchable."""
        signature = signature_of(name)
        values = dict(zip(signature.parameters, args, strict=False))
        mode = int(values["mode"])
        if mode not in POLYGON_MODES:
            return None
        pointer = _vertex_pointer()
        normal = _normal_pointer() if wanted.normals else None
        key = self._key(signature, values, pointer, normal)
        kept = self._kept.get(key) if key is not None else None
        if kept is not None:
            return kept
        runs = _index_runs(signature, values)
        parts = [self._part(mode, pointer, normal, indices) for indices in runs]
        batch = join([p for p in parts if len(p.corners)], key)
        if key is not None:
            given = 0 if batch.normals is None else batch.normals.nbytes
            self._kept.put(key, batch, batch.positions.nbytes + batch.corners.nbytes + given)
        return batch

    def tick(self) -> None:
        """A frame has passed."""
        self._kept.tick()

    def element(self, index: int) -> tuple[float, float, float]:
        """Object-space position of one vertex of the current arrays (glArrayElement)."""
        x, y, z = _positions(_vertex_pointer(), index, 1)[0]
        return float(x), float(y), float(z)

    def element_normal(self, index: int) -> bytes:
        """The record of its normal; empty if none is in an array."""
        normal = _normal_pointer()
        return b"" if normal is None else normals.record(_normals(normal, index, 1)[0])

    def _version(self, buffer: int) -> tuple[int, int, int]:
        return buffer, self._versions.get(buffer, 0), self._epoch

    def _key(
        self,
        signature: Signature,
        values: dict[str, Any],
        pointer: _Pointer,
        normal: _Pointer | None,
    ) -> Hashable | None:
        if not pointer.buffer or signature.multiple or (normal and not normal.buffer):
            return None
        scalars = tuple(int(values[p]) for p in signature.parameters if p not in ("indices",))
        indexed: Hashable = None
        if "indices" in values:
            element_buffer = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING)
            if not element_buffer:
                return None
            indexed = (*self._version(element_buffer), address_of(values["indices"]))
        version = self._version(pointer.buffer)
        with_normals = (normal, self._version(normal.buffer)) if normal else None
        return ("arrays", current_context(), scalars, pointer, version, indexed, with_normals)

    def _part(
        self,
        mode: int,
        pointer: _Pointer,
        normal: _Pointer | None,
        indices: tuple[int, NDArray[np.int64] | None, int],
    ) -> PolygonBatch:
        first, elements, count = indices
        if elements is None:
            positions = _positions(pointer, first, count)
            corners, starts = polygon_corners(mode, count)
        else:
            low = int(elements.min()) if len(elements) else 0
            high = int(elements.max()) if len(elements) else -1
            if low < 0:
                raise Unfetchable("an index is negative")
            first, count = low, high - low + 1
            positions = _positions(pointer, first, count)
            corners, starts = polygon_corners(mode, len(elements))
            corners = (elements - low).astype(np.int32)[corners]
        given = None if normal is None else _normals(normal, first, count)[corners]
        boundary = np.ones(len(corners), np.bool_)
        return PolygonBatch(positions, corners, starts, boundary, normals=given)


def _index_runs(
    signature: Signature, values: dict[str, Any]
) -> list[tuple[int, NDArray[np.int64] | None, int]]:
    """(first, indices or None, count) of each run that the call draws."""
    if not signature.multiple:
        if "indices" not in values:
            return [(int(values["first"]), None, int(values["count"]))]
        base = int(values.get("basevertex", 0))
        indices = _indices(values["indices"], int(values["type"]), int(values["count"]))
        return [(0, indices + base, 0)]
    draws = int(values["drawcount"])
    counts = _integers_at(values["count"], draws)
    if "first" in values:
        firsts = _integers_at(values["first"], draws)
        return [(int(f), None, int(c)) for f, c in zip(firsts, counts, strict=True)]
    pointers = _pointers_at(values["indices"], draws)
    bases = _integers_at(values["basevertex"], draws) if "basevertex" in values else [0] * draws
    return [
        (0, _indices(p, int(values["type"]), int(c)) + int(b), 0)
        for p, c, b in zip(pointers, counts, bases, strict=True)
    ]


def _indices(value: Any, type_: int, count: int) -> NDArray[np.int64]:
    if type_ not in _INDICES:
        raise Unfetchable(f"index type {type_:#x}")
    if restarts_primitives():
        raise Unfetchable("primitive restart is on")
    dtype = np.dtype(_INDICES[type_])
    bound = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING)
    raw = _bytes(bound, GL_ELEMENT_ARRAY_BUFFER, address_of(value), count * dtype.itemsize)
    return np.frombuffer(raw, dtype).astype(np.int64)


def _vertex_pointer() -> _Pointer:
    if not is_enabled(GL_VERTEX_ARRAY):
        raise Unfetchable("positions are not in the fixed-function vertex array")
    pointer = _Pointer(
        integer(GL_VERTEX_ARRAY_SIZE),
        integer(GL_VERTEX_ARRAY_TYPE),
        integer(GL_VERTEX_ARRAY_STRIDE),
        integer(GL_VERTEX_ARRAY_BUFFER_BINDING),
        pointer_of(GL_VERTEX_ARRAY_POINTER),
    )
    if pointer.type not in _DTYPES:
        raise Unfetchable(f"vertex type {pointer.type:#x}")
    return pointer


def _normal_pointer() -> _Pointer | None:
    """The normal array, None when it is off."""
    if not is_enabled(GL_NORMAL_ARRAY):
        return None
    return _Pointer(
        3,
        integer(GL_NORMAL_ARRAY_TYPE),
        integer(GL_NORMAL_ARRAY_STRIDE),
        integer(GL_NORMAL_ARRAY_BUFFER_BINDING),
        pointer_of(GL_NORMAL_ARRAY_POINTER),
    )


def _normals(pointer: _Pointer, first: int, count: int) -> NDArray[np.float32]:
    """Normals (count, 3), zero where they cannot be had."""
    dtype = normals.DTYPES.get(pointer.type)
    try:
        if dtype is None:
            raise Unfetchable(f"normal type {pointer.type:#x}")
        return normals.mapped(_strided(pointer, np.dtype(dtype), first, count))
    except Unfetchable as reason:
        say_once(f"normals are not known, because {reason}")
        return np.zeros((max(count, 0), 3), np.float32)


def _positions(pointer: _Pointer, first: int, count: int) -> NDArray[np.float32]:
    """Positions (count, 3) float32 after division by w."""
    strided = _strided(pointer, np.dtype(_DTYPES[pointer.type]), first, count)
    positions = np.zeros((len(strided), 3), np.float32)
    positions[:, : min(pointer.size, 3)] = strided[:, :3]
    if pointer.size == 4:
        with np.errstate(divide="ignore", invalid="ignore"):
            positions /= strided[:, 3:4].astype(np.float32)
    return positions


def _strided(
    pointer: _Pointer, dtype: np.dtype[Any], first: int, count: int
) -> NDArray[Any]:
    """(count, size) what a client array holds."""
    width = dtype.itemsize * pointer.size
    stride = pointer.stride or width
    if count <= 0:
        return np.empty((0, pointer.size), dtype)
    if first < 0:
        raise Unfetchable("the first vertex is negative")
    if not pointer.buffer and not pointer.address:
        raise Unfetchable("the pointer of an array is null")
    start, size = pointer.address + first * stride, (count - 1) * stride + width
    raw = _bytes(pointer.buffer, GL_ARRAY_BUFFER, start, size)
    return np.ndarray((count, pointer.size), dtype, raw, 0, (stride, dtype.itemsize))


def _bytes(buffer: int, target: int, address: int, size: int) -> bytes:
    """Bytes of a buffer object, or of the app's memory when no buffer is bound."""
    if size <= 0:
        return b""
    if not buffer:
        return ctypes.string_at(address, size)
    bound = integer(_BINDINGS[target])
    gl.glBindBuffer(target, buffer)
    try:
        if of_buffer(target, GL_BUFFER_MAPPED):
            raise Unfetchable("the buffer is mapped while it is drawn from")
        if address + size > of_buffer(target, GL_BUFFER_SIZE):
            raise Unfetchable("the draw reads past the end of its buffer")
        data = ctypes.create_string_buffer(size)
        gl.glGetBufferSubData(target, address, size, data)
        return data.raw
    finally:
        gl.glBindBuffer(target, bound)


def _integers_at(value: Any, count: int) -> list[int]:
    return list((ctypes.c_int * count).from_address(address_of(value)))


def _pointers_at(value: Any, count: int) -> list[int]:
    address = ctypes.cast(value, ctypes.c_void_p).value if not isinstance(value, int) else value
    return [p or 0 for p in (ctypes.c_void_p * count).from_address(int(address or 0))]
