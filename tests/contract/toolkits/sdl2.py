"""SDL2 by PySDL2, whose functions are of ctypes' and whose events are structures."""

from __future__ import annotations

import ctypes
from collections import deque
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.sdl2 import Sdl2

from .rig import Rig, fill, library_function


class Keysym(ctypes.Structure):
    _fields_ = (("scancode", ctypes.c_int), ("sym", ctypes.c_int32), ("mod", ctypes.c_uint16))


class Key(ctypes.Structure):
    _fields_ = (
        ("type", ctypes.c_uint32), ("time", ctypes.c_uint32), ("window", ctypes.c_uint32),
        ("state", ctypes.c_uint8), ("repeat", ctypes.c_uint8), ("keysym", Keysym),
    )  # fmt: skip


class Window(ctypes.Structure):
    _fields_ = (
        ("type", ctypes.c_uint32), ("time", ctypes.c_uint32), ("windowID", ctypes.c_uint32),
        ("event", ctypes.c_uint8),
    )  # fmt: skip


class Event(ctypes.Union):
    _fields_ = (("type", ctypes.c_uint32), ("key", Key), ("window", Window))


Events = ctypes.POINTER(Event)
F1 = 0x4000003A
KEY_DOWN, KEY_UP, EXPOSED = 0x300, 0x301, 0x200


class Sdl2Rig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Sdl2())
        self.queue: deque[Event] = deque()
        self.modules = {
            "sdl2.video": SimpleNamespace(
                SDL_GL_SwapWindow=library_function(self.shown, ctypes.c_void_p),
                SDL_GL_GetDrawableSize=lambda window, width, height: fill(width, height),
                SDL_GetWindowID=lambda window: 5, SDL_GetWindowFromID=lambda number: number == 5),
            "sdl2.events": SimpleNamespace(
                SDL_Event=Event, SDL_PushEvent=lambda event: self.queue.append(event._obj),
                SDL_PollEvent=library_function(self.poll, Events),
                SDL_WaitEvent=library_function(self.poll, Events),
                SDL_WaitEventTimeout=library_function(self.poll, Events, ctypes.c_int),
                SDL_PeepEvents=library_function(self.peep, Events, *[ctypes.c_int] * 4)),
            "sdl2.timer": SimpleNamespace(
                SDL_GetTicks=library_function(lambda: 99_000),
                SDL_Delay=library_function(lambda duration: 0, ctypes.c_int)),
        }  # fmt: skip

    def poll(self, event: Any, _: int = 0) -> int:
        if not self.queue:
            return 0
        event[0] = self.queue.popleft()
        return 1

    def peep(self, events: Any, count: int, action: int, first: int, last: int) -> int:
        found = [self.queue.popleft() for _ in range(min(count, len(self.queue)))]
        for place, event in enumerate(found):
            events[place] = event
        return len(found)

    def take(self) -> None:
        self.swap = self.modules["sdl2.video"].SDL_GL_SwapWindow
        self.events = SimpleNamespace(**vars(self.modules["sdl2.events"]))
        self.ticks = self.modules["sdl2.timer"].SDL_GetTicks

    def present(self) -> Any:
        return self.swap(None)

    def push(self, name: str, down: bool, held: int = 0, again: bool = False) -> None:
        event = Event()
        event.key.type = KEY_DOWN if down else KEY_UP
        event.key.keysym.sym = F1 + int(name[1:]) - 1 if len(name) > 1 else ord(name.lower())
        event.key.keysym.mod, event.key.repeat = held, int(again)
        self.queue.append(event)

    def note(self, event: Event) -> None:
        if event.type in (KEY_DOWN, KEY_UP):
            sym = event.key.keysym.sym
            name = f"F{sym - F1 + 1}" if sym > 0x1000 else chr(sym).upper()
            self.got.append((name, event.type == KEY_DOWN))

    def key(self, name: str, down: bool) -> None:
        self.push(name, down)
        event = Event()
        while self.events.SDL_PollEvent(ctypes.byref(event)):
            self.note(event)

    def redraws(self) -> int:
        return [(each.type, each.window.windowID) for each in self.queue].count((EXPOSED, 5))

    def seconds(self) -> float:
        return float(self.ticks()) / 1000


RIGS: dict[str, Callable[[], Rig]] = {"SDL2": Sdl2Rig}
