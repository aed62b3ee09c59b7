"""The driver's own functions, bare: no PyOpenGL conversion, no error check, no hook.

What the shim itself says to GL goes through here, so it never meets its own hooks, never raises a
GL error of its own and costs a fifth of a PyOpenGL call. A signature is a row of letters.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

_LETTERS: dict[str, Any] = {
    "i": ctypes.c_int,
    "u": ctypes.c_uint,
    "f": ctypes.c_float,
    "d": ctypes.c_double,
    "b": ctypes.c_ubyte,
    "p": ctypes.c_void_p,
    "n": ctypes.c_ssize_t,
}

SIGNATURES: dict[str, str] = {
    # queries
    "glGetFloatv": "up", "glGetIntegerv": "up", "glGetBooleanv": "up", "glGetDoublev": "up",
    "glGetPointerv": "up", "glIsEnabled": "u>b", "glGetError": ">u", "glGetString": "u>p",
    "glGetStringi": "uu>p",
    "glGetBufferSubData": "unnp", "glGetBufferParameteriv": "uup", "glGetClipPlane": "up",
    "glGetLightfv": "uup", "glGetMaterialfv": "uup",
    "glGetVertexAttribiv": "uup", "glGetMapiv": "uup", "glGetMapfv": "uup",
    # immediate mode
    "glBegin": "u", "glEnd": "",
    "glVertex2fv": "p", "glVertex3fv": "p", "glVertex4fv": "p", "glNormal3fv": "p",
    "glColor3fv": "p", "glColor4fv": "p", "glTexCoord1fv": "p", "glTexCoord2fv": "p",
    "glTexCoord3fv": "p", "glTexCoord4fv": "p", "glEdgeFlag": "b",
    # arrays
    "glVertexPointer": "iuip", "glNormalPointer": "uip", "glColorPointer": "iuip",
    "glTexCoordPointer": "iuip", "glEnableClientState": "u", "glDisableClientState": "u",
    "glClientActiveTexture": "u", "glDrawArrays": "uii", "glDrawElements": "uiup",
    "glEnableVertexAttribArray": "u", "glDisableVertexAttribArray": "u",
    "glBindBuffer": "uu", "glGenVertexArrays": "ip", "glBindVertexArray": "u",
    "glDeleteVertexArrays": "ip", "glIsFramebuffer": "u>b",
    "glGenFramebuffers": "ip", "glDeleteFramebuffers": "ip",
    # state
    "glEnable": "u", "glDisable": "u", "glUseProgram": "u", "glColorMask": "bbbb",
    "glPushAttrib": "u", "glPopAttrib": "", "glPushClientAttrib": "u", "glPopClientAttrib": "",
    "glMatrixMode": "u", "glPushMatrix": "", "glPopMatrix": "", "glLoadIdentity": "",
    "glLoadMatrixf": "p", "glOrtho": "dddddd", "glViewport": "iiii", "glDepthRange": "dd",
    "glActiveTexture": "u", "glGenTextures": "ip", "glBindTexture": "uu",
    "glTexImage2D": "uiiiiiuup", "glTexParameteri": "uui", "glPolygonMode": "uu", "glCallList": "u",
    "glRenderMode": "u>i", "glFeedbackBuffer": "iup", "glPixelStorei": "ui",
    "glReadPixels": "iiiiuup", "glReadBuffer": "u", "glBindFramebuffer": "uu",
    "glFinish": "", "glDepthMask": "b", "glLoadMatrixd": "p",
    # small programs of our own in the app's compatibility context
    "glCreateProgram": ">u", "glCreateShader": "u>u", "glShaderSource": "uipp",
    "glCompileShader": "u", "glAttachShader": "uu", "glLinkProgram": "u",
    "glGetUniformLocation": "up>i", "glIsVertexArray": "u>b", "glUniform4f": "iffff",
    "glDeleteShader": "u", "glGetProgramiv": "uup",
}  # fmt: skip


class Driver:
    """Attribute access gives the bare function, resolved once: ``gl.glGetFloatv(pname, buffer)``.

    Raises AttributeError for a function that this platform does not have; resolve after a context
    is current.
    """

    def __getattr__(self, name: str) -> Callable[..., Any]:
        signature = SIGNATURES.get(name)
        if signature is None:
            raise AttributeError(f"glshim.spec.driver has no signature for {name!r}")
        arguments, _, result = signature.partition(">")
        from OpenGL.platform import PLATFORM

        prototype = ctypes.CFUNCTYPE(
            _LETTERS[result] if result else None, *(_LETTERS[letter] for letter in arguments)
        )
        try:
            address = ctypes.cast(getattr(PLATFORM.GL, name), ctypes.c_void_p).value
        except AttributeError:
            address = PLATFORM.getExtensionProcedure(name.encode())
        if not address:
            raise AttributeError(f"this GL driver has no {name}")
        function = prototype(address)
        setattr(self, name, function)
        return function


gl = Driver()


def quick(name: str) -> Callable[..., Any]:
    """A bare function without result for the hottest paths: twice as fast as ``gl.name``.

    It does not convert: arguments are integers, ``bytes`` or ctypes pointers. It keeps the GIL, so
    it is for calls that return at once.
    """
    address = ctypes.cast(getattr(gl, name), ctypes.c_void_p).value
    assert address is not None
    return ctypes.PYFUNCTYPE(None)(address)


_get_current: Callable[[], int | None] | None = None


def current_context() -> int:
    """The platform's handle of the current context, 0 when none is current."""
    global _get_current
    if _get_current is None:
        _get_current = _current_getter()
    return _get_current() or 0


def _current_getter() -> Callable[[], int | None]:
    from OpenGL.platform import PLATFORM

    getter = PLATFORM.GetCurrentContext
    try:
        address = ctypes.cast(getter, ctypes.c_void_p).value
    except ctypes.ArgumentError:  # a Python function on some platforms
        address = None
    if address:
        return ctypes.PYFUNCTYPE(ctypes.c_void_p)(address)

    def current() -> int:
        context = getter()
        return int(getattr(context, "value", context) or 0)

    return current
