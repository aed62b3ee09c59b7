"""The background in a style's colour, before the app draws on it: what the app blends with it, or
draws without depth, is then on paper from the beginning."""

from __future__ import annotations

import numpy as np

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.driver.pixels import pack_plainly, transfer_plainly
from glshim.model.boxes import Box, Unbacked, boxes_of
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.matrices import matrices_kept
from glshim.outputs.gl.fixed import plainest
from glshim.spec.constants import (
    GL_COLOR_ARRAY,
    GL_COLOR_BUFFER_BIT,
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FLOAT,
    GL_FRAMEBUFFER_SRGB,
    GL_LEQUAL,
    GL_MODELVIEW,
    GL_NO_ERROR,
    GL_PROJECTION,
    GL_READ_FRAMEBUFFER,
    GL_RGB,
    GL_SCISSOR_TEST,
    GL_TRIANGLES,
    GL_UNSIGNED_BYTE,
    GL_VERTEX_ARRAY,
)
from glshim.styling.values import Colour

_MOST = 2000
"""Boxes of a picture that are filled one by one, the largest first."""
_LITTLE = 0.1
"""Of a picture: no more than that was drawn in the background's colour."""
_CORNERS = np.array(((-1, -1), (3, -1), (-1, 3)), np.float32)
"""Of a triangle over every viewport. From arrays: where a program evaluates normals, Mesa shows it
what was said before between glBegin and glEnd."""


def lay(places: Unbacked, colour: Colour) -> bool:
    """Fill boxes of the framebuffer that is bound; its alpha and its depth stay. Whether that was
    possible."""
    if not possible():
        return False
    with Guard():
        for switch in (GL_DITHER, GL_FRAMEBUFFER_SRGB):
            gl.glDisable(switch)
        gl.glEnable(GL_SCISSOR_TEST)
        if places.around is not None:
            _clear(_bare(places.boxes, places.around), colour)
        elif places.free_depth:
            _fill_behind(places.boxes, colour)
        else:
            _clear(places.boxes, colour)
    return True


def _bare(boxes: tuple[Box, ...], own: Colour) -> tuple[Box, ...]:
    """The parts of boxes that have a colour, where that is much; all if they cannot be read."""
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, integer(GL_DRAW_FRAMEBUFFER_BINDING))
    gl.glReadBuffer(integer(GL_DRAW_BUFFER))
    pack_plainly()
    transfer_plainly()
    found: list[Box] = []
    for x, y, width, height in boxes:
        seen = np.zeros((height, width, 3), np.uint8)
        gl.glReadPixels(x, y, width, height, GL_RGB, GL_UNSIGNED_BYTE, seen.ctypes.data)
        if gl.glGetError() != GL_NO_ERROR:
            return boxes
        alike = np.asarray((abs(seen - np.multiply(own, 255.0)) < 1.0).all(axis=2))
        if alike.mean() > _LITTLE:
            found += [(x + at[0], y + at[1], at[2], at[3]) for at in boxes_of(alike)]
    found.sort(key=lambda at: at[2] * at[3], reverse=True)
    return tuple(found[:_MOST])


def lift(box: Box, laid: Colour, own: Colour) -> tuple[Box, ...]:
    """Give pixels of a small box that still have the colour which was laid another one. They."""
    if not possible():
        return ()
    x, y, width, height = box
    seen = np.zeros((height, width, 3), np.uint8)
    with Guard():
        pack_plainly()
        transfer_plainly()
        gl.glReadPixels(*box, GL_RGB, GL_UNSIGNED_BYTE, seen.ctypes.data)
        same = (abs(seen - np.multiply(laid, 255.0)) < 1.0).all(2)
        pixels = tuple((x + int(i), y + int(j), 1, 1) for j, i in np.argwhere(same))
        if pixels:
            for switch in (GL_DITHER, GL_FRAMEBUFFER_SRGB):
                gl.glDisable(switch)
            gl.glEnable(GL_SCISSOR_TEST)
            _clear(pixels, own)
    return pixels


def _clear(boxes: tuple[Box, ...], colour: Colour) -> None:
    gl.glColorMask(1, 1, 1, 0)
    gl.glClearColor(*colour, 1.0)
    for box in boxes:
        gl.glScissor(*box)
        gl.glClear(GL_COLOR_BUFFER_BIT)


def _fill_behind(boxes: tuple[Box, ...], colour: Colour) -> None:
    """Behind what has depth already."""
    with matrices_kept():
        plainest()
        gl.glColorMask(1, 1, 1, 0)
        gl.glDisable(GL_CULL_FACE)
        for mode in (GL_PROJECTION, GL_MODELVIEW):
            gl.glMatrixMode(mode)
            gl.glLoadIdentity()
        gl.glEnable(GL_DEPTH_TEST)
        gl.glDepthFunc(GL_LEQUAL)
        gl.glDepthRange(1.0, 1.0)
        for array in (GL_VERTEX_ARRAY, GL_COLOR_ARRAY):
            gl.glEnableClientState(array)
        paints = np.array([(*colour, 1.0)] * 3, np.float32)
        gl.glVertexPointer(2, GL_FLOAT, 0, _CORNERS.ctypes.data)
        gl.glColorPointer(4, GL_FLOAT, 0, paints.ctypes.data)
        for box in boxes:
            gl.glViewport(*box)
            gl.glScissor(*box)
            gl.glDrawArrays(GL_TRIANGLES, 0, 3)
