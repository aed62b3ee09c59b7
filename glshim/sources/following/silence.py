"""Says once why a style draws no line, and what can be done."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping

from glshim.notices import say
from glshim.sources.following import census
from glshim.sources.following.census import Census
from glshim.sources.programs.source import IN_USE

FRAMES, SECONDS = 60, 2.0
"""Without a line: after so many frames, or so long after the first, that is no accident."""
_LOOKS = 4
"""At what is behind layers, each of which reads the picture: the first frames may be blank."""
DARK = 0.3
"""Of the brightest channel, at most."""

_TELLS_MORE = "(`glshim doctor PROGRAM` has the details)"
_WHY = {
    IN_USE: "it draws with its own shaders, and glshim restyles only fixed-function drawing: see "
    "whether the program has a mode for older OpenGL",
    census.NO_DEPTH_TEST: "its polygons are drawn without depth test, so nothing tells which are "
    "in front: look for a 3D view, or a depth setting in the program",
    census.NO_DEPTH_WRITES: "its polygons do not write depth, as if they were transparent: make "
    "them opaque in the program",
    census.NOT_FILLED: "its polygons are drawn as lines or points: switch the program to a solid "
    "view",
    census.TEXT: "its polygons are text, of which only the letters are seen: only solids get lines",
    census.HUD: "its polygons are drawn flat over a picture, as texts and buttons are: only "
    "solids get lines",
}
"""Reasons for which polygons pass, at length and with what to do."""
_ONLY_LINES = (
    "it draws only lines, points or pixels, and glshim adds lines to filled polygons: switch the "
    "program to a solid view"
)
_NOTHING = (
    "it draws nothing through PyOpenGL: drawing by moderngl, pyglet and vispy themselves is not "
    "followed"
)
_NO_ADDITION = (
    "the style adds nothing to its polygons: `glshim styles NAME` lists what the style can draw"
)
_NO_FRAME = (
    "no end of a frame was seen, where lines are added: glshim does not know the toolkit of the "
    "window (`glshim doctor` lists those that it knows)"
)


def reason(seen: Census) -> str:
    """Why a program gets no line, with what to do; empty where that is said already, context by
    context."""
    if seen.carried:
        return "" if seen.refused else _NO_ADDITION
    if seen.passed:
        why, _ = seen.passed.most_common(1)[0]
        return _WHY.get(why, f"its polygons are drawn while {why}")
    if seen.refused:
        return ""
    return _ONLY_LINES if seen.others else _NOTHING


class Silence:
    """Watches over one run."""

    def __init__(self, seen: Census) -> None:
        self._census = seen
        self._frames = self._layers = 0
        self._since: float | None = None
        self._over = False
        """It is said, or there are lines."""
        self._lines = False
        self._hinted = False
        self._looks = 0
        """At what is behind layers."""

    def layer_ends(self) -> None:
        """Lines are added; they are seen if the end of the frame is."""
        self._layers += 1
        if not self._frames and not self._over and self._is_long(self._layers):
            self._say(_NO_FRAME)

    def frame_ends(self, draws: int) -> None:
        """A frame was presented, with so many draws of a styler's."""
        self._frames += 1
        if draws:
            self._lines = self._over = True
        elif not self._over and self._is_long(self._frames):
            self._say(reason(self._census))

    def program_ends(self) -> None:
        """Now or never."""
        if not self._over:
            self._say(self.because())

    def because(self) -> str:
        """Why there is no line so far, with what to do; empty where there is one, or where nothing
        was to be expected."""
        seen = self._census
        if self._lines:
            return ""
        if not self._frames and seen.carried:
            return _NO_FRAME
        return reason(seen) if self._frames or seen.passed or seen.others else ""

    @property
    def wants_colours(self) -> bool:
        """Whether a hint on colours may still come."""
        return not self._hinted and self._looks < _LOOKS

    def look_at(
        self, style: str, inks: Mapping[str, tuple[float, ...]],
        brightness_behind: Callable[[], float | None],
    ) -> None:
        """Lines of these colours, by the style's options, go over a picture that is so bright
        behind them, 0..1; None: nobody knows."""
        self._looks += 1
        if not inks or max(map(max, inks.values())) > DARK:
            return
        behind = brightness_behind()
        if behind is not None and behind > DARK:
            self._looks = _LOOKS  # a second view may be dark, such as a map in a corner
        elif behind is not None:
            self._hinted = True
            say(
                "the program's background is dark, and dark lines can hardly be seen on it: try "
                f"{style}:{next(iter(inks))}=#ffffff, or a style with paper, such as sketch"
            )

    def _is_long(self, count: int) -> bool:
        now = time.monotonic()
        if self._since is None:
            self._since = now
        return count >= FRAMES or (count > 1 and now - self._since >= SECONDS)

    def _say(self, why: str) -> None:
        self._over = True
        if why:
            say(f"no lines are drawn: {why} {_TELLS_MORE}")
