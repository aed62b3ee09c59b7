"""GLUT's bitmap text, which draws its bitmaps inside C: each glyph is drawn once, small, on a
surface of our own, read back, and from then on drawn magnified."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from glshim.bindings.imports import after_import
from glshim.bindings.pyopengl.raw import Call, ground_function
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.running.shots import bitmaps
from glshim.running.shots.mapping import Mapping
from glshim.spec.ask import integer
from glshim.spec.driver import gl

_FRAMEBUFFER, _RENDERBUFFER, _COLOUR_AT, _RGBA8 = 0x8D40, 0x8D41, 0x8CE0, 0x8058
_SIZE, _MIDDLE = 128, 48
_RASTER_PLACE = 0x0B07
_OFF = (0x0BC0, 0x0BE2, 0x0B71, 0x0B90, 0x0C11, 0x0B60, 0x0B50, 0x0DE0, 0x0DE1, 0x0BF2, 0x3000,
        0x3001, 0x3002, 0x3003, 0x3004, 0x3005)  # fmt: skip
"""Alpha test, blending, depth test, stencil test, scissor, fog, lighting, textures, logic operation
and clip planes."""


class Glyphs:
    """Hooks on GLUT's text. mapping: that of what is drawn to the window now, None outside a
    shot."""

    def __init__(self, mapping: Callable[[], Mapping | None]) -> None:
        self._mapping = mapping
        self._known: dict[tuple[int, int], tuple[bitmaps.Bits, int, int, float, float]] = {}
        self._framebuffer = 0

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
            ground_function(function, maker)

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
        RECORDER.spill()
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
            self._open()
            for switch in _OFF:
                gl.glDisable(switch)
            gl.glUseProgram(0)
            gl.glColorMask(1, 1, 1, 1)
            gl.glClearColor(0.0, 0.0, 0.0, 0.0)
            gl.glClear(0x4000)
            gl.glColor3f(1.0, 1.0, 1.0)
            gl.glWindowPos3f(float(_MIDDLE), float(_MIDDLE), 0.0)
            self._character(font, code)
            place = (ctypes.c_float * 4)()
            gl.glGetFloatv(_RASTER_PLACE, ctypes.addressof(place))
            pixels = ctypes.create_string_buffer(_SIZE * _SIZE * 4)
            for name, plain in ((0x0D00, 0), (0x0D02, 0), (0x0D03, 0), (0x0D04, 0), (0x0D05, 1)):
                gl.glPixelStorei(name, plain)
            buffer = integer(0x88ED)
            gl.glBindBuffer(0x88EB, 0)
            gl.glReadPixels(0, 0, _SIZE, _SIZE, 0x1908, 0x1401, pixels)
            gl.glBindBuffer(0x88EB, buffer)
        seen = np.frombuffer(pixels.raw, np.uint8).reshape(_SIZE, _SIZE, 4)[..., 0] > 127
        rows, columns = (np.flatnonzero(seen.any(axis=k)) for k in (1, 0))
        move = place[0] - _MIDDLE, place[1] - _MIDDLE
        if not len(rows):
            return np.zeros((0, 0), np.uint8), 0, 0, *move
        bits = seen[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].astype(np.uint8)
        return bits, int(columns[0]) - _MIDDLE, int(rows[0]) - _MIDDLE, *move

    def _open(self) -> None:
        if self._framebuffer:
            gl.glBindFramebuffer(_FRAMEBUFFER, self._framebuffer)
            return
        name = ctypes.c_uint()
        gl.glGenFramebuffers(1, ctypes.addressof(name))
        self._framebuffer = name.value
        gl.glBindFramebuffer(_FRAMEBUFFER, name.value)
        gl.glGenRenderbuffers(1, ctypes.addressof(name))
        gl.glBindRenderbuffer(_RENDERBUFFER, name.value)
        gl.glRenderbufferStorage(_RENDERBUFFER, _RGBA8, _SIZE, _SIZE)
        gl.glFramebufferRenderbuffer(_FRAMEBUFFER, _COLOUR_AT, _RENDERBUFFER, name.value)
        gl.glDrawBuffer(_COLOUR_AT)
        gl.glReadBuffer(_COLOUR_AT)
