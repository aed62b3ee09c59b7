"""Programs that draw in several threads: each has a primitive and a list of its own.

One thread costs nothing: its record has plain slots. From the second one on the same record looks
in the state of the thread that asks.
"""

from __future__ import annotations

import threading
from _thread import _count
from operator import attrgetter
from threading import get_ident
from typing import Any

from glshim.bindings.pyopengl.record import Record

_OWN = (
    "able", "held", "home", "list_open", "loose", "mode", "records", "sequences", "shadow", "write",
)  # fmt: skip
"""What each thread has of its own. Not what holds for the program as a whole."""

others = _count
"""How many threads Python has started that run still."""



class _State(threading.local):
    """Of one thread; the one that was alone so far keeps what it had."""

    def __init__(self, home: int, kept: dict[str, Any]) -> None:
        fresh = Record()
        vars(self).update(
            kept if get_ident() == home else {name: getattr(fresh, name) for name in _OWN})


class _Shared(Record):
    """A record with a state for each thread."""

    __slots__ = ()


def _own(name: str) -> property:
    def put(record: Record, value: Any) -> None:
        setattr(record.own, name, value)

    return property(attrgetter(f"own.{name}"), put)


for _name in _OWN:
    setattr(_Shared, _name, _own(_name))


def look(record: Record) -> None:
    """Before a primitive of a thread that is not alone, or opens its first one."""
    if isinstance(record, _Shared) or not (others() or record.home):
        return
    home = record.home or get_ident()  # what a list holds is this thread's, before any primitive
    record.own = _State(home, {name: getattr(record, name) for name in _OWN})
    record.__class__ = _Shared
