"""The time of a program whose clocks stand still, as toolkits' clocks show it too."""

from __future__ import annotations

import time

real_sleep = time.sleep
real_clock = time.monotonic
"""As they are before any clock is held: this module comes first."""
STEP = 0.02
"""Seconds that pass with each frame."""


class Moment:
    """The program's time, in seconds from its start."""

    def __init__(self) -> None:
        self.now = 0.0
        self.frames = 0
        """Presented so far."""
        self.held = False
        """Neither frames nor sleep move time: the same moment is drawn again."""

    def frame_ends(self) -> None:
        """A frame was presented."""
        self.frames += 1
        self.pass_by(STEP)

    def pass_by(self, seconds: float) -> None:
        """Let time pass."""
        if not self.held:
            self.now += seconds


MOMENT = Moment()
"""The one of a program that was started still."""
