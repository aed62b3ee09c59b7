"""Clocks and luck that stand still while a frame is made, so that runs of one program show the same
moment: `glshim gallery` and `glshim shot` ask for it, and so do the tests.

Time moves by `STEP` with each presented frame, by what the program sleeps, and to the next of its
timers where it waits for that. Timers and idle calls come once a frame at most. Clocks of toolkits
that say that they lack this (`glshim doctor`) run on, and so do those of other C libraries.
"""

from __future__ import annotations

from glshim import toolkits
from glshim.running import clocks, luck, rest
from glshim.toolkits import Part, frames
from glshim.toolkits.frames import Stage
from glshim.toolkits.moment import MOMENT

VARIABLE = "GLSHIM_STILL"
"""Set by us for programs that we start; never by people."""
_HELD_PATIENCE = 20.0
"""Times `rest.PATIENCE` for a frame of a moment that is held: it may be a large picture."""


def begin() -> None:
    """Hold this process's clocks and luck, and those of toolkits when they are imported."""
    luck.hold()
    clocks.hold(MOMENT)
    toolkits.watch(Part.CLOCK)


def count_frames() -> None:
    """Let time pass with the frames that the shim sees presented, and end a program that shows
    none any more."""
    frames.listen(Stage.CLOCK, after=MOMENT.frame_ends)
    rest.watch(
        lambda: MOMENT.frames, moment=MOMENT,
        patience=lambda: _HELD_PATIENCE if MOMENT.held else 1.0,
    )  # fmt: skip
