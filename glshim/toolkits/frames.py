"""The ends of frames, and who listens to them. Which call of which toolkit ends a frame is said in
the toolkits' own files, which call `present`; this one knows no toolkit.

A listener is up to two functions: ``before`` runs with the app's context current just before the
frame is presented, ``after`` just after. The app sees neither them nor their exceptions; its own
signal handlers wait meanwhile.
"""

from __future__ import annotations

import atexit
import os
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass
from enum import IntEnum
from threading import get_ident, local
from types import MappingProxyType
from typing import Any, NoReturn, TypeVar

from glshim.driver.functions import current_context
from glshim.notices import say, say_fault
from glshim.spec.pixels import TextureImage
from glshim.system import modules
from glshim.system.interrupts import Held

Result = TypeVar("Result")
Size = tuple[int, int]
"""Width and height of a drawable, in pixels."""


class Stage(IntEnum):
    """When a listener is called: in this order, before the present and again after it."""

    DRAW = 0
    """The style is drawn into the app's picture."""
    CLOCK = 1
    """Clocks that stand still move on."""
    CAPTURE = 2
    """The finished picture is read."""
    OVERLAY = 3
    """What belongs to no picture is drawn over it."""
    COUNT = 4
    """Frames are counted, and the program may end."""
    RELOAD = 5
    """Saved files are read again."""


@dataclass(frozen=True, slots=True, eq=False)
class Listener:
    """Who listens to frame ends."""

    stage: Stage
    before: Callable[[], None] | None
    after: Callable[[], None] | None
    read: Callable[[], None] | None = None

    def stop(self) -> None:
        """Listen no more. A toolkit's hook with no listener only calls the toolkit."""
        global _listeners
        _listeners = tuple(each for each in _listeners if each is not self)


@dataclass(frozen=True, slots=True)
class Drawable:
    """What a toolkit is about to present: a window, a widget."""

    size: Callable[[], Size | None]
    may_raise: bool = True
    """Whether an exception that leaves the present call gets through to the app's main loop."""
    framebuffer: Callable[[], int] = lambda: 0
    """The framebuffer object that it is drawn into, 0 for the window's own."""
    leave: Callable[[], bool] = lambda: False
    """Asks the app's main loop to return, soon; False where no such loop runs."""
    buffer: int = 0
    """The framebuffer's buffer that is looked at, 0 for the one that is shown."""
    texture: TextureImage | None = None
    """What is looked at in place of a framebuffer."""
    is_shown: bool = True
    """By a toolkit; else the app reads it back."""
    owner: str = ""
    """The toolkit's name; empty where there is none."""


UNKNOWN = Drawable(lambda: None, is_shown=False)


class _Here(local):
    """What each thread presents."""

    drawable = UNKNOWN


_here = _Here()
_listeners: tuple[Listener, ...] = ()
_presented = 0
_leaving = False
_exit_raised = False
_caught = 0
"""The exit status of a program that catches the exception which ends it."""
_loop_asked = False
"""The app's main loop was asked to return: frames that it still shows are nobody's."""
_showing: set[int] = set()
"""Threads in which a frame is being shown."""
_drawing: set[int] = set()
"""Threads in which a toolkit has the app draw, and shows what that leaves."""
_shown = False
"""A toolkit has presented a frame: nothing that is read back is one."""
_read: Drawable | None = None
"""What was last read back, where that may be all that becomes of the frame."""
_double_buffered: bool | None = None
_wanted = False
RESTS, ASKED_AGAIN = 1.0, 0.05
"""Seconds without a frame after which a program rests, and where it shows none but when asked."""


def listen(
    stage: Stage,
    *,
    before: Callable[[], None] | None = None,
    after: Callable[[], None] | None = None,
    read: Callable[[], None] | None = None,
) -> Listener:
    """Have the functions called at each frame end, after those of earlier stages and those that
    came to the same stage earlier, until the listener is stopped. Toolkits end frames only once
    they are hooked: see `glshim.toolkits.watch`. read: the app has read back what may be the
    frame, which keeps its number until a toolkit shows it or another begins."""
    global _listeners
    listener = Listener(stage, before, after, read)
    _listeners = tuple(sorted((*_listeners, listener), key=lambda each: each.stage))
    return listener


def has_listeners() -> bool:
    """Whether anyone listens, in whatever context."""
    return bool(_listeners)


def listening() -> bool:
    """Whether a frame that ends now matters to anyone: someone listens, a context is current."""
    return bool(_listeners) and not _loop_asked and _context_is_current()


def present(
    swap: Callable[..., Result],
    *arguments: Any,
    on: Drawable | None = None,
    named: Mapping[str, Any] = MappingProxyType({}),
) -> Result:
    """Call ``swap(*arguments, **named)`` as the end of a frame.

    For the hooks on toolkits, and without ``on`` for what ends a frame by itself: glFlush or
    glFinish on a single-buffered or off-screen context. May raise `SystemExit`: see `end_program`.
    """
    if not listening() or get_ident() in _showing:
        return swap(*arguments, **named)
    with _ending(on or _here.drawable):
        return swap(*arguments, **named)


def showing() -> bool:
    """Whether some thread is showing a frame: a style may be at work on it."""
    return bool(_showing)


class Ending:
    """The end of a frame that is shown between two calls of the toolkit's: for hooks that hear of
    both and make neither."""

    def __init__(self) -> None:
        self._open: AbstractContextManager[None] | None = None

    def begin(self, on: Drawable) -> None:
        """It is about to be shown. May raise what a signal handler of the app's raises."""
        if self._open is None and listening() and get_ident() not in _showing:
            ending = _ending(on)
            ending.__enter__()
            self._open = ending

    def finish(self, error: Exception | None = None) -> None:
        """It was shown, or the toolkit failed to. May raise as `present` does."""
        ending, self._open = self._open, None
        if ending is not None:
            ending.__exit__(None if error is None else type(error), error, None)


@contextmanager
def _ending(on: Drawable) -> Iterator[None]:
    """Inside it a frame is shown, once: toolkits call one another."""
    global _shown, _read
    outer, thread = _here.drawable, get_ident()
    try:  # a signal handler of the app's may raise from here on
        _here.drawable = on
        _shown, _read = _shown or on.is_shown, None
        _showing.add(thread)
        with Held():
            for listener in _listeners:
                _call(listener.before)
        yield
        _over(on)
    finally:
        _here.drawable = outer
        _showing.discard(thread)


def _over(drawable: Drawable) -> None:
    """The frame is over."""
    global _presented
    with Held():
        _presented += 1
        for listener in _listeners:
            _call(listener.after)
        modules.hide()
    if _leaving:
        _leave(drawable)


def finish_drawing() -> None:
    """The app looks at its picture, which may be all that becomes of the frame."""
    with Held():
        for listener in _listeners:
            if listener.stage is Stage.DRAW:
                _call(listener.before)


def read_back(on: Drawable) -> None:
    """The app has read its picture. It is a frame unless a toolkit shows it yet."""
    global _read
    outer = _here.drawable
    try:
        _here.drawable = on
        with Held():
            for listener in _listeners:
                _call(listener.read)
        _read = on
    finally:
        _here.drawable = outer


def end_read() -> None:
    """Another frame begins, and no toolkit has shown what was read back: that was a frame."""
    global _read
    on, _read = _read, None
    if on is None:
        return
    outer = _here.drawable
    try:
        _here.drawable = on
        finish_drawing()
        _over(on)
    finally:
        _here.drawable = outer


def shown_by_a_toolkit() -> bool:
    """Whether what the app draws now is shown by a toolkit: one has shown frames, or has it draw
    in this thread."""
    return _shown or get_ident() in _drawing


def _context_is_current() -> bool:
    # Without PyOpenGL there is nothing of ours in the frame.
    return "OpenGL.platform" in sys.modules and bool(current_context())


@contextmanager
def drawing(on: Drawable) -> Iterator[None]:
    """Frames that end inside belong to this drawable."""
    outer, thread = _here.drawable, get_ident()
    is_first = thread not in _drawing
    try:
        _here.drawable = on
        _drawing.add(thread)
        yield
    finally:
        _here.drawable = outer
        if is_first:
            _drawing.discard(thread)


def presented() -> int:
    """Frames presented so far in this process."""
    return _presented


def begun() -> int:
    """Frames presented or read back so far: the last of those may be one that is to be shown."""
    return _presented + (_read is not None)


def drawable_size() -> Size | None:
    """The size of what is being presented, None where the toolkit did not say."""
    with suppress(Exception):
        return _here.drawable.size()
    return None


def drawable_framebuffer() -> int:
    """The framebuffer object of what is being presented, 0 for the window's own."""
    with suppress(Exception):
        return _here.drawable.framebuffer()
    return 0


def drawable_buffer() -> int:
    """The buffer of that framebuffer that is looked at, 0 for the one that is shown."""
    return _here.drawable.buffer


def drawable_texture() -> TextureImage | None:
    """The texture that the app reads its picture from, if it does."""
    return _here.drawable.texture


def drawable_owner() -> str:
    """The name of the toolkit that presents it, or how it ends without one."""
    if _here.drawable.owner:
        return _here.drawable.owner
    return "glFlush or glFinish" if _here.drawable is UNKNOWN else "pictures that are read back"


def buffering(double: bool | None) -> None:
    """Whether the window is double-buffered, while something else takes its place; None: the
    driver knows."""
    global _double_buffered
    _double_buffered = double


def window_is_double_buffered() -> bool | None:
    """What was said of it; None: the driver knows."""
    return _double_buffered


def want_more(wanted: bool) -> None:
    """Whether frames are wanted that a program may not show by itself."""
    global _wanted
    _wanted = wanted


def more_are_wanted() -> bool:
    """Whether a program that rests is to be asked for another frame."""
    return _wanted and not leaving()


def leaving() -> bool:
    """Whether the program is about to end."""
    return _leaving or _loop_asked


def leave_now(leave: Callable[[], bool]) -> None:
    """End a program that rests, from any thread: by its main loop where that can be asked."""
    global _loop_asked
    with suppress(Exception):
        _loop_asked = leave()
    if not _loop_asked:
        exit_now()


def end_program(*, caught: int = 0) -> None:
    """Have the program end with status 0 once the listeners of this frame have run. caught: the
    status, if the program catches the exception that ends it and presents another frame."""
    global _leaving, _caught
    _leaving, _caught = True, caught


def _call(function: Callable[[], None] | None) -> None:
    if function is None:
        return
    try:
        function()
    except Exception as error:
        say_fault("an error at the end of a frame; the program runs on", error)


def _leave(drawable: Drawable) -> None:
    """End as the app would by itself, with its ``finally`` blocks run. By an exception where one
    gets that far: not out of a callback from C, not out of a thread, not twice. Else by its main
    loop, once the callback has returned: what a toolkit is painting must not go meanwhile."""
    global _exit_raised, _loop_asked
    in_main_thread = threading.current_thread() is threading.main_thread()
    if drawable.may_raise and in_main_thread and not _exit_raised:
        _exit_raised = True
        atexit.register(_nothing_caught)
        raise SystemExit(0)
    with suppress(Exception):
        _loop_asked = drawable.leave()
    if _loop_asked:
        return
    if _exit_raised and _caught and not isinstance(sys.exc_info()[1], SystemExit):
        say("the program caught the SystemExit that was to end it, and was ended one frame later")
        exit_now(_caught)
    exit_now()


def _nothing_caught() -> None:
    """The interpreter ends: what is presented now, exit functions present."""
    global _caught
    _caught = 0


def exit_now(status: int = 0) -> NoReturn:
    """What the interpreter does at its end, without unwinding the stack."""
    run_exit_functions: Callable[[], None] = atexit._run_exitfuncs
    with suppress(Exception):
        run_exit_functions()
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os._exit(status)
