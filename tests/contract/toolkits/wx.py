"""wxPython's GLCanvas."""

from __future__ import annotations

from collections.abc import Callable

from glshim.toolkits.wx import Wx

from .rig import SIZE, MethodRig, Rig

RIGS: dict[str, Callable[[], Rig]] = {
    "wx": lambda: MethodRig(Wx(), "wx.glcanvas", "GLCanvas", "SwapBuffers",
                            GetClientSize=lambda canvas: (SIZE[0] // 2, SIZE[1] // 2),
                            GetContentScaleFactor=lambda canvas: 2.0),
}  # fmt: skip
