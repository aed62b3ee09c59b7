"""Vertex fetch: polygons from client arrays and buffer objects, as the draw call will read them."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.arguments import address_of, number, signed, unsigned
from glshim.driver.ask import integer, of_buffer
from glshim.driver.context import restarts_primitives
from glshim.driver.functions import current_context, gl
from glshim.model.batch import PolygonBatch, Wanted, join
from glshim.model.caches import AgingCache
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.arrays import DTYPES, Array, Unfetchable, normal_array, vertex_array
from glshim.sources.fixed.immediate import POLYGON_MODES, complete, polygon_corners
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_ARRAY_BUFFER_BINDING,
    GL_BUFFER_MAPPED,
    GL_BUFFER_SIZE,
    GL_ELEMENT_ARRAY_BUFFER,
    GL_ELEMENT_ARRAY_BUFFER_BINDING,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_SHORT,
)
from glshim.spec.draws import Signature, signature_of
from glshim.spec.roles import Role
from glshim.system import memory

_INDICES = {GL_UNSIGNED_BYTE: np.uint8, GL_UNSIGNED_SHORT: np.uint16, GL_UNSIGNED_INT: np.uint32}
_BINDINGS = {
    GL_ARRAY_BUFFER: GL_ARRAY_BUFFER_BINDING,
    GL_ELEMENT_ARRAY_BUFFER: GL_ELEMENT_ARRAY_BUFFER_BINDING,
}
_UNSIGNED = frozenset(("mode", "type", "start", "end"))
_WRAP = 0xFFFFFFFF
"""An index and what is added to it make 32 bits."""
_SPAN = 1 << 26
"""Bytes between the first and the last vertex of a draw that are read at once, however few of them
it uses."""
_MOST_DRAWS = 1 << 20
"""Of one call."""

_EPOCHS = count()
"""No two fetchers share one: what was derived from keys outlives a style, and buffers may have been
written while none was installed."""


@dataclass(frozen=True, slots=True)
class _Run:
    """Vertices of whole polygons, in order."""

    first: int
    count: int
    elements: NDArray[np.int64] | None = None
    """Their numbers, instead."""


class VertexFetch:
    """Reads draws; what comes from unchanged buffers is assembled once."""

    def __init__(self) -> None:
        self._versions: dict[int, int] = {}
        self._epoch = next(_EPOCHS)
        self._kept: AgingCache[PolygonBatch] = AgingCache()

    def buffer_written(self, role: Role, args: tuple[Any, ...]) -> None:
        """A call of BUFFER_WRITES: the buffer's content has a new version; that of all buffers,
        where it cannot be told which."""
        first = number(args, 0)
        if role is Role.NAMED_BUFFER_WRITE and first > 0:
            buffer = first
        elif first in _BINDINGS and role is not Role.BUFFERS_WRITE:
            buffer = integer(_BINDINGS[first])
        else:
            self._epoch = next(_EPOCHS)
            self._versions.clear()  # of names that may never come again
            return
        self._versions[buffer] = self._versions.get(buffer, 0) + 1

    def batch(self, name: str, args: Sequence[Any], wanted: Wanted) -> PolygonBatch | None:
        """Polygons of an ARRAY_DRAW call, with what is wanted as far as it is in an array; None
        when it draws none. Raises Unfetchable."""
        signature = signature_of(name)
        values = _values(signature, args)
        mode = values["mode"]
        if mode not in POLYGON_MODES or _is_refused(values):
            return None
        pointer = vertex_array()
        normal = normal_array() if wanted.normals else None
        key = self._key(signature, values, pointer, normal)
        kept = self._kept.get(key) if key is not None else None
        if kept is not None:
            return kept
        parts = [_part(mode, pointer, normal, run) for run in _runs(mode, signature, values)]
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
        x, y, z = _positions(vertex_array(), index, 1)[0]
        return float(x), float(y), float(z)

    def element_normal(self, index: int) -> bytes:
        """The record of its normal; empty if none is in an array."""
        normal = normal_array()
        return b"" if normal is None else normals.record(_normals(normal, index, 1)[0])

    def _version(self, buffer: int) -> tuple[int, int, int]:
        return buffer, self._versions.get(buffer, 0), self._epoch

    def _key(
        self,
        signature: Signature,
        values: dict[str, Any],
        pointer: Array,
        normal: Array | None,
    ) -> Hashable | None:
        if not pointer.buffer or signature.multiple or (normal and not normal.buffer):
            return None
        scalars = tuple(values[p] for p in signature.parameters if p != "indices")
        indexed: Hashable = None
        if "indices" in values:
            element_buffer = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING)
            if not element_buffer:
                return None
            indexed = (*self._version(element_buffer), values["indices"])
        version = self._version(pointer.buffer)
        with_normals = (normal, self._version(normal.buffer)) if normal else None
        return ("arrays", current_context(), scalars, pointer, version, indexed, with_normals)


def _values(signature: Signature, args: Sequence[Any]) -> dict[str, Any]:
    """The arguments by their names; integers as C has them, arrays as they are given."""
    arrays = ("first", "count", "indices", "basevertex") if signature.multiple else ("indices",)
    values = dict(zip(signature.parameters, args, strict=False))
    try:
        for name in signature.parameters:
            if name not in arrays:
                values[name] = (unsigned if name in _UNSIGNED else signed)(values[name])
        if "indices" in values and not signature.multiple:
            values["indices"] = address_of(values["indices"])
    except (KeyError, TypeError) as error:
        raise Unfetchable("it cannot be told what its arguments are") from error
    return values


def _is_refused(values: dict[str, Any]) -> bool:
    """Whether GL makes an error of the call, or draws nothing: then it reads nothing, either."""
    alone = "drawcount" not in values
    return (
        (alone and (values["count"] <= 0 or values.get("first", 0) < 0))
        or values.get("drawcount", 1) <= 0
        or values.get("end", 0) < values.get("start", 0)
        or values.get("type", GL_UNSIGNED_INT) not in _INDICES
    )


def _runs(mode: int, signature: Signature, values: dict[str, Any]) -> list[_Run]:
    """What the call draws, without vertices that are left over: GL need not read those."""
    if not signature.multiple:
        whole = complete(mode, values["count"])
        if "indices" not in values:
            return [_Run(values["first"], whole)]
        elements = _indices(values["indices"], values["type"], whole)
        return [_Run(0, whole, elements + values.get("basevertex", 0) & _WRAP)]
    draws = values["drawcount"]
    counts = _integers_at(values["count"], draws)
    if min(counts) < 0:  # then nothing is drawn at all
        return []
    wholes = [complete(mode, each) for each in counts]
    if "first" in values:
        return list(map(_Run, _integers_at(values["first"], draws), wholes))
    pointers = _pointers_at(values["indices"], draws)
    bases = _integers_at(values["basevertex"], draws) if "basevertex" in values else [0] * draws
    return [
        _Run(0, whole, _indices(pointer, values["type"], whole) + base & _WRAP)
        for pointer, whole, base in zip(pointers, wholes, bases, strict=True)
    ]


def _indices(address: int, type_: int, count: int) -> NDArray[np.int64]:
    if restarts_primitives():
        raise Unfetchable("primitive restart is on")
    dtype = np.dtype(_INDICES[type_])
    bound = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING)
    raw = _bytes(bound, GL_ELEMENT_ARRAY_BUFFER, address, count * dtype.itemsize)
    return np.frombuffer(raw, dtype).astype(np.int64)


def _part(mode: int, pointer: Array, normal: Array | None, run: _Run) -> PolygonBatch:
    """The polygons of a run."""
    corners, starts = polygon_corners(mode, run.count)
    elements, first, count = run.elements, run.first, run.count
    if elements is not None and len(elements):
        low, high = int(elements.min()), int(elements.max())
        if (high - low) * max(pointer.stride, 1) > max(_SPAN, 64 * len(elements)):
            return _scattered(mode, pointer, normal, elements)
        first, count = low, high - low + 1
        corners = (elements - low).astype(np.int32)[corners]
    positions = _positions(pointer, first, count)
    given = None if normal is None else _normals(normal, first, count)[corners]
    return PolygonBatch(positions, corners, starts, np.ones(len(corners), np.bool_), normals=given)


def _scattered(
    mode: int, pointer: Array, normal: Array | None, elements: NDArray[np.int64]
) -> PolygonBatch:
    """The polygons of vertices that are far apart: each is read by itself."""
    used, numbers = np.unique(elements, return_inverse=True)
    corners, starts = polygon_corners(mode, len(elements))
    corners = numbers.reshape(-1).astype(np.int32)[corners]
    positions = np.concatenate([_positions(pointer, int(each), 1) for each in used])
    given = None
    if normal is not None:
        given = np.concatenate([_normals(normal, int(each), 1) for each in used])[corners]
    return PolygonBatch(positions, corners, starts, np.ones(len(corners), np.bool_), normals=given)


def _normals(pointer: Array, first: int, count: int) -> NDArray[np.float32]:
    """Normals (count, 3), zero where they cannot be had."""
    dtype = normals.DTYPES.get(pointer.type)
    try:
        if dtype is None:
            raise Unfetchable(f"normal type {pointer.type:#x}")
        return normals.mapped(_strided(pointer, np.dtype(dtype), first, count))
    except Unfetchable as reason:
        say_once(f"normals are not known, because {reason}")
        return np.zeros((max(count, 0), 3), np.float32)


def _positions(pointer: Array, first: int, count: int) -> NDArray[np.float32]:
    """Positions (count, 3) float32 after division by w."""
    strided = _strided(pointer, np.dtype(DTYPES[pointer.type]), first, count)
    positions = np.zeros((len(strided), 3), np.float32)
    positions[:, : min(pointer.size, 3)] = strided[:, :3]
    if pointer.size == 4:
        with np.errstate(divide="ignore", invalid="ignore"):
            positions /= strided[:, 3:4].astype(np.float32)
    return positions


def _strided(
    pointer: Array, dtype: np.dtype[Any], first: int, count: int
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


def _bytes(buffer: int, target: int, address: int, size: int) -> bytes | memory.Octets:
    """Bytes of a buffer object, or of the app's memory when no buffer is bound."""
    if size <= 0:
        return b""
    if not buffer:
        return _memory(address, size)
    bound = integer(_BINDINGS[target])
    gl.glBindBuffer(target, buffer)
    try:
        if of_buffer(target, GL_BUFFER_MAPPED):
            raise Unfetchable("the buffer is mapped while it is drawn from")
        if address < 0 or address + size > of_buffer(target, GL_BUFFER_SIZE):
            raise Unfetchable("the draw reads past the end of its buffer")
        data = ctypes.create_string_buffer(size)
        gl.glGetBufferSubData(target, address, size, data)
        return data.raw
    finally:
        gl.glBindBuffer(target, bound)


def _memory(address: int, size: int) -> memory.Octets:
    found = memory.read(address, size)
    if found is None:
        raise Unfetchable("the memory that it is drawn from cannot be read")
    return found


def _integers_at(value: Any, count: int) -> list[int]:
    """The GLints or GLsizeis of a call that draws several times."""
    return _listed(value, count, np.dtype(np.int32), signed)


def _pointers_at(value: Any, count: int) -> list[int]:
    """Its addresses or offsets."""
    return _listed(value, count, np.dtype(np.uintp), address_of)


def _listed(
    value: Any, count: int, dtype: np.dtype[Any], convert: Callable[[Any], int]
) -> list[int]:
    """Numbers behind a pointer, or given in a list."""
    if count > _MOST_DRAWS:
        raise Unfetchable(f"it draws {count} times")
    try:
        if type(value) is not list and type(value) is not tuple:
            return [int(n) for n in _memory(address_of(value), count * dtype.itemsize).view(dtype)]
        if len(value) >= count:
            return [convert(each) for each in value[:count]]
    except TypeError as error:
        raise Unfetchable("it cannot be told what its arguments are") from error
    raise Unfetchable("an argument has fewer numbers than draws")
