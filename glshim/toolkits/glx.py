"""GLX by PyOpenGL, for programs that open windows of X by themselves."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit


class Glx(Toolkit):
    """One function of PyOpenGL's raw layer."""

    name, package, distribution = "GLX", "OpenGL", "PyOpenGL"
    tested = "pyopengltk 0.0.4 on X"
    lacks: ClassVar[Lacks] = {
        Part.SIZE: "the viewport's size counts as the window's",
        Part.KEYS: "live control hears no key",
        Part.REDRAW: "a program that draws on demand shows a new style with its next frame",
        Part.CLOCK: "what shows the time runs on",
    }

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "OpenGL.raw.GLX.VERSION.GLX_1_0", self.hook_swaps, "glXSwapBuffers")

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        if not module.glXSwapBuffers:  # which loads it; none without GLX
            return
        function = type(module.glXSwapBuffers)
        swap = functools.partial(frames.present, function.__call__, on=self.drawable())
        changes.set(function, "__call__", staticmethod(swap))


TOOLKITS = (Glx(),)
