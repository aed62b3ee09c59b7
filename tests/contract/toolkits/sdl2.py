"""SDL2 by PySDL2."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.sdl2 import Sdl2

from .rig import Rig, fill, library_function


class Sdl2Rig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Sdl2())
        self.modules = {"sdl2.video": SimpleNamespace(
            SDL_GL_SwapWindow=library_function(self.shown, ctypes.c_void_p),
            SDL_GL_GetDrawableSize=lambda window, width, height: fill(width, height))}  # fmt: skip

    def take(self) -> None:
        self.swap = self.modules["sdl2.video"].SDL_GL_SwapWindow

    def present(self) -> Any:
        return self.swap(None)


RIGS: dict[str, Callable[[], Rig]] = {"SDL2": Sdl2Rig}
