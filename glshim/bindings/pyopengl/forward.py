"""Hands a recorded primitive to the real fixed-function GL: call by call through the bare driver.

Not as one glDrawArrays, which is quicker by a seventh: drivers interpolate what is the same for a
whole draw with other roundings than what every vertex has, and what an earlier primitive said per
vertex every vertex has until some state changes (Mesa 22.3).
"""

from __future__ import annotations

import ctypes
import operator
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from struct import Struct
from typing import Any

from glshim.driver.functions import quick
from glshim.spec.attributes import (
    RECORD_BYTES,
    REPLAY,
    TAG_OFFSET,
)
from glshim.system.interrupts import exhaust

_LONGEST_PERIOD = 4
_FLOAT = Struct("=f")
_ONE = _FLOAT.pack(1.0)

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


def check(real: Callable[..., Any], args: tuple[Any, ...] = ()) -> Any:
    """PyOpenGL's own error check of a call with these arguments that was made past it."""
    function = getattr(real, "__self__", None)
    checker = getattr(function, "errcheck", None)
    return checker(None, function, args) if checker is not None else None


def error_checker() -> Any:
    """PyOpenGL's error checker for GL, None when the app has switched error checking off."""
    from OpenGL.raw.GL import _errors

    return _errors._error_checker
