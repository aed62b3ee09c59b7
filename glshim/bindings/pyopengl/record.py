"""The record of the primitive that is open, and of what an open list says outside primitives."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from threading import local

from glshim.bindings.base import PrimitiveSink
from glshim.bindings.pyopengl import forward
from glshim.driver.ask import integer
from glshim.driver.context import list_closed, list_opened
from glshim.spec.attributes import RECORD_BYTES
from glshim.spec.constants import GL_COMPILE, GL_LIST_MODE, GL_RENDER, GL_RENDER_MODE
from glshim.system.interrupts import at_once


class Record(local):
    """A `glshim.bindings.base.PrimitiveStream`, and the state that the recording hooks share.

    In one of three states: nothing is recorded; vertices are held back from the driver (`held`);
    or what goes straight through to it is recorded as well (`shadow`).

    Each thread has a primitive and a list of its own: what is set in `__init__`, which each runs
    when it is met first. Slots are those of all threads.
    """

    __slots__ = ("aside", "modes", "sink")

    aside: bool
    """Nothing is to be held back: `stand_aside`."""
    modes: bool
    """Some context may be in another render mode than GL_RENDER: `render_mode_seen`."""
    sink: PrimitiveSink | None

    def __new__(cls) -> Record:
        record = super().__new__(cls)
        record.aside = record.modes = False
        record.sink = None
        return record

    def __init__(self) -> None:
        self.list_open = False
        self.only_compiled = False
        """A list is open and not executed: the driver stays outside primitives."""
        self.records: list[bytes] = []
        self.write: Callable[[bytes], None] = self.records.append
        """Records what is said."""
        self.held: Callable[[bytes], None] | None = None
        """`write` while vertices are held back, else None."""
        self.shadow = False
        self.loose = False
        """Inside a display list, outside any primitive of it; a shadow, too."""
        self.sequences: frozenset[type] | None = None
        """What PyOpenGL's own handlers of arrays convert, of list, tuple and array; None until that
        is asked in this primitive."""
        self.mode = 0

    def inside(self) -> bool:
        """Whether this thread has a recorded glBegin open."""
        return (self.held is not None or self.shadow) and not self.loose

    def unsaid(self) -> bool:
        """Whether nothing of the open primitive has reached the driver but its beginning."""
        return self.held is not None

    def position(self) -> int:
        """Bytes recorded so far."""
        return RECORD_BYTES * len(self.records)

    def stream(self) -> bytes:
        """All that is recorded so far."""
        return b"".join(self.records)

    def restart(self) -> None:
        """An empty record."""
        self.records = []
        self.write = self.records.append

    def spill(self) -> None:
        """Send what is held back, call by call; the rest of the primitive follows at once."""
        if self.held is not None:
            at_once((
                partial(setattr, self, "held", None),
                partial(setattr, self, "shadow", True),
                forward.said(self.stream()),
            ))  # fmt: skip

    def ended_unheard(self) -> None:
        """C code has ended the open primitive, with vertices that nobody heard of."""
        self.spill()
        self.shadow = False
        if self.sink is not None:
            self.sink.end(self.mode, b"")

    def stand_aside(self) -> None:
        """From now on all goes straight through to the driver."""
        self.aside = True
        self.spill()

    def render_mode_seen(self) -> None:
        """From now on it is asked for before anything is held back: in feedback and selection the
        driver writes into the program's memory while a primitive is open."""
        self.modes = True

    def is_read(self) -> bool:
        """Whether the driver writes what is drawn into the program's memory. Outside primitives."""
        return self.modes and integer(GL_RENDER_MODE) != GL_RENDER

    def extend(self, records: bytes) -> None:
        """Add records of vertices that reached the driver another way."""
        if self.shadow:
            self.records += forward.split(records)

    def replay(self, records: bytes) -> None:
        """Say records to the driver, call by call, past every hook."""
        forward.replay(records)

    # -- display lists ---------------------------------------------------------------------------

    def open_list(self, *, capturing: bool) -> None:
        """A list begins; when capturing, what is said outside primitives is recorded, too."""
        self.spill()
        self.list_open = True
        self.only_compiled = integer(GL_LIST_MODE) == GL_COMPILE
        list_opened()
        if capturing and not self.shadow:
            self.between()

    def between(self) -> None:
        """An open list has ended a primitive: what is said until the next one is outside."""
        self.restart()
        self.loose = self.shadow = True

    def close_list(self) -> None:
        """It ends: what is recorded goes into it, also of a primitive that it leaves open."""
        self.spill()
        self.settle()
        if self.sink is not None and self.shadow and not self.loose:
            self.sink.unfinished(self.mode, self.stream())
        self.loose = self.shadow = False
        self.list_open = self.only_compiled = False
        list_closed()

    def settle(self) -> None:
        """Tell the sink what an open list has said outside primitives so far."""
        if self.loose and self.records:
            if self.sink is not None:
                self.sink.loose(self.stream())
            self.restart()

    def resume(self, mode: int, records: bytes) -> None:
        """A list that was called left a primitive open, with these records in it."""
        self.restart()
        self.records += forward.split(records)
        self.mode = mode
        self.shadow = True

    def finish(self) -> tuple[int, bytes] | None:
        """A list that was called has closed the primitive: its mode and records."""
        if not self.shadow and self.held is None:
            return None
        self.spill()
        self.shadow = False
        return self.mode, self.stream()
