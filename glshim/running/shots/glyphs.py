"""GLUT's bitmap text, which draws its bitmaps inside C: each glyph is drawn once, small, on a
surface of our own, read back, and from then on drawn magnified."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from glshim.bindings.imports import after_import
from glshim.bindings.pyopengl.raw import Call, hook_function_below
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.driver.ask import reals
from glshim.driver.functions import gl
from glshim.driver.pixels import pack_plainly, transfer_plainly
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.target import RenderTarget
from glshim.running.shots import bitmaps
from glshim.running.shots.mapping import Mapping
from glshim.spec.constants import (
    GL_ALPHA_TEST,
    GL_BLEND,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE1,
    GL_CLIP_PLANE2,
    GL_CLIP_PLANE3,
    GL_CLIP_PLANE4,
    GL_CLIP_PLANE5,
    GL_COLOR_BUFFER_BIT,
    GL_COLOR_LOGIC_OP,
    GL_CURRENT_RASTER_POSITION,
    GL_DEPTH_TEST,
    GL_FOG,
    GL_LIGHTING,
    GL_RGBA,
    GL_RGBA8,
    GL_SCISSOR_TEST,
    GL_STENCIL_TEST,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_UNSIGNED_BYTE,
)

_SIZE, _MIDDLE = 128, 48
_OFF = (
    GL_ALPHA_TEST, GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_SCISSOR_TEST, GL_FOG, GL_LIGHTING,
    GL_TEXTURE_1D, GL_TEXTURE_2D, GL_COLOR_LOGIC_OP, GL_CLIP_PLANE0, GL_CLIP_PLANE1,
    GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5,
)  # fmt: skip
"""What would change or drop the pixels of a glyph."""


class Glyphs:
    """Hooks on GLUT's text. mapping: that of what is drawn to the window now, None outside a
    shot."""

    def __init__(self, mapping: Callable[[], Mapping | None]) -> None:
        self._mapping = mapping
        self._known: dict[tuple[int, int], tuple[bitmaps.Bits, int, int, float, float]] = {}
        self._target = RenderTarget(buffers=(GL_RGBA8,))

    def install(self) -> None:
        """Hook it when it is imported."""
        after_import("OpenGL.raw.GLUT", self._hook)

    def _hook(self, module: ModuleType) -> None:
        for name, maker in (("glutBitmapCharacter", self._one), ("glutBitmapString", self._string)):
            function: Any = getattr(module, name, None)
            while function is not None and not hasattr(type(function), "_flags_"):
                function = getattr(function, "", None)  # inside PyOpenGL's logging proxies
            if function is None or not function:
                continue
            hook_function_below(function, maker)

    def _one(self, plain: Call) -> Call:
        self._character = plain
        return self._draw

    def _string(self, plain: Call) -> Call:
        def hook(font: Any, text: Any) -> Any:
            if self._mapping() is None or not isinstance(text, bytes) or b"\n" in text:
                return plain(font, text)
            for code in text:
                self._draw(font, code)
            return None

        return hook

    def _draw(self, font: Any, code: Any) -> Any:
        mapping = self._mapping()
        if mapping is None or not isinstance(code, int) or not possible():
            return self._character(font, code)
        RECORDER.record.spill()
        key = ctypes.cast(font, ctypes.c_void_p).value or 0, code
        if key not in self._known:
            self._known[key] = self._look(font, code)
        bits, left, low, x, y = self._known[key]
        move = x * mapping.across, y * mapping.up
        if bits.size == 0:
            gl.glBitmap(0, 0, 0.0, 0.0, *move, None)
        else:
            origin = -left * mapping.across, -low * mapping.up
            bitmaps.draw(bitmaps.magnified(bits, mapping.across, mapping.up), origin, move)
        return None

    def _look(self, font: Any, code: int) -> tuple[bitmaps.Bits, int, int, float, float]:
        """The bits of a glyph, where they begin beside the raster place, and how far that moves."""
        with Guard():
            self._target.fit(_SIZE, _SIZE)
            self._target.bind()
            for switch in _OFF:
                gl.glDisable(switch)
            gl.glUseProgram(0)
            gl.glColorMask(1, 1, 1, 1)
            gl.glClearColor(0.0, 0.0, 0.0, 0.0)
            gl.glClear(GL_COLOR_BUFFER_BIT)
            gl.glColor3f(1.0, 1.0, 1.0)
            gl.glWindowPos3f(float(_MIDDLE), float(_MIDDLE), 0.0)
            self._character(font, code)
            place = reals(GL_CURRENT_RASTER_POSITION, 4)
            pixels = ctypes.create_string_buffer(_SIZE * _SIZE * 4)
            pack_plainly()
            transfer_plainly()
            gl.glReadPixels(0, 0, _SIZE, _SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels)
        seen = np.frombuffer(pixels.raw, np.uint8).reshape(_SIZE, _SIZE, 4)[..., 0] > 127
        rows, columns = (np.flatnonzero(seen.any(axis=k)) for k in (1, 0))
        move = place[0] - _MIDDLE, place[1] - _MIDDLE
        if not len(rows):
            return np.zeros((0, 0), np.uint8), 0, 0, *move
        bits = seen[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].astype(np.uint8)
        return bits, int(columns[0]) - _MIDDLE, int(rows[0]) - _MIDDLE, *move
