"""Back faces as lines by the fixed-function pipeline alone: no shader, no framebuffer object, no
buffer object. Needs nothing past OpenGL 1.1, and keeps away from what a version does not have."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer
from glshim.driver.context import NO_FIXED_FUNCTION, has_fixed_function, version
from glshim.driver.errorflag import drain
from glshim.driver.functions import current_context, gl
from glshim.errors import RenderError
from glshim.geometry.recovery.outward import outward_sign
from glshim.model.batch import Item, PolygonBatch
from glshim.model.caches import AgingCache
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import put_the_apps_arrays_away
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.matrices import matrices_kept
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.gl.device.triangles import flagged_triangles
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, scissor, stencil
from glshim.spec.constants import (
    GL_ALIASED_LINE_WIDTH_RANGE,
    GL_BACK,
    GL_BLEND,
    GL_CCW,
    GL_CLIP_PLANE0,
    GL_COLOR_MATERIAL,
    GL_COLOR_SUM,
    GL_CULL_FACE,
    GL_CW,
    GL_DEPTH_BITS,
    GL_DEPTH_FUNC,
    GL_DEPTH_TEST,
    GL_EDGE_FLAG_ARRAY,
    GL_FILL,
    GL_FLOAT,
    GL_FOG,
    GL_FRAGMENT_PROGRAM_ARB,
    GL_FRONT,
    GL_GEQUAL,
    GL_GREATER,
    GL_LEQUAL,
    GL_LIGHTING,
    GL_LINE,
    GL_LINE_SMOOTH,
    GL_LINE_STIPPLE,
    GL_MAX_TEXTURE_UNITS,
    GL_MODELVIEW,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_PROJECTION,
    GL_SCISSOR_TEST,
    GL_SMOOTH_LINE_WIDTH_RANGE,
    GL_SRC_ALPHA,
    GL_TEXTURE0,
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_RECTANGLE,
    GL_TRIANGLES,
    GL_VERTEX_ARRAY,
    GL_VERTEX_PROGRAM_ARB,
)
from glshim.styling.fixed import BackFaces
from glshim.styling.values import Colour, in_order

_TEXTURES = (
    GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE,
)  # fmt: skip
_SHADED = (
    GL_LIGHTING, GL_FOG, GL_COLOR_SUM, GL_VERTEX_PROGRAM_ARB, GL_FRAGMENT_PROGRAM_ARB,
    GL_LINE_STIPPLE, GL_POLYGON_OFFSET_LINE, GL_COLOR_MATERIAL,
)  # fmt: skip
"""What changes colours or lines of the fixed function, or is changed by them, besides what
`plainly` turns off."""

_Fans = tuple[NDArray[np.float32], NDArray[np.uint8], float]
"""Points, edge flags and the way out (`outward_sign`)."""


class FixedPen:
    """Holds nothing of GL: one serves all contexts."""

    def __init__(self) -> None:
        self._known: AgingCache[_Fans] = AgingCache()

    def render(self, draws: Iterable[BackFaces]) -> None:
        """Add lines, and fills before them, to the framebuffer that is bound, against its depth,
        and touch nothing else.

        Does nothing where GL cannot draw now (a list being compiled, selection, a full attribute
        stack), nor where nothing tells what is hidden: without a depth buffer. Raises
        `RenderError` in a core profile and without a context.
        """
        if not current_context() or not has_fixed_function():
            raise RenderError(NO_FIXED_FUNCTION)
        self._known.tick()
        found = [(draw, _seen(draw)) for draw in draws]
        if not any(items for _, items in found) or not possible():
            return
        if not integer(GL_DEPTH_BITS):
            say_once("this window has no depth buffer: back faces cannot be drawn as lines in it")
            return
        with Guard(), matrices_kept():
            greater = integer(GL_DEPTH_FUNC) in (GL_GREATER, GL_GEQUAL)
            plainest()
            gl.glEnable(GL_DEPTH_TEST)
            gl.glDepthFunc(GL_GEQUAL if greater else GL_LEQUAL)
            self._fill(found, greater)
            self._lines(found)

    def _fill(self, found: list[tuple[BackFaces, list[Item]]], greater: bool) -> None:
        """Front faces. Their depth is there already: a nudge lets them pass in spite of rounding.
        """
        gl.glPolygonMode(GL_FRONT, GL_FILL)
        gl.glCullFace(GL_BACK)
        gl.glEnable(GL_POLYGON_OFFSET_FILL)
        towards = 1.0 if greater else -1.0
        gl.glPolygonOffset(towards, towards)
        for draw, items in found:
            if draw.fill is not None:
                self._draw(items, draw.fill)
        gl.glDisable(GL_POLYGON_OFFSET_FILL)

    def _lines(self, found: list[tuple[BackFaces, list[Item]]]) -> None:
        """Back faces."""
        gl.glPolygonMode(GL_BACK, GL_LINE)
        gl.glCullFace(GL_FRONT)
        gl.glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
        for draw, items in found:
            if not items:
                continue
            for switch in (GL_LINE_SMOOTH, GL_BLEND):
                (gl.glEnable if draw.smooth else gl.glDisable)(switch)
            (gl.glEnable if draw.dash > 0.0 else gl.glDisable)(GL_LINE_STIPPLE)
            gl.glLineStipple(*_stipple(draw.dash))
            gl.glLineWidth(_possible_width(draw.width, draw.smooth))
            self._draw(items, draw.ink)

    def _draw(self, items: list[Item], colour: Colour) -> None:
        rgba = np.array((*colour, 1.0), np.float32)
        for batch, camera in items:
            self._one(batch, camera, rgba)

    def _one(self, batch: PolygonBatch, camera: Camera, rgba: NDArray[np.float32]) -> None:
        points, flags, way = self._fans(batch)
        if not len(points):
            return
        if way != 0.0:  # GLUT's teapot winds about what is in, and says nothing
            camera = replace(camera, front_ccw=(way > 0.0) != camera.mirrored)
        _look_through(camera)
        gl.glColor4fv(rgba.ctypes.data)
        gl.glVertexPointer(3, GL_FLOAT, 0, points.ctypes.data)
        gl.glEdgeFlagPointer(0, flags.ctypes.data)
        # Left on from draw to draw they make Mesa 22 miss the change of colour.
        gl.glEnableClientState(GL_EDGE_FLAG_ARRAY)
        gl.glDrawArrays(GL_TRIANGLES, 0, 3 * len(points))
        gl.glDisableClientState(GL_EDGE_FLAG_ARRAY)

    def _fans(self, batch: PolygonBatch) -> _Fans:
        known = None if batch.key is None else self._known.get(batch.key)
        if known is None:
            points, flags = flagged_triangles(batch)
            known = points, flags, outward_sign(points)
            if batch.key is not None:
                self._known.put(batch.key, known, points.nbytes + flags.nbytes)
        return known


def plainest() -> None:
    """Flat colours, the arrays of what is drawn now, and no texture and no program."""
    plainly()
    number = version() or (1, 1)
    if number >= (2, 0):
        gl.glUseProgram(0)
    several = number >= (1, 3)
    for unit in range(integer(GL_MAX_TEXTURE_UNITS) if several else 1):
        if several:
            gl.glActiveTexture(GL_TEXTURE0 + unit)
        for texture in _TEXTURES:
            gl.glDisable(texture)
    for switch in _SHADED:
        gl.glDisable(switch)
    put_the_apps_arrays_away()
    drain()  # what older versions do not know of these
    gl.glEnableClientState(GL_VERTEX_ARRAY)
    gl.glEnable(GL_CULL_FACE)
    gl.glEnable(GL_SCISSOR_TEST)


def _look_through(camera: Camera) -> None:
    """All of a camera as fixed state."""
    gl.glViewport(*camera.viewport)
    gl.glDepthRange(*camera.depth_range)
    gl.glFrontFace(GL_CCW if camera.front_ccw else GL_CW)
    scissor(camera, camera.viewport)
    stencil(camera)
    gl.glMatrixMode(GL_PROJECTION)
    _load(camera.projection)
    gl.glMatrixMode(GL_MODELVIEW)
    gl.glLoadIdentity()
    for k in range(MOST_CLIP_PLANES):
        if k < len(camera.clip_planes):
            plane = np.array(camera.clip_planes[k], np.float64)
            gl.glClipPlane(GL_CLIP_PLANE0 + k, plane.ctypes.data)  # in eye space
            gl.glEnable(GL_CLIP_PLANE0 + k)
        else:
            gl.glDisable(GL_CLIP_PLANE0 + k)
    _load(camera.modelview)


def _load(matrix: NDArray[np.float64]) -> None:
    columns = np.ascontiguousarray(matrix.T, np.float64)
    gl.glLoadMatrixd(columns.ctypes.data)


def _seen(draw: BackFaces) -> list[Item]:
    """The batches that have polygons, and cameras that see any."""
    return [
        (batch, camera)
        for batch, camera in in_order(draw.bodies)
        if batch.polygon_count and _can_be_seen(camera)
    ]


def _can_be_seen(camera: Camera) -> bool:
    finite = np.isfinite(camera.modelview).all() and np.isfinite(camera.projection).all()
    return bool(finite) and min(camera.viewport[2:]) > 0


def _stipple(dash: float) -> tuple[int, int]:
    """Factor and pattern of dashes that take so many pixels with their gaps, about."""
    bits = next((bits for bits in (2, 4, 8) if dash < 1.5 * bits), 16)
    drawn = (1 << round(0.6 * bits)) - 1
    pattern = sum(drawn << place for place in range(0, 16, bits))
    return min(max(round(dash / bits), 1), 256), pattern


def _possible_width(width: float, smooth: bool) -> float:
    """The width, as far as the driver draws lines of it."""
    limits = (ctypes.c_float * 2)(1.0, 1.0)
    # Before 1.2 there is one range for both.
    known = (version() or (1, 1)) >= (1, 2)
    name = GL_ALIASED_LINE_WIDTH_RANGE if known and not smooth else GL_SMOOTH_LINE_WIDTH_RANGE
    gl.glGetFloatv(name, ctypes.addressof(limits))
    least, most = limits
    found = min(max(width, least), max(most, 1.0))
    if found != width:
        say_once(f"this driver draws lines of {least:g} to {most:g} pixels, not of {width:g}")
    return found
