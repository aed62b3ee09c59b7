"""The panel over the picture: what style is on, what a frame costs, what keys do."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from glshim.outputs.gl.frame import overlay
from glshim.styling.protocol import Styler
from glshim.toolkits import frames

_REWRITTEN_AFTER = 0.25
"""Seconds for which the panel's numbers stand, so that they can be read."""
_WEIGHT = 0.1
"""Of the last frame in the smoothed time."""


class FrameClock:
    """The time from one frame end to the next, smoothed."""

    def __init__(self) -> None:
        self._last: float | None = None
        self.seconds = 1e-3

    def tick(self) -> None:
        """A frame ends now."""
        now = time.perf_counter()
        if self._last is not None:
            new = max(now - self._last, 1e-6)
            first = self.seconds == 1e-3
            self.seconds = new if first else self.seconds + _WEIGHT * (new - self.seconds)
        self._last = now


class Panel:
    """The overlay, which is made anew a few times a second."""

    def __init__(self) -> None:
        self._pixels: NDArray[np.uint8] | None = None
        self._said: list[str] = []
        self._state = (0, 0)
        self._since = -_REWRITTEN_AFTER

    def show(self, drawing: Styler | None, lines_of: Callable[[], list[str]]) -> None:
        """Draw it over the picture that is about to be presented."""
        size = frames.drawable_size()
        width = size[0] if size is not None else 1 << 16
        now, state = time.monotonic(), (id(drawing), width)
        if self._pixels is None or state != self._state or now - self._since >= _REWRITTEN_AFTER:
            lines = lines_of()
            if self._pixels is None or lines != self._said or width != self._state[1]:
                self._pixels = overlay.panel(lines, width)
            self._said, self._state, self._since = lines, state, now
        overlay.show(self._pixels, size, frames.drawable_framebuffer())
