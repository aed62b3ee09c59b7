"""pyglet's windows."""

from __future__ import annotations

from collections.abc import Callable

from glshim.toolkits.pyglet import Pyglet

from .rig import SIZE, MethodRig, Rig

RIGS: dict[str, Callable[[], Rig]] = {
    "pyglet": lambda: MethodRig(Pyglet(), "pyglet.window", "Window", "flip",
                                get_framebuffer_size=lambda window: SIZE),
}  # fmt: skip
