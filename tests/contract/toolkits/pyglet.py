"""pyglet's windows."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.pyglet import Pyglet

from .rig import SIZE, Rig

F1 = 0xFFBE


class PygletRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Pyglet())
        self.asked = 0
        rig = self

        class BaseWindow:
            context: Any = object()
            invalid = False

            def dispatch_event(self, kind: str, *arguments: Any) -> None:
                if kind == "on_expose":
                    rig.asked += self.invalid
                else:
                    symbol, _ = arguments
                    name = f"F{symbol - F1 + 1}" if symbol > 0xFF else chr(symbol).upper()
                    rig.got.append((name, kind == "on_key_press"))

        class Window(BaseWindow):
            def flip(self) -> None:
                rig.shown()

            def get_framebuffer_size(self) -> tuple[int, int]:
                return SIZE

        class Loop:
            def step(self, timeout: float | None = None) -> bool:
                return timeout is None or timeout > 0.0

        self.loop = Loop()
        self.modules = {
            "pyglet.window": SimpleNamespace(BaseWindow=BaseWindow, Window=Window),
            "pyglet.app": SimpleNamespace(platform_event_loop=self.loop, windows=set()),
        }

    def take(self) -> None:
        self.kind = self.modules["pyglet.window"].Window

    def open(self) -> None:
        self.window = self.kind()

    def present(self) -> Any:
        return self.window.flip()

    def key(self, name: str, down: bool) -> None:
        symbol = F1 + int(name[1:]) - 1 if len(name) > 1 else ord(name.lower())
        self.window.dispatch_event("on_key_press" if down else "on_key_release", symbol, 0)

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        """What the loop waits for passes at once."""
        moment = self.toolkit.moment
        before = moment.now
        assert not self.loop.step(0.25)
        assert moment.now == before + (0.0 if moment.held else 0.25)
        moment.now = before
        return moment.now


RIGS: dict[str, Callable[[], Rig]] = {"pyglet": PygletRig}
