"""EGL by PyOpenGL."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.egl import EGL_HEIGHT, EGL_WIDTH, Egl

from .rig import SIZE, Rig


class EglRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Egl())
        cls = type("eglSwapBuffers", (), {"__call__": staticmethod(self.shown)})
        self.modules = {"OpenGL.raw.EGL.VERSION.EGL_1_0": SimpleNamespace(
            eglSwapBuffers=cls(), eglQuerySurface=self.query)}  # fmt: skip

    def query(self, display: int, surface: int, name: int, value: Any) -> None:
        assert (display, surface) == (1, 2)
        answer = SIZE[(EGL_WIDTH, EGL_HEIGHT).index(name)]
        ctypes.cast(value, ctypes.POINTER(ctypes.c_int)).contents.value = answer

    def take(self) -> None:
        (module,) = self.modules.values()
        self.swap = module.eglSwapBuffers

    def present(self) -> Any:
        return self.swap(1, 2)


RIGS: dict[str, Callable[[], Rig]] = {"EGL": EglRig}
