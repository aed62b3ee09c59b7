"""GTK 3 and 4 by PyGObject: a `GLArea` is painted by its ``render`` signal, into a framebuffer
object that GTK puts together with the rest of the window later."""

from __future__ import annotations

import sys
import weakref
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any, ClassVar

from glshim.driver.ask import integer
from glshim.spec.constants import GL_DRAW_FRAMEBUFFER_BINDING
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, Moment

_GTK, _GLIB, _GIO = "gi.repository.Gtk", "gi.repository.GLib", "gi.repository.Gio"
_SPECIAL = {
    0xFF63: "Insert", 0xFF50: "Home", 0xFF57: "End", 0xFF55: "PageUp", 0xFF56: "PageDown",
}  # fmt: skip
_KEYS = {
    **{0xFFBD + n: f"F{n}" for n in range(1, 13)},
    **{ord(name): name for name in keyboard.NAMES if len(name) == 1},
    **{ord(name.lower()): name for name in keyboard.NAMES if len(name) == 1},
    **_SPECIAL,
}  # fmt: skip
"""GDK_KEY_F1 and so on."""
_MODIFIERS = {"shift": 1, "ctrl": 4, "alt": 8}
"""GdkModifierType."""
KEY_PRESS, KEY_RELEASE = 8, 9
"""GdkEventType, in GTK 3."""
CAPTURE = 1
"""GtkPropagationPhase."""
_Reference = Callable[[], Any]
"""Gives an object of GTK's, None once it is gone. Python's own of it come and go before that; their
hash stays."""
_CONNECTS = ("connect", "connect_after", "connect_object", "connect_object_after")


class Gtk(Toolkit):
    """It calls back from C, where an exception is printed and the loop goes on."""

    name, package, distribution = "GTK", "gi", "PyGObject"
    tested = "GTK 3.24 and 4.8 on X and Wayland"
    may_raise = False
    hears_threads = True
    lacks: ClassVar[Lacks] = {Part.CLOCK: "GLib's timeouts and GTK's frame clock run on"}

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._gtk: Any = None
        self._areas: dict[int, _Reference] = {}
        """Those that have been painted."""
        self._last: dict[int, weakref.ref[_Handler]] = {}
        """The handler that was connected last, by area: no other comes after it."""
        self._painting = False
        self._loops: list[Any] = []
        """Those of GLib's that run, outermost first."""
        self._down: set[str] = set()
        self._windows: dict[int, tuple[_Reference, Callable[[Any], object]]] = {}
        """Whose keys are heard, and what ends that."""

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, _GTK, self.hook_render, "the return of GLArea's render handler")
        yield Hook(Part.FRAMES, _GLIB, self.hook_loops, "the return of GLArea's render handler")
        yield Hook(Part.KEYS, _GTK, self.hook_keys, "an event handler of the window")

    def size(self, window: Any) -> Size:
        scale = window.get_scale_factor()
        return window.get_allocated_width() * scale, window.get_allocated_height() * scale

    def redraw(self) -> None:
        """From any thread."""
        glib = sys.modules.get(_GLIB)
        for reference in tuple(self._areas.values()):
            area = reference()
            if area is not None and glib is not None:
                glib.idle_add(area.queue_render)

    def leave(self) -> bool:
        """The loop that runs: GTK 3's own, an application's, or one of GLib's. From any thread."""
        glib, gio = sys.modules.get(_GLIB), sys.modules.get(_GIO)
        level = getattr(self._gtk, "main_level", None)
        app = gio.Application.get_default() if gio is not None else None
        if level is not None and level():
            end = self._gtk.main_quit
        elif app is not None or self._loops:
            end = app.quit if app is not None else self._loops[-1].quit
        else:
            return False
        if glib is not None:
            glib.idle_add(end)
        return glib is not None

    # -- frame ends ------------------------------------------------------------------------------

    def hook_render(self, module: Any, changes: Changes) -> None:
        """What is connected to ``render``, and the `do_render` of classes that derive from it."""
        self._gtk, base = module, getattr(module, "GLArea", None)
        if base is None:  # before GTK 3.16
            return
        for name in _CONNECTS:
            changes.set(base, name, self._connecting(getattr(base, name)))

        def follow(cls: Any, /, **named: Any) -> None:
            super(base, cls).__init_subclass__(**named)
            if "do_render" in vars(cls):  # GTK takes it as the class is made, right after this
                cls.do_render = self._painted(cls.do_render)

        changes.set(base, "__init_subclass__", classmethod(follow))

    def _connecting(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        def connect(area: Any, signal: Any, handler: Any, *more: Any) -> Any:
            if signal == "render" and callable(handler):
                handler = _Handler(handler, self)
                self._last[hash(area)] = weakref.ref(handler)
            return plain(area, signal, handler, *more)

        return connect

    def _painted(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        def do_render(area: Any, context: Any) -> Any:
            return self.paint(area, plain, area, context)

        return do_render

    def paint(
        self, area: Any, paint: Callable[..., Any], *arguments: Any, is_last: bool = True
    ) -> Any:
        """Have the app paint an area: a frame, unless another handler goes on with it."""
        if self._painting or not frames.listening():
            return paint(*arguments)
        if hash(area) not in self._areas:
            self._areas = {key: each for key, each in self._areas.items() if each() is not None}
            self._areas[hash(area)] = area.weak_ref()
        bound = integer(GL_DRAW_FRAMEBUFFER_BINDING)
        on = replace(self.drawable(area), framebuffer=lambda: bound)
        before = frames.presented()
        self._painting = True
        try:
            with frames.drawing(on):
                result = paint(*arguments)
                if frames.presented() == before and (result or is_last):
                    frames.present(_shown_by_gtk)
                return result
        finally:
            self._painting = False

    def hook_loops(self, module: Any, changes: Changes) -> None:
        """Which loops run is known to nobody else."""
        plain = module.MainLoop.run

        def run(loop: Any) -> Any:
            self._loops.append(loop)
            try:
                return plain(loop)
            finally:
                self._loops.remove(loop)

        changes.set(module.MainLoop, "run", run)

    # -- keys ------------------------------------------------------------------------------------

    def hook_keys(self, module: Any, changes: Changes) -> None:
        """Windows are listened to once they are there."""
        self._gtk = module
        changes.add(self._deaf)

    def window_is_there(self) -> None:
        for window in self._gtk.Window.list_toplevels():
            reference, _ = self._windows.get(hash(window), (_gone, None))
            if reference() is None:
                hear = self._hear_events if hasattr(window, "add_events") else self._hear_keys
                self._windows[hash(window)] = window.weak_ref(), hear(window)

    def _hear_events(self, window: Any) -> Callable[[Any], object]:
        """GTK 3: ``event`` comes before the signals of each kind, and to the window first."""

        def on_event(_window: Any, event: Any) -> bool:
            kind = int(event.type)
            if kind not in (KEY_PRESS, KEY_RELEASE):
                return False
            key = event.key
            return self._is_ours(key.keyval, int(key.state), down=kind == KEY_PRESS)

        handler = window.connect("event", on_event)
        return lambda window: window.disconnect(handler)

    def _hear_keys(self, window: Any) -> Callable[[Any], object]:
        """GTK 4: a controller that comes before those of the widgets inside."""
        controller = self._gtk.EventControllerKey()
        controller.set_propagation_phase(self._gtk.PropagationPhase(CAPTURE))

        def pressed(_controller: Any, value: int, _code: int, state: Any) -> bool:
            return self._is_ours(value, int(state), down=True)

        def released(_controller: Any, value: int, _code: int, state: Any) -> None:
            self._is_ours(value, int(state), down=False)

        controller.connect("key-pressed", pressed)
        controller.connect("key-released", released)
        window.add_controller(controller)
        return lambda window: window.remove_controller(controller)

    def _is_ours(self, value: int, state: int, *, down: bool) -> bool:
        name = _KEYS.get(value)
        if name is None:
            return False
        if not down:
            self._down.discard(name)
            return keyboard.released(name)
        again = name in self._down  # a key that is held is pressed again and again
        self._down.add(name)
        return keyboard.pressed(name, keyboard.modifiers(state, _MODIFIERS), again=again)

    def _deaf(self) -> None:
        for reference, end in list(self._windows.values()):
            window = reference()
            if window is not None:
                end(window)
        self._windows.clear()


class _Handler:
    """A handler of ``render``. GTK finds it by the app's own, which it equals."""

    def __init__(self, plain: Callable[..., Any], toolkit: Gtk) -> None:
        self.glshim_plain, self._toolkit = plain, toolkit

    def __call__(self, area: Any, *arguments: Any) -> Any:
        last = self._toolkit._last.get(hash(area))
        is_last = last is None or last() in (self, None)
        return self._toolkit.paint(area, self.glshim_plain, area, *arguments, is_last=is_last)

    def __eq__(self, other: object) -> bool:
        return self is other or bool(self.glshim_plain == other)

    def __hash__(self) -> int:
        return hash(self.glshim_plain)


def _gone() -> None:
    """Of what was never there."""


def _shown_by_gtk() -> None:
    """GTK puts the area's picture on the screen later."""


TOOLKITS = (Gtk(),)
