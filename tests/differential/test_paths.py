"""One shape drawn in every way that OpenGL has: the same picture, lines included."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from contextlib import suppress
from functools import cache

import numpy as np
import pytest
from OpenGL import GL

from glshim.geometry.recovery.mesh import mesh
from tests import look

from .gathering import gathered
from .scenes_lists import recorded
from .test_contexts import INK, VISIBLE, inked
from .world import App, Outcome, run

MESH = look.torus(14, 8, 0.9, 0.45)
QUADS = MESH.corners.reshape(-1, 4)
POINTS = np.ascontiguousarray(MESH.positions, np.float32)
ORDER = np.ascontiguousarray(QUADS.reshape(-1), np.uint32)
UNROLLED = np.ascontiguousarray(POINTS[ORDER])
NORMALS = (mesh(MESH).vertex_normals[mesh(MESH).weld] * 3.0).astype(np.float32)
"""(V, 3) not of unit length: what is sent is what counts."""
SENT = np.ascontiguousarray(NORMALS[ORDER])
Path = Callable[[App], None]
PATHS: dict[str, Path] = {}


def path(function: Path) -> Path:
    PATHS[function.__name__] = function
    return function


def look_down() -> None:
    """A turned torus under light."""
    GL.glEnable(GL.GL_CULL_FACE)
    GL.glRotatef(35.0, 1.0, 0.2, 0.0)
    GL.glColor3f(0.3, 0.6, 0.5)
    GL.glScalef(1.2, 1.2, 1.2)


@path
def immediate_mode(app: App) -> None:
    GL.glBegin(GL.GL_QUADS)
    for point, normal in zip(UNROLLED.tolist(), SENT.tolist(), strict=True):
        GL.glNormal3fv(normal)
        GL.glVertex3fv(point)
    GL.glEnd()


@path
def many_small_primitives(app: App) -> None:
    for quad in QUADS:
        GL.glBegin(GL.GL_POLYGON)
        for corner in quad:
            GL.glNormal3d(*NORMALS[corner].tolist())
            GL.glVertex3f(*POINTS[corner].tolist())
        GL.glEnd()


@path
def the_first_normal_before_each_primitive(app: App) -> None:
    for quad in QUADS:
        GL.glNormal3f(*NORMALS[quad[0]].tolist())
        GL.glBegin(GL.GL_POLYGON)
        for place, corner in enumerate(quad):
            if place:
                GL.glNormal3f(*NORMALS[corner].tolist())
            GL.glVertex3f(*POINTS[corner].tolist())
        GL.glEnd()


@path
def normals_between_the_primitives_of_a_list(app: App) -> None:
    recorded(1, lambda: the_first_normal_before_each_primitive(app))
    GL.glCallList(1)


@path
def homogeneous_vertices(app: App) -> None:
    GL.glBegin(GL.GL_QUADS)
    for (x, y, z), normal in zip(UNROLLED.tolist(), SENT, strict=True):
        GL.glNormal3dv(normal.astype(float))
        GL.glVertex4f(2.0 * x, 2.0 * y, 2.0 * z, 2.0)
    GL.glEnd()


@path
def with_materials_between(app: App) -> None:
    GL.glBegin(GL.GL_QUADS)
    for point, normal in zip(UNROLLED.tolist(), SENT.tolist(), strict=True):
        GL.glNormal3f(*normal)
        GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 3.0)
        GL.glVertex3fv(point)
    GL.glEnd()


@path
def display_list(app: App) -> None:
    recorded(1, lambda: immediate_mode(app))
    GL.glCallList(1)


@path
def list_compiled_and_executed(app: App) -> None:
    recorded(1, lambda: many_small_primitives(app), GL.GL_COMPILE_AND_EXECUTE)


@path
def nested_lists_with_matrices(app: App) -> None:
    def moved() -> None:
        GL.glPushMatrix()
        GL.glTranslatef(0.5, 0.0, 0.25)
        GL.glCallLists([1])
        GL.glPopMatrix()

    def back() -> None:
        GL.glBegin(GL.GL_QUADS)
        for (x, y, z), normal in zip(UNROLLED.astype(float), SENT, strict=True):
            GL.glNormal3fv(normal)
            GL.glVertex3d(x - 0.5, y, z - 0.25)
        GL.glEnd()

    recorded(1, back)
    recorded(2, moved)
    GL.glCallList(2)


@path
def list_of_bare_vertices(app: App) -> None:
    half = len(UNROLLED) // 2

    def vertices(part: slice) -> None:
        for point, normal in zip(UNROLLED[part], SENT[part], strict=True):
            GL.glNormal3fv(normal)
            GL.glVertex3fv(point)

    recorded(1, lambda: vertices(slice(half, None)))
    GL.glListBase(-1 & 0xFFFFFFFF)
    GL.glBegin(GL.GL_QUADS)
    vertices(slice(half))
    GL.glCallLists(np.array([2], np.uint8))
    GL.glEnd()


@path
def begun_and_ended_in_lists(app: App) -> None:
    def begin() -> None:
        GL.glNormal3fv(SENT[0])
        GL.glBegin(GL.GL_QUADS)

    def end() -> None:
        GL.glVertex3fv(UNROLLED[0])
        for point, normal in zip(UNROLLED[1:], SENT[1:], strict=True):
            GL.glNormal3fv(normal)
            GL.glVertex3fv(point)
        GL.glEnd()

    recorded(1, begin)
    recorded(2, end)
    GL.glCallList(1)
    with suppress(GL.GLError):  # PyOpenGL's own: it asks for errors inside the primitive
        GL.glCallList(2)


def _pointer(app: App, points: np.ndarray, normals: np.ndarray) -> None:
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(points.shape[1], GL.GL_FLOAT, 0, app.keeps(points))
    GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
    GL.glNormalPointer(GL.GL_FLOAT, 0, app.keeps(normals))


@path
def draw_arrays(app: App) -> None:
    _pointer(app, UNROLLED, SENT)
    GL.glDrawArrays(GL.GL_QUADS, 0, len(UNROLLED))


@path
def draw_arrays_with_stride_and_doubles(app: App) -> None:
    wide = app.keeps(np.zeros((len(UNROLLED) + 3, 5)))
    wide[3:, 1:4] = UNROLLED
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_DOUBLE, 40, ctypes.c_void_p(wide.ctypes.data + 8))
    normals = app.keeps(np.zeros((len(UNROLLED) + 3, 4)))
    normals[3:, :3] = SENT
    GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
    GL.glNormalPointer(GL.GL_DOUBLE, 32, ctypes.c_void_p(normals.ctypes.data))
    GL.glDrawArrays(GL.GL_QUADS, 3, len(UNROLLED))


@path
def interleaved_arrays(app: App) -> None:
    data = np.hstack([SENT, UNROLLED])
    GL.glInterleavedArrays(GL.GL_N3F_V3F, 0, app.keeps(np.ascontiguousarray(data)))
    GL.glDrawArrays(GL.GL_QUADS, 0, len(UNROLLED))


@path
def draw_elements(app: App) -> None:
    _pointer(app, POINTS, NORMALS)
    GL.glDrawElements(GL.GL_QUADS, len(ORDER), GL.GL_UNSIGNED_INT, app.keeps(ORDER))


@path
def draw_elements_of_bytes(app: App) -> None:
    _pointer(app, POINTS, NORMALS)
    GL.glDrawElements(GL.GL_QUADS, len(ORDER), GL.GL_UNSIGNED_BYTE, app.keeps(ORDER.astype("u1")))


@path
def draw_range_elements(app: App) -> None:
    _pointer(app, POINTS, NORMALS)
    GL.glDrawRangeElements(GL.GL_QUADS, 0, len(POINTS), len(ORDER), GL.GL_UNSIGNED_INT, ORDER)


@path
def base_vertex(app: App) -> None:
    room = np.zeros((5, 3), np.float32)
    _pointer(app, np.vstack([room, POINTS]), np.vstack([room, NORMALS]))
    GL.glDrawElementsBaseVertex(GL.GL_QUADS, len(ORDER), GL.GL_UNSIGNED_INT, ORDER, 5)


@path
def multi_draw_arrays(app: App) -> None:
    _pointer(app, UNROLLED, SENT)
    firsts = np.arange(0, len(UNROLLED), 4, dtype=np.int32)
    GL.glMultiDrawArrays(GL.GL_QUADS, firsts, np.full(len(firsts), 4, np.int32), len(firsts))


@path
def multi_draw_elements(app: App) -> None:
    _pointer(app, POINTS, NORMALS)
    half = len(ORDER) // 8 * 4
    pointers = (ctypes.c_void_p * 2)(ORDER.ctypes.data, ORDER.ctypes.data + 4 * half)
    counts = np.array([half, len(ORDER) - half], np.int32)
    GL.glMultiDrawElements(GL.GL_QUADS, counts, GL.GL_UNSIGNED_INT, pointers, 2)


@path
def array_elements(app: App) -> None:
    _pointer(app, POINTS, NORMALS)
    GL.glBegin(GL.GL_QUADS)
    for index in ORDER:
        GL.glArrayElement(int(index))
    GL.glEnd()


@path
def array_elements_in_a_list(app: App) -> None:
    _pointer(app, POINTS, NORMALS)

    def body() -> None:
        GL.glBegin(GL.GL_QUADS)
        for place, index in enumerate(ORDER.tolist()):
            if place % 3:
                GL.glArrayElement(index)
            else:
                GL.glNormal3fv(NORMALS[index])
                GL.glVertex3fv(POINTS[index])
        GL.glEnd()

    recorded(1, body)
    GL.glDisableClientState(GL.GL_NORMAL_ARRAY)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    GL.glCallList(1)


def _buffer(target: int, data: np.ndarray) -> int:
    name = GL.glGenBuffers(1)
    GL.glBindBuffer(target, name)
    GL.glBufferData(target, data, GL.GL_STATIC_DRAW)
    return int(name)


@path
def buffer_object(app: App) -> None:
    _buffer(GL.GL_ARRAY_BUFFER, np.hstack([UNROLLED, SENT]))
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 24, ctypes.c_void_p(0))
    GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
    GL.glNormalPointer(GL.GL_FLOAT, 24, ctypes.c_void_p(12))
    GL.glDrawArrays(GL.GL_QUADS, 0, len(UNROLLED))


@path
def indexed_buffer_objects_rewritten(app: App) -> None:
    _buffer(GL.GL_ARRAY_BUFFER, NORMALS)
    GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
    GL.glNormalPointer(GL.GL_FLOAT, 0, ctypes.c_void_p(0))
    _buffer(GL.GL_ARRAY_BUFFER, np.zeros_like(POINTS))
    _buffer(GL.GL_ELEMENT_ARRAY_BUFFER, ORDER)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))
    for data in (None, POINTS):
        if data is not None:
            GL.glBufferSubData(GL.GL_ARRAY_BUFFER, 0, data)
        GL.glDrawElements(GL.GL_QUADS, len(ORDER), GL.GL_UNSIGNED_INT, ctypes.c_void_p(0))


@path
def vertex_array_object(app: App) -> None:
    GL.glBindVertexArray(GL.glGenVertexArrays(1))
    buffer_object(app)


@path
def arrays_in_a_list(app: App) -> None:
    points, normals = UNROLLED.copy(), SENT.copy()
    _pointer(app, points, normals)
    recorded(1, lambda: GL.glDrawArrays(GL.GL_QUADS, 0, len(points)))
    points[:], normals[:] = 0.0, 0.0
    GL.glDisableClientState(GL.GL_NORMAL_ARRAY)
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    GL.glCallList(1)


@cache
def reference() -> Outcome:
    return run(lambda app: [look_down(), immediate_mode(app)][0], VISIBLE)


def test_the_reference_has_lines() -> None:
    assert inked(reference()) > 250


ROUNDED = ("nested_lists_with_matrices", "homogeneous_vertices")
"""Positions that pass through other floats: pixels may fall on the other side of an edge."""


@pytest.mark.parametrize("name", PATHS)
def test_every_path_gives_the_same_lines(name: str) -> None:
    outcome = run(lambda app: [look_down(), PATHS[name](app)][0], VISIBLE)
    assert [said for said in outcome.saw if said != "0"] == []
    different = (outcome.picture != reference().picture).any(axis=2)
    assert different.sum() <= (12 if name in ROUNDED else 0)



@pytest.mark.parametrize("name", PATHS)
def test_every_path_gives_the_normals_that_were_sent(name: str) -> None:
    batches = gathered(PATHS[name])
    assert all(batch.normals is not None for batch in batches)
    points = np.concatenate([b.positions[b.corners] for b in batches])
    normals = np.concatenate([b.normals for b in batches])
    if name == "indexed_buffer_objects_rewritten":  # its first draw has no extent
        points, normals = points[len(ORDER) :], normals[len(ORDER) :]
    assert points.shape == normals.shape == (len(ORDER), 3)
    apart = np.abs(points[:, None] - POINTS).max(axis=2)
    assert apart.min(axis=1).max() < 1e-6
    assert np.abs(normals - NORMALS[apart.argmin(axis=1)]).max() <= 1e-6


@pytest.mark.parametrize("name", PATHS)
def test_a_style_that_does_not_ask_gets_no_normals(name: str) -> None:
    batches = gathered(PATHS[name], normals=False)
    assert batches and all(batch.normals is None for batch in batches)


def test_rectangles_are_quads() -> None:
    def rectangles(app: App) -> None:
        look_down()
        GL.glRectf(-0.5, -0.25, 0.5, 0.75)
        GL.glTranslatef(-1.2, 0, 0)
        GL.glRectiv([0, 0], [1, -1])

    def quads(app: App) -> None:
        look_down()
        for move, (x1, y1, x2, y2) in ((0, (-0.5, -0.25, 0.5, 0.75)), (-1.2, (0, 0, 1, -1))):
            GL.glTranslatef(move, 0, 0)
            GL.glBegin(GL.GL_QUADS)
            for corner in ((x1, y1), (x2, y1), (x2, y2), (x1, y2)):
                GL.glVertex2f(*corner)
            GL.glEnd()

    outcome = run(rectangles, VISIBLE)
    assert inked(outcome) > 30
    assert (outcome.picture == run(quads, VISIBLE).picture).all()


@pytest.mark.parametrize("fill", ["none", "#123456"])
@pytest.mark.parametrize("name", ["immediate_mode", "many_small_primitives", "display_list",
                                  "buffer_object", "array_elements"])  # fmt: skip
def test_fill_replaces_the_surfaces_and_no_state(name: str, fill: str) -> None:
    def scene(app: App) -> None:
        look_down()
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFunc(GL.GL_ONE, GL.GL_ONE)
        PATHS[name](app)

    plain, filled = run(scene), run(scene, f"{VISIBLE},fill={fill}")
    assert plain.differences(filled, pictures=False) == {}
    surface = (128, 128, 128) if fill == "none" else (0x12, 0x34, 0x56)
    colours = np.unique(filled.picture[..., :3].reshape(-1, 3), axis=0).astype(float)
    assert {(128, 128, 128), surface, INK} <= {tuple(map(int, colour)) for colour in colours}
    # Anything else is ink that covers a part of a pixel.
    apart = [_off_the_mix(colours, base) for base in ((128, 128, 128), surface)]
    assert (np.min(apart, axis=0) <= 1.5).all()


def _off_the_mix(colours: np.ndarray, base: tuple[int, ...]) -> np.ndarray:
    """How far colours (N, 3) are from being mixed of a base colour and ink."""
    span = np.subtract(INK, base).astype(float)
    share = np.clip((colours - base) @ span / (span @ span), 0.0, 1.0)
    return np.abs(colours - base - share[:, None] * span).max(axis=1)


def test_a_hud_stays_on_top_and_unlined() -> None:
    def with_hud(depth: bool) -> Callable[[App], None]:
        def scene(app: App) -> None:
            look_down()
            immediate_mode(app)
            GL.glMatrixMode(GL.GL_PROJECTION)
            GL.glLoadIdentity()
            GL.glMatrixMode(GL.GL_MODELVIEW)
            GL.glLoadIdentity()
            GL.glDisable(GL.GL_CULL_FACE)
            if not depth:
                GL.glDisable(GL.GL_DEPTH_TEST)
            GL.glColor3f(1.0, 1.0, 0.0)
            GL.glBegin(GL.GL_QUADS)
            for corner in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
                GL.glVertex3f(*corner, -1.0)
            GL.glEnd()

        return scene

    for depth in (False, True):
        outcome = run(with_hud(depth), VISIBLE)
        hud = np.zeros((72, 96), bool)
        hud[18:54, 24:72] = True
        assert (outcome.picture[hud][:, :3] == (255, 255, 0)).all()
        assert (outcome.picture[~hud] == reference().picture[~hud]).all()
