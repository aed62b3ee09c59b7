"""Vertex fetch: polygons from client arrays and buffer objects, as the draw call will read them."""

from __future__ import annotations

import ctypes
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch, Wanted
from glshim.model.caches import AgingCache
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.immediate import POLYGON_MODES, concatenate, polygon_corners
from glshim.spec.ask import integer, is_enabled
from glshim.spec.context import restarts_primitives
from glshim.spec.draws import DRAWS, Signature
from glshim.spec.driver import current_context, gl

_DTYPES = {
    0x1402: np.int16, 0x1404: np.int32, 0x1406: np.float32, 0x140A: np.float64, 0x140B: np.float16,
}  # fmt: skip
_INDICES = {0x1401: np.uint8, 0x1403: np.uint16, 0x1405: np.uint32}
_BINDINGS = {0x8892: 0x8894, 0x8893: 0x8895}
_ARRAY_BUFFER, _ELEMENT_BUFFER = 0x8892, 0x8893


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

    def buffer_written(self, name: str, args: tuple[Any, ...]) -> None:
        """A BUFFER_WRITE entry point was called: the buffer's content has a new version."""
        if "Named" in name and args and isinstance(args[0], int):
            buffer = args[0]
        elif args and isinstance(args[0], int) and int(args[0]) in _BINDINGS:
            buffer = integer(_BINDINGS[int(args[0])])
        else:
            self._epoch = next(_EPOCHS)
            return
        self._versions[buffer] = self._versions.get(buffer, 0) + 1

    def batch(self, name: str, args: Sequence[Any], wanted: Wanted) -> PolygonBatch | None:
        """Polygons of an ARRAY_DRAW call, with what is wanted as far as it is in an array; None
        when it draws none. Raises Unfetchable."""
        signature = DRAWS[name.removesuffix("EXT")]
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
        batch = concatenate([p for p in parts if len(p.corners)], key)
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
            element_buffer = integer(0x8895)
            if not element_buffer:
                return None
            indexed = (*self._version(element_buffer), _address(values["indices"]))
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
    raw = _bytes(integer(0x8895), _ELEMENT_BUFFER, _address(value), count * dtype.itemsize)
    return np.frombuffer(raw, dtype).astype(np.int64)


def _vertex_pointer() -> _Pointer:
    if not is_enabled(0x8074):
        raise Unfetchable("positions are not in the fixed-function vertex array")
    pointer = _Pointer(
        integer(0x807A), integer(0x807B), integer(0x807C), integer(0x8896), _pointed(0x808E)
    )
    if pointer.type not in _DTYPES:
        raise Unfetchable(f"vertex type {pointer.type:#x}")
    return pointer


def _normal_pointer() -> _Pointer | None:
    """The normal array, None when it is off."""
    if not is_enabled(0x8075):
        return None
    return _Pointer(3, integer(0x807E), integer(0x807F), integer(0x8897), _pointed(0x808F))


def _pointed(name: int) -> int:
    """An address, or the offset in a buffer, of the client state."""
    address = ctypes.c_void_p()
    gl.glGetPointerv(name, ctypes.byref(address))
    return address.value or 0


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
    raw = _bytes(pointer.buffer, _ARRAY_BUFFER, start, size)
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
        state = ctypes.c_int()
        gl.glGetBufferParameteriv(target, 0x88BC, ctypes.byref(state))
        if state.value:
            raise Unfetchable("the buffer is mapped while it is drawn from")
        gl.glGetBufferParameteriv(target, 0x8764, ctypes.byref(state))
        if address + size > state.value:
            raise Unfetchable("the draw reads past the end of its buffer")
        data = ctypes.create_string_buffer(size)
        gl.glGetBufferSubData(target, address, size, data)
        return data.raw
    finally:
        gl.glBindBuffer(target, bound)


def _address(value: Any) -> int:
    """The address (or buffer offset) behind an argument of PyOpenGL's raw layer."""
    if value is None:
        return 0
    if isinstance(value, int):
        return value
    if isinstance(value, ctypes.c_void_p):
        return value.value or 0
    from OpenGL.arrays import ArrayDatatype

    return int(ArrayDatatype.voidDataPointer(value).value or 0)


def _integers_at(value: Any, count: int) -> list[int]:
    return list((ctypes.c_int * count).from_address(_address(value)))


def _pointers_at(value: Any, count: int) -> list[int]:
    address = ctypes.cast(value, ctypes.c_void_p).value if not isinstance(value, int) else value
    return [p or 0 for p in (ctypes.c_void_p * count).from_address(int(address or 0))]
