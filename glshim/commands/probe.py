"""What GL a window gets here, as JSON: ``python -m glshim.commands.probe``.

In a process of its own, since a broken display or driver can take a process down.
"""

from __future__ import annotations

import ctypes
import json
import sys
from dataclasses import asdict, dataclass
from typing import Any

_INTEGERS = {"samples": 0x80A9, "depth_bits": 0x0D56, "profile_mask": 0x9126}
_STRINGS = {"vendor": 0x1F00, "renderer": 0x1F01, "version": 0x1F02, "glsl": 0x8B8C}


@dataclass(frozen=True, slots=True)
class Probe:
    """A default window's context, the one that GLUT, glfw and pygame ask for."""

    vendor: str
    renderer: str
    version: str
    glsl: str
    samples: int
    depth_bits: int
    profile_mask: int
    """0 below OpenGL 3.2; 1 core, 2 compatibility."""
    shortcoming: str
    """Why no lines can be drawn; empty when they can."""

    @property
    def number(self) -> tuple[int, int]:
        """The version as numbers."""
        major, _, minor = self.version.split()[0].partition(".")
        return int(major), int(minor.split(".")[0])

    @property
    def profile(self) -> str:
        """In words."""
        if self.number < (3, 2):
            return "no profiles yet: fixed function"
        return "core: no fixed function" if self.profile_mask & 1 else "compatibility"


def probe() -> Probe:
    """Open a hidden window and ask. Raises `OSError` where there is none to be had."""
    import glfw

    from glshim.spec.context import shortcoming
    from glshim.spec.driver import gl

    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        raise OSError("no display to open a window on")
    try:
        glfw.window_hint(glfw.VISIBLE, glfw.FALSE)
        window = glfw.create_window(64, 64, "glshim doctor", None, None)
        if not window:
            raise OSError("the display gives no OpenGL window")
        glfw.make_context_current(window)
        found: dict[str, Any] = {"shortcoming": shortcoming()}
        for name, pname in _INTEGERS.items():
            value = ctypes.c_int()
            gl.glGetIntegerv(pname, ctypes.byref(value))
            found[name] = value.value
        for name, pname in _STRINGS.items():
            found[name] = ctypes.string_at(gl.glGetString(pname)).decode(errors="replace")
        return Probe(**found)
    finally:
        glfw.terminate()


if __name__ == "__main__":
    try:
        print(json.dumps(asdict(probe())))
    except (OSError, ImportError) as error:
        sys.exit(str(error))
