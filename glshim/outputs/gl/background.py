"""The background in a style's colour, before the app draws on it: what the app blends with it, or
draws without depth, is then on paper from the beginning."""

from __future__ import annotations

import numpy as np

from glshim.driver.functions import gl
from glshim.model.boxes import Box, Unbacked
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.fixed import matrices_kept, plainest
from glshim.outputs.gl.frame.canvas import fill_viewport
from glshim.spec.constants import (
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_FRAMEBUFFER_SRGB,
    GL_LEQUAL,
    GL_MODELVIEW,
    GL_PROJECTION,
)
from glshim.styling.values import Colour


def lay(places: Unbacked, colour: Colour) -> bool:
    """Fill boxes of the framebuffer that is bound; its alpha and its depth stay. Whether that was
    possible."""
    if not possible():
        return False
    with Guard(), matrices_kept():
        plainest()
        for switch in (GL_DITHER, GL_FRAMEBUFFER_SRGB, GL_CULL_FACE):
            gl.glDisable(switch)
        for mode in (GL_PROJECTION, GL_MODELVIEW):
            gl.glMatrixMode(mode)
            gl.glLoadIdentity()
        gl.glColorMask(1, 1, 1, 0)
        gl.glColor4fv(np.array((*colour, 1.0), np.float32).ctypes.data)
        if places.free_depth:  # all behind what has depth already
            gl.glEnable(GL_DEPTH_TEST)
            gl.glDepthFunc(GL_LEQUAL)
            gl.glDepthRange(1.0, 1.0)
        for box in places.boxes:
            _fill(box)
    return True


def _fill(box: Box) -> None:
    gl.glViewport(*box)
    gl.glScissor(*box)
    fill_viewport()
