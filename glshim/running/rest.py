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
from glshim.toolkits.moment import real_clock, real_sleep

PATIENCE = 8.0
"""Seconds without a frame after which a program that shows frames on demand is done; three times
its longest wait so far where that is more."""
_IDLE = 0.25
"""Share of one processor that a program takes at most while it waits for something to happen."""
_LOOK = 0.1
"""Seconds between two looks."""


def watch(
    shown: Callable[[], int], *, asks: bool = False, patience: Callable[[], float] = lambda: 1.0
) -> None:
    """End a program that shows frames no more, in a thread of its own. One that shows none at all
    is left alone.

    shown: how many frames it has shown. asks: its toolkit is asked for frames, and a program that
    works is not taken for one that rests. patience: times what is waited otherwise.
    """
    watcher = _Watcher(shown, asks, patience)
    threading.Thread(target=watcher.run, name="glshim-rest", daemon=True).start()


class _Watcher:
    def __init__(
        self, shown: Callable[[], int], asks: bool, patience: Callable[[], float]
    ) -> None:
        self._shown, self._asks, self._patience = shown, asks, patience
        self._seen, self._longest = 0, 0.0
        self._since = self._worked = real_clock()
        self._pause = RESTS
        self._asked = self._done = False

    def run(self) -> None:
        used = time.process_time()
        while not self._done:
            real_sleep(_LOOK)
            before, used = used, time.process_time()
            if self._asks and used - before > _IDLE * _LOOK:
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
        if not shown:
            return
        rests = now - max(self._since, self._worked if self._asks else 0.0)
        if rests > max(PATIENCE, 3.0 * self._longest) * self._patience():
            self._end()
        elif self._asks and not self._asked and not frames.leaving() and rests > self._pause:
            self._asked = True
            toolkits.redraw_from_a_thread()

    def _end(self) -> None:
        self._since = real_clock()
        if runners.runner():  # it decides by itself when it is done
            self._done = True
            return
        if not frames.leaving():
            say(f"the program shows nothing new after frame {self._seen}, and was ended there")
            frames.leave_now(toolkits.leave)
            return
        say("the program did not end when its main loop was asked to, and was ended")
        for stream in (sys.stdout, sys.stderr):
            with suppress(Exception):
                stream.flush()
        os._exit(0)
