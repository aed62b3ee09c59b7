"""Images that strokes are drawn with, as textures."""

from __future__ import annotations

import ctypes

import numpy as np

from glshim.spec.driver import gl
from glshim.styling.pictures import Image

STROKE_UNIT = 13
"""Texture unit of the image while lines are drawn."""
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_RGBA_8, _RGBA, _BYTE = 0x8058, 0x1908, 0x1401
_MOST = 16
_LINEAR, _MIPMAP, _REPEAT, _TO_EDGE = 0x2601, 0x2703, 0x2901, 0x812F


class Textures:
    """Textures of one context by image, premultiplied. Use it inside the state guard."""

    def __init__(self) -> None:
        self._names: dict[Image, int] = {}

    def bind(self, image: Image) -> None:
        """Let shaders read an image at `STROKE_UNIT`: repeated along, ending across."""
        gl.glActiveTexture(_TEXTURE_0 + STROKE_UNIT)
        name = self._names.get(image)
        if name is None:
            if len(self._names) >= _MOST:
                self._forget()
            name = self._names[image] = self._upload(image)
        gl.glBindTexture(_TEXTURE_2D, name)

    def _forget(self) -> None:
        names = (ctypes.c_uint * len(self._names))(*self._names.values())
        gl.glDeleteTextures(len(names), ctypes.addressof(names))
        self._names.clear()

    def _upload(self, image: Image) -> int:
        value = ctypes.c_uint()
        gl.glGenTextures(1, ctypes.addressof(value))
        gl.glBindTexture(_TEXTURE_2D, value.value)
        gl.glBindBuffer(_UNPACK_BUFFER, 0)
        for alignment in ((0x0CF5, 1), (0x0CF2, 0), (0x0CF3, 0), (0x0CF4, 0)):
            gl.glPixelStorei(*alignment)
        pixels = np.array(image.pixels[::-1], np.uint8)
        alpha = pixels[..., 3:] / 255.0
        pixels[..., :3] = np.rint(pixels[..., :3] * alpha)
        height, width = pixels.shape[:2]
        gl.glTexImage2D(_TEXTURE_2D, 0, _RGBA_8, width, height, 0, _RGBA, _BYTE,
                        pixels.ctypes.data)  # fmt: skip
        gl.glGenerateMipmap(_TEXTURE_2D)
        for parameter, setting in ((0x2801, _MIPMAP), (0x2800, _LINEAR), (0x2802, _REPEAT),
                                   (0x2803, _TO_EDGE)):  # fmt: skip
            gl.glTexParameteri(_TEXTURE_2D, parameter, setting)
        return value.value
