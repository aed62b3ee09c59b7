"""How bright the app's picture is where nothing solid is drawn: what lines at outlines stand on."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.driver.pixels import pack_plainly, transfer_plainly
from glshim.model.boxes import Box
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.spec.constants import (
    GL_DEPTH_BITS,
    GL_DEPTH_COMPONENT,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FLOAT,
    GL_NO_ERROR,
    GL_READ_FRAMEBUFFER,
    GL_RGB,
)

_ROWS = 7
"""That are read."""
_LEAST = 0.02
"""Of what is read: less background than that tells nothing."""


def brightness_behind(box: Box) -> float | None:
    """0..1, the brightest channel in the middle of the background of a box of the framebuffer that
    is bound; None where there is none, or it cannot be read."""
    x, y, width, height = box
    if width < 1 or height < _ROWS or not integer(GL_DEPTH_BITS) or not possible():
        return None
    with Guard():
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, integer(GL_DRAW_FRAMEBUFFER_BINDING))
        gl.glReadBuffer(integer(GL_DRAW_BUFFER))
        pack_plainly()
        transfer_plainly()
        rows = [y + (2 * k + 1) * height // (2 * _ROWS) for k in range(_ROWS)]
        colours = [_row(x, row, width, GL_RGB, 3) for row in rows]
        depths = [_row(x, row, width, GL_DEPTH_COMPONENT, 1) for row in rows]
        if gl.glGetError() != GL_NO_ERROR:  # of several samples
            return None
    far = np.concatenate(depths)[:, 0] >= 1.0
    if far.mean() < _LEAST:
        return None
    return float(np.median(np.concatenate(colours)[far].max(axis=1)))


def _row(x: int, y: int, width: int, layout: int, count: int) -> NDArray[np.float32]:
    pixels = np.zeros((width, count), np.float32)
    gl.glReadPixels(x, y, width, 1, layout, GL_FLOAT, pixels.ctypes.data)
    return pixels
