"""pygame and pygame-ce."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from types import MappingProxyType
from typing import Any, ClassVar

from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, STEP, Alarm, Moment

# pygame.OPENGL and pygame.PREALLOC: SDL shows a window without OpenGL by way of GL of its own, with
# the first flag too, but keeps that window's pixels itself.
OPENGL, PREALLOC = 0x2, 0x1000000
_MODIFIERS = {"shift": 0x3, "ctrl": 0xC0, "alt": 0x300}
"""pygame.KMOD_SHIFT, KMOD_CTRL and KMOD_ALT: the left key of each and the right one."""


class Pygame(Toolkit):
    """The app gets its events without those of our keys. Another frame is asked for by a
    VIDEOEXPOSE, for programs that draw when there is an event."""

    name = package = "pygame"
    hears_threads = True
    tested = "pygame 2.6 on X and Wayland, and without a display"
    displayless: ClassVar[Mapping[str, str] | None] = MappingProxyType(
        {"SDL_VIDEODRIVER": "offscreen"}
    )

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "pygame.display", self.hook_presents, "pygame.display.flip")
        yield Hook(Part.KEYS, "pygame.event", self.hook_events, "pygame.event.get, poll, wait")
        yield Hook(Part.CLOCK, "pygame.time", self.hold_clock, "pygame.time")

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._display: Any = None

    def size(self, window: Any) -> Size:
        width, height = self._display.get_window_size()
        return width, height

    def redraw(self) -> None:
        with suppress(Exception):  # a full queue, no display
            event: Any = sys.modules["pygame.event"]
            event.post(event.Event(sys.modules["pygame.constants"].VIDEOEXPOSE))

    def hook_presents(self, module: Any, changes: Changes) -> None:
        self._display = module
        drawable = self.drawable()

        def presenting(plain: Callable[..., None]) -> Callable[..., None]:
            @functools.wraps(plain)
            def flip(*arguments: Any, **named: Any) -> None:
                shown = module.get_surface() if frames.listening() else None
                if shown is None or shown.get_flags() & (OPENGL | PREALLOC) != OPENGL:
                    return plain(*arguments, **named)
                return frames.present(plain, *arguments, on=drawable, named=named)

            return flip

        for name in ("flip", "update"):
            changes.set(module, name, presenting(getattr(module, name)))

    def hook_events(self, module: Any, changes: Changes) -> None:
        constants: Any = sys.modules["pygame.constants"]
        names = {getattr(constants, f"K_{name}"): name for name in keyboard.NAMES[:12]}
        names |= {ord(name.lower()): name for name in keyboard.NAMES if len(name) == 1}
        names |= {getattr(constants, f"K_{name.upper()}"): name for name in keyboard.SPECIAL}

        def ours(event: Any) -> bool:
            if event.type == constants.KEYUP:
                return keyboard.released(names.get(event.key))
            if event.type != constants.KEYDOWN:
                return False
            held = keyboard.modifiers(getattr(event, "mod", 0), _MODIFIERS)
            return keyboard.pressed(names.get(event.key), held)

        def many(plain: Callable[..., Any]) -> Callable[..., Any]:
            @functools.wraps(plain)
            def get(*arguments: Any, **named: Any) -> Any:
                events = plain(*arguments, **named)
                if not keyboard.listening():
                    return events
                return [event for event in events if not ours(event)]

            return get

        def one(plain: Callable[..., Any]) -> Callable[..., Any]:
            @functools.wraps(plain)
            def next_event(*arguments: Any, **named: Any) -> Any:
                event = plain(*arguments, **named)
                while keyboard.listening() and ours(event):
                    event = plain(*arguments, **named)
                return event

            return next_event

        changes.set(module, "get", many(module.get))
        for name in ("poll", "wait"):
            changes.set(module, name, one(getattr(module, name)))

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """The clocks of module `pygame.time` show the moment; waiting moves it."""
        moment, timers = self.moment, dict[int, Alarm]()

        class Clock:
            def tick(self, _framerate: float = 0) -> int:
                return 0 if moment.held else int(STEP * 1000)

            tick_busy_loop = get_time = get_rawtime = tick

            def get_fps(self) -> float:
                return 1 / STEP

        def wait(duration: int) -> int:
            moment.pass_by(duration / 1000)
            return duration

        def set_timer(event: Any, millis: int, loops: int = 0) -> None:
            kind = event if isinstance(event, int) else event.type
            if kind in timers:
                timers.pop(kind).stop()
            if millis > 0:
                timers[kind] = self._timer(event, millis / 1000, loops)

        for name, replacement in (
            ("set_timer", set_timer), ("get_ticks", lambda: int(moment.now * 1000)),
            ("wait", wait), ("delay", wait), ("Clock", Clock),
        ):  # fmt: skip
            changes.set(module, name, replacement)

    def _timer(self, event: Any, seconds: float, loops: int) -> Alarm:
        """Posts an event, or one of that type, so often; 0: until it is stopped."""
        left = loops

        def ring() -> None:
            nonlocal left
            events: Any = sys.modules["pygame.event"]
            with suppress(Exception):  # a full queue, no display
                events.post(events.Event(event) if isinstance(event, int) else event)
            left -= 1
            if not left:
                alarm.stop()

        alarm = Alarm(self.moment, seconds, ring)
        return alarm


TOOLKITS = (Pygame(),)
