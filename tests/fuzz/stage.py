"""Plays a program: each step is tried, and what it gives is noted; at its swaps we look around."""

from __future__ import annotations

import ctypes
import re
import signal
import threading
from collections.abc import Iterable
from functools import lru_cache
from importlib import import_module
from types import CodeType
from typing import Any, ClassVar, NamedTuple

import glfw
import numpy as np
from OpenGL import GL, GLU
from OpenGL.raw.GL import _errors

from tests.fuzz import things
from tests.fuzz.bare import driver
from tests.fuzz.look import Eyes, inside
from tests.fuzz.pictures import Pictures
from tests.fuzz.registry import registry
from tests.fuzz.told import raised, told

WIDTH, HEIGHT = 64, 48
HINTS = {"VISIBLE": 0, "STENCIL_BITS": 8}


class _Raw:
    """PyOpenGL's functions without its conversion of arrays, whatever version they are of."""

    def __getattr__(self, name: str) -> Any:
        module = import_module(f"OpenGL.raw.GL.VERSION.{registry().commands[name].module}")
        return getattr(module, name)


RAW = _Raw()


class Note(NamedTuple):
    """What was seen at one step."""

    step: int
    what: str
    """``result``, ``after: back`` and the like, or ``said``."""
    value: str | bytes


class Window:
    """A hidden window of the program's, with a context of its own."""

    def __init__(self, handle: Any, kind: tuple[Any, ...]) -> None:
        self.handle = handle
        self.kind = kind
        self.holder: int | None = None
        """The thread in which it is current."""

    def __repr__(self) -> str:
        return "Window"


class Stage:
    """One program's world."""

    eyes: ClassVar[dict[tuple[Any, ...], Eyes]] = {}
    pictures = Pictures()
    other = things.Other()

    def __init__(self) -> None:
        self.notes: list[Note] = []
        self.number = 0
        self._memory = things.Memory()
        self._windows: list[Window] = []
        self._heard: list[str] = []
        memory = self._memory
        self.space: dict[str, Any] = {
            "__name__": "__main__", "GL": GL, "GLU": GLU, "raw": RAW, "bare": driver, "np": np,
            "ctypes": ctypes,
            "floats": memory.floats, "doubles": memory.doubles, "octets": memory.octets,
            "indices": memory.indices, "room": memory.room, "keep": memory.keep,
            "other": self.other, "strike": things.strike,
            "swap": self.swap, "use": self.use, "window": self.window, "destroy": self.destroy,
            "look": self.look, "hear": self.hear, "heard": self.heard,
            **{cls.__name__: cls for cls in (things.Interrupt, things.Refusal, things.Striking,
                                             things.Number, things.Valued, things.Holding)},
        }  # fmt: skip

    # -- what programs call ----------------------------------------------------------------------

    def window(self, share: Window | None = None, **hints: int) -> Window:
        """A new window, current from now on."""
        glfw.default_window_hints()
        for name, value in {**HINTS, **hints}.items():
            glfw.window_hint(getattr(glfw, name), value)
        handle = glfw.create_window(WIDTH, HEIGHT, "fuzz", None, share and share.handle)
        if not handle:
            raise RuntimeError("no such window")
        made = Window(handle, tuple(sorted(hints.items())))
        self._windows.append(made)
        self.use(made)
        if made.kind not in self.eyes:
            self.eyes[made.kind] = Eyes()
        return made

    def use(self, window: Window | None) -> None:
        """Make it current in the calling thread, unless it is in another."""
        here = threading.get_ident()
        self._outside()
        if window is not None and (
            window not in self._windows or window.holder not in (None, here)
        ):
            raise RuntimeError("not to be had")
        for each in self._windows:
            if each.holder == here:
                each.holder = None
        glfw.make_context_current(window and window.handle)
        if window is not None:
            window.holder = here

    def destroy(self, window: Window) -> None:
        """The window, with its context."""
        self._outside()
        if window not in self._windows or window.holder not in (None, threading.get_ident()):
            raise RuntimeError("not to be had")
        self._windows.remove(window)
        glfw.destroy_window(window.handle)

    def swap(self, observed: bool = True) -> None:
        """Present the current window. observed: what there is to see before and after is noted."""
        self._outside()
        if observed:
            self.look("before", "BACK")
        glfw.swap_buffers(self._current().handle)
        if observed:
            self.look("after", "FRONT")

    def look(self, when: str = "then", *buffers: str) -> None:
        """Note the state, and the picture in these buffers."""
        eyes = self.eyes[self._current().kind]
        self._outside()
        seen = eyes.look(self._memory.place)
        if buffers:
            seen |= self.pictures.read(buffers, WIDTH, HEIGHT)
        for what, value in seen.items():
            self.notes.append(Note(self.number, f"{when}: {what}", value))

    def hear(self, *args: Any) -> None:
        """A callback that writes down what it is told, without the names of objects in a message: a
        driver that counts upwards has other ones for programs and shaders (see docs, limits)."""
        if len(args) == 7 and isinstance(args[5], bytes):
            message = re.sub(rb"\b\d+\b", b"N", args[5])
            args = (*args[:4], len(message), message, args[6])
        self._heard.append(", ".join(map(told, args)))

    def heard(self) -> list[str]:
        """What callbacks were told since."""
        found = self._heard[:]
        self._heard.clear()
        return found

    def _outside(self) -> None:
        """What is done to windows inside a primitive is undefined."""
        here = threading.get_ident()
        if any(window.holder == here for window in self._windows) and inside():
            raise RuntimeError("inside a primitive")

    def _current(self) -> Window:
        here = threading.get_ident()
        for window in self._windows:
            if window.holder == here:
                return window
        raise RuntimeError("no window is current")

    # -- playing ---------------------------------------------------------------------------------

    def play(self, steps: Iterable[str]) -> list[Note]:
        """The steps, one after the other. Gives the notes."""
        before = signal.signal(signal.SIGUSR1, things.interrupt)
        checker = _errors._error_checker
        if checker is not None:
            checker.onEnd()
        try:
            for self.number, step in enumerate(steps):
                self.notes.append(Note(self.number, "result", self._tried(step)))
        finally:
            self._close()
            signal.signal(signal.SIGUSR1, before)
        return self.notes

    def _tried(self, step: str) -> str:
        if not self._ready(step):
            return "not tried: no window is current"  # drivers crash there, or do nothing
        try:
            name, code = compiled(step)
            value = eval(code, self.space)
            if name:
                self.space[name] = value
            return told(value)
        except BaseException as error:
            return raised(error)

    def _ready(self, step: str) -> bool:
        thread = self.other.number if step.startswith("other(") else threading.get_ident()
        held = any(window.holder == thread for window in self._windows)
        return held or not re.search(r"\b(GL|GLU|raw|bare)\.", step)

    def _close(self) -> None:
        if self.other.number:
            self.other(lambda: glfw.make_context_current(None))
        for window in self._windows[::-1]:
            glfw.destroy_window(window.handle)
        glfw.make_context_current(None)
        self.space.clear()


@lru_cache(maxsize=4096)
def compiled(step: str) -> tuple[str, CodeType]:
    """The name that a step gives its value, or none, and what it evaluates."""
    name, equals, rest = step.partition(" = ")
    if equals and name.isidentifier():
        return name, compile(rest, "<step>", "eval")
    return "", compile(step, "<step>", "eval")


def play(text: str) -> None:
    """Play a program from a script, and print what each step gives."""
    if not glfw.init():
        raise SystemExit("there is no display: use xvfb-run -a")
    steps = [line.strip() for line in text.strip().splitlines() if line.strip()]
    for note in Stage().play(steps):
        value = note.value if isinstance(note.value, str) else told(note.value)
        print(f"{steps[note.step]:60}  {note.what}: {value}")
