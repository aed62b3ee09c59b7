"""Whether a context that was current once is still there, asked of the window system: OpenGL
itself knows the current context alone, and toolkits destroy others unheard.

The program notices nothing: no call of GL's is made, no error of EGL's comes up in its thread, and
none in its X error handler.
"""

from __future__ import annotations

import _thread
import ctypes
import os
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from glshim.driver.functions import address, current_context
from glshim.system.prototypes import function_type

Witness = Callable[[], bool]
"""False once a context is gone, for sure; its handle may be another one's then."""

_EGL_CONTEXT_CLIENT_TYPE = 0x3097


def witness() -> Witness:
    """Of the current context. Ask it at any time, whatever is current then."""
    handle = current_context()
    for known in (_glx, _egl):
        with suppress(AttributeError, OSError):  # no such library, or no such function in it
            found = known(handle)
            if found is not None and found():
                return found
    return lambda: True


def _glx(handle: int) -> Witness | None:
    """The X server knows contexts by number."""
    server = _Server()
    number = server.number(handle) if server.current() == handle else 0
    if not number:
        return None
    name = server.name()

    def is_there() -> bool:
        current = server.current()
        if not current:
            return True
        if current == handle:  # which may be another one's by now
            return bool(server.number(current) == number)
        # Numbers of a connection that is closed may be given to the next one.
        return server.name() != name or (
            server.number(current) != number and server.knows(number)
        )

    return is_there if server.knows(number) else None


class _Server:
    """The X server that the current context's drawable is on."""

    def __init__(self) -> None:
        pointer, libx11 = ctypes.c_void_p, ctypes.CDLL("libX11.so.6")
        glx, requests = _loaded("libGLX.so.0", "libGL.so.1"), ctypes.CDLL("libxcb-glx.so.0")
        number = address("glXGetContextIDEXT")
        if not number:
            raise AttributeError("glXGetContextIDEXT")
        self.current = _function(glx.glXGetCurrentContext, pointer)
        """The handle of the current context."""
        self.number = function_type(ctypes.c_ulong, pointer)(number)
        """Of a context that is there, by its handle."""
        self._display = _function(glx.glXGetCurrentDisplay, pointer)
        self._name = _function(libx11.XDisplayString, ctypes.c_char_p, pointer)
        self._connection = _function(
            ctypes.CDLL("libX11-xcb.so.1").XGetXCBConnection, pointer, pointer
        )
        self._ask = _function(requests.xcb_glx_is_direct, _Cookie, pointer, ctypes.c_uint)
        self._answer = _function(
            requests.xcb_glx_is_direct_reply, pointer, pointer, _Cookie, pointer
        )
        self._free = _function(ctypes.CDLL(None).free, None, pointer)

    def name(self) -> bytes:
        """For example ``:0``; empty where no context is current."""
        display = self._display()
        return self._name(display) or b"" if display else b""

    def knows(self, number: int) -> bool:
        """Whether it has a context of that number."""
        error = ctypes.c_void_p()
        connection = self._connection(self._display())
        asked = self._ask(connection, number)
        # Who takes the error here keeps it from Xlib's handler.
        answer = self._answer(connection, asked, ctypes.addressof(error))
        self._free(error)
        self._free(answer)
        return bool(answer)


class _Cookie(ctypes.Structure):
    """``xcb_glx_is_direct_cookie_t``."""

    _fields_ = (("sequence", ctypes.c_uint),)


def _egl(handle: int) -> Witness | None:
    """EGL looks handles up before it believes in them."""
    library, pointer = _loaded("libEGL.so.1"), ctypes.c_void_p
    current = _function(library.eglGetCurrentContext, pointer)
    if current() != handle:
        return None
    display = _function(library.eglGetCurrentDisplay, pointer)()
    query = _function(
        library.eglQueryContext, ctypes.c_uint, pointer, pointer, ctypes.c_int, pointer
    )

    def is_there() -> bool:
        if current() == handle:
            return True
        value = ctypes.c_int()
        arguments = display, handle, _EGL_CONTEXT_CLIENT_TYPE, ctypes.addressof(value)
        return bool(_in_a_thread(lambda: query(*arguments)))

    return is_there


def _in_a_thread(call: Callable[[], Any]) -> Any:
    """What a call gives in a thread of its own: errors of EGL's belong to the thread."""
    answers: list[Any] = []
    over = _thread.allocate_lock()
    over.acquire()

    def run() -> None:
        try:
            answers.append(call())
        finally:
            over.release()

    _thread.start_new_thread(run, ())
    over.acquire()
    return answers[0] if answers else None


def _loaded(*names: str) -> ctypes.CDLL:
    """The first of these libraries that the process has already."""
    for name in names:
        with suppress(OSError):
            return ctypes.CDLL(name, mode=os.RTLD_NOLOAD)
    raise OSError(f"no library {names[0]} is loaded")


def _function(place: Any, result: Any, *arguments: Any) -> Callable[..., Any]:
    pointer = ctypes.cast(place, ctypes.c_void_p).value
    assert pointer is not None
    function: Callable[..., Any] = function_type(result, *arguments)(pointer)
    return function
