"""GTK by PyGObject: an area whose ``render`` is connected, and (derives) one with a `do_render`."""

from __future__ import annotations

import functools
import weakref
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.gi import KEY_PRESS, KEY_RELEASE, Gtk

from .rig import SIZE, Rig

VALUES = {"F5": 0xFFC2, "X": ord("x")}


class GtkRig(Rig):
    """takes_early: a handler that is connected before the hooks is GTK's."""

    shows_by_itself = True

    def __init__(self, version: int, *, derives: bool = False) -> None:
        super().__init__(Gtk())
        self.version, self.derives = version, derives
        self.asked = 0
        self.handlers: dict[str, Any] = {}
        self.controllers: list[Any] = []
        self.taken: set[str] = set()
        rig = self

        class GLArea:
            def connect(self, signal: str, handler: Any, *more: Any) -> int:
                rig.handlers[signal] = handler
                return 1

            connect_after = connect_object = connect_object_after = connect

            def weak_ref(self) -> Any:
                return weakref.ref(self)

            def get_scale_factor(self) -> int:
                return 2

            def get_allocated_width(self) -> int:
                return SIZE[0] // 2

            def get_allocated_height(self) -> int:
                return SIZE[1] // 2

            def queue_render(self) -> None:
                rig.asked += 1

        class Window:
            @staticmethod
            def list_toplevels() -> list[Any]:
                return [rig.toplevel]

            def weak_ref(self) -> Any:
                return weakref.ref(self)

            def connect(self, signal: str, handler: Any) -> int:
                rig.handlers[signal] = handler
                return 1

            def disconnect(self, number: int) -> None:
                del rig.handlers["event"]

            def add_controller(self, controller: Any) -> None:
                rig.controllers.append(controller)

            def remove_controller(self, controller: Any) -> None:
                rig.controllers.remove(controller)

        class Controller:
            def __init__(self) -> None:
                self.handlers: dict[str, Any] = {}
                self.connect = self.handlers.__setitem__

            def set_propagation_phase(self, phase: int) -> None:
                assert phase == 1

        if version == 3:
            Window.add_events = None  # type: ignore[attr-defined]
        self.toplevel = Window()
        self.modules = {
            "gi.repository.Gtk": SimpleNamespace(
                GLArea=GLArea, Window=Window, EventControllerKey=Controller, PropagationPhase=int),
            "gi.repository.GLib": SimpleNamespace(
                idle_add=lambda call: call(), MainLoop=type("MainLoop", (), {"run": self.shown})),
        }  # fmt: skip

    def take(self) -> None:
        self.base: Any = self.modules["gi.repository.Gtk"].GLArea
        if self.derives:
            rig = self

            class Area(self.base):  # type: ignore[misc]
                def do_render(self, context: Any) -> int:
                    return rig.shown()

            self.base = Area

    def open(self) -> None:
        self.area = self.base()
        if not self.derives:
            self.area.connect("render", lambda area, context: self.shown())

    def present(self) -> Any:
        if self.derives:
            return self.area.do_render(None)
        return self.handlers["render"](self.area, None)

    def key(self, name: str, down: bool) -> None:
        stopped = False
        if self.version == 3 and "event" in self.handlers:
            event = SimpleNamespace(
                type=KEY_PRESS if down else KEY_RELEASE,
                key=SimpleNamespace(keyval=VALUES[name], state=0))
            stopped = self.handlers["event"](self.toplevel, event)
        for controller in self.controllers:
            handler = controller.handlers["key-pressed" if down else "key-released"]
            if handler(controller, VALUES[name], 0, 0):
                self.taken.add(name)
            stopped = name in self.taken  # who has the press has the release
            if not down:
                self.taken.discard(name)
        if not stopped:
            self.got.append((name, down))

    def redraws(self) -> int:
        return self.asked


RIGS: dict[str, Callable[[], Rig]] = {
    "GTK 3": functools.partial(GtkRig, 3),
    "GTK 4": functools.partial(GtkRig, 4),
    "GTK, derived": functools.partial(GtkRig, 4, derives=True),
}
