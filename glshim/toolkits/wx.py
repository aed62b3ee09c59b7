"""wxPython's GLCanvas."""

from __future__ import annotations

import atexit
import functools
import sys
import weakref
from collections.abc import Callable, Iterable
from typing import Any, ClassVar

from glshim.system.interrupts import is_ours as is_fault
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Moment

# wx's enumerators, the same on every system.
_KEYS = {
    **{339 + n: f"F{n}" for n in range(1, 13)},
    **{ord(name): name for name in keyboard.NAMES if len(name) == 1},
    312: "End", 313: "Home", 322: "Insert", 366: "PageUp", 367: "PageDown",
}  # fmt: skip
"""WXK_F1 and so on."""
_MODIFIERS = {"alt": 1, "ctrl": 2, "shift": 4}
"""wx.MOD_ALT and so on."""
SKIP, PROCESSED = -1, 1
"""wx.EventFilter.Event_Skip and Event_Processed."""


class Wx(Toolkit):
    """It calls back from C++, where an exception is printed and the loop goes on. Keys come by a
    filter on all events."""

    name, package, distribution = "wx", "wx", "wxPython"
    may_raise = False
    tested = "wxPython 4.2.0 on GTK 3 and X"
    lacks: ClassVar[Lacks] = {Part.CLOCK: "wx.Timer and wx.StopWatch run on"}

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._canvases: weakref.WeakSet[Any] = weakref.WeakSet()
        """Those that have swapped."""
        self._remove: Callable[[], None] = lambda: None
        """Takes the filter away, which C++ must not find gone."""

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "wx.glcanvas", self.hook_swaps, "GLCanvas.SwapBuffers")
        yield Hook(Part.KEYS, "wx", self.hook_keys, "wx.EventFilter")

    def size(self, canvas: Any) -> Size:
        width, height = canvas.GetClientSize()
        ratio = canvas.GetContentScaleFactor()
        return round(width * ratio), round(height * ratio)

    def drawable(self, canvas: Any = None) -> Drawable:
        self._canvases.add(canvas)
        return super().drawable(canvas)

    def redraw(self) -> None:
        for canvas in tuple(self._canvases):
            if canvas:  # else its C++ half is gone
                canvas.Refresh(False)

    def leave(self) -> bool:
        """`MainLoop` returns."""
        wx: Any = sys.modules["wx"]
        app = wx.GetApp()
        if app is None or not app.IsMainLoopRunning():
            return False
        app.ExitMainLoop()
        return True

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        plain = module.GLCanvas.SwapBuffers

        @functools.wraps(plain)
        def swap_buffers(canvas: Any) -> Any:
            return frames.present(plain, canvas, on=self.drawable(canvas))

        changes.set(module.GLCanvas, "SwapBuffers", swap_buffers)

    # -- keys ------------------------------------------------------------------------------------

    def hook_keys(self, module: Any, changes: Changes) -> None:
        down = {module.wxEVT_CHAR_HOOK, module.wxEVT_KEY_DOWN}
        kinds = {*down, module.wxEVT_KEY_UP}

        class Filter(module.EventFilter):  # type: ignore[misc]
            """Keeps the events of our keys from the app's windows."""

            def FilterEvent(self, event: Any) -> int:
                try:
                    kind = event.GetEventType()
                    if kind in kinds and keyboard.listening() and _is_ours(event, kind in down):
                        return PROCESSED
                except Exception as error:
                    if not is_fault(error):
                        raise
                return SKIP

        event_filter = Filter()
        module.EvtHandler.AddFilter(event_filter)

        def remove() -> None:
            self._remove = lambda: None
            module.EvtHandler.RemoveFilter(event_filter)

        self._remove = remove
        atexit.register(self._unfilter)
        changes.add(self._unfilter)

    def _unfilter(self) -> None:
        atexit.unregister(self._unfilter)
        self._remove()


def _is_ours(event: Any, down: bool) -> bool:
    """Of a press wx tells twice; one that is ours it tells once, since the first ends here."""
    name = _KEYS.get(event.GetKeyCode())
    if not down:
        return keyboard.released(name)
    repeats = getattr(event, "IsAutoRepeat", bool)  # wxPython 4.2; it says so of other presses too
    if repeats() and keyboard.pressed(name, again=True):
        return True
    return keyboard.pressed(name, keyboard.modifiers(event.GetModifiers(), _MODIFIERS))


TOOLKITS = (Wx(),)
