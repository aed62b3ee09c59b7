"""SDL2 by PySDL2: ctypes functions, which are hooked in place."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any, ClassVar

from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.system.interrupts import Held
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, Moment

# From SDL's headers, where they are a stable ABI.
WINDOW_EVENT, KEY_DOWN, KEY_UP = 0x200, 0x300, 0x301
"""SDL_WINDOWEVENT and so on."""
EXPOSED = 3
"""SDL_WINDOWEVENT_EXPOSED."""
GET_EVENT = 2
"""SDL_GETEVENT."""
_SCANCODE = 1 << 30
_KEYS = {
    **{(_SCANCODE | 57) + n: f"F{n}" for n in range(1, 13)},
    **{ord(name.lower()): name for name in keyboard.NAMES if len(name) == 1},
    _SCANCODE | 73: "Insert", _SCANCODE | 74: "Home", _SCANCODE | 75: "PageUp",
    _SCANCODE | 77: "End", _SCANCODE | 78: "PageDown",
}  # fmt: skip
"""SDLK_F1 and so on."""
_MODIFIERS = {"shift": 0x3, "ctrl": 0xC0, "alt": 0x300}
"""KMOD_SHIFT and so on: the left key of each and the right one."""
_NANOSECONDS = 1_000_000_000
Maker = Callable[[Callable[..., Any]], Callable[..., Any]]


class Sdl2(Toolkit):
    """The app gets its events without those of our keys. Another frame is asked for by an event
    that says that a window is exposed."""

    name, package, distribution = "SDL2", "sdl2", "PySDL2"
    hears_threads = True
    tested = "PySDL2 0.9.17 on X, and without a display"
    displayless: ClassVar[Mapping[str, str] | None] = MappingProxyType(
        {"SDL_VIDEODRIVER": "offscreen"}
    )

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._video: Any = None
        self._events: Any = None
        self._windows: set[int] = set()
        """SDL's numbers of those that may be asked for another frame."""

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "sdl2.video", self.hook_swaps, "SDL_GL_SwapWindow")
        yield Hook(
            Part.KEYS, "sdl2.events", self.hook_events,
            "SDL_PollEvent, SDL_WaitEvent, SDL_WaitEventTimeout, SDL_PeepEvents",
        )  # fmt: skip
        yield Hook(Part.CLOCK, "sdl2.timer", self.hold_clock, "SDL_GetTicks, SDL_Delay")

    def size(self, window: Any) -> Size:
        width, height = ctypes.c_int(), ctypes.c_int()
        self._video.SDL_GL_GetDrawableSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    def redraw(self) -> None:
        for number in tuple(self._windows):
            if not self._video.SDL_GetWindowFromID(number):  # it is gone
                self._windows.discard(number)
                continue
            events: Any = sys.modules["sdl2.events"]
            event = events.SDL_Event()
            event.type = WINDOW_EVENT
            event.window.windowID, event.window.event = number, EXPOSED
            events.SDL_PushEvent(ctypes.byref(event))

    # -- frame ends ------------------------------------------------------------------------------

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        self._video = module

        def swapping(plain: Callable[..., Any]) -> Callable[..., Any]:
            def swap_window(window: Any, *more: Any) -> Any:
                if self.is_hooked(Part.KEYS):
                    with Held():
                        self._windows.add(module.SDL_GetWindowID(window))
                return frames.present(plain, window, *more, on=self.drawable(window))

            return swap_window

        _hook(changes, module.SDL_GL_SwapWindow, swapping)

    # -- keys ------------------------------------------------------------------------------------

    def hook_events(self, module: Any, changes: Changes) -> None:
        self._events = module

        def events_at(pointer: Any) -> Any:
            """What a pointer, or what ctypes takes for one, points to."""
            if isinstance(pointer, module.SDL_Event):
                pointer = ctypes.byref(pointer)
            return ctypes.cast(pointer, ctypes.POINTER(module.SDL_Event))

        def one(plain: Callable[..., Any]) -> Callable[..., Any]:
            def next_event(event: Any, *more: Any) -> Any:
                found = plain(event, *more)
                while found and event is not None and keyboard.listening():
                    if not _is_ours(events_at(event)[0]):
                        break
                    found = plain(event, *more)
                return found

            return next_event

        def many(plain: Callable[..., Any]) -> Callable[..., Any]:
            def peep_events(events: Any, count: Any, action: Any, *more: Any) -> Any:
                found = plain(events, count, action, *more)
                if found < 1 or not events or action != GET_EVENT or not keyboard.listening():
                    return found
                fetched = events_at(events)
                kept = [n for n in range(found) if not _is_ours(fetched[n])]
                for place, n in enumerate(kept):
                    if place != n:
                        ctypes.pointer(fetched[place])[0] = fetched[n]
                return len(kept)

            return peep_events

        for name in ("SDL_PollEvent", "SDL_WaitEvent", "SDL_WaitEventTimeout"):
            _hook(changes, getattr(module, name), one)
        _hook(changes, module.SDL_PeepEvents, many)

    # -- clock -----------------------------------------------------------------------------------

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """SDL's clocks show the moment; waiting moves it."""
        moment = self.moment
        clocks: dict[str, Callable[..., Any]] = {
            "SDL_GetTicks": lambda: int(moment.now * 1000),
            "SDL_GetTicks64": lambda: int(moment.now * 1000),
            "SDL_GetPerformanceCounter": lambda: int(moment.now * _NANOSECONDS),
            "SDL_GetPerformanceFrequency": lambda: _NANOSECONDS,
            "SDL_Delay": lambda milliseconds: moment.pass_by(int(milliseconds) / 1000),
        }
        for name, clock in clocks.items():
            _hook(changes, getattr(module, name, None), _instead(clock))


def _hook(changes: Changes, function: Any, maker: Maker) -> None:
    """Have the maker's call in the place of a function's, which is given to it."""
    if hasattr(type(function), "_flags_"):  # PySDL2 has one of Python's for what SDL lacks
        hook_function(function, maker(original_call(function)))
        changes.add(lambda: hook_function(function, None))


def _instead(call: Callable[..., Any]) -> Maker:
    return lambda plain: call


def _is_ours(event: Any) -> bool:
    if event.type not in (KEY_DOWN, KEY_UP):
        return False
    name = _KEYS.get(event.key.keysym.sym)
    if event.type == KEY_UP:
        return keyboard.released(name)
    held = keyboard.modifiers(event.key.keysym.mod, _MODIFIERS)
    return keyboard.pressed(name, held, again=bool(event.key.repeat))


TOOLKITS = (Sdl2(),)
