"""The time of a program whose clocks stand still, as toolkits' clocks show it too."""

from __future__ import annotations

import time
from collections.abc import Callable

real_sleep = time.sleep
real_clock = time.monotonic
"""As they are before any clock is held: this module comes first."""
STEP = 0.02
"""Seconds that pass with each frame."""


class Alarm:
    """A timer of the program's."""

    def __init__(
        self, moment: Moment, seconds: float, ring: Callable[[], object] | None = None
    ) -> None:
        """ring: called each time it comes, in the thread that moves time; None: whoever has it
        looks (`comes`)."""
        self._moment, self.ring = moment, ring
        self._round = -1
        self.seconds = seconds or STEP
        """From one time to the next. One that comes at once comes once a frame."""
        self.due = moment.now + self.seconds
        moment.alarms.add(self)

    def comes(self, *, again: bool) -> bool:
        """Whether its moment is there. It comes once a frame at most, and if not again it is over
        then."""
        moment = self._moment
        if self.due > moment.alarms_until + 1e-9 or self._round == moment.rounds:
            return False
        self._round = moment.rounds
        self.due = max(self.due + self.seconds, moment.now)
        if not again:
            self.stop()
        return True

    def stop(self) -> None:
        """It does not come any more."""
        self._moment.alarms.discard(self)


class Moment:
    """The program's time, in seconds from its start."""

    def __init__(self) -> None:
        self.now = 0.0
        self.frames = 0
        """Presented so far."""
        self.held = False
        """Neither frames nor sleep nor timers move anything: the same moment is drawn again."""
        self.alarms: set[Alarm] = set()
        """Timers of toolkits that have no other clock than this."""
        self.rounds = 0
        """Frames, and skips in between."""
        self._let = float("-inf")

    @property
    def alarms_until(self) -> float:
        """Alarms that are due until then come."""
        return self._let if self.held else self.now

    def frame_ends(self) -> None:
        """A frame was presented."""
        self.frames += 1
        self.rounds += 1
        self._let = float("-inf")
        self.pass_by(STEP)

    def skip(self) -> None:
        """The program waits for its next alarm: its moment is there. While a moment is held that
        alarm comes all the same, and no time passes. From any thread."""
        dues = [alarm.due for alarm in tuple(self.alarms)]
        if dues:
            self._let = min(dues)
            self.rounds += 1
            self.pass_by(max(self._let - self.now, 0.0))

    def pass_by(self, seconds: float) -> None:
        """Let time pass."""
        if not self.held:
            self.now += seconds
        for alarm in tuple(self.alarms):
            if alarm.ring is not None and alarm.comes(again=True):
                alarm.ring()


MOMENT = Moment()
"""The one of a program that was started still."""
