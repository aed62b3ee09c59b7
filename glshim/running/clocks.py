"""Python's clocks, held: modules `time` and `datetime` show a moment that somebody moves.

Local time is what the system's zone says of that moment. Clocks that C libraries ask by themselves
run on.
"""

from __future__ import annotations

import copyreg
import datetime
import time
from collections.abc import Callable
from typing import Any

from glshim.toolkits.moment import Moment

START = 1_600_000_000.0
"""Seconds since the epoch at which a program starts: 2020-09-13 12:26:40 UTC."""


def hold(moment: Moment) -> None:
    """From now on this process's clocks show the moment, and sleeping moves it."""
    _hold_time(moment)
    _hold_datetime(lambda: START + moment.now)


def _hold_time(moment: Moment) -> None:
    for name, base in (("time", START), ("perf_counter", 0.0), ("monotonic", 0.0),
                       ("process_time", 0.0), ("thread_time", 0.0), ("clock", 0.0)):  # fmt: skip
        setattr(time, name, lambda base=base: base + moment.now)
        setattr(time, name + "_ns", lambda base=base: int((base + moment.now) * 1e9))
    time.sleep = moment.pass_by  # type: ignore[assignment]
    for name in ("localtime", "gmtime", "ctime"):
        setattr(time, name, _now_unless_told(getattr(time, name)))
    of_fields, in_words = time.strftime, time.asctime
    time.strftime = lambda form, *fields: of_fields(form, *(fields or (time.localtime(),)))
    time.asctime = lambda *fields: in_words(*(fields or (time.localtime(),)))
    if hasattr(time, "clock_gettime"):  # POSIX
        bases = {time.CLOCK_REALTIME: START}
        time.clock_gettime = lambda clock: bases.get(clock, 0.0) + moment.now
        time.clock_gettime_ns = lambda clock: int(time.clock_gettime(clock) * 1e9)


def _now_unless_told(plain: Callable[[float], Any]) -> Callable[..., Any]:
    def of(seconds: float | None = None) -> Any:
        return plain(time.time() if seconds is None else seconds)

    return of


def _hold_datetime(now: Callable[[], float]) -> None:
    """`datetime.datetime` is C's and cannot be changed, so a subclass takes its place, to which
    instances of either belong. Both kinds of `today` ask `time.time`."""
    plain = datetime.datetime

    class Kind(type):
        def __instancecheck__(cls, value: object) -> bool:
            return isinstance(value, plain) if cls is held else super().__instancecheck__(value)

        def __subclasscheck__(cls, kind: type) -> bool:
            return issubclass(kind, plain) if cls is held else super().__subclasscheck__(kind)

    def now_of(cls: type[datetime.datetime], tz: datetime.tzinfo | None = None) -> Any:
        return cls.fromtimestamp(now(), tz)

    def utcnow_of(cls: type[datetime.datetime]) -> Any:
        return cls.fromtimestamp(now(), datetime.timezone.utc).replace(tzinfo=None)

    def written(value: datetime.datetime) -> str:
        text = plain.__repr__(value)
        return f"datetime.{text}" if type(value) is held else text

    held = Kind("datetime", (plain,), {
        "__module__": "datetime", "__doc__": plain.__doc__, "__slots__": (), "__repr__": written,
        "now": classmethod(now_of), "utcnow": classmethod(utcnow_of),
    })  # fmt: skip
    datetime.datetime = held  # type: ignore[misc, assignment]
    # Pickles name classes: one that C made is pickled as the kind that has the name.
    copyreg.pickle(plain, lambda value: (held, value.__reduce__()[1]))  # type: ignore[arg-type, return-value]
