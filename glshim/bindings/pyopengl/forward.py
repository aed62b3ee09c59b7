"""Hands a recorded primitive to the real fixed-function GL.

Large primitives go as one glDrawArrays from client arrays, which is the same picture and leaves the
same current attributes; everything else is replayed call by call through the bare driver, exactly.
"""

from __future__ import annotations

import ctypes
import operator
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import lru_cache, partial
from struct import Struct
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer
from glshim.driver.context import obstacles_to_client_arrays, version_text
from glshim.driver.functions import current_context, gl, quick
from glshim.driver.queries import counting_if_seen
from glshim.spec.attributes import (
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
    decode,
)
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_CLIENT_ATTRIB_STACK_DEPTH,
    GL_CLIENT_VERTEX_ARRAY_BIT,
    GL_COLOR_ARRAY,
    GL_EDGE_FLAG_ARRAY,
    GL_FLOAT,
    GL_FOG_COORD_ARRAY,
    GL_INDEX_ARRAY,
    GL_LINE_STRIP,
    GL_LINES,
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH,
    GL_MAX_TEXTURE_UNITS,
    GL_MAX_VERTEX_ATTRIBS,
    GL_NORMAL_ARRAY,
    GL_POINTS,
    GL_QUAD_STRIP,
    GL_QUADS,
    GL_RENDER,
    GL_RENDER_MODE,
    GL_SECONDARY_COLOR_ARRAY,
    GL_TEXTURE0,
    GL_TEXTURE_COORD_ARRAY,
    GL_TRIANGLE_STRIP,
    GL_TRIANGLES,
    GL_VERTEX_ARRAY,
    GL_VERTEX_ATTRIB_ARRAY_ENABLED,
)
from glshim.system.interrupts import exhaust

SMALL = 128 * RECORD_BYTES
"""Below this many bytes a replay is quicker than setting up arrays (measured)."""

_ARRAYS = {
    VERTEX: GL_VERTEX_ARRAY, NORMAL: GL_NORMAL_ARRAY, COLOR: GL_COLOR_ARRAY,
    TEXCOORD: GL_TEXTURE_COORD_ARRAY,
}  # fmt: skip
"""Client states by kind."""
_PARTED = frozenset((
    GL_POINTS, GL_LINES, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_QUADS, GL_QUAD_STRIP,
))  # fmt: skip
"""Modes of which one vertex draws nothing, but for points: fans, polygons and line loops of one
are not tried."""
_EDGE_FLAG_TAG = BY_NAME["glEdgeFlag"].tag
_CLIENT_STATES = (
    GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
    GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY,
)  # fmt: skip
_UNITS, _ATTRIBUTES = 8, 32
"""At most so many texture units and generic attributes are looked at."""
_LONGEST_PERIOD = 4
_FLOAT = Struct("=f")
_ONE = _FLOAT.pack(1.0)
_Array = tuple[int, int, Any]
"""Kind, components and address, which may keep alive what lies there."""

Step = Callable[[], Any]
"""A call of C's with its arguments: `glshim.system.interrupts.at_once` makes it."""

_calls: list[Callable[..., Any]] = []
"""By tag."""
_CALL: Any = getattr(operator, "call", ctypes.PYFUNCTYPE(None).__call__)

_TAKES: dict[str, Callable[[bytes], Any]] = {
    "opaque": lambda record: record[:12] + _ONE,
    "number": lambda record: int(_FLOAT.unpack_from(record)[0]),
}
"""By `Replay.takes`: from a record to the argument, where that is not the record itself."""
_OTHERS = {tag: _TAKES[row.takes] for tag, row in enumerate(REPLAY) if row.takes in _TAKES}
"""By tag."""
_PLAIN = bytes(tag for tag in range(len(REPLAY)) if tag not in _OTHERS)


def saying(stream: bytes, records: Sequence[bytes] | None = None) -> Iterable[Any]:
    """Says the recorded calls to the driver one by one, as it is exhausted. Exact in every case.
    records: the same, one by one."""
    calls = _calls or _bare_calls()
    tags = stream[TAG_OFFSET::RECORD_BYTES]
    arguments: Sequence[Any] = split(stream) if records is None else records
    if tags.translate(None, _PLAIN):
        arguments = [
            _OTHERS[tag](record) if tag in _OTHERS else record
            for tag, record in zip(tags, arguments, strict=True)
        ]
    for period in range(1, _LONGEST_PERIOD + 1) if tags else ():
        beat = tags[:period]
        if tags == beat * (len(tags) // period):  # twice as fast
            columns = [map(calls[tag], arguments[at::period]) for at, tag in enumerate(beat)]
            return zip(*columns, strict=True) if period > 1 else columns[0]
    return map(_CALL, map(calls.__getitem__, tags), arguments)


def split(stream: bytes) -> list[bytes]:
    """The records of a stream."""
    return [stream[at : at + RECORD_BYTES] for at in range(0, len(stream), RECORD_BYTES)]


def _bare_calls() -> list[Callable[..., Any]]:
    if not _calls:
        _calls[:] = [quick(row.name) for row in REPLAY]  # at once: another thread may look
    return _calls


def said(stream: bytes) -> Step:
    """A step that exhausts `saying`."""
    return partial(exhaust, saying(stream), 0)


def replay(stream: bytes) -> None:
    """Say the recorded calls to the driver one by one, with no signal handler between them."""
    exhaust(saying(stream), 0)


def able(mode: int) -> bool:
    """Whether a large primitive of this mode may be drawn from arrays in the state that the driver
    is in. Ask outside a primitive: these queries disturb nothing, not even Mesa's batching."""
    if mode not in _PARTED or not current_context():
        return False
    told = version_text()
    if told not in _obstacles:
        _obstacles[told] = obstacles_to_client_arrays()
    obstacles = _obstacles[told]
    return bool(
        obstacles
        and not any(map(integer, obstacles))
        and integer(GL_RENDER_MODE) == GL_RENDER  # each part would be a strip in feedback
        and not counting_if_seen()  # which vertices come twice, and how they are batched
        and integer(GL_CLIENT_ATTRIB_STACK_DEPTH) < integer(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH)
    )


_obstacles: dict[str, tuple[int, ...]] = {}
"""By version the integers that must be zero; empty when arrays are out of the question."""


class Parted(NamedTuple):
    """A primitive whose glBegin the driver has, in two parts."""

    head: Step
    """Says the first vertex; glEnd follows."""
    rest: Callable[[], list[Step]]
    """Asks the driver, outside the primitive, and gives what draws all of it in one glDrawArrays.
    """


def parted(mode: int, stream: bytes) -> Parted | None:
    """How a recorded primitive can be said in two parts. The app's array state is left as it was.

    None for a stream that only a replay renders exactly.

    Mesa 22.3 sets the terms. An empty glBegin/glEnd pair makes it lose the next primitive: hence
    the first vertex, which draws nothing by itself. Polygons are not shared out: which way a quad
    is cut depends on whether anything of its draw is clipped. An attribute that comes in different
    sizes, or for the first time after some vertices, makes it cut the primitive where its buffers
    happen to stand: hence replays.
    """
    start = int(mode == GL_POINTS)
    tags, values = decode(stream)
    period = _period(tags)
    if period:
        return _parted_regular(mode, stream, tags[:period], start)
    used = np.flatnonzero(np.bincount(tags, minlength=len(KIND)))
    kinds = KIND[tags]
    vertex_rows = np.flatnonzero(kinds == VERTEX)
    if _EDGE_FLAG_TAG in used or len(set(KIND[used].tolist())) < len(used):
        return None
    if len(vertex_rows) < 2:
        return None
    arrays: list[_Array] = []
    last: list[bytes] = []
    for tag in used:
        kind, size = int(KIND[tag]), int(SIZE[tag])
        rows = np.flatnonzero(tags == tag)
        if rows[0] > vertex_rows[0]:
            return None
        if kind != VERTEX:
            if rows[-1] < vertex_rows[0]:
                continue  # set once, before all vertices: the head says it
            at = int(rows[-1]) * RECORD_BYTES
            last.append(stream[at : at + RECORD_BYTES])
        which = np.cumsum(tags == tag)[vertex_rows[start:]] - 1
        array = np.ascontiguousarray(values[rows[which], :size])
        arrays.append((kind, size, array.ctypes._as_parameter_))
    return Parted(
        said(stream[: (int(vertex_rows[0]) + 1) * RECORD_BYTES]),
        lambda: [
            *_arrays_drawn(mode, len(vertex_rows) - start, arrays, 0), said(b"".join(last)),
        ],
    )  # fmt: skip


def _period(tags: NDArray[np.int32]) -> int:
    """Records a vertex when every vertex comes with the same calls before it, else 0."""
    head = KIND[tags[:_LONGEST_PERIOD]]
    vertices = np.flatnonzero(head == VERTEX)
    period = int(vertices[0]) + 1 if len(vertices) else 0
    if not period or len(tags) % period or len(set(head[:period].tolist())) < period:
        return 0
    regular = bool((tags.reshape(-1, period) == tags[:period]).all())
    return period if regular else 0


def _parted_regular(
    mode: int, stream: bytes, tags: NDArray[np.int32], start: int
) -> Parted | None:
    """The stream is an interleaved array as it stands: nothing is copied."""
    stride = len(tags) * RECORD_BYTES
    count = len(stream) // stride
    if _EDGE_FLAG_TAG in tags or count < 2:
        return None
    base = int(np.frombuffer(stream, np.uint8).ctypes.data) + start * stride
    arrays = [
        (int(KIND[tag]), int(SIZE[tag]), base + i * RECORD_BYTES) for i, tag in enumerate(tags)
    ]
    return Parted(
        said(stream[:stride]),
        lambda: [
            *_arrays_drawn(mode, count - start, arrays, stride), said(stream[-stride:-RECORD_BYTES])
        ],
    )  # fmt: skip


def _arrays_drawn(mode: int, count: int, arrays: list[_Array], stride: int) -> list[Step]:
    """One glDrawArrays from these arrays alone."""
    steps = [*_put_away(_texture_units())]
    generic = _generic_arrays()
    steps += [partial(gl.glDisableVertexAttribArray, index) for index in generic]
    for kind, size, address in arrays:
        steps.append(partial(gl.glEnableClientState, _ARRAYS[kind]))
        if kind == VERTEX:
            steps.append(partial(gl.glVertexPointer, size, GL_FLOAT, stride, address))
        elif kind == NORMAL:
            steps.append(partial(gl.glNormalPointer, GL_FLOAT, stride, address))
        elif kind == COLOR:
            steps.append(partial(gl.glColorPointer, size, GL_FLOAT, stride, address))
        else:
            steps.append(partial(gl.glTexCoordPointer, size, GL_FLOAT, stride, address))
    steps.append(partial(gl.glDrawArrays, mode, 0, count))
    steps += [partial(gl.glEnableVertexAttribArray, index) for index in generic]
    steps.append(gl.glPopClientAttrib)
    return steps


@lru_cache
def _put_away(last_unit: int) -> tuple[Step, ...]:
    """The app's arrays are kept, and off."""
    steps: list[Step] = [partial(gl.glPushClientAttrib, GL_CLIENT_VERTEX_ARRAY_BIT)]
    steps += [partial(gl.glDisableClientState, state) for state in _CLIENT_STATES]
    with suppress(AttributeError):  # OpenGL 1.4 has no buffers to unbind
        steps.append(partial(gl.glBindBuffer, GL_ARRAY_BUFFER, 0))
    for unit in range(last_unit, -1, -1):
        steps.append(partial(gl.glClientActiveTexture, GL_TEXTURE0 + unit))
        steps.append(partial(gl.glDisableClientState, GL_TEXTURE_COORD_ARRAY))
    return tuple(steps)


def _generic_arrays() -> list[int]:
    """Generic attribute arrays that the app has left enabled: a draw would read them."""
    try:
        get = gl.glGetVertexAttribiv
    except AttributeError:
        return []
    found, value = [], ctypes.c_int(0)
    for index in range(min(integer(GL_MAX_VERTEX_ATTRIBS), _ATTRIBUTES)):
        get(index, GL_VERTEX_ATTRIB_ARRAY_ENABLED, ctypes.byref(value))
        if value.value:
            found.append(index)
    return found


def _texture_units() -> int:
    """Highest texture unit whose client array may be enabled."""
    return max(0, min(integer(GL_MAX_TEXTURE_UNITS), _UNITS) - 1)


def check(real: Callable[..., Any], args: tuple[Any, ...] = ()) -> Any:
    """PyOpenGL's own error check of a call with these arguments that was made past it."""
    function = getattr(real, "__self__", None)
    checker = getattr(function, "errcheck", None)
    return checker(None, function, args) if checker is not None else None


def error_checker() -> Any:
    """PyOpenGL's error checker for GL, None when the app has switched error checking off."""
    from OpenGL.raw.GL import _errors

    return _errors._error_checker
