"""SDL2 by PySDL2."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from typing import Any, ClassVar

from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Size
from glshim.toolkits.moment import MOMENT, Moment


class Sdl2(Toolkit):
    """ctypes functions, which are hooked in place."""

    name, package, distribution = "SDL2", "sdl2", "PySDL2"
    tested = "PySDL2 0.9.17 on X"
    lacks: ClassVar[Lacks] = {
        Part.KEYS: "live control hears no key",
        Part.REDRAW: "a program that draws on demand shows a new style with its next frame",
        Part.CLOCK: "SDL_GetTicks and SDL_Delay run on",
    }

    def __init__(self, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self._video: Any = None

    def hooks(self) -> Iterable[Hook]:
        yield Hook(Part.FRAMES, "sdl2.video", self.hook_swaps, "SDL_GL_SwapWindow")

    def size(self, window: Any) -> Size:
        width, height = ctypes.c_int(), ctypes.c_int()
        self._video.SDL_GL_GetDrawableSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    def hook_swaps(self, module: Any, changes: Changes) -> None:
        self._video = module
        function = module.SDL_GL_SwapWindow
        swap = original_call(function)

        def swap_window(window: Any, *more: Any) -> Any:
            return frames.present(swap, window, *more, on=self.drawable(window))

        hook_function(function, swap_window)
        changes.add(lambda: hook_function(function, None))


TOOLKITS = (Sdl2(),)
