"""The driver's own functions, bare: no PyOpenGL conversion, no error check, no hook.

What the shim itself says to GL goes through here, so it never meets its own hooks, never raises a
GL error of its own and costs a fifth of a PyOpenGL call. Signatures are data
(`glshim.spec.signatures`).
"""

from __future__ import annotations

import ctypes
import os
from collections.abc import Callable
from typing import Any

from glshim.spec.signatures import SIGNATURES
from glshim.system.prototypes import function_type

LETTERS: dict[str, Any] = {
    "i": ctypes.c_int,
    "u": ctypes.c_uint,
    "f": ctypes.c_float,
    "d": ctypes.c_double,
    "b": ctypes.c_ubyte,
    "p": ctypes.c_void_p,
    "n": ctypes.c_ssize_t,
}


class Driver:
    """Attribute access gives the bare function, resolved once: ``gl.glGetFloatv(pname, buffer)``.

    Raises AttributeError for a function that this platform does not have; resolve after a context
    is current.
    """

    def __getattr__(self, name: str) -> Callable[..., Any]:
        place = address(name)
        if not place:
            raise AttributeError(f"this GL driver has no {name}")
        function: Callable[..., Any] = prototype(name)(place)
        setattr(self, name, function)
        return function


gl = Driver()


def prototype(name: str) -> Any:
    """The ctypes class of a function of the driver's. Raises AttributeError where no row tells its
    signature."""
    signature = SIGNATURES.get(name)
    if signature is None:
        raise AttributeError(f"glshim.spec.signatures has no row for {name!r}")
    arguments, _, result = signature.partition(">")
    return function_type(
        LETTERS[result] if result else None, *(LETTERS[letter] for letter in arguments)
    )


def address(name: str) -> int:
    """Where a function of the driver's is, 0 where this platform does not have it."""
    from OpenGL.platform import PLATFORM

    try:
        # Not as an attribute: the library would keep it, for the program to see.
        place = ctypes.cast(PLATFORM.GL._FuncPtr((name, PLATFORM.GL)), ctypes.c_void_p).value
    except AttributeError:
        place = PLATFORM.getExtensionProcedure(name.encode())
    return place or 0


def quick(name: str) -> Callable[..., Any]:
    """A bare function without result for the hottest paths: twice as fast as ``gl.name``.

    It does not convert: arguments are integers, ``bytes`` or ctypes pointers. It keeps the GIL, so
    it is for calls that return at once.
    """
    place = ctypes.cast(getattr(gl, name), ctypes.c_void_p).value
    assert place is not None
    return _QUICK(place)


_QUICK = ctypes.PYFUNCTYPE(None)  # a new class each time it is asked for
_Getter = Callable[[], int | None]
_get_current: _Getter | None = None


def current_context() -> int:
    """The platform's handle of the current context, 0 when none is current."""
    global _get_current
    if _get_current is None:
        _get_current = _current_getter()
    return _get_current() or _of_another_platform()


_OTHERS = (
    ("libEGL.so.1", "eglGetCurrentContext"),
    ("libGLX.so.0", "glXGetCurrentContext"),
    ("libGL.so.1", "glXGetCurrentContext"),
)
_others: dict[str, _Getter] = {}


def _of_another_platform() -> int:
    """The current context where it is not of the platform that PyOpenGL has been told: toolkits
    choose theirs by themselves, and its functions are the same. 0 when none is current."""
    from OpenGL.platform import PLATFORM

    if "OSMesa" in str(getattr(PLATFORM.GL, "_name", "")):  # a GL of its own
        return 0
    for library, name in _OTHERS:
        getter = _others.get(name)
        if getter is None:
            try:
                loaded = ctypes.CDLL(library, mode=os.RTLD_NOLOAD)
            except (OSError, AttributeError):  # the process has no such library; no such system
                continue
            place = ctypes.cast(getattr(loaded, name), ctypes.c_void_p).value
            getter = _others[name] = ctypes.PYFUNCTYPE(ctypes.c_void_p)(place or 0)
        handle = getter()
        if handle:
            return handle
    return 0


def _current_getter() -> _Getter:
    from OpenGL.platform import PLATFORM

    getter = PLATFORM.GetCurrentContext
    try:
        place = ctypes.cast(getter, ctypes.c_void_p).value
    except ctypes.ArgumentError:  # a Python function on some platforms
        place = None
    if place:
        return ctypes.PYFUNCTYPE(ctypes.c_void_p)(place)

    def current() -> int:
        context = getter()
        return int(getattr(context, "value", context) or 0)

    return current
