"""Back faces as lines by the fixed-function pipeline alone: no shader, no framebuffer object, no
buffer object. Needs nothing past OpenGL 1.1, and keeps away from what a version does not have."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glshim.errors import RenderError
from glshim.geometry.recovery.outward import way_out
from glshim.model.batch import PolygonBatch
from glshim.model.caches import AgingCache
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import fans, put_the_apps_arrays_away
from glshim.outputs.gl.device.guard import Guard, drain, possible
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, scissor, stencil
from glshim.spec.ask import integer
from glshim.spec.context import NO_FIXED_FUNCTION, has_fixed_function, version
from glshim.spec.driver import current_context, gl
from glshim.styling.fixed import BackFaces
from glshim.styling.values import Colour, Item, in_order

_TRIANGLES, _FLOAT, _VERTICES, _EDGE_FLAGS = 0x0004, 0x1406, 0x8074, 0x8079
_FRONT, _BACK, _LINE, _FILL = 0x0404, 0x0405, 0x1B01, 0x1B02
_CULL_FACE, _CLOCKWISE, _COUNTER_CLOCKWISE = 0x0B44, 0x0900, 0x0901
_DEPTH_TEST, _DEPTH_FUNC, _DEPTH_BITS, _SCISSOR_TEST = 0x0B71, 0x0B74, 0x0D56, 0x0C11
_GREATER, _GEQUAL, _LEQUAL = 0x0204, 0x0206, 0x0203
_OFFSET_FILL, _BLEND, _ALPHA, _REST = 0x8037, 0x0BE2, 0x0302, 0x0303
_LINE_SMOOTH, _LINE_WIDTHS, _SMOOTH_LINE_WIDTHS = 0x0B20, 0x846E, 0x0B22
_MODELVIEW, _PROJECTION = 0x1700, 0x1701
_STACKS = ((_MODELVIEW, 0x0BA6), (_PROJECTION, 0x0BA7))
_CLIP_PLANE = 0x3000
_TEXTURE_0, _MOST_UNITS = 0x84C0, 0x84E2
_TEXTURES = (0x0DE0, 0x0DE1, 0x806F, 0x8513, 0x84F5)
"""1D, 2D, 3D, cube maps, rectangles."""
_SHADED = (
    0x0B50, 0x0B60, 0x8458,  # lighting, fog, colour sum
    0x8620, 0x8804,  # programs of ARB_vertex_program and ARB_fragment_program
    0x0B24, 0x2A02,  # line stipple, polygon offset of lines
)  # fmt: skip
"""What changes colours or lines of the fixed function, besides what `plainly` turns off."""

_Fans = tuple[NDArray[np.float32], NDArray[np.uint8], float]
"""Points, edge flags and the way out (`way_out`)."""


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
        if not integer(_DEPTH_BITS):
            say_once("this window has no depth buffer: back faces cannot be drawn as lines in it")
            return
        with Guard(), _matrices():
            greater = integer(_DEPTH_FUNC) in (_GREATER, _GEQUAL)
            _plainest()
            gl.glEnable(_DEPTH_TEST)
            gl.glDepthFunc(_GEQUAL if greater else _LEQUAL)
            self._fill(found, greater)
            self._lines(found)

    def _fill(self, found: list[tuple[BackFaces, list[Item]]], greater: bool) -> None:
        """Front faces. Their depth is there already: a nudge lets them pass in spite of rounding.
        """
        gl.glPolygonMode(_FRONT, _FILL)
        gl.glCullFace(_BACK)
        gl.glEnable(_OFFSET_FILL)
        towards = 1.0 if greater else -1.0
        gl.glPolygonOffset(towards, towards)
        for draw, items in found:
            if draw.fill is not None:
                self._draw(items, draw.fill)
        gl.glDisable(_OFFSET_FILL)

    def _lines(self, found: list[tuple[BackFaces, list[Item]]]) -> None:
        """Back faces."""
        gl.glPolygonMode(_BACK, _LINE)
        gl.glCullFace(_FRONT)
        gl.glBlendFunc(_ALPHA, _REST)
        for draw, items in found:
            if not items:
                continue
            for switch in (_LINE_SMOOTH, _BLEND):
                (gl.glEnable if draw.smooth else gl.glDisable)(switch)
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
        gl.glVertexPointer(3, _FLOAT, 0, points.ctypes.data)
        gl.glEdgeFlagPointer(0, flags.ctypes.data)
        # Left on from draw to draw they make Mesa 22 miss the change of colour.
        gl.glEnableClientState(_EDGE_FLAGS)
        gl.glDrawArrays(_TRIANGLES, 0, 3 * len(points))
        gl.glDisableClientState(_EDGE_FLAGS)

    def _fans(self, batch: PolygonBatch) -> _Fans:
        known = None if batch.key is None else self._known.get(batch.key)
        if known is None:
            points, flags = fans(batch)
            known = points, flags, way_out(points)
            if batch.key is not None:
                self._known.put(batch.key, known, points.nbytes + flags.nbytes)
        return known


def _plainest() -> None:
    """Flat colours, the arrays of what is drawn now, and no texture and no program."""
    plainly()
    number = version() or (1, 1)
    if number >= (2, 0):
        gl.glUseProgram(0)
    several = number >= (1, 3)
    for unit in range(integer(_MOST_UNITS) if several else 1):
        if several:
            gl.glActiveTexture(_TEXTURE_0 + unit)
        for texture in _TEXTURES:
            gl.glDisable(texture)
    for switch in _SHADED:
        gl.glDisable(switch)
    put_the_apps_arrays_away()
    drain()  # what older versions do not know of these
    gl.glEnableClientState(_VERTICES)
    gl.glEnable(_CULL_FACE)
    gl.glEnable(_SCISSOR_TEST)


@contextmanager
def _matrices() -> Iterator[None]:
    """Put both matrices back: they are in no attribute group, and their stacks may be full."""
    kept = []
    for mode, name in _STACKS:
        matrix = (ctypes.c_double * 16)()
        gl.glGetDoublev(name, ctypes.addressof(matrix))
        kept.append((mode, matrix))
    try:
        yield
    finally:
        for mode, matrix in kept:
            gl.glMatrixMode(mode)
            gl.glLoadMatrixd(ctypes.addressof(matrix))


def _look_through(camera: Camera) -> None:
    """All of a camera as fixed state."""
    gl.glViewport(*camera.viewport)
    gl.glDepthRange(*camera.depth_range)
    gl.glFrontFace(_COUNTER_CLOCKWISE if camera.front_ccw else _CLOCKWISE)
    scissor(camera, camera.viewport)
    stencil(camera)
    gl.glMatrixMode(_PROJECTION)
    _load(camera.projection)
    gl.glMatrixMode(_MODELVIEW)
    gl.glLoadIdentity()
    for k in range(MOST_CLIP_PLANES):
        if k < len(camera.clip_planes):
            plane = np.array(camera.clip_planes[k], np.float64)
            gl.glClipPlane(_CLIP_PLANE + k, plane.ctypes.data)  # in eye space
            gl.glEnable(_CLIP_PLANE + k)
        else:
            gl.glDisable(_CLIP_PLANE + k)
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


def _possible_width(width: float, smooth: bool) -> float:
    """The width, as far as the driver draws lines of it."""
    limits = (ctypes.c_float * 2)(1.0, 1.0)
    # Before 1.2 there is one range for both.
    known = (version() or (1, 1)) >= (1, 2)
    name = _LINE_WIDTHS if known and not smooth else _SMOOTH_LINE_WIDTHS
    gl.glGetFloatv(name, ctypes.addressof(limits))
    least, most = limits
    found = min(max(width, least), max(most, 1.0))
    if found != width:
        say_once(f"this driver draws lines of {least:g} to {most:g} pixels, not of {width:g}")
    return found
