"""The example's own package."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.stub import Stub

from .rig import SIZE, Rig


class StubRig(Rig):
    framebuffer = 7

    def __init__(self) -> None:
        super().__init__(Stub())
        self.events: deque[Any] = deque()
        self.asked = 0
        self.modules = {"stub": SimpleNamespace(
            show=self.shown, next_event=lambda: self.events.popleft() if self.events else None,
            seconds=lambda: 99.0)}  # fmt: skip

    def take(self) -> None:
        self.kit = SimpleNamespace(**vars(self.modules["stub"]))

    def open(self) -> None:
        class Window:
            size, framebuffer = SIZE, 7

            def repaint(_: Any) -> None:
                self.asked += 1

        self.window = Window()

    def present(self) -> Any:
        return self.kit.show(self.window)

    def key(self, name: str, down: bool) -> None:
        event = SimpleNamespace(key=name.lower(), kind="down" if down else "up", held=0)
        self.events.append(event)
        while (event := self.kit.next_event()) is not None:
            self.got.append((event.key.upper(), event.kind == "down"))

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.kit.seconds())


RIGS: dict[str, Callable[[], Rig]] = {"stub": StubRig}
