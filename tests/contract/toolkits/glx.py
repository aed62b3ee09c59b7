"""GLX by PyOpenGL."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.glx import Glx

from .rig import Rig


class GlxRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Glx())
        cls = type("glXSwapBuffers", (), {"__call__": staticmethod(self.shown)})
        self.modules = {"OpenGL.raw.GLX.VERSION.GLX_1_0": SimpleNamespace(glXSwapBuffers=cls())}

    def take(self) -> None:
        (module,) = self.modules.values()
        self.swap = module.glXSwapBuffers

    def present(self) -> Any:
        return self.swap(1, 2)


RIGS: dict[str, Callable[[], Rig]] = {"GLX": GlxRig}
