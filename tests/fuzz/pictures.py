"""The picture in a window, read in a context of our own: the program's is left alone."""

from __future__ import annotations

import ctypes
from ctypes import POINTER, byref, c_int, c_uint, c_void_p

from OpenGL import GL

from tests.fuzz.bare import driver

_FBCONFIG_ID, _RGBA_TYPE = 0x8013, 0x8014
_current_context = driver.glx("glXGetCurrentContext", c_void_p)
_current_drawable = driver.glx("glXGetCurrentDrawable", c_void_p)
_current_display = driver.glx("glXGetCurrentDisplay", c_void_p)
_query_context = driver.glx("glXQueryContext", c_int, c_void_p, c_void_p, c_int, POINTER(c_int))
_choose = driver.glx(
    "glXChooseFBConfig", POINTER(c_void_p), c_void_p, c_int, POINTER(c_int), POINTER(c_int)
)
_new_context = driver.glx(
    "glXCreateNewContext", c_void_p, c_void_p, c_void_p, c_int, c_void_p, c_int
)
_make_current = driver.glx("glXMakeContextCurrent", c_int, c_void_p, c_void_p, c_void_p, c_void_p)
_x_free = ctypes.CDLL("libX11.so.6").XFree
_x_free.argtypes = [c_void_p]


class Pictures:
    """Reads what a window shows; keeps one context for each of their kinds."""

    def __init__(self) -> None:
        self._contexts: dict[int, int] = {}

    def read(self, buffers: tuple[str, ...], width: int, height: int) -> dict[str, bytes]:
        """Colour of each buffer (``BACK``, ``FRONT``), depth and stencil of the current window."""
        display, drawable = _current_display(), _current_drawable()
        context = _current_context()
        if not context or not drawable:
            return {}
        _make_current(display, drawable, drawable, self._context(display, context))
        try:
            return _read(buffers, width, height)
        finally:
            _make_current(display, drawable, drawable, context)

    def _context(self, display: int, context: int) -> int:
        number = c_int()
        _query_context(display, context, _FBCONFIG_ID, byref(number))
        if number.value not in self._contexts:
            count = c_int()
            wanted = (c_int * 3)(_FBCONFIG_ID, number.value, 0)
            found = _choose(display, 0, wanted, byref(count))
            made = _new_context(display, found[0], _RGBA_TYPE, None, True)
            _x_free(found)
            self._contexts[number.value] = made
        return self._contexts[number.value]


def _read(buffers: tuple[str, ...], width: int, height: int) -> dict[str, bytes]:
    room = (c_uint * (width * height))()
    driver.glPixelStorei(GL.GL_PACK_ALIGNMENT, 1)
    found = {}
    for buffer in buffers:
        driver.glReadBuffer(getattr(GL, f"GL_{buffer}"))
        found[buffer.lower()] = _pixels(room, width, height, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)
    found["depth"] = _pixels(room, width, height, GL.GL_DEPTH_COMPONENT, GL.GL_FLOAT)
    found["stencil"] = _pixels(room, width, height, GL.GL_STENCIL_INDEX, GL.GL_UNSIGNED_INT)
    return found


def _pixels(room: ctypes.Array[c_uint], width: int, height: int, form: int, kind: int) -> bytes:
    ctypes.memset(room, 0, ctypes.sizeof(room))
    driver.glReadPixels(0, 0, width, height, form, kind, ctypes.addressof(room))
    return bytes(room)
