"""Programs that paint once and rest: they are asked for the frames that are still wanted, and ended
where none come."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress

from glshim import toolkits
from glshim.notices import say
from glshim.running import runners
from glshim.toolkits import frames
from glshim.toolkits.frames import ASKED_AGAIN, RESTS
from glshim.toolkits.moment import Moment, real_clock, real_sleep

PATIENCE = 8.0
"""Seconds without a frame after which a program that shows frames on demand is done; three times
its longest wait so far where that is more."""
_AT_WORK = 8.0
"""Times that patience, as long as it draws, or the style does."""
_IDLE = 0.25
"""Share of one processor that a program takes at most while it waits for something to happen."""
_LOOK = 0.1
"""Seconds between two looks."""
_NEXT_ALARM = 0.2
"""Seconds without a frame after which a program whose clocks stand still gets its next timer."""
_COMES_UP = 2.0
"""The same before its first frame."""
_ALARMS = 10
"""Timers without a frame after which it is asked for one."""


def watch(
    shown: Callable[[], int],
    *,
    moment: Moment | None = None,
    patience: Callable[[], float] = lambda: 1.0,
) -> None:
    """Ask a program that rests for frames, and end one that shows none any more, in a thread of its
    own. One that shows none at all is left alone.

    shown: how many frames it has shown. moment: what its clocks show, where they stand still: time
    passes while it waits for its timers. patience: times what is waited otherwise.
    """
    watcher = _Watcher(shown, moment, patience)
    threading.Thread(target=watcher.run, name="glshim-rest", daemon=True).start()


def draws() -> int:
    """Draws of the program's that a style has looked at so far."""
    try:
        from glshim import pipeline  # which a program that ends early may never need
    except (ImportError, KeyError):  # it ends just now, and its modules are taken apart
        return 0
    census = pipeline.census()
    return 0 if census is None else census.draws()


class _Watcher:
    def __init__(
        self, shown: Callable[[], int], moment: Moment | None, patience: Callable[[], float]
    ) -> None:
        self._shown, self._moment, self._patience = shown, moment, patience
        self._seen, self._longest = 0, 0.0
        self._since = self._worked = real_clock()
        self._pause = RESTS
        self._asked = self._done = False
        self._drawn, self._drew = 0, self._since
        """Draws so far, and when there was one last."""
        self._alarms, self._skipped = 0, self._since
        """Timers since the last frame, and when the last one came."""

    def run(self) -> None:
        used = time.process_time()
        while not self._done:
            real_sleep(_LOOK)
            before, used = used, time.process_time()
            if used - before > _IDLE * _LOOK:
                self._worked = real_clock()
            self.look()

    def look(self) -> None:
        now, shown = real_clock(), self._shown()
        if shown != self._seen:
            # One that shows them by itself is left more time than one that waits to be asked.
            self._pause, self._asked = (ASKED_AGAIN if self._asked else RESTS), False
            if self._seen:  # what comes before the first frame tells nothing
                self._longest = max(self._longest, now - self._since)
            self._seen, self._since = shown, now
            self._alarms = 0
        drawn = draws()
        if drawn != self._drawn or frames.showing():
            self._drawn, self._drew = drawn, now
        rests = now - max(self._since, self._worked)
        if self._moment is not None and self._waits_for_an_alarm(self._moment, rests):
            if now - self._skipped > _NEXT_ALARM:
                self._alarms, self._skipped = self._alarms + 1, now
                self._moment.skip()
            return
        if not shown:
            return
        # Loops of toolkits that stand still are never idle.
        silent = rests if self._moment is None else now - self._since
        patience = max(PATIENCE, 3.0 * self._longest) * self._patience()
        silent_at_work = min(silent, now - self._drew)
        if silent_at_work > patience or silent > _AT_WORK * patience:
            self._end()
        elif not self._asked and not frames.leaving() and rests > self._pause_now():
            self._asked = True
            toolkits.redraw_from_a_thread()

    def _pause_now(self) -> float:
        """Seconds of rest after which it is asked."""
        held = self._moment is not None and self._moment.held  # then all it draws is asked for
        return ASKED_AGAIN if held else self._pause

    def _waits_for_an_alarm(self, moment: Moment, rests: float) -> bool:
        if not moment.alarms or self._alarms >= _ALARMS:
            return False
        if moment.held:  # it may draw by its timers alone
            return self._asked and rests > RESTS
        return rests > (_NEXT_ALARM if self._seen else _COMES_UP)

    def _end(self) -> None:
        self._since = real_clock()
        if runners.runner():  # it decides by itself when it is done
            self._done = True
            return
        if not frames.leaving():
            say(f"ended the program: it shows nothing new after frame {self._seen}")
            frames.leave_now(toolkits.leave)
            return
        say("ended the program: its main loop did not return when asked to")
        for stream in (sys.stdout, sys.stderr):
            with suppress(Exception):
                stream.flush()
        os._exit(0)
