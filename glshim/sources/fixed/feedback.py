"""Polygons of whatever C code draws, seen through OpenGL's own feedback mode.

GLU quadrics, GLUT solids, evaluators, NURBS, GLE and display lists never pass PyOpenGL vertex by
vertex, but the driver will say what they draw: modelview identity, a parallel projection of radius
R, culling off, ``glRenderMode(GL_FEEDBACK)``, draw, undo the viewport. Drawn once filled and once
as lines: the lines are the true edges, without the diagonals that triangulation adds.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Hashable
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer, pointer_of, settle_attributes
from glshim.driver.functions import gl
from glshim.driver.unnoticed import Unnoticed
from glshim.model.batch import PolygonBatch
from glshim.model.polygons import fan
from glshim.spec.constants import (
    GL_3D,
    GL_ALL_ATTRIB_BITS,
    GL_ALPHA_TEST,
    GL_ATTRIB_STACK_DEPTH,
    GL_BITMAP_TOKEN,
    GL_CLIENT_ALL_ATTRIB_BITS,
    GL_CLIENT_ATTRIB_STACK_DEPTH,
    GL_CLIP_PLANE0,
    GL_COPY_PIXEL_TOKEN,
    GL_CULL_FACE,
    GL_DRAW_PIXEL_TOKEN,
    GL_FEEDBACK,
    GL_FEEDBACK_BUFFER_POINTER,
    GL_FEEDBACK_BUFFER_SIZE,
    GL_FEEDBACK_BUFFER_TYPE,
    GL_FILL,
    GL_FOG,
    GL_FRONT_AND_BACK,
    GL_LIGHTING,
    GL_LINE,
    GL_LINE_RESET_TOKEN,
    GL_LINE_STIPPLE,
    GL_LINE_TOKEN,
    GL_MATRIX_MODE,
    GL_MAX_ATTRIB_STACK_DEPTH,
    GL_MAX_CLIENT_ATTRIB_STACK_DEPTH,
    GL_MODELVIEW,
    GL_MODELVIEW_MATRIX,
    GL_PASS_THROUGH_TOKEN,
    GL_POINT_TOKEN,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_STIPPLE,
    GL_POLYGON_TOKEN,
    GL_PROJECTION,
    GL_PROJECTION_MATRIX,
    GL_RENDER,
)

if TYPE_CHECKING:
    from collections.abc import Iterator

_VERTICES = {
    GL_POINT_TOKEN: 1, GL_LINE_TOKEN: 2, GL_BITMAP_TOKEN: 1, GL_DRAW_PIXEL_TOKEN: 1,
    GL_COPY_PIXEL_TOKEN: 1, GL_LINE_RESET_TOKEN: 2,
}  # fmt: skip
"""Of each token but polygons."""
_OFF = (
    GL_CULL_FACE, GL_LIGHTING, GL_FOG, GL_POLYGON_OFFSET_FILL, GL_ALPHA_TEST, GL_POLYGON_STIPPLE,
    GL_LINE_STIPPLE, *(GL_CLIP_PLANE0 + k for k in range(6)),
)  # fmt: skip
"""What is in the way."""
_STACKS = (
    (GL_ATTRIB_STACK_DEPTH, GL_MAX_ATTRIB_STACK_DEPTH),
    (GL_CLIENT_ATTRIB_STACK_DEPTH, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH),
)
"""Depths of the attribute stacks, and their limits."""
_LEVELS = 4
"""Our level of them, and those of C libraries above it (GLU and GLUT push one). Where theirs finds
no room, they pop ours."""
_SIDE = 1024
_FIRST_RADIUS = 1.0e6
_COARSE = 2.0**-21
_FIRST_SIZE = 1 << 20


def polygons(draw: Callable[[], Any], key: Hashable | None = None) -> PolygonBatch | None:
    """What ``draw`` draws, in the space that was current when it was called; None when nothing.

    Costs three or four runs of ``draw``: call once and keep the result. The GL state that ``draw``
    changes is put back, matrices included. Call outside glBegin/glEnd and open display lists.
    """
    with Unnoticed(), _stage() as set_stage:
        radius = _FIRST_RADIUS
        while True:
            triangles, _ = _parse(_run(draw, set_stage, radius, GL_FILL), radius)
            if not len(triangles):
                return None
            # Window coordinates are floats: what comes back is as coarse as the stage is large.
            reach = float(np.abs(triangles).max()) * 1.01 + radius * _COARSE
            if reach > radius / 16.0:
                break
            radius = reach
        _, lines = _parse(_run(draw, set_stage, radius, GL_LINE), radius)
    return _batch(triangles, lines, key)


def possible() -> bool:
    """Whether there is room on the attribute stacks. Ask before :func:`polygons`."""
    return all(integer(depth) + _LEVELS <= integer(limit) for depth, limit in _STACKS)


@contextmanager
def _stage() -> Iterator[Callable[[float, int], None]]:
    """Feedback's surroundings: a callable that sets them up, undone at the end."""
    buffer = (
        integer(GL_FEEDBACK_BUFFER_SIZE),
        integer(GL_FEEDBACK_BUFFER_TYPE),
        pointer_of(GL_FEEDBACK_BUFFER_POINTER) or None,
    )
    saved = _save_matrices()
    gl.glPushAttrib(GL_ALL_ATTRIB_BITS)
    gl.glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS)

    def set_stage(radius: float, faces: int) -> None:
        for switch in _OFF:
            gl.glDisable(switch)
        gl.glPolygonMode(GL_FRONT_AND_BACK, faces)
        gl.glViewport(0, 0, _SIDE, _SIDE)
        gl.glDepthRange(0.0, 1.0)
        gl.glMatrixMode(GL_PROJECTION)
        gl.glLoadIdentity()
        gl.glOrtho(-radius, radius, -radius, radius, -radius, radius)
        gl.glMatrixMode(GL_MODELVIEW)
        gl.glLoadIdentity()

    try:
        yield set_stage
    finally:
        gl.glPopClientAttrib()
        settle_attributes()
        gl.glPopAttrib()
        _restore_matrices(saved)
        gl.glFeedbackBuffer(*buffer)


def _save_matrices() -> tuple[int, Any, Any]:
    """The matrix mode, and both matrices as the driver takes them back."""
    modelview, projection = (ctypes.c_float * 16)(), (ctypes.c_float * 16)()
    gl.glGetFloatv(GL_MODELVIEW_MATRIX, modelview)
    gl.glGetFloatv(GL_PROJECTION_MATRIX, projection)
    return integer(GL_MATRIX_MODE), modelview, projection


def _restore_matrices(saved: tuple[int, Any, Any]) -> None:
    mode, modelview, projection = saved
    gl.glMatrixMode(GL_PROJECTION)
    gl.glLoadMatrixf(projection)
    gl.glMatrixMode(GL_MODELVIEW)
    gl.glLoadMatrixf(modelview)
    gl.glMatrixMode(mode)


def _run(
    draw: Callable[[], Any], set_stage: Callable[[float, int], None], radius: float, faces: int
) -> NDArray[np.float32]:
    size = _FIRST_SIZE
    while True:
        buffer = np.empty(size, np.float32)
        set_stage(radius, faces)
        gl.glFeedbackBuffer(size, GL_3D, buffer.ctypes.data)
        gl.glRenderMode(GL_FEEDBACK)
        try:
            draw()
        finally:
            written = gl.glRenderMode(GL_RENDER)
        if written >= 0:
            return buffer[:written]
        size *= 4


def _parse(
    tokens: NDArray[np.float32], radius: float
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Triangles (T, 3, 3) and line segments (L, 2, 3), in object space."""
    at, end = 0, len(tokens)
    triangles: list[NDArray[np.float32]] = []
    lines: list[NDArray[np.float32]] = []
    # Runs of equal tokens are taken at once: lists of 100k triangles are one run.
    while at < end:
        token = int(tokens[at])
        if token == GL_POLYGON_TOKEN:
            sides = int(tokens[at + 1])
            stride = 2 + 3 * sides
            count = _same(tokens[at:], stride, (token, sides))
            block = tokens[at : at + count * stride].reshape(count, stride)
            corners = block[:, 2:].reshape(count, sides, 3)
            triangles.extend(corners[:, each] for each in fan(sides))
            at += count * stride
        elif token in _VERTICES:
            stride = 1 + 3 * _VERTICES[token]
            count = _same(tokens[at:], stride, (token,))
            if _VERTICES[token] == 2:
                block = tokens[at : at + count * stride].reshape(count, stride)
                lines.append(block[:, 1:].reshape(count, 2, 3))
            at += count * stride
        elif token == GL_PASS_THROUGH_TOKEN:
            at += 2
        else:
            break
    return _object_space(triangles, 3, radius), _object_space(lines, 2, radius)


def _same(tokens: NDArray[np.float32], stride: int, head: tuple[int, ...]) -> int:
    """How many records of this stride and head stand at the front."""
    total = len(tokens) // stride
    same, look = 1, 16
    while same < total:  # runs may be short: look only as far as they go
        end = min(total, same + look)
        blocks = tokens[same * stride : end * stride].reshape(-1, stride)
        different = np.zeros(len(blocks), np.bool_)
        for column, value in enumerate(head):
            different |= blocks[:, column] != value
        if different.any():
            return same + int(different.argmax())
        same, look = end, look * 4
    return same


def _object_space(
    parts: list[NDArray[np.float32]], corners: int, radius: float
) -> NDArray[np.float32]:
    if not parts:
        return np.empty((0, corners, 3), np.float32)
    window = np.concatenate(parts).astype(np.float64)
    scale = np.array([2.0 / _SIDE, 2.0 / _SIDE, -2.0])
    space: NDArray[np.float32] = ((window * scale + np.array([-1.0, -1.0, 1.0])) * radius).astype(
        np.float32
    )
    return space


def _batch(
    triangles: NDArray[np.float32], lines: NDArray[np.float32], key: Hashable | None
) -> PolygonBatch:
    positions = np.ascontiguousarray(triangles.reshape(-1, 3))
    count = len(triangles)
    boundary = np.ones(3 * count, np.bool_)
    if len(lines):
        points = np.concatenate([positions, lines.reshape(-1, 3)])
        scale = float(np.abs(points).max()) * 1e-6 + 1e-30
        _, names = np.unique(np.round(points / scale), axis=0, return_inverse=True)
        names = names.reshape(-1)
        total = int(names.max()) + 1
        true_edges = np.unique(_edge_names(names[len(positions) :].reshape(-1, 2), total))
        corners = names[: len(positions)].reshape(-1, 3)
        sides = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2).reshape(-1, 2)
        named = _edge_names(sides, total)
        boundary = np.isin(named, true_edges) & ~_inside_a_face(named, triangles)
    return PolygonBatch(
        positions,
        np.arange(3 * count, dtype=np.int32),
        np.arange(0, 3 * count + 1, 3, dtype=np.int32),
        boundary,
        key,
    )


def _inside_a_face(named: NDArray[np.int64], triangles: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Sides (3T,) between two coplanar triangles: the library cut a flat face into them."""
    t = triangles.astype(np.float64)
    normals = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    with np.errstate(divide="ignore", invalid="ignore"):
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    order = np.argsort(named, kind="stable")
    first, second = order[:-1], order[1:]
    same = named[first] == named[second]
    flat = (normals[first // 3] * normals[second // 3]).sum(axis=1) > 1.0 - 1e-9
    inside = np.zeros(len(named), np.bool_)
    inside[first[same & flat]] = True
    inside[second[same & flat]] = True
    return inside


def _edge_names(pairs: NDArray[Any], total: int) -> NDArray[np.int64]:
    ordered = np.sort(pairs.astype(np.int64), axis=1)
    return ordered[:, 0] * total + ordered[:, 1]
