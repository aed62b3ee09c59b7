"""The end of the program, by whichever way it comes: Python's own, or `exit` of C, by which
freeglut leaves and of which Python's `atexit` hears nothing."""

from __future__ import annotations

import atexit
import ctypes
import os
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from glshim.notices import say_fault
from glshim.system.prototypes import function_type

_functions: list[tuple[int, Callable[[], None]]] = []
"""With the process that each is for: a fork is another one."""
_guard: _Guard | None = None


def at_end(function: Callable[[], None]) -> None:
    """Have it called once as this process ends, unless a signal or `os._exit` ends it."""
    global _guard
    _functions.append((os.getpid(), function))
    if _guard is None:
        _guard = _Guard()
        atexit.register(_guard.python_ends)


def _call_all() -> None:
    while _functions:
        process, function = _functions.pop()
        if process == os.getpid():
            try:
                function()
            except Exception as error:
                say_fault("an error at the end of the program", error)


class _Guard:
    """A handler at C's `exit`, taken back before Python is gone."""

    def __init__(self) -> None:
        self._mark = ctypes.create_string_buffer(1)  # its address names the handler
        self._take_back: Any = None
        self._handler = function_type(None, ctypes.c_void_p)(self._c_ends)
        with suppress(AttributeError, OSError, TypeError):  # another C library has other names
            library = ctypes.CDLL(None)
            register, self._take_back = (
                getattr(library, name) for name in ("__cxa_atexit", "__cxa_finalize")
            )
            self._take_back.argtypes = [ctypes.c_void_p]
            register.argtypes = [type(self._handler), ctypes.c_void_p, ctypes.c_void_p]
            register(self._handler, None, ctypes.addressof(self._mark))

    def python_ends(self) -> None:
        _call_all()
        self.disarm()

    def _c_ends(self, _: int | None) -> None:
        if self._take_back is not None:
            _call_all()

    def disarm(self) -> None:
        """C calls a handler as it takes it back, which is nothing to it any more."""
        take_back, self._take_back = self._take_back, None
        if take_back is not None:
            take_back(ctypes.addressof(self._mark))

    def __del__(self) -> None:  # where the program has cleared Python's exit functions
        self.disarm()
