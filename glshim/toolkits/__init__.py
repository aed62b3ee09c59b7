"""Window toolkits: how a frame ends, keys, redraw, clock, the drawable and its size.

One file each, behind the base in `glshim.toolkits.base`. This module finds them by listing its
folder, so that a new toolkit is a new file and nothing else.
"""

from __future__ import annotations

import os
from contextlib import suppress
from functools import cache
from importlib import import_module

from glshim.system.interrupts import Held
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Part, Toolkit

__all__ = ["Part", "Toolkit", "frames", "keyboard", "known", "leave", "redraw",
           "redraw_from_a_thread", "release", "used", "watch", "watch_package",
           "window_is_there"]  # fmt: skip


@cache
def of_file(name: str) -> tuple[Toolkit, ...]:
    """The toolkits of one file in this folder; none where it holds something else."""
    found: tuple[Toolkit, ...] = getattr(import_module(f"{__name__}.{name}"), "TOOLKITS", ())
    return found


@cache
def known() -> tuple[Toolkit, ...]:
    """Every toolkit, in the order of the files' names."""
    files = (os.path.splitext(name) for name in sorted(os.listdir(__path__[0])))
    names = [name for name, suffix in files if suffix == ".py" and name.isidentifier()]
    return tuple(toolkit for name in names if name != "__init__" for toolkit in of_file(name))


@cache
def used() -> tuple[Toolkit, ...]:
    """Those that programs use: all but the example."""
    return tuple(toolkit for toolkit in known() if not toolkit.example)


def watch(part: Part) -> None:
    """Hook every toolkit that is imported, and the others when they are."""
    for toolkit in used():
        toolkit.watch(part)


def watch_package(package: str, *parts: Part) -> None:
    """Hook one whose package has just been imported and whose file has its name."""
    for toolkit in of_file(package):
        if toolkit.package == package and not toolkit.example:
            for part in parts:
                toolkit.watch(part)


def release() -> None:
    """Leave the toolkits as they were found, but for what somebody still listens to."""
    for toolkit in used():
        if not frames.has_listeners():
            toolkit.release(Part.FRAMES)
        if not keyboard.listening():
            toolkit.release(Part.KEYS)


def window_is_there() -> None:
    """A window's context is current: some keys can be hooked only now."""
    for toolkit in used():
        if toolkit.is_hooked(Part.KEYS):
            toolkit.window_is_there()


def redraw() -> None:
    """Ask for another frame: programs that draw only on demand would show nothing new."""
    with Held():
        for toolkit in used():
            if toolkit.is_hooked(Part.KEYS):
                toolkit.redraw()


def redraw_from_a_thread() -> None:
    """The same, where it can be asked from another thread than the program's; whether or not keys
    are watched."""
    for toolkit in used():
        if toolkit.is_hooked(Part.FRAMES):
            with suppress(Exception):
                toolkit.redraw_from_a_thread()


def leave() -> bool:
    """Ask the main loop that runs to return; False where none can be asked. From any thread."""
    return any(
        toolkit.leave() for toolkit in used()
        if toolkit.is_hooked(Part.FRAMES) and toolkit.hears_threads
    )
