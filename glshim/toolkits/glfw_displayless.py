"""glfw where there is no display: windows of its null platform, which nobody sees, with contexts of
ours (`glshim.toolkits.pbuffers`). By itself glfw makes none there but by OSMesa."""

from __future__ import annotations

import ctypes
from typing import Any

from glshim.toolkits import frames, pbuffers
from glshim.toolkits.base import Changes
from glshim.toolkits.pbuffers import Pbuffer

# From glfw3.h.
GLFW_PLATFORM, GLFW_PLATFORM_NULL = 0x00050003, 0x00060005
GLFW_CLIENT_API, GLFW_NO_API, GLFW_OPENGL_API, GLFW_OPENGL_ES_API = 0x22001, 0, 0x30001, 0x30002
GLFW_CONTEXT_VERSION_MAJOR, GLFW_CONTEXT_VERSION_MINOR = 0x22002, 0x22003
GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE = 0x22008, 0x32001
GLFW_DOUBLEBUFFER = 0x21010
_DEFAULTS = {
    GLFW_CLIENT_API: GLFW_OPENGL_API, GLFW_CONTEXT_VERSION_MAJOR: 1, GLFW_CONTEXT_VERSION_MINOR: 0,
    GLFW_OPENGL_PROFILE: 0, GLFW_DOUBLEBUFFER: 1,
    0x21004: 8, 0x21005: 24, 0x21006: 8, 0x2100D: 0,  # alpha, depth, stencil, samples
}  # fmt: skip
"""The hints that matter here, as glfw has them at first."""
_SIZES = {
    0x21004: pbuffers.EGL_ALPHA_SIZE, 0x21005: pbuffers.EGL_DEPTH_SIZE,
    0x21006: pbuffers.EGL_STENCIL_SIZE, 0x2100D: pbuffers.EGL_SAMPLES,
}  # fmt: skip


class Displayless:
    """In place of functions of glfw's library."""

    def __init__(self, library: Any, changes: Changes) -> None:
        self._library = library
        self._hints = dict(_DEFAULTS)
        self._made: dict[int, Pbuffer] = {}
        """By the address of the window."""
        self._current: Any = None
        self._plain = {
            name: getattr(library, name) for name in (
                "glfwInit", "glfwTerminate", "glfwDefaultWindowHints", "glfwWindowHint",
                "glfwCreateWindow", "glfwDestroyWindow", "glfwMakeContextCurrent",
                "glfwGetCurrentContext", "glfwSwapBuffers", "glfwSwapInterval",
                "glfwGetProcAddress", "glfwSetWindowSize", "glfwGetWindowAttrib",
            )
        }  # fmt: skip
        for name in self._plain:
            changes.set(library, name, getattr(self, name))

    def glfwInit(self) -> Any:
        self._library.glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_NULL)
        return self._plain["glfwInit"]()

    def glfwTerminate(self) -> None:
        for address in [*self._made]:
            self._destroy(address)
        self._hints = dict(_DEFAULTS)
        self._plain["glfwTerminate"]()

    def glfwDefaultWindowHints(self) -> None:
        self._hints = dict(_DEFAULTS)
        self._plain["glfwDefaultWindowHints"]()

    def glfwWindowHint(self, hint: int, value: int) -> None:
        if hint in self._hints:
            self._hints[hint] = value
        self._plain["glfwWindowHint"](hint, value)

    def glfwCreateWindow(self, width: int, height: int, title: Any, *more: Any) -> Any:
        share = self._made.get(_address(more[1])) if len(more) > 1 else None
        hints = self._hints
        self._plain["glfwWindowHint"](GLFW_CLIENT_API, GLFW_NO_API)
        window = self._plain["glfwCreateWindow"](width, height, title, None, None)
        self._plain["glfwWindowHint"](GLFW_CLIENT_API, hints[GLFW_CLIENT_API])
        if not window or hints[GLFW_CLIENT_API] == GLFW_NO_API:
            return window
        wanted = {ours: hints[theirs] for theirs, ours in _SIZES.items() if hints[theirs] > 0}
        if pbuffers.EGL_SAMPLES in wanted:
            wanted[pbuffers.EGL_SAMPLE_BUFFERS] = 1
        made = pbuffers.pbuffers().make(
            self._size(window), wanted, self._version(), share,
            embedded=hints[GLFW_CLIENT_API] == GLFW_OPENGL_ES_API,
        )  # fmt: skip
        if made is None:
            self._plain["glfwDestroyWindow"](window)
            return None
        self._made[_address(window)] = made
        frames.buffering(bool(hints[GLFW_DOUBLEBUFFER]))  # as the program means it
        return window

    def glfwDestroyWindow(self, window: Any) -> None:
        self._destroy(_address(window))
        self._plain["glfwDestroyWindow"](window)

    def glfwMakeContextCurrent(self, window: Any) -> None:
        made = self._made.get(_address(window))
        if made is not None:
            pbuffers.pbuffers().resize(made, self._size(window))
        pbuffers.pbuffers().make_current(made)
        self._current = window if made is not None else None

    def glfwGetCurrentContext(self) -> Any:
        return self._current

    def glfwSwapBuffers(self, window: Any) -> None:
        made = self._made.get(_address(window))
        if made is not None and made.size != self._size(window):
            self._fit(window)

    def glfwSwapInterval(self, interval: int) -> None:
        """There is nothing to wait for."""

    def glfwGetProcAddress(self, name: bytes) -> int:
        return pbuffers.pbuffers().address(name)

    def glfwSetWindowSize(self, window: Any, width: int, height: int) -> None:
        self._plain["glfwSetWindowSize"](window, width, height)
        self._fit(window)

    def glfwGetWindowAttrib(self, window: Any, attribute: int) -> Any:
        if attribute in self._hints and _address(window) in self._made:
            return self._hints[attribute]
        return self._plain["glfwGetWindowAttrib"](window, attribute)

    def _fit(self, window: Any) -> None:
        made = self._made.get(_address(window))
        if made is not None and _address(self._current) == _address(window):
            self.glfwMakeContextCurrent(window)

    def _destroy(self, address: int) -> None:
        made = self._made.pop(address, None)
        if made is None:
            return
        if _address(self._current) == address:
            self.glfwMakeContextCurrent(None)
        pbuffers.pbuffers().destroy(made)

    def _size(self, window: Any) -> tuple[int, int]:
        width, height = ctypes.c_int(), ctypes.c_int()
        self._library.glfwGetFramebufferSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    def _version(self) -> dict[int, int]:
        """None where the program asks for whatever there is."""
        major, minor = (
            self._hints[name] for name in (GLFW_CONTEXT_VERSION_MAJOR, GLFW_CONTEXT_VERSION_MINOR)
        )
        if (major, minor) == (1, 0):
            return {}
        found = {
            pbuffers.EGL_CONTEXT_MAJOR_VERSION: major, pbuffers.EGL_CONTEXT_MINOR_VERSION: minor,
        }  # fmt: skip
        if (major, minor) >= (3, 2) and self._hints[GLFW_CLIENT_API] == GLFW_OPENGL_API:
            core = self._hints[GLFW_OPENGL_PROFILE] == GLFW_OPENGL_CORE_PROFILE
            found[pbuffers.EGL_CONTEXT_OPENGL_PROFILE_MASK] = (
                pbuffers.CORE if core else pbuffers.COMPATIBILITY
            )
        return found


def _address(pointer: Any) -> int:
    return ctypes.cast(pointer, ctypes.c_void_p).value or 0 if pointer else 0
