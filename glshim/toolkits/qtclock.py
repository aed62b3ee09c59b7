"""Qt's clocks, held: timers come by the moment, and QElapsedTimer shows it.

Qt's own timers run as ever; an event filter lets an event through once its moment is there. Timers
that C++ started are not touched, nor are those of other threads.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable
from typing import Any

from glshim.toolkits.base import Changes
from glshim.toolkits.moment import Alarm, Moment

TIMER = 1
"""QEvent::Timer."""
_ALARM, _STARTED = "glshim_alarm", "glshim_started"
"""Attributes of a QTimer that was started, and of a QElapsedTimer."""


class QtClock:
    """The clocks of one binding."""

    def __init__(self, core: Any, moment: Moment) -> None:
        """core: its module QtCore."""
        self._core, self._moment = core, moment
        self._by_number: dict[int, Alarm] = {}
        """Of QObject.startTimer and QBasicTimer, by the number that Qt gave."""
        self._filtered: tuple[Any, Any] = (None, None)
        """The application and its event filter, which Qt does not own."""
        self._single: set[Any] = set()
        """Timers of QTimer.singleShot."""

    def serve(self, changes: Changes) -> None:
        """Put ours in the place of Qt's own."""
        timer = getattr(self._core, "QTimer", None)
        if timer is not None:
            changes.set(timer, "start", self._starting(timer.start))
            changes.set(timer, "setInterval", self._starting(timer.setInterval, only_active=True))
            changes.set(timer, "stop", self._stopping(timer.stop))
            changes.set(timer, "singleShot", staticmethod(self._shooting(timer)))
        base = self._core.QObject
        if hasattr(base, "startTimer"):
            changes.set(base, "startTimer", self._starting_number(base.startTimer))
            changes.set(base, "killTimer", self._killing(base.killTimer))
        self._hold_elapsed(self._core.QElapsedTimer, changes)

    # -- timers ----------------------------------------------------------------------------------

    def _starting(self, plain: Callable[..., Any], *, only_active: bool = False) -> Any:
        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def start(timer: Any, *arguments: Any, **named: Any) -> Any:
            result = plain(timer, *arguments, **named)
            if not only_active or timer.isActive():
                self._forget(timer)
                if self._watches():
                    setattr(timer, _ALARM, Alarm(self._moment, timer.interval() / 1000))
            return result

        return start

    def _stopping(self, plain: Callable[..., Any]) -> Any:
        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def stop(timer: Any) -> Any:
            self._forget(timer)
            return plain(timer)

        return stop

    def _forget(self, timer: Any) -> None:
        alarm = getattr(timer, _ALARM, None)
        if alarm is not None:
            alarm.stop()
            setattr(timer, _ALARM, None)

    def _shooting(self, kind: Any) -> Any:
        plain = kind.singleShot

        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def single_shot(milliseconds: int, *arguments: Any) -> Any:
            slot = arguments[-1] if arguments else None
            if not milliseconds or not callable(slot) or not self._watches():
                return plain(milliseconds, *arguments)
            timer = kind()

            def over() -> None:
                self._single.discard(timer)

            timer.setSingleShot(True)
            timer.timeout.connect(slot)
            timer.timeout.connect(over)
            self._single.add(timer)
            return timer.start(milliseconds)

        return single_shot

    def _starting_number(self, plain: Callable[..., Any]) -> Any:
        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def start_timer(target: Any, interval: int, *arguments: Any, **named: Any) -> Any:
            number = plain(target, interval, *arguments, **named)
            if number and self._watches():
                self._by_number[number] = Alarm(self._moment, interval / 1000)
            return number

        return start_timer

    def _killing(self, plain: Callable[..., Any]) -> Any:
        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def kill_timer(target: Any, number: int) -> Any:
            alarm = self._by_number.pop(number, None)
            if alarm is not None:
                alarm.stop()
            return plain(target, number)

        return kill_timer

    # -- events ----------------------------------------------------------------------------------

    def _watches(self) -> bool:
        """Whether events of a timer that is started now pass our filter."""
        app = self._core.QCoreApplication.instance()
        if app is None or threading.current_thread() is not threading.main_thread():
            return False
        if self._filtered[0] is not app:
            event_filter = self._filter_class()()
            app.installEventFilter(event_filter)
            self._filtered = app, event_filter
        return True

    def _filter_class(self) -> Callable[[], Any]:
        waits = self._waits

        class Filter(self._core.QObject):  # type: ignore[misc, name-defined]
            """Keeps timers' events until their moment is there."""

            def eventFilter(self, watched: Any, event: Any) -> bool:
                try:
                    return enumerator(event.type()) == TIMER and waits(watched, event)
                except Exception:  # PyQt ends the program at one
                    return False

        return Filter

    def _waits(self, watched: Any, event: Any) -> bool:
        """Whether an event comes too early."""
        alarm = getattr(watched, _ALARM, None)
        again = True
        if alarm is not None:
            again = not watched.isSingleShot()
        else:
            alarm = self._by_number.get(event.timerId())
        return alarm is not None and not alarm.comes(again=again)

    # -- QElapsedTimer ---------------------------------------------------------------------------

    def _hold_elapsed(self, kind: Any, changes: Changes) -> None:
        moment = self._moment

        def passed(timer: Any) -> float:
            return moment.now - getattr(timer, _STARTED, moment.now)

        def start(timer: Any) -> None:
            setattr(timer, _STARTED, moment.now)
            plain_start(timer)

        def restart(timer: Any) -> int:
            before = elapsed(timer)
            start(timer)
            return before

        def elapsed(timer: Any) -> int:
            return round(passed(timer) * 1000)

        def nanoseconds(timer: Any) -> int:
            return round(passed(timer) * 1e9)

        def has_expired(timer: Any, milliseconds: int) -> bool:
            return 0 <= milliseconds < elapsed(timer)

        plain_start = kind.start
        for name, replacement in (("start", start), ("restart", restart), ("elapsed", elapsed),
                                  ("nsecsElapsed", nanoseconds),
                                  ("hasExpired", has_expired)):  # fmt: skip
            changes.set(kind, name, replacement)


def enumerator(value: Any) -> int:
    """An enumerator, of Python's or of a binding's own kind."""
    return int(getattr(value, "value", value))
