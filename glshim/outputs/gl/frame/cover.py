"""The base polygons in another surface than the app's: depth only, one flat colour, or the app's
own paints without its light.

The app's own draw is made with colour writes off, or with a program whose vertices are exactly the
fixed function's (``ftransform``), so its depth stays bit for bit the app's.
"""

from __future__ import annotations

import ctypes
from importlib.resources import files

from glshim.outputs.gl.device.programs import compiled
from glshim.outputs.gl.frame.paint import Paint
from glshim.spec.driver import current_context, gl
from glshim.styling.protocol import Colour

_BLEND, _ALPHA_TEST = 0x0BE2, 0x0BC0


class Surface:
    """Covers the app's draws with a styler's surface."""

    def __init__(self) -> None:
        self._surface: str | Colour = "app"
        self._programs: dict[int, tuple[int, int]] = {}
        self._paints: dict[tuple[int, bool], Paint] = {}
        """By context, and whether they have textures."""
        self._blend = self._alpha = False
        self._mask = (ctypes.c_int * 4)()
        self._covered = False

    def wear(self, surface: str | Colour) -> None:
        """Another one from now on: see `Styler.surface`; ``"app"`` covers nothing."""
        self.uncover()
        self._surface = surface

    @property
    def changes(self) -> bool:
        """Whether anything is covered at all."""
        return self._surface != "app"

    def cover(self) -> None:
        """Before the app's draw, outside primitives; no program of the app's is in use."""
        if self._surface == "app" or self._covered:
            return
        if self._surface in ("paint", "colours"):
            self._covered = self._paint().begin()
            return
        self._covered = True
        if isinstance(self._surface, str):
            gl.glGetIntegerv(0x0C23, self._mask)
            gl.glColorMask(0, 0, 0, 0)
            return
        program, location = self._program()
        self._blend, self._alpha = bool(gl.glIsEnabled(_BLEND)), bool(gl.glIsEnabled(_ALPHA_TEST))
        gl.glDisable(_BLEND)
        gl.glDisable(_ALPHA_TEST)
        gl.glUseProgram(program)
        gl.glUniform4f(location, *self._surface, 1.0)

    def uncover(self) -> None:
        """After it."""
        if not self._covered:
            return
        self._covered = False
        if self._surface in ("paint", "colours"):
            self._paint().end()
            return
        if isinstance(self._surface, str):
            gl.glColorMask(*(int(bool(m)) for m in self._mask))
            return
        gl.glUseProgram(0)
        if self._blend:
            gl.glEnable(_BLEND)
        if self._alpha:
            gl.glEnable(_ALPHA_TEST)

    def release(self) -> None:
        """Delete what was made in the current context. Outside glBegin/glEnd."""
        context = current_context()
        for textures in (True, False):
            paint = self._paints.pop((context, textures), None)
            if paint is not None:
                paint.release()
        flat = self._programs.pop(context, None)
        if flat is not None:
            gl.glDeleteProgram(flat[0])

    def forget(self) -> None:
        """What was made in the current context is gone."""
        context = current_context()
        self._programs.pop(context, None)
        for textures in (True, False):
            self._paints.pop((context, textures), None)

    def _paint(self) -> Paint:
        key = current_context(), self._surface == "paint"
        if key not in self._paints:
            self._paints[key] = Paint(textures=key[1])
        return self._paints[key]

    def _program(self) -> tuple[int, int]:
        context = current_context()
        if context not in self._programs:
            self._programs[context] = _compile()
        return self._programs[context]


def _compile() -> tuple[int, int]:
    shaders = files("glshim.outputs.gl") / "shaders"
    texts = (shaders / f"surface.{kind}.glsl" for kind in ("vert", "frag"))
    program = compiled("surface", *(text.read_text("utf-8") for text in texts))
    return program, int(gl.glGetUniformLocation(program, b"colour"))
