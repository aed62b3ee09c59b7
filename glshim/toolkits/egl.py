"""EGL by PyOpenGL, for programs that make their surfaces themselves: windows of Wayland and X."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Mapping
from typing import Any, ClassVar

from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size

EGL_HEIGHT, EGL_WIDTH = 0x3056, 0x3057


class Egl(Toolkit):
    """One function of PyOpenGL's raw layer. Surfaces are given as (display, surface)."""

    name, package, distribution = "EGL", "OpenGL", "PyOpenGL"
    tested = "Mesa 22.3: windows of X, pbuffers, no surface at all"
    displayless: ClassVar[Mapping[str, str] | None] = {}
    lacks: ClassVar[Lacks] = {
        Part.KEYS: "live control receives no keys",
        Part.REDRAW: "programs that draw on demand show a new style only with their next frame",
        Part.CLOCK: "animation driven by a clock is not held still",
    }

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._module: Any = None

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "OpenGL.raw.EGL.VERSION.EGL_1_0", self.hook_swaps, "eglSwapBuffers")

    def size(self, window: Any) -> Size:
        found = []
        for name in (EGL_WIDTH, EGL_HEIGHT):
            value = ctypes.c_int()
            self._module.eglQuerySurface(*window, name, ctypes.byref(value))
            found.append(value.value)
        return found[0], found[1]

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        if not module.eglSwapBuffers:  # which loads it; none without EGL
            return
        self._module = module
        function = type(module.eglSwapBuffers)
        plain = function.__call__

        def swap(*args: Any, **_named: Any) -> Any:  # ctypes ignores keywords
            if len(args) < 2:
                return plain(*args)  # it refuses them
            return frames.present(plain, *args, on=self.drawable(args[:2]))

        changes.set(function, "__call__", staticmethod(swap))


TOOLKITS = (Egl(),)
