"""OpenGL itself, without a window: one glFinish of PyOpenGL's kind."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from OpenGL.platform import baseplatform

from glshim.bindings.pyopengl.pictures import stand_around
from glshim.bindings.pyopengl.raw import RAW
from glshim.toolkits import frames
from glshim.toolkits.offscreen import Offscreen

from .rig import Rig


class OffscreenRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Offscreen())
        stand_around(None)
        cls = type(
            "glFinish", (baseplatform._NullFunctionPointer,),
            {"__call__": staticmethod(self.shown), "__init__": lambda this: None})  # fmt: skip
        if RAW._undo:  # PyOpenGL is followed already, for what is below hooks: it has loaded this
            RAW._adopt(cls, vars(cls)["__call__"])
        self.modules = {"OpenGL.error": SimpleNamespace(glFinish=cls())}
        frames.buffering(False)

    def take(self) -> None:
        self.finish = self.modules["OpenGL.error"].glFinish

    def present(self) -> Any:
        return self.finish()


RIGS: dict[str, Callable[[], Rig]] = {"no window": OffscreenRig}
