"""Records what is said between glBegin and glEnd, and hands it on at glEnd.

The driver's glBegin is issued at once, so whatever is illegal inside a primitive fails there as it
would without us. Vertices and attributes are packed into 20-byte records instead of being sent; at
glEnd they go to the driver in one piece (``forward.py``). Anything that may look at or depend on
them before that makes the recorder *spill*: what was recorded is replayed call by call, and the
rest of the primitive goes straight through, recorded as well.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from functools import partial
from itertools import chain
from typing import Any, NamedTuple

from glshim.bindings.pyopengl import attributes, bare, conversions, forward
from glshim.bindings.pyopengl.raw import RAW, Call, Maker
from glshim.bindings.pyopengl.record import Record
from glshim.bindings.pyopengl.vectors import vectors
from glshim.driver.functions import gl, quick
from glshim.spec.attributes import ATTRIBUTES
from glshim.spec.constants import GL_TRIANGLE_STRIP_ADJACENCY
from glshim.system.interrupts import Held, exhaust, in_turn

_LAST_MODE = GL_TRIANGLE_STRIP_ADJACENCY
"""Greater modes are errors inside glBegin."""
_ENUM = 0xFFFFFFFF
"""What C keeps of an integer."""


class Recorder:
    """The recording hooks. One instance: :data:`RECORDER`."""

    def __init__(self) -> None:
        self.record = Record()
        self._set: list[tuple[Callable[[str, Maker | None], None], str]] = []
        self._watch_ends: Callable[[], None] = type(None)

    def install(self) -> None:
        """Hook glBegin, glEnd and every recorded attribute."""
        from OpenGL import _configflags

        # A log of every call, or a check of the context at each: nothing may be held back then.
        debugging = ("FULL_LOGGING", "ERROR_LOGGING", "CONTEXT_CHECKING")
        careful = any(getattr(_configflags, flag) for flag in debugging)
        raw, wrappers = self._makers(_configflags.ERROR_CHECKING and not careful, careful)
        for name, maker in raw.items():
            RAW.hook(name, maker)
            self._set.append((RAW.hook, name))
        # ERROR_ON_COPY promises an error for every list: leave the wrappers to raise it.
        if not _configflags.ERROR_ON_COPY:
            for name, maker in wrappers.items():
                RAW.hook_wrapper(name, maker)
                self._set.append((RAW.hook_wrapper, name))
        self._watch_ends = bare.watch(self.record)

    def uninstall(self) -> None:
        """Send what is still recorded and take the hooks away."""
        self._watch_ends()
        self.record.aside = False
        self.record.spill()
        for place, name in self._set:
            place(name, None)
        self._set.clear()

    def _makers(
        self, quick_begin: bool, careful: bool
    ) -> tuple[dict[str, Maker], dict[str, Maker]]:
        """Makers by name for the raw layer and for the wrappers. When ``careful``, everything goes
        straight through and is recorded beside that."""
        begin, end = _brackets(self.record, careful)
        raw: dict[str, Maker] = {"glBegin": partial(begin, checked=True), "glEnd": end}
        wrappers: dict[str, Maker] = {}
        if quick_begin:
            unchecked = partial(begin, checked=False)
            wrappers["glBegin"] = _quick("glBegin", unchecked, "onBegin", 1)
            wrappers["glEnd"] = _quick("glEnd", end, "onEnd", 0)
        for row in ATTRIBUTES:
            vector = row.name + "v"
            raw[row.name] = attributes.scalars(self.record, row)
            raw[vector] = attributes.pointers(self.record, row)
            wrappers[vector] = vectors(self.record, row)
        return raw, wrappers


class _Brackets(NamedTuple):
    """Makers of the hooks of glBegin and glEnd."""

    begin: Callable[..., Call]
    """Takes the original, and whether PyOpenGL's error check is made."""
    end: Maker


def _brackets(record: Record, careful: bool) -> _Brackets:
    def make_begin(real: Call, checked: bool) -> Call:
        driver_begin = quick("glBegin")
        integers = conversions.integers()
        function = conversions.function_of(real)
        converted: Callable[..., tuple[Any, ...]] | None = None

        def begin(*args: Any, **named: Any) -> Any:
            nonlocal converted
            own = record.__dict__  # this thread's values, looked up once
            if own["loose"]:
                record.settle()
                own["loose"] = own["shadow"] = False
            plain = len(args) == 1 and type(args[0]) in integers
            if plain:
                mode = args[0] & _ENUM
            elif function is None:
                return real(*args, **named)
            else:
                if converted is None:
                    converted = conversions.numbers(function, "e")
                mode = converted(*args, **named)[0]
            if own["held"] is not None or own["shadow"] or mode > _LAST_MODE:
                if plain:
                    return real(*args, **named)
                driver_begin(mode)
                return forward.check(real, args)
            sink = record.sink
            try:
                if sink is not None:
                    sink.begin(mode)
                records: list[bytes] = []
                own["records"] = records
                own["write"] = write = records.append
                own["mode"] = mode
                own["sequences"] = None
                straight = careful or record.aside or (record.modes and record.is_read())
                if not straight:
                    own["held"] = write
            except BaseException:  # a signal handler's, before the primitive
                own["held"] = None
                if sink is not None:
                    sink.refused()
                raise
            # What is raised now finds the primitive open.
            if straight:
                own["shadow"] = True
                if plain:
                    return real(*args, **named)
            driver_begin(mode)
            return forward.check(real, args) if checked else None

        return begin

    def make_end(real: Call) -> Call:
        function = conversions.function_of(real)

        def end(*args: Any, **named: Any) -> Any:
            own = record.__dict__  # as in begin
            held = own["held"] is not None
            if not held and not own["shadow"]:
                return real(*args, **named)
            sink = record.sink
            if own["loose"]:
                record.settle()
                if sink is not None:
                    sink.stray_end()
                return real(*args, **named)
            if args and function is not None:
                conversions.numbers(function, "")(*args)
            mode, records = own["mode"], own["records"]
            stream = b"".join(records)
            taker = sink if own["list_open"] else None
            so_far = 0 if taker is None else taker.listed()
            if careful:
                whole: Iterable[Any] = ()
            else:
                ended = in_turn((gl.glEnd,))
                whole = chain(forward.saying(stream, records), ended) if held else ended
            try:
                try:
                    try:
                        exhaust(whole, 0)  # before it the primitive is open, after it no more
                    finally:
                        own["held"], own["shadow"] = None, False
                    # Not returned from in here: between the blocks that ends nothing is caught.
                    result = real(*args, **named) if careful else forward.check(real, args)
                finally:
                    if sink is not None:
                        sink.end(mode, stream)
                        if taker is not None:
                            record.between()
            except BaseException:
                if taker is not None:  # the list has the primitive by now
                    with Held():
                        if taker.listed() == so_far:
                            taker.end(mode, stream)
                        record.between()
                raise
            return result

        return end

    return _Brackets(make_begin, make_end)


_HOME = "OpenGL.GL.exceptional"
"""Where PyOpenGL wraps glBegin and glEnd."""


def _quick(name: str, make: Maker, bookkeeping: str, count: int) -> Maker:
    """What PyOpenGL's lazy wrapper does, less two Python calls: its bookkeeping, then the hook."""

    def make_wrapper(base: Call) -> Call:
        own: Any = None  # PyOpenGL's; a program may have one of its own
        hook: Call = base
        before: Call = type(None)  # does nothing

        def wrapper(this: Any, *args: Any, **named: Any) -> Any:
            nonlocal own, hook, before
            if this is not own or named or len(args) != count:
                real = RAW.original(name)
                its = getattr(sys.modules.get(_HOME), name, None)
                if real is None or this is not its or named or len(args) != count:
                    return base(this, *args, **named)  # the long way loads it, or raises
                before = getattr(forward.error_checker(), bookkeeping)
                hook = make(real)
                own = this  # last: another thread may come by
            before()
            return hook(*args)

        return wrapper

    return make_wrapper


RECORDER = Recorder()
