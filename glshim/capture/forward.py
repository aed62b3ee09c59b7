"""Hands a recorded primitive to the real fixed-function GL.

Large primitives go as one glDrawArrays from client arrays, which is the same picture and leaves the
same current attributes; everything else is replayed call by call through the bare driver.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from contextlib import suppress
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..spec.attributes import (
    BY_NAME,
    COLOR,
    KIND,
    NORMAL,
    RECORD_BYTES,
    REPLAY,
    SIZE,
    TAG_OFFSET,
    TEXCOORD,
    VERTEX,
    Attribute,
    decode,
)
from ..spec.driver import current_context, gl, quick

SMALL = 128 * RECORD_BYTES
"""Below this many bytes a replay is quicker than setting up arrays (measured)."""

_GL_FLOAT = 0x1406
_ARRAYS = {  # kind: (client state, glGet of the current value, components of the array)
    NORMAL: (0x8075, 0x0B02, 3),
    COLOR: (0x8076, 0x0B00, 4),
    TEXCOORD: (0x8078, 0x0B03, 4),
}
_VERTEX_ARRAY = 0x8074
_ENABLED = 0x8622
_EDGE_FLAG_TAG = BY_NAME["glEdgeFlag"].tag
_CLIENT_STATES = (0x8074, 0x8075, 0x8076, 0x8077, 0x8079, 0x8457, 0x845E)
_LONGEST_PERIOD = 4
_FLOAT = Struct("=f")
_ONE = _FLOAT.pack(1.0)
_Array = tuple[int, int, int]
"""Kind, components and address."""

ELEMENTS: dict[str, Any] = {
    "f": ctypes.c_float, "d": ctypes.c_double, "i": ctypes.c_int, "s": ctypes.c_short,
    "u": ctypes.c_ubyte, "b": ctypes.c_ubyte,
}  # fmt: skip
"""C types by the type letters of attributes."""

_calls: list[Callable[[bytes], Any]] = []


def _bare_calls() -> list[Callable[[bytes], Any]]:
    if not _calls:
        for name, size in zip(REPLAY, SIZE, strict=True):
            bare = quick(name)
            if name == "glColor4fv" and size == 3:
                bare = _opaque(bare)
            _calls.append(bare if name.endswith("v") else _switch(bare))
    return _calls


def _opaque(bare: Callable[[bytes], Any]) -> Callable[[bytes], Any]:
    return lambda record: bare(record[:12] + _ONE)


def _switch(bare: Callable[..., Any]) -> Callable[[bytes], Any]:
    return lambda record: bare(int(_FLOAT.unpack_from(record)[0]))


def replay(stream: bytes) -> None:
    """Say the recorded calls to the driver one by one. Exact in every case."""
    calls = _calls or _bare_calls()
    for at in range(0, len(stream), RECORD_BYTES):
        calls[stream[at + TAG_OFFSET]](stream[at : at + TAG_OFFSET])


def worthwhile(stream: bytes) -> bool:
    """Whether a stream is large enough, and of a kind, to be drawn from arrays.

    It is not when an attribute comes with different numbers of components: Mesa 22.3 then lets
    components of one call stand in the next, and the picture depends on its own buffering.
    """
    if len(stream) < SMALL:
        return False
    used = np.flatnonzero(np.bincount(decode(stream)[0], minlength=len(KIND)))
    if _EDGE_FLAG_TAG in used:
        return False
    sizes: dict[int, int] = {VERTEX: 0}
    return all(sizes.setdefault(int(KIND[tag]), int(SIZE[tag])) in (0, SIZE[tag]) for tag in used)


def drawable() -> bool:
    """Whether :func:`draw` is exactly equivalent in this context. Ask outside a primitive."""
    return bool(
        current_context()
        and _integer(0x0BB1) < _integer(0x0D3B)  # room on the client attribute stack
        and not _integer(0x8B8D)  # the app's program may look at gl_VertexID
        and not _vertex_array_object()
    )


_value = (ctypes.c_int * 16)()


def _integer(name: int) -> int:
    _value[0] = 0
    gl.glGetIntegerv(name, _value)
    return _value[0]


def list_open() -> bool:
    """Whether the driver is compiling a display list. Ask outside a primitive."""
    return bool(current_context() and _integer(0x0B33))


def _vertex_array_object() -> bool:
    try:
        _ = gl.glBindVertexArray
    except AttributeError:
        return False
    return bool(_integer(0x85B5))


def draw(mode: int, stream: bytes) -> None:
    """Draw a recorded primitive in one glDrawArrays; the app's array state is left as it was.

    Attributes that do not change between vertices are set, not sent as arrays; vertices before the
    first call of an attribute get the current one, as in immediate mode.
    """
    tags, values = decode(stream)
    period = _period(tags)
    if period:
        _draw_regular(mode, stream, tags[:period], len(tags) // period)
        return
    kinds = KIND[tags]
    vertex_rows = np.flatnonzero(kinds == VERTEX)
    if not len(vertex_rows):
        replay(stream)
        return
    sizes = SIZE[tags[vertex_rows]]
    size = int(sizes.max())
    positions = _filled(values[vertex_rows], sizes)[:, :size]
    arrays: list[_Array] = []
    last: list[bytes] = []
    kept: list[NDArray[np.float32]] = []  # alive until they are drawn
    for kind in (NORMAL, COLOR, TEXCOORD):
        rows = np.flatnonzero(kinds == kind)
        if not len(rows):
            continue
        at = int(rows[-1])
        record = stream[at * RECORD_BYTES : (at + 1) * RECORD_BYTES]
        if rows[-1] < vertex_rows[0]:
            replay(record)
            continue
        last.append(record)
        given = _filled(values[rows], SIZE[tags[rows]])
        which = np.cumsum(kinds == kind)[vertex_rows] - 1
        array = _per_vertex(kind, given, which)
        kept.append(array)
        arrays.append((kind, array.shape[1], array.ctypes.data))
    positions = np.ascontiguousarray(positions)
    arrays.append((VERTEX, size, positions.ctypes.data))
    _draw_arrays(mode, len(positions), arrays, 0)
    for record in last:
        replay(record)


def _period(tags: NDArray[np.int32]) -> int:
    """Records a vertex when every vertex comes with the same calls before it, else 0."""
    head = KIND[tags[:_LONGEST_PERIOD]]
    vertices = np.flatnonzero(head == VERTEX)
    period = int(vertices[0]) + 1 if len(vertices) else 0
    if not period or len(tags) % period or len(set(head[:period].tolist())) < period:
        return 0
    regular = bool((tags.reshape(-1, period) == tags[:period]).all())
    return period if regular else 0


def _draw_regular(mode: int, stream: bytes, tags: NDArray[np.int32], count: int) -> None:
    """The stream is an interleaved array as it stands: nothing is copied."""
    base = int(np.frombuffer(stream, np.uint8).ctypes.data)
    arrays = [
        (int(KIND[tag]), int(SIZE[tag]), base + i * RECORD_BYTES) for i, tag in enumerate(tags)
    ]
    _draw_arrays(mode, count, arrays, len(tags) * RECORD_BYTES)
    replay(stream[-len(tags) * RECORD_BYTES : -RECORD_BYTES])


def _filled(values: NDArray[np.float32], sizes: NDArray[np.int8]) -> NDArray[np.float32]:
    """Values (N, 4) with what GL puts for the components that were not given: 0, 0, 0, 1."""
    filled = np.ascontiguousarray(values)
    if (sizes < 4).any():
        filled = filled.copy() if filled is values else filled
        filled[sizes < 4, 3] = 1.0
    return filled


def _per_vertex(
    kind: int, given: NDArray[np.float32], which: NDArray[np.intp]
) -> NDArray[np.float32]:
    """The attribute that is current at each vertex, (V, 3 or 4) float32.

    ``given`` (N, 4) are the values that were set, ``which`` (V,) says which of them is the last
    before each vertex; -1 means none was, and the driver's current one holds.
    """
    _, current_name, components = _ARRAYS[kind]
    result = given[which]
    before = which < 0
    if before.any():
        current = (ctypes.c_float * 4)()
        gl.glGetFloatv(current_name, current)
        result[before] = np.array(current, np.float32)
    return np.ascontiguousarray(result[:, :components])


def _draw_arrays(mode: int, count: int, arrays: list[_Array], stride: int) -> None:
    """One glDrawArrays from these arrays alone."""
    gl.glPushClientAttrib(0x2)
    for state in _CLIENT_STATES:
        gl.glDisableClientState(state)
    with suppress(AttributeError):  # OpenGL 1.4 has no buffers to unbind
        gl.glBindBuffer(0x8892, 0)
    for unit in range(_texture_units(), -1, -1):
        gl.glClientActiveTexture(0x84C0 + unit)
        gl.glDisableClientState(0x8078)
    generic = _generic_arrays()
    for index in generic:
        gl.glDisableVertexAttribArray(index)
    for kind, size, address in arrays:
        gl.glEnableClientState(_VERTEX_ARRAY if kind == VERTEX else _ARRAYS[kind][0])
        if kind == VERTEX:
            gl.glVertexPointer(size, _GL_FLOAT, stride, address)
        elif kind == NORMAL:
            gl.glNormalPointer(_GL_FLOAT, stride, address)
        elif kind == COLOR:
            gl.glColorPointer(size, _GL_FLOAT, stride, address)
        else:
            gl.glTexCoordPointer(size, _GL_FLOAT, stride, address)
    gl.glDrawArrays(mode, 0, count)
    for index in generic:
        gl.glEnableVertexAttribArray(index)
    gl.glPopClientAttrib()


def _generic_arrays() -> list[int]:
    """Generic attribute arrays that the app has left enabled: a draw would read them."""
    try:
        get = gl.glGetVertexAttribiv
    except AttributeError:
        return []
    found = []
    for index in range(min(_integer(0x8869), 32)):
        get(index, _ENABLED, _value)
        if _value[0]:
            found.append(index)
    return found


def _texture_units() -> int:
    """Highest texture unit whose client array may be enabled."""
    return max(0, min(_integer(0x84E2), 8) - 1)


def check(real: Callable[..., Any]) -> Any:
    """PyOpenGL's own error check of a call that was made past it."""
    function = getattr(real, "__self__", None)
    checker = getattr(function, "errcheck", None)
    return checker(None, function, ()) if checker is not None else None


def error_checker() -> Any:
    """PyOpenGL's error checker for GL, None when the app has switched error checking off."""
    from OpenGL.raw.GL import _errors

    return _errors._error_checker


def read(row: Attribute, value: Any = None, *more: Any) -> Sequence[Any]:
    """The components behind a pointer-like argument of a raw vector call, as Python numbers.

    Raises TypeError where PyOpenGL's own conversion should decide.
    """
    element, size = ELEMENTS[row.type], row.size
    if not more:
        if isinstance(value, np.ndarray):
            if value.dtype == element and value.flags.c_contiguous and value.size >= size:
                flat = np.asarray(value).reshape(-1)  # a matrix stays of two dimensions
                return flat[:size].tolist()  # type: ignore[no-any-return]
        elif isinstance(value, ctypes.Array):
            if value._type_ is element and len(value) >= size:
                return value[:size]
        elif isinstance(value, ctypes._Pointer) and value._type_ is element and value:
            return value[:size]
    raise TypeError("not plainly numbers of the right type")
