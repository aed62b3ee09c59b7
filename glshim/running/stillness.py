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
from collections.abc import Callable
from types import ModuleType
from typing import Any

VARIABLE = "GLSHIM_STILL"
"""Set by us for programs that we start; never by people."""
STEP = 0.02
"""Seconds that pass with each frame."""
SETTLE = 12
"""Rounds of GLUT's main loop before the first display: the window comes up."""
QUIET = 40
"""Rounds without a new picture after which a program stands still."""
PATIENCE = 8.0
"""Seconds without a frame after which a program that shows frames on demand is done; three times
its longest wait so far where that is more."""
_LARGE = 20.0
"""Times that for a frame of a moment that is held: it may be a large picture."""
_START = 1_600_000_000.0

real_sleep = time.sleep
real_clock = time.monotonic


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


def begin() -> None:
    """Hold this process's clocks and luck, and those of toolkits when they are imported."""
    from glshim.bindings.imports import after_import

    still_luck()
    still_clock(MOMENT)
    after_import("numpy.random", lambda module: module.seed(1))
    after_import("OpenGL.GLUT", lambda module: _still_glut(module, MOMENT))
    after_import("pygame.time", lambda module: still_pygame(module, MOMENT))
    after_import("glfw", lambda module: still_glfw(module, MOMENT))


def count_frames() -> None:
    """Let time pass with the frames that the shim sees presented, and end a program that shows
    none any more."""
    from glshim.toolkits import frames

    frames.install(_nothing, MOMENT.frame_ends, rank=0)  # before a shot stops the clock
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


def still_pygame(module: ModuleType, moment: Moment) -> None:
    """The clocks of module `pygame.time`."""

    class Clock:
        def tick(self, _framerate: float = 0) -> int:
            return int(STEP * 1000)

        tick_busy_loop = get_time = get_rawtime = tick

        def get_fps(self) -> float:
            return 1 / STEP

    def wait(duration: int) -> int:
        moment.pass_by(duration / 1000)
        return duration

    for name, replacement in (("get_ticks", lambda: int(moment.now * 1000)), ("wait", wait),
                              ("delay", wait), ("Clock", Clock)):  # fmt: skip
        setattr(module, name, replacement)


def still_glfw(module: Any, moment: Moment) -> None:
    """The clock of module `glfw`."""
    module.get_time = lambda: moment.now


class GlutLoop:
    """GLUT's idle function, timers and clock, served from one pump in a fixed order.

    freeglut calls idle functions and timers as often as real time allows, and displays when the
    window happens to be exposed. The pump waits until the window has settled, then serves one round
    after another: clock, due timers, the program's idle function, a redisplay if one was asked for.
    """

    def __init__(self, glut: ModuleType, moment: Moment, quiet: Callable[[], None]) -> None:
        """quiet: called when the program has shown nothing new for `QUIET` rounds."""
        self.glut, self.moment, self.when_quiet = glut, moment, quiet
        self.round = 0
        self.quiet = 0
        self.shown = 0
        self.idle: Callable[[], None] | None = None
        self.timers: list[tuple[float, int, Callable[[int], None], int]] = []
        self.waiting: set[int] = set()
        names = ("glutDisplayFunc", "glutIdleFunc", "glutTimerFunc", "glutMainLoop", "glutGet",
                 "glutPostRedisplay", "glutSetWindow", "glutGetWindow",
                 "glutMainLoopEvent")  # fmt: skip
        self.real = {name: getattr(glut, name, None) for name in names}
        replacements: dict[str, Callable[..., Any]] = {
            "glutIdleFunc": self.set_idle, "glutTimerFunc": self.add_timer,
            "glutDisplayFunc": self.set_display, "glutMainLoop": self.main_loop,
            "glutGet": self.get, "glutMainLoopEvent": self.main_loop_event,
        }  # fmt: skip
        for name, replacement in replacements.items():
            setattr(glut, name, replacement)
        self.elapsed = glut.GLUT_ELAPSED_TIME

    def set_idle(self, function: Callable[[], None] | None = None) -> None:
        """glutIdleFunc."""
        self.idle = function

    def add_timer(self, milliseconds: int, function: Callable[[int], None], value: int = 0) -> None:
        """glutTimerFunc."""
        due = self.moment.now + milliseconds / 1000
        self.timers.append((due, len(self.timers), function, value))

    def set_display(self, function: Callable[[], None]) -> None:
        """glutDisplayFunc."""

        def display() -> None:
            if self.round < SETTLE:
                self.waiting.add(self._call("glutGetWindow"))
            else:
                function()

        self._call("glutDisplayFunc", display)

    def get(self, what: Any) -> Any:
        """glutGet."""
        if what == self.elapsed:
            return int(self.moment.now * 1000)
        return self._call("glutGet", what)

    def main_loop(self) -> None:
        """glutMainLoop."""
        self._call("glutIdleFunc", self.pump)
        self._call("glutMainLoop")

    def main_loop_event(self) -> None:
        """glutMainLoopEvent: the program has a loop of its own."""
        self._call("glutMainLoopEvent")
        self.pump()

    def redisplay(self) -> None:
        """Have every window drawn again."""
        for window in sorted(self.waiting):
            self._call("glutSetWindow", window)
            self._call("glutPostRedisplay")

    def pump(self) -> None:
        """One round."""
        self.round += 1
        if self.round < SETTLE:
            real_sleep(0.01)
            return
        if self.round == SETTLE:
            self.redisplay()
            return
        self.quiet = 0 if self.moment.frames != self.shown else self.quiet + 1
        if self.quiet == 0:
            self.shown = self.moment.frames
        else:
            self.moment.pass_by(STEP)  # nothing was shown: a frame's time passes all the same
            real_sleep(0.001)
        if self.quiet > QUIET:
            self.when_quiet()
        due = sorted(t for t in self.timers if t[0] <= self.moment.now + 1e-9)
        self.timers = [t for t in self.timers if t not in due]
        for _, _, function, value in due:
            function(value)
        if self.idle is not None:
            self.idle()

    def _call(self, name: str, *arguments: Any) -> Any:
        function = self.real[name]
        return function(*arguments) if function is not None else None


def _still_glut(glut: ModuleType, moment: Moment) -> None:
    def draw_again() -> None:
        """A program that draws on demand: its picture is asked for once more."""
        loop.quiet = 0
        loop.redisplay()

    loop = GlutLoop(glut, moment, draw_again)


def _watch(moment: Moment) -> None:
    from glshim.notices import say
    from glshim.toolkits import frames

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


def _nothing() -> None:
    """Before a frame is presented."""
