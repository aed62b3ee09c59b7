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

from glshim.model.batch import PolygonBatch
from glshim.model.polygons import fan
from glshim.spec.driver import gl

if TYPE_CHECKING:
    from collections.abc import Iterator

_FEEDBACK, _RENDER = 0x1C01, 0x1C00
_GL_3D = 0x0601
_POINT, _LINE, _POLYGON, _BITMAP, _DRAW_PIXEL, _COPY_PIXEL, _LINE_RESET, _PASS = (
    0x0701, 0x0702, 0x0703, 0x0704, 0x0705, 0x0706, 0x0707, 0x0700,
)  # fmt: skip
_VERTICES = {_POINT: 1, _LINE: 2, _BITMAP: 1, _DRAW_PIXEL: 1, _COPY_PIXEL: 1, _LINE_RESET: 2}
_FILLED, _LINES = 0x1B02, 0x1B01
_OFF = (0x0B44, 0x0B50, 0x0B60, 0x8037, 0x0BC0, 0x0B42, 0x0B24,
        0x3000, 0x3001, 0x3002, 0x3003, 0x3004, 0x3005)  # fmt: skip
"""Culling, lighting, fog, polygon offset, alpha test, stipple, clip planes: not in the way."""
_STACKS = ((0x0BB0, 0x0D35), (0x0BB1, 0x0D3B))
"""Depths of the attribute stacks, and their limits."""
_SIDE = 1024
_FIRST_RADIUS = 1.0e6
_COARSE = 2.0**-21
_FIRST_SIZE = 1 << 20


def polygons(draw: Callable[[], Any], key: Hashable | None = None) -> PolygonBatch | None:
    """What ``draw`` draws, in the space that was current when it was called; None when nothing.

    Costs three or four runs of ``draw``: call once and keep the result. The GL state that ``draw``
    changes is put back, matrices included. Call outside glBegin/glEnd and open display lists.
    """
    with _stage() as set_stage:
        radius = _FIRST_RADIUS
        while True:
            triangles, _ = _parse(_run(draw, set_stage, radius, _FILLED), radius)
            if not len(triangles):
                return None
            # Window coordinates are floats: what comes back is as coarse as the stage is large.
            reach = float(np.abs(triangles).max()) * 1.01 + radius * _COARSE
            if reach > radius / 16.0:
                break
            radius = reach
        _, lines = _parse(_run(draw, set_stage, radius, _LINES), radius)
    return _batch(triangles, lines, key)


def possible() -> bool:
    """Whether there is room on the attribute stacks. Ask before :func:`polygons`."""
    depth, limit = ctypes.c_int(), ctypes.c_int()
    for name, most in _STACKS:
        gl.glGetIntegerv(name, ctypes.byref(depth))
        gl.glGetIntegerv(most, ctypes.byref(limit))
        if depth.value >= limit.value:
            return False
    return True


@contextmanager
def _stage() -> Iterator[Callable[[float, int], None]]:
    """Feedback's surroundings: a callable that sets them up, undone at the end."""
    pointer, size, kind = ctypes.c_void_p(), ctypes.c_int(), ctypes.c_int()
    gl.glGetPointerv(0x0DF0, ctypes.byref(pointer))
    gl.glGetIntegerv(0x0DF1, ctypes.byref(size))
    gl.glGetIntegerv(0x0DF2, ctypes.byref(kind))
    error = gl.glGetError()
    saved = _save_matrices()
    gl.glPushAttrib(0xFFFFFFFF)
    gl.glPushClientAttrib(0xFFFFFFFF)

    def set_stage(radius: float, faces: int) -> None:
        for switch in _OFF:
            gl.glDisable(switch)
        gl.glPolygonMode(0x0408, faces)
        gl.glViewport(0, 0, _SIDE, _SIDE)
        gl.glDepthRange(0.0, 1.0)
        gl.glMatrixMode(0x1701)
        gl.glLoadIdentity()
        gl.glOrtho(-radius, radius, -radius, radius, -radius, radius)
        gl.glMatrixMode(0x1700)
        gl.glLoadIdentity()

    try:
        yield set_stage
    finally:
        gl.glPopClientAttrib()
        gl.glPopAttrib()
        _restore_matrices(saved)
        gl.glFeedbackBuffer(size.value, kind.value, pointer)
        while gl.glGetError():
            pass
        if error:
            _raise_flag(error)


def _raise_flag(error: int) -> None:
    """Set the GL error flag again that the app has not asked for yet."""
    if error == 0x0500:
        gl.glEnable(0xFFFF)
    elif error == 0x0501:
        gl.glViewport(0, 0, -1, -1)
    else:
        gl.glEnd()


def _save_matrices() -> tuple[int, Any, Any]:
    mode = ctypes.c_int()
    modelview, projection = (ctypes.c_float * 16)(), (ctypes.c_float * 16)()
    gl.glGetIntegerv(0x0BA0, ctypes.byref(mode))
    gl.glGetFloatv(0x0BA6, modelview)
    gl.glGetFloatv(0x0BA7, projection)
    return mode.value, modelview, projection


def _restore_matrices(saved: tuple[int, Any, Any]) -> None:
    mode, modelview, projection = saved
    gl.glMatrixMode(0x1701)
    gl.glLoadMatrixf(projection)
    gl.glMatrixMode(0x1700)
    gl.glLoadMatrixf(modelview)
    gl.glMatrixMode(mode)


def _run(
    draw: Callable[[], Any], set_stage: Callable[[float, int], None], radius: float, faces: int
) -> NDArray[np.float32]:
    size = _FIRST_SIZE
    while True:
        buffer = np.empty(size, np.float32)
        set_stage(radius, faces)
        gl.glFeedbackBuffer(size, _GL_3D, buffer.ctypes.data)
        gl.glRenderMode(_FEEDBACK)
        try:
            draw()
        finally:
            written = gl.glRenderMode(_RENDER)
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
        if token == _POLYGON:
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
        elif token == _PASS:
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
