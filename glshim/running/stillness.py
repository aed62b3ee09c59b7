"""Clocks and luck that stand still while a frame is made, so that runs of one program show the same
moment: `glshim gallery` and `glshim shot` ask for it, and so do the tests.

Time moves by `STEP` with each presented frame, and by what the program sleeps. GLUT's timers and
idle calls are served one round a frame, after the window has settled. Clocks of C libraries that
Python does not ask (Qt's timers) run on.
"""

from __future__ import annotations

import random
import sys
import threading
import time

from glshim import toolkits
from glshim.bindings.imports import after_import
from glshim.notices import say
from glshim.toolkits import Part, frames
from glshim.toolkits.frames import Stage
from glshim.toolkits.moment import MOMENT, Moment, real_clock, real_sleep

VARIABLE = "GLSHIM_STILL"
"""Set by us for programs that we start; never by people."""
PATIENCE = 8.0
"""Seconds without a frame after which a program that shows frames on demand is done; three times
its longest wait so far where that is more."""
_LARGE = 20.0
"""Times that for a frame of a moment that is held: it may be a large picture."""
_START = 1_600_000_000.0


def begin() -> None:
    """Hold this process's clocks and luck, and those of toolkits when they are imported."""
    still_luck()
    still_clock(MOMENT)
    after_import("numpy.random", lambda module: module.seed(1))
    toolkits.watch(Part.CLOCK)


def count_frames() -> None:
    """Let time pass with the frames that the shim sees presented, and end a program that shows
    none any more."""
    frames.listen(Stage.CLOCK, after=MOMENT.frame_ends)
    threading.Thread(target=_watch, args=(MOMENT,), daemon=True).start()


def still_luck() -> None:
    """Seed what is random."""
    random.seed(1)
    numpy_random = sys.modules.get("numpy.random")
    if numpy_random is not None:
        numpy_random.seed(1)


def still_clock(moment: Moment) -> None:
    """The clocks of module `time` show the moment; sleeping moves it."""
    for name, base in (("time", _START), ("perf_counter", 0.0), ("monotonic", 0.0),
                       ("process_time", 0.0), ("clock", 0.0)):  # fmt: skip
        setattr(time, name, lambda base=base: base + moment.now)
        setattr(time, name + "_ns", lambda base=base: int((base + moment.now) * 1e9))
    time.sleep = moment.pass_by  # type: ignore[assignment]


def _watch(moment: Moment) -> None:
    seen, since, longest = 0, real_clock(), 0.0
    while True:
        real_sleep(0.2)
        if moment.frames != seen:
            longest = max(longest, real_clock() - since)
            seen, since = moment.frames, real_clock()
        elif seen and real_clock() - since > max(PATIENCE, 3.0 * longest) * (
            _LARGE if moment.held else 1.0
        ):
            say(f"the program shows nothing new after frame {seen}, and was ended there")
            frames.exit_now()
