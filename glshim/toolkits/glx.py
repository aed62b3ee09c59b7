"""GLX by PyOpenGL, for programs that open windows of X by themselves."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit


class Glx(Toolkit):
    """One function of PyOpenGL's raw layer."""

    name, package, distribution = "GLX", "OpenGL", "PyOpenGL"
    tested = "pyopengltk 0.0.4 on X"
    lacks: ClassVar[Lacks] = {
        Part.SIZE: "the size of the viewport counts as that of the window",
        Part.KEYS: "live control receives no keys",
        Part.REDRAW: "programs that draw on demand show a new style only with their next frame",
        Part.CLOCK: "animation driven by a clock is not held still",
    }

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "OpenGL.raw.GLX.VERSION.GLX_1_0", self.hook_swaps, "glXSwapBuffers")

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        if not module.glXSwapBuffers:  # which loads it; none without GLX
            return
        function = type(module.glXSwapBuffers)
        plain, on = function.__call__, self.drawable()

        def swap(*args: Any, **_named: Any) -> Any:  # ctypes ignores keywords
            return frames.present(plain, *args, on=on)

        changes.set(function, "__call__", staticmethod(swap))


TOOLKITS = (Glx(),)
