"""pyglet's windows. What pyglet draws by itself goes past PyOpenGL; what a program draws in them by
PyOpenGL is seen."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size


class Pyglet(Toolkit):
    """A window flips by a method of its class."""

    name = package = "pyglet"
    tested = "pyglet 2.1.19 on X"
    lacks: ClassVar[Lacks] = {
        Part.KEYS: "live control hears no key",
        Part.REDRAW: "a program that draws on demand shows a new style with its next frame",
        Part.CLOCK: "calls that `pyglet.clock` schedules come due only as frames move the time",
    }

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "pyglet.window", self.hook_flips, "Window.flip")

    def size(self, window: Any) -> Size:
        width, height = window.get_framebuffer_size()
        return width, height

    def hook_flips(self, module: Any, changes: Changes) -> None:
        plain = module.Window.flip

        @functools.wraps(plain)
        def flip(window: Any) -> None:
            frames.present(plain, window, on=self.drawable(window))

        changes.set(module.Window, "flip", flip)


TOOLKITS = (Pyglet(),)
