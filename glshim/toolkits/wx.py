"""wxPython's GLCanvas."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size


class Wx(Toolkit):
    """It calls back from C++, where an exception is printed and the loop goes on."""

    name, package, distribution = "wx", "wx", "wxPython"
    may_raise = False
    lacks: ClassVar[Lacks] = {
        Part.KEYS: "live control hears no key",
        Part.REDRAW: "a program that draws on demand shows a new style with its next frame",
        Part.CLOCK: "wx.Timer and wx.StopWatch run on",
    }

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "wx.glcanvas", self.hook_swaps, "GLCanvas.SwapBuffers")

    def size(self, canvas: Any) -> Size:
        width, height = canvas.GetClientSize()
        ratio = canvas.GetContentScaleFactor()
        return round(width * ratio), round(height * ratio)

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        plain = module.GLCanvas.SwapBuffers

        @functools.wraps(plain)
        def swap_buffers(canvas: Any) -> Any:
            return frames.present(plain, canvas, on=self.drawable(canvas))

        changes.set(module.GLCanvas, "SwapBuffers", swap_buffers)


TOOLKITS = (Wx(),)
