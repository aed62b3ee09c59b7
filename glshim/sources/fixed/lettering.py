"""Which polygons are text: quads for letters, whose shapes are in the alpha of a texture.

What tells is how they are drawn and what the texture holds: it is blended, or has holes; depth does
not matter (parallel to the screen in a flat projection, or with depth neither tested nor written);
and the texture has texels that are clear and some that are opaque, with few between, all of one
colour or grey. A wall is opaque, a pane is the same all over, a tree has several colours.
"""

from __future__ import annotations

import ctypes

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer, is_enabled
from glshim.driver.functions import gl
from glshim.driver.pixels import pack_plainly, transfer_plainly
from glshim.driver.unnoticed import Unnoticed
from glshim.sources.state import DrawState
from glshim.spec.constants import (
    GL_ALPHA_TEST,
    GL_ATTRIB_STACK_DEPTH,
    GL_BLEND,
    GL_CLIENT_ATTRIB_STACK_DEPTH,
    GL_CLIENT_PIXEL_STORE_BIT,
    GL_MAX_ATTRIB_STACK_DEPTH,
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH,
    GL_PIXEL_MODE_BIT,
    GL_RGBA,
    GL_TEXTURE_2D,
    GL_TEXTURE_ALPHA_SIZE,
    GL_TEXTURE_BINDING_2D,
    GL_TEXTURE_HEIGHT,
    GL_TEXTURE_INTENSITY_SIZE,
    GL_TEXTURE_WIDTH,
    GL_UNSIGNED_BYTE,
)

_MOST = 4096
"""Texels of a side that are looked into."""


class Lettering:
    """Of one context."""

    def __init__(self) -> None:
        self._known: dict[tuple[int, ...], tuple[bool, int]] = {}
        """By texture, whether it has letters, and how often that was asked."""

    def draws(self, state: DrawState) -> bool:
        """Whether polygons that are drawn now, in a state, are text. Outside primitives."""
        irrelevant = state.upright or not (state.depth_tested and state.depth_written)
        if not irrelevant or not state.fill_faces or not is_enabled(GL_TEXTURE_2D):
            return False
        if not (is_enabled(GL_BLEND) or is_enabled(GL_ALPHA_TEST)):
            return False
        width, height, alpha, intensity = (
            _of_level(name) for name in (
                GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_ALPHA_SIZE,
                GL_TEXTURE_INTENSITY_SIZE,
            )
        )  # fmt: skip
        if not (alpha or intensity) or not 0 < min(width, height) <= max(width, height) <= _MOST:
            return False
        key = integer(GL_TEXTURE_BINDING_2D), width, height, alpha, intensity
        found, asked = self._known.get(key, (False, 0))
        # What a texture holds may change unheard: it is looked into again, ever more seldom.
        if asked & (asked - 1) == 0:
            texels = _texels(width, height)
            found = texels is not None and has_letters(texels)
        if len(self._known) > 4096:
            self._known.clear()
        self._known[key] = found, asked + 1
        return found


def has_letters(texels: NDArray[np.uint8]) -> bool:
    """Whether a picture (..., 4) is one of letters: clear and opaque, of one colour or grey."""
    texels = texels.reshape(-1, 4)
    alpha = texels[:, 3]
    clear, opaque = int((alpha < 26).sum()), int((alpha > 229).sum())
    between = len(alpha) - clear - opaque
    if clear < 0.15 * len(alpha) or not opaque or between > 4 * opaque:
        return False
    colours = texels[alpha > 128, :3].astype(np.int16)
    grey = np.ptp(colours, axis=1) < 26
    return bool(grey.mean() > 0.95 or colours.std(axis=0).max() < 20.0)


def _of_level(name: int) -> int:
    """One integer of the texture that is bound."""
    value = ctypes.c_int(0)
    gl.glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, ctypes.byref(value))
    return value.value


def _texels(width: int, height: int) -> NDArray[np.uint8] | None:
    """(H, W, 4) of the texture that is bound; None where that cannot be asked for."""
    if integer(GL_ATTRIB_STACK_DEPTH) >= integer(GL_MAX_ATTRIB_STACK_DEPTH):
        return None
    if integer(GL_CLIENT_ATTRIB_STACK_DEPTH) >= integer(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH):
        return None
    found = np.zeros((height, width, 4), np.uint8)
    with Unnoticed():
        gl.glPushAttrib(GL_PIXEL_MODE_BIT)
        gl.glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT)
        try:
            pack_plainly()
            transfer_plainly()
            gl.glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, found.ctypes.data)
        finally:
            gl.glPopClientAttrib()
            gl.glPopAttrib()
    return found
