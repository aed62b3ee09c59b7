"""Clocks and luck that stand still while a frame is made, so that runs of one program show the same
moment: `glshim gallery` and `glshim shot` ask for it, and so do the tests.

Time moves by `STEP` with each presented frame, and by what the program sleeps. GLUT's timers and
idle calls are served one round a frame, after the window has settled. Clocks of toolkits that say
that they lack this (`glshim doctor`) run on, and so do those of other C libraries.
"""

from __future__ import annotations

import threading

from glshim import toolkits
from glshim.notices import say
from glshim.running import clocks, luck
from glshim.toolkits import Part, frames
from glshim.toolkits.frames import Stage
from glshim.toolkits.moment import MOMENT, Moment, real_clock, real_sleep

VARIABLE = "GLSHIM_STILL"
"""Set by us for programs that we start; never by people."""
PATIENCE = 8.0
"""Seconds without a frame after which a program that shows frames on demand is done; three times
its longest wait so far where that is more."""
_HELD_PATIENCE = 20.0
"""Times that for a frame of a moment that is held: it may be a large picture."""


def begin() -> None:
    """Hold this process's clocks and luck, and those of toolkits when they are imported."""
    luck.hold()
    clocks.hold(MOMENT)
    toolkits.watch(Part.CLOCK)


def count_frames() -> None:
    """Let time pass with the frames that the shim sees presented, and end a program that shows
    none any more."""
    frames.listen(Stage.CLOCK, after=MOMENT.frame_ends)
    threading.Thread(target=_watch, args=(MOMENT,), daemon=True).start()


def _watch(moment: Moment) -> None:
    seen, since, longest = 0, real_clock(), 0.0
    while True:
        real_sleep(0.2)
        if moment.frames != seen:
            longest = max(longest, real_clock() - since)
            seen, since = moment.frames, real_clock()
        elif seen and real_clock() - since > max(PATIENCE, 3.0 * longest) * (
            _HELD_PATIENCE if moment.held else 1.0
        ):
            say(f"the program shows nothing new after frame {seen}, and was ended there")
            frames.exit_now()
