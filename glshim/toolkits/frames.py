"""The ends of frames: every toolkit's present function, as data, and who listens to it.

A listener is a pair of functions: ``before`` runs with the app's context current just before the
frame is presented, ``after`` just after. The app sees neither them nor their exceptions.
"""

from __future__ import annotations

import atexit
import os
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, NoReturn, TypeVar

from glshim.bindings.imports import after_import
from glshim.notices import say_fault

Result = TypeVar("Result")
Size = tuple[int, int]
"""Width and height of a drawable, in pixels."""


def _nothing() -> None:
    """Stands for the half of a listener that was not given."""


@dataclass(frozen=True, slots=True)
class _Listener:
    before: Callable[[], None]
    after: Callable[[], None]
    rank: int


@dataclass(frozen=True, slots=True)
class Surface:
    """What a toolkit is about to present."""

    size: Callable[[], Size | None]
    may_raise: bool = True
    """Whether an exception that leaves the present call gets through to the app's main loop."""
    framebuffer: Callable[[], int] = lambda: 0
    """The framebuffer object that it is drawn into, 0 for the window's own."""


UNKNOWN = Surface(lambda: None)
_listeners: tuple[_Listener, ...] = ()
_surface = UNKNOWN
_watching = False
_presented = 0
_leaving = False
_exit_raised = False


def install(
    before_present: Callable[[], None],
    after_present: Callable[[], None] = _nothing,
    *,
    rank: int = 0,
) -> None:
    """Listen to frame ends. Listeners of a lower rank come first: 0 draws, 1 looks at the picture,
    2 draws over it, 3 counts. Installing the same ``before_present`` again replaces it."""
    global _listeners
    uninstall(before_present)
    listener = _Listener(before_present, after_present, rank)
    _listeners = tuple(sorted((*_listeners, listener), key=lambda each: each.rank))
    watch_toolkits()


def uninstall(before_present: Callable[[], None]) -> None:
    """Stop listening. A toolkit's hook with no listener only calls the toolkit."""
    global _listeners
    _listeners = tuple(each for each in _listeners if each.before != before_present)


def watch_toolkits() -> None:
    """Hook every toolkit of the table that is imported, and the others when they are."""
    from glshim.toolkits.toolkits import TOOLKITS

    global _watching
    if not _watching:
        _watching = True
        for toolkit in TOOLKITS:
            after_import(toolkit.module, toolkit.hook)


def present(
    swap: Callable[..., Result],
    *arguments: Any,
    on: Surface | None = None,
    named: Mapping[str, Any] = MappingProxyType({}),
) -> Result:
    """Call ``swap(*arguments, **named)`` as the end of a frame.

    For the hooks on toolkits, and without ``on`` for what ends a frame by itself: glFlush or
    glFinish on a single-buffered or off-screen context. May raise `SystemExit`: see `end_program`.
    """
    global _presented
    if not listening():
        return swap(*arguments, **named)
    with drawing(on or _surface):
        for listener in _listeners:
            _call(listener.before)
        result = swap(*arguments, **named)
        _presented += 1
        for listener in _listeners:
            _call(listener.after)
        if _leaving:
            _leave(_surface)
    return result


def listening() -> bool:
    """Whether a frame that ends now matters to anyone: someone listens, a context is current."""
    return bool(_listeners) and _context_is_current()


def _context_is_current() -> bool:
    # Without PyOpenGL there is nothing of ours in the frame.
    platform = sys.modules.get("OpenGL.platform")
    return platform is not None and bool(platform.PLATFORM.GetCurrentContext())


@contextmanager
def drawing(on: Surface) -> Iterator[None]:
    """Frames that end inside belong to this surface."""
    global _surface
    outer, _surface = _surface, on
    try:
        yield
    finally:
        _surface = outer


def presented() -> int:
    """Frames presented so far in this process."""
    return _presented


def drawable_size() -> Size | None:
    """The size of what is being presented, None where the toolkit did not say."""
    with suppress(Exception):
        return _surface.size()
    return None


def drawable_framebuffer() -> int:
    """The framebuffer object of what is being presented, 0 for the window's own."""
    with suppress(Exception):
        return _surface.framebuffer()
    return 0


def end_program() -> None:
    """Have the program end with status 0 once the listeners of this frame have run."""
    global _leaving
    _leaving = True


def _call(function: Callable[[], None]) -> None:
    try:
        function()
    except Exception as error:
        say_fault("a frame end went wrong, the program runs on", error)


def _leave(surface: Surface) -> None:
    """End as the app would by itself, with its ``finally`` blocks run, where an exception gets
    that far: not out of a callback from C, not out of a thread, not twice."""
    global _exit_raised
    in_main_thread = threading.current_thread() is threading.main_thread()
    if surface.may_raise and in_main_thread and not _exit_raised:
        _exit_raised = True
        raise SystemExit(0)
    exit_now()


def exit_now() -> NoReturn:
    """What the interpreter does at its end, without unwinding the stack."""
    run_exit_functions: Callable[[], None] = atexit._run_exitfuncs
    with suppress(Exception):
        run_exit_functions()
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(0)
