"""The driver's functions below PyOpenGL, and below glshim: for those who look on."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

from tests.fuzz.registry import registry

_C: dict[str, Any] = {
    "void": None, "GLenum": ctypes.c_uint, "GLbitfield": ctypes.c_uint, "GLuint": ctypes.c_uint,
    "GLint": ctypes.c_int, "GLsizei": ctypes.c_int, "GLboolean": ctypes.c_ubyte,
    "GLubyte": ctypes.c_ubyte, "GLbyte": ctypes.c_byte, "GLshort": ctypes.c_short,
    "GLushort": ctypes.c_ushort, "GLfloat": ctypes.c_float, "GLdouble": ctypes.c_double,
    "GLintptr": ctypes.c_ssize_t, "GLsizeiptr": ctypes.c_ssize_t, "GLint64": ctypes.c_int64,
    "GLuint64": ctypes.c_uint64, "GLsync": ctypes.c_void_p, "GLchar": ctypes.c_char,
    "GLDEBUGPROC": ctypes.c_void_p,
}  # fmt: skip


class Driver:
    """``driver.glFinish()``: typed as the registry says, every pointer an address."""

    def __init__(self) -> None:
        self._library = ctypes.CDLL("libGL.so.1")
        find = self._library.glXGetProcAddressARB
        find.restype, find.argtypes = ctypes.c_void_p, [ctypes.c_char_p]
        self._find = find

    def __getattr__(self, name: str) -> Callable[..., Any]:
        command = registry().commands[name]
        types = [ctypes.c_void_p if p.pointer else _C[p.type] for p in command.parameters]
        result = ctypes.c_void_p if command.result.endswith("*") else _C[command.result]
        address = self._find(name.encode())
        if not address:
            raise AttributeError(name)
        made: Callable[..., Any] = ctypes.CFUNCTYPE(result, *types)(address)
        setattr(self, name, made)
        return made

    def glx(self, name: str, result: Any, *types: Any) -> Callable[..., Any]:
        """A function of GLX's with these types."""
        function = self._library[name]
        function.restype, function.argtypes = result, list(types)
        made: Callable[..., Any] = function
        return made


driver = Driver()
