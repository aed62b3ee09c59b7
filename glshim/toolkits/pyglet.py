"""pyglet's windows. What pyglet draws by itself goes past PyOpenGL; what a program draws in them by
PyOpenGL is seen."""

from __future__ import annotations

import functools
import weakref
from collections.abc import Iterable
from typing import Any

from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Moment

# From `pyglet.window.key`; they are X's on every system.
_KEYS = {
    **{0xFFBD + n: f"F{n}" for n in range(1, 13)},
    **{ord(name.lower()): name for name in keyboard.NAMES if len(name) == 1},
    0xFF50: "Home", 0xFF55: "PageUp", 0xFF56: "PageDown", 0xFF57: "End", 0xFF63: "Insert",
}  # fmt: skip
_MODIFIERS = {"shift": 1, "ctrl": 2, "alt": 4}
_LOOK = 0.05
"""Seconds of a look for events where nothing is scheduled."""
PRESS, RELEASE, EXPOSE = "on_key_press", "on_key_release", "on_expose"


class Pyglet(Toolkit):
    """A window flips, and hears of events, by methods of its class."""

    name = package = "pyglet"
    tested = "pyglet 1.5.31 and 2.1.19 on X"
    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._windows: weakref.WeakSet[Any] = weakref.WeakSet()
        """Those that have flipped."""
        self._is_asked = False
        """For another frame, by another thread."""

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "pyglet.window", self.hook_flips, "Window.flip")
        yield Hook(Part.KEYS, "pyglet.window", self.hook_events, "Window.dispatch_event")
        yield Hook(Part.CLOCK, "pyglet.app", self.hold_clock, "the event loop's waits")

    def size(self, window: Any) -> Size:
        width, height = window.get_framebuffer_size()
        return width, height

    def drawable(self, window: Any = None) -> Drawable:
        self._windows.add(window)
        return super().drawable(window)

    def redraw(self) -> None:
        """Windows are drawn again while they are `invalid`, and may listen to being exposed."""
        for window in tuple(self._windows):
            if window.context is not None:  # else it is closed
                window.invalid = True
                window.dispatch_event(EXPOSE)

    def hook_flips(self, module: Any, changes: Changes) -> None:
        plain = module.Window.flip

        @functools.wraps(plain)
        def flip(window: Any) -> None:
            frames.present(plain, window, on=self.drawable(window))

        changes.set(module.Window, "flip", flip)

    def hook_events(self, module: Any, changes: Changes) -> None:
        plain = module.BaseWindow.dispatch_event

        @functools.wraps(plain)
        def dispatch_event(window: Any, *event: Any) -> Any:
            if keyboard.listening() and event and event[0] in (PRESS, RELEASE) and _is_ours(*event):
                return None
            return plain(window, *event)

        changes.set(module.BaseWindow, "dispatch_event", dispatch_event)

    # -- clock -----------------------------------------------------------------------------------

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """`pyglet.clock` asks module `time`: what the loop waits until a call is due passes at
        once. While a moment is held no call is due, and the windows are drawn again."""
        kind, moment = type(module.platform_event_loop), self.moment
        plain = kind.step

        @functools.wraps(plain)
        def step(loop: Any, timeout: float | None = None) -> Any:
            if moment.held:
                for window in tuple(module.windows):
                    _draw(window)
            elif timeout is None and not self._is_asked:
                return plain(loop, _LOOK)
            elif timeout is not None:
                moment.pass_by(timeout)
            if self._is_asked:
                self._is_asked = False
                self.redraw()
            return plain(loop, 0)

        changes.set(kind, "step", step)

    def redraw_from_a_thread(self) -> None:
        self._is_asked = True


def _draw(window: Any) -> None:
    """As the event loop does."""
    if hasattr(window, "draw"):  # from pyglet 2 on
        window.draw(0.0)
        return
    window.switch_to()
    window.dispatch_event("on_draw")
    window.flip()


def _is_ours(kind: str, symbol: int, modifiers: int) -> bool:
    name = _KEYS.get(symbol)
    if kind == RELEASE:
        return keyboard.released(name)
    return keyboard.pressed(name, keyboard.modifiers(modifiers, _MODIFIERS))


TOOLKITS = (Pyglet(),)
