"""pygame, whose constants are its own: it is installed with the tests."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.pygame import Pygame

from .rig import SIZE, Rig


class PygameRig(Rig):
    def __init__(self) -> None:
        super().__init__(Pygame())
        import pygame

        self.pygame = pygame
        self.queue: deque[Any] = deque()
        surface = SimpleNamespace(get_flags=lambda: pygame.OPENGL)
        self.modules = {
            "pygame.display": SimpleNamespace(
                flip=self.shown, update=self.shown, get_surface=lambda: surface,
                get_window_size=lambda: SIZE),
            "pygame.event": SimpleNamespace(
                get=lambda: [self.queue.popleft() for _ in range(len(self.queue))],
                poll=self.poll, wait=self.poll, post=self.queue.append,
                Event=lambda kind: SimpleNamespace(type=kind)),
            "pygame.time": SimpleNamespace(get_ticks=lambda: 99, wait=None, delay=None, Clock=None),
        }  # fmt: skip

    def poll(self) -> Any:
        nothing = SimpleNamespace(type=self.pygame.NOEVENT)
        return self.queue.popleft() if self.queue else nothing

    def take(self) -> None:
        self.flip, self.get = self.modules["pygame.display"].flip, self.modules["pygame.event"].get
        self.ticks = self.modules["pygame.time"].get_ticks

    def present(self) -> Any:
        return self.flip()

    def key(self, name: str, down: bool) -> None:
        kinds = {self.pygame.KEYDOWN: True, self.pygame.KEYUP: False}
        kind = self.pygame.KEYDOWN if down else self.pygame.KEYUP
        names = {self.pygame.K_F5: "F5", self.pygame.K_x: "X"}
        (code,) = (code for code in names if names[code] == name)
        self.queue.append(SimpleNamespace(type=kind, key=code, mod=0))
        for event in self.get():
            if event.type in kinds:
                self.got.append((names[event.key], kinds[event.type]))
            else:
                self.queue.append(event)

    def redraws(self) -> int:
        return [event.type for event in self.queue].count(self.pygame.VIDEOEXPOSE)

    def seconds(self) -> float:
        return float(self.ticks()) / 1000


RIGS: dict[str, Callable[[], Rig]] = {"pygame": PygameRig}
