"""Images that strokes are drawn with, as textures."""

from __future__ import annotations

import numpy as np

from glshim.driver.functions import gl
from glshim.driver.objects import delete, made
from glshim.driver.pixels import unpack_plainly
from glshim.spec.constants import (
    GL_CLAMP_TO_EDGE,
    GL_LINEAR,
    GL_LINEAR_MIPMAP_LINEAR,
    GL_REPEAT,
    GL_RGBA,
    GL_RGBA8,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
    GL_TEXTURE_MAG_FILTER,
    GL_TEXTURE_MIN_FILTER,
    GL_TEXTURE_WRAP_S,
    GL_TEXTURE_WRAP_T,
    GL_UNSIGNED_BYTE,
)
from glshim.spec.kinds import TEXTURE
from glshim.styling.pictures import Image

STROKE_UNIT = 13
"""Texture unit of the image while lines are drawn."""
_MOST = 16
_PARAMETERS = (
    (GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR), (GL_TEXTURE_MAG_FILTER, GL_LINEAR),
    (GL_TEXTURE_WRAP_S, GL_REPEAT), (GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE),
)  # fmt: skip


class Textures:
    """Textures of one context by image, premultiplied. Use it inside the state guard."""

    def __init__(self) -> None:
        self._names: dict[Image, int] = {}

    def bind(self, image: Image) -> None:
        """Let shaders read an image at `STROKE_UNIT`: repeated along, ending across."""
        gl.glActiveTexture(GL_TEXTURE0 + STROKE_UNIT)
        name = self._names.get(image)
        if name is None:
            if len(self._names) >= _MOST:
                self._forget()
            name = self._names[image] = self._upload(image)
        gl.glBindTexture(GL_TEXTURE_2D, name)

    def _forget(self) -> None:
        delete(TEXTURE, self._names.values())
        self._names.clear()

    def _upload(self, image: Image) -> int:
        name = made(TEXTURE)
        gl.glBindTexture(GL_TEXTURE_2D, name)
        unpack_plainly()
        pixels = np.array(image.pixels[::-1], np.uint8)
        alpha = pixels[..., 3:] / 255.0
        pixels[..., :3] = np.rint(pixels[..., :3] * alpha)
        height, width = pixels.shape[:2]
        gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.ctypes.data)  # fmt: skip
        gl.glGenerateMipmap(GL_TEXTURE_2D)
        for parameter in _PARAMETERS:
            gl.glTexParameteri(GL_TEXTURE_2D, *parameter)
        return name
