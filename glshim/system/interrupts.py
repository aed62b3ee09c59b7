"""Exceptions that are the program's: its signal handlers may raise between any two bytecodes.

Short work is made `at_once`: inside C no handler runs. Longer work is done while handlers are
`Held`; they run after it, and what they raise leaves the call of the program's that we worked in.
Where exceptions are caught for fear of our own faults, `is_ours` tells those.
"""

from __future__ import annotations

import _signal  # type: ignore[import-not-found]
import ctypes
import sys
from collections import deque
from collections.abc import Callable, Iterable
from functools import partial
from itertools import chain, repeat
from operator import methodcaller
from threading import get_ident, main_thread
from types import FrameType, TracebackType
from typing import Any

_NUMBERS = range(1, _signal.NSIG)
_call = methodcaller("__call__")

exhaust: Callable[[Iterable[Any], int], Any] = deque
"""``exhaust(in_turn(calls), 0)`` makes all calls in one, and that one is made whole."""


def in_turn(calls: Iterable[Callable[[], Any]]) -> Iterable[Any]:
    """Calls of functions of C's without arguments, or of `functools.partial` of them."""
    return map(_call, calls)


def at_once(calls: Iterable[Callable[[], Any]]) -> None:
    """Make all of them; none where a handler of the program's raises before."""
    exhaust(in_turn(calls), 0)


def is_ours(error: BaseException) -> bool:
    """Whether an exception that was caught in our code comes from it, or from what it called; not
    from a signal handler, nor from a trace function, which Python ran in its midst."""
    trace = error.__traceback__
    while trace is not None:
        if _is_handler(trace):
            return False
        trace = trace.tb_next
    return isinstance(error, Exception)


def _is_handler(trace: TracebackType) -> bool:
    """Whether a function was given a frame: handlers and trace functions are, and no others."""
    for value in trace.tb_frame.f_locals.values():
        if isinstance(value, FrameType):
            return True
        if type(value) is tuple and any(isinstance(part, FrameType) for part in value):
            return True
    return False


class Held:
    """``with Held():`` lets signal handlers wait; in other threads than the main one there are
    none. Costs some microseconds, inside another one nearly nothing."""

    __slots__ = ("_holds",)

    def __enter__(self) -> None:
        self._holds = _hold()

    def __exit__(self, *_: object) -> None:
        if self._holds:
            _release()


def raiser(error: BaseException) -> Callable[[], Any]:
    """What, called by C in this thread, has the error raised in the code of Python's that C returns
    to, as a signal handler would raise it there. Called by Python it raises at once."""

    def make(cls: Any, *_: object) -> BaseException:
        return error

    # Python makes an instance of a class when the time has come. Before 3.11 it is the class that
    # handlers are looked for by.
    kind = type(error) if sys.version_info < (3, 11) else BaseException
    late = type("Late", (kind,), {"__new__": make})
    thread = ctypes.c_ulong(get_ident())
    return partial(ctypes.pythonapi.PyThreadState_SetAsyncExc, thread, ctypes.py_object(late))


_depth = 0
_handlers: dict[int, Any] = {}
"""The program's, by signal, as they were when they were last made to wait."""
_came: dict[int, FrameType | None] = {}
"""Signals that came meanwhile, each once, as the system does it; and where the program was."""
_ACTION_BYTES = 256
"""Of a ``struct sigaction``, at most."""


def _wait(number: int, frame: FrameType | None) -> None:
    """In the place of handlers that wait."""
    while frame is not None and _is_of_the_shim(frame) and frame.f_back is not None:
        frame = frame.f_back
    _came.setdefault(number, frame)


def _is_of_the_shim(frame: FrameType) -> bool:
    name = frame.f_globals.get("__name__")
    return isinstance(name, str) and name.partition(".")[0] in ("glshim", "glshim_stylers")


def _hold() -> bool:
    global _depth
    if get_ident() != main_thread().ident:
        return False
    if _depth:
        _depth += 1
        return True
    found = {
        number: handler
        for number, handler in zip(_NUMBERS, map(_signal.getsignal, _NUMBERS), strict=True)
        if callable(handler) and handler is not _wait
    }
    actions = [_action(number) for number in found]
    try:
        _handlers.update(found)
        _actions.update(zip(found, actions, strict=True))
        exhaust(map(_signal.signal, found, repeat(_wait)), 0)
    except ValueError:  # the main thread of an interpreter that hears no signals
        return False
    except BaseException:  # of a handler, before it was to wait
        _let_go()
        raise
    _depth = 1
    return True


def _release() -> None:
    global _depth
    _depth -= 1
    if not _depth:
        _let_go()


def _let_go() -> None:
    """Give the program its handlers again. Those whose signals came run now."""
    waiting = [number for number in _handlers if _signal.getsignal(number) is _wait]
    handlers = [_handlers[number] for number in waiting]
    actions = [_actions[number] for number in waiting]
    again = map(_signal.signal, waiting, handlers)
    as_it_was = map(_set_action, waiting, actions, repeat(None))
    try:
        exhaust(chain(again, as_it_was), 0)
    except BaseException:  # of a handler that was given back and ran at once
        _let_go()
        raise
    _run()


def _run() -> None:
    if _came:
        number, frame = _came.popitem()
        try:
            _handlers[number](number, frame)
        finally:
            _run()


# -- the system's part of a handler: whether calls of C begin anew, or a library's own -------------

_actions: dict[int, Any] = {}
_set_action: Callable[..., Any] = getattr(ctypes.pythonapi, "sigaction", None) or (lambda *_: None)


def _action(number: int) -> Any:
    found = ctypes.create_string_buffer(_ACTION_BYTES)
    _set_action(number, None, found)
    return found
