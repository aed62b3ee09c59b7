"""The smallest complete toolkit: the file to start from.

The package ``stub`` stands for one with the usual parts: a window that is shown by a function, a
queue of events, a request for another frame, a clock. To add a toolkit, copy this file, give it the
name of the toolkit's package, leave out what cannot be done and say so in `lacks`. No other file
changes: start-up, `glshim doctor` and clocks that stand still read it from here. The contract test
asks for a stand-in of the package in the folder `tests/contract/toolkits`, and runs on it.
"""

from __future__ import annotations

import functools
import weakref
from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, Moment

_KEYS = {name.lower(): name for name in keyboard.NAMES}
"""The toolkit's own codes of keys, and ours."""
_MODIFIERS = {"shift": 1, "ctrl": 2, "alt": 4}


class Stub(Toolkit):
    """``stub.show(window)`` ends a frame, ``stub.next_event()`` gives keys."""

    name = package = "stub"
    distribution = ""  # where pip knows it by another name
    may_raise = True  # False where it calls back from C, which swallows exceptions
    lacks: ClassVar[Lacks] = {}  # Part.CLOCK: "what a user notices of that"
    tested = "the stand-in of the contract test"  # with what you have tried it yourself
    example = True  # of this file alone

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._windows: weakref.WeakSet[Any] = weakref.WeakSet()

    def hooks(self) -> Iterable[Hook]:
        """A row each: for what, after the import of which module, how, and what people call it."""
        yield Hook(Part.FRAMES, "stub", self.hook_show, "stub.show")
        yield Hook(Part.KEYS, "stub", self.hook_events, "stub.next_event")
        yield Hook(Part.CLOCK, "stub", self.hold_clock, "stub.seconds")

    # -- what is asked about a window, with its context current ----------------------------------

    def size(self, window: Any) -> Size:
        width, height = window.size
        return width, height

    def framebuffer(self, window: Any) -> int:
        return int(window.framebuffer)  # leave the method out where that is always 0

    # -- what it is asked to do ------------------------------------------------------------------

    def redraw(self) -> None:
        for window in tuple(self._windows):
            window.repaint()

    def window_is_there(self) -> None:
        """Nothing: its keys need no window to be hooked."""

    # -- hooks: each is given the module that was imported, and notes what it changes -------------

    def hook_show(self, module: Any, changes: Changes) -> None:
        plain = module.show

        @functools.wraps(plain)
        def show(window: Any) -> Any:
            self._windows.add(window)
            return frames.present(plain, window, on=self.drawable(window))

        changes.set(module, "show", show)

    def hook_events(self, module: Any, changes: Changes) -> None:
        plain = module.next_event

        @functools.wraps(plain)
        def next_event() -> Any:
            event = plain()
            while event is not None and self._is_ours(event):
                event = plain()
            return event

        changes.set(module, "next_event", next_event)

    def _is_ours(self, event: Any) -> bool:
        name = _KEYS.get(event.key)
        if event.kind == "up":
            return keyboard.released(name)
        held = keyboard.modifiers(event.held, _MODIFIERS)
        return event.kind == "down" and keyboard.pressed(name, held)

    def hold_clock(self, module: Any, changes: Changes) -> None:
        changes.set(module, "seconds", lambda: self.moment.now)


TOOLKITS = (Stub(),)
