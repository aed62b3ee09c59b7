"""Normals in all their forms, and which one holds where a primitive says none."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

import numpy as np
import pytest
from OpenGL import GL, GLU

from glshim.model.batch import PolygonBatch

from .gathering import gathered
from .scenes_lists import recorded

SQUARE = np.float32([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)])
UP, SIDE, UNKNOWN, FIRST = (0.0, 2.0, 0.0), (1.0, 0.0, 1.0), (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
"""FIRST: what every context begins with."""
Body = Callable[[], object]


def square(*normals: tuple[float, ...], x: float = 0.0) -> None:
    """A quad; it says the normals before its first corners."""
    GL.glBegin(GL.GL_QUADS)
    for place, (u, v, w) in enumerate(SQUARE.tolist()):
        if place < len(normals):
            GL.glNormal3f(*normals[place])
        GL.glVertex3f(u + x, v, w)
    GL.glEnd()


def batches(body: Body) -> list[PolygonBatch]:
    return gathered(lambda app: [body()][0] and None)


def normals(body: Body) -> list[tuple[float, ...]]:
    """The normal at every corner of what a body draws, in order; UNKNOWN without any."""
    found: list[tuple[float, ...]] = []
    for batch in batches(body):
        given = batch.normals
        if given is None:
            given = np.zeros((len(batch.corners), 3))
        found += map(tuple, np.round(given, 6).tolist())
    return found


def flat(body: Body) -> list[tuple[float, ...]]:
    """The normal of every quad, which must be the same at its corners."""
    found = normals(body)
    corners = [found[at : at + 4] for at in range(0, len(found), 4)]
    assert all(len(set(quad)) == 1 for quad in corners)
    return [quad[0] for quad in corners]


PACKED = (511 << 20) | (-100 & 1023) << 10 | 7
FORMS: dict[str, tuple[object, ...]] = {
    "glNormal3b": (127, -128, 3), "glNormal3bv": ([1, -1, 100],),
    "glNormal3s": (32767, -5, 300), "glNormal3sv": ([-32768, 1000, 0],),
    "glNormal3i": (2**31 - 1, -(2**31), 5), "glNormal3iv": ([10**9, -(10**9), 7],),
    "glNormal3f": (0.1, 2.0, -3.0), "glNormal3fv": ([0.5, -0.25, 8.0],),
    "glNormal3d": (0.1, 2.0, -3.0), "glNormal3dv": ([0.5, -0.25, 8.0],),
    "glNormalP3ui": (GL.GL_INT_2_10_10_10_REV, PACKED),
    "glNormalP3uiv": (GL.GL_UNSIGNED_INT_2_10_10_10_REV, [PACKED]),
}  # fmt: skip


def arguments(name: str) -> list[object]:
    """A NumPy array for every list but those of glNormal3dv, which stays one."""
    letter = name.rstrip("v")[-1]
    dtypes = {"b": np.int8, "s": np.int16, "f": np.float32, "i": np.int32}
    dtype = np.uint32 if "P3ui" in name else dtypes.get(letter)
    return [np.array(a, dtype) if isinstance(a, list) and dtype else a for a in FORMS[name]]


@pytest.mark.parametrize("where", ["inside", "before", "in a list", "before, in a list"])
@pytest.mark.parametrize("name", FORMS)
def test_every_form_is_what_the_driver_takes_it_for(name: str, where: str) -> None:
    driver: list[np.ndarray] = []

    def say() -> None:
        getattr(GL, name)(*arguments(name))

    def draw() -> None:
        if "before" in where:
            say()
        GL.glBegin(GL.GL_QUADS)
        for place, corner in enumerate(SQUARE.tolist()):
            if place == 0 and "before" not in where:
                say()
            GL.glVertex3f(*corner)
        GL.glEnd()

    def body() -> None:
        GL.glNormal3f(*SIDE)
        if "list" in where:
            recorded(1, draw)
            GL.glCallList(1)
        else:
            draw()
        driver.append(np.array(GL.glGetFloatv(GL.GL_CURRENT_NORMAL)))

    found = flat(body)
    assert len(found) == 1 and found[0] != SIDE
    assert np.allclose(found[0], driver[0], atol=1e-6)


ARRAYS = {
    "bytes": (GL.GL_BYTE, np.int8([(127, -128, 3)] * 4), (255 / 255, -255 / 255, 7 / 255)),
    "shorts": (GL.GL_SHORT, np.int16([(32767, 0, -3)] * 4), (1.0, 1 / 65535, -5 / 65535)),
    "ints": (GL.GL_INT, np.int32([(2**31 - 1, -(2**31), 2**30)] * 4), (1.0, -1.0, 0.5)),
    "floats": (GL.GL_FLOAT, np.float32([UP] * 4), UP),
    "doubles": (GL.GL_DOUBLE, np.float64([SIDE] * 4), SIDE),
    "halves": (GL.GL_HALF_FLOAT, np.float16([SIDE] * 4), SIDE),
}  # fmt: skip


@pytest.mark.parametrize("elements", [False, True])
@pytest.mark.parametrize("stored", [False, True])
@pytest.mark.parametrize("kind", ARRAYS)
def test_arrays_of_every_type(kind: str, stored: bool, elements: bool) -> None:
    type_, data, wanted = ARRAYS[kind]
    stride = data.itemsize * data[0].size + 4  # bytes are not aligned to four: let them be
    wide = np.zeros((5, stride), np.uint8)
    wide[1:, : stride - 4] = data.reshape(4, -1).view(np.uint8)
    points = np.vstack([SQUARE[:1], SQUARE])

    def pointer(array: np.ndarray) -> ctypes.c_void_p:
        if not stored:
            return ctypes.c_void_p(array.ctypes.data)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, GL.glGenBuffers(1))
        GL.glBufferData(GL.GL_ARRAY_BUFFER, array, GL.GL_STATIC_DRAW)
        return ctypes.c_void_p(0)

    def body() -> None:
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, pointer(points))
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glNormalPointer(type_, stride, pointer(wide))
        if elements:
            GL.glBegin(GL.GL_QUADS)
            for index in range(1, 5):
                GL.glArrayElement(index)
            GL.glEnd()
        else:
            GL.glDrawArrays(GL.GL_QUADS, 1, 4)

    (found,) = flat(body)
    assert np.allclose(found, wanted, atol=2e-6)


def test_the_current_normal_holds_until_another_is_said() -> None:
    def body() -> None:
        square()
        GL.glNormal3f(*UP)
        square(x=1)
        square(SIDE, x=2)
        square(x=3)
        GL.glRectf(0, 0, 1, 1)
        GL.glNormal3f(*UP)
        GL.glRectiv([0, 0], [1, 1])

    # Primitives of one length are assembled together: the third has four records more.
    assert sorted(flat(body)) == sorted([FIRST, UP, SIDE, SIDE, SIDE, UP])


def arrays() -> None:
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, SQUARE)
    GL.glDrawArrays(GL.GL_QUADS, 0, 4)


def test_arrays_without_normals_have_the_current_one() -> None:
    def body() -> None:
        GL.glNormal3f(*UP)
        arrays()

    assert flat(body) == [UP]


def listed(*bodies: Body, before: tuple[float, ...] = SIDE) -> Body:
    """Bodies as lists 1, 2, ..., the last of which is called, under a normal of the caller's."""

    def body() -> None:
        for number, each in enumerate(bodies, 1):
            recorded(number, each)
        GL.glNormal3f(*before)
        GL.glCallList(len(bodies))

    return body


def test_a_list_does_not_know_the_normal_of_its_caller() -> None:
    assert flat(listed(square)) == [UNKNOWN]
    assert flat(listed(lambda: GL.glRectf(0, 0, 1, 1))) == [UNKNOWN]
    assert flat(listed(arrays)) == [UNKNOWN]


def test_the_caller_has_the_normal_that_a_list_leaves() -> None:
    def body() -> None:
        listed(lambda: square(UP))()
        square()

    assert flat(body) == [UP, UP]


@pytest.mark.parametrize(
    "draw", [square, arrays, lambda: GL.glRectf(0, 0, 1, 1)], ids=["begun", "arrays", "rectangle"]
)
def test_normals_of_a_list_come_in_the_order_they_were_said(draw: Body) -> None:
    def body() -> None:
        GL.glNormal3f(*UP)
        draw()
        GL.glNormal3f(*SIDE)
        draw()
        GL.glPushAttrib(GL.GL_CURRENT_BIT)
        GL.glNormal3f(*UP)
        draw()
        GL.glPopAttrib()
        draw()
        GL.glPushAttrib(GL.GL_ENABLE_BIT)
        GL.glNormal3f(*UP)
        GL.glPopAttrib()
        draw()

    assert flat(listed(body)) == [UP, SIDE, UP, SIDE, UP]


def test_normals_go_into_nested_lists_and_come_out() -> None:
    def outer() -> None:
        GL.glNormal3f(*UP)
        GL.glCallList(1)
        square(x=4)

    def inner() -> None:
        square()
        GL.glNormal3f(*SIDE)

    assert flat(listed(inner, outer)) == [UP, SIDE]


def test_what_may_have_set_the_normal_leaves_it_unknown() -> None:
    def after(what: Body) -> Body:
        def body() -> None:
            GL.glNormal3f(*UP)
            square()
            what()
            square()

        return listed(body)

    def with_normals() -> None:
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glNormalPointer(GL.GL_FLOAT, 0, np.tile(np.float32(SIDE), (4, 1)))
        arrays()
        GL.glDisableClientState(GL.GL_NORMAL_ARRAY)

    assert flat(after(lambda: GL.glCallList(77))) == [UP, UNKNOWN]
    assert flat(after(with_normals)) == [UP, SIDE, UNKNOWN]
    quadric = GLU.gluNewQuadric()
    sphere = normals(after(lambda: GLU.gluSphere(quadric, 1.0, 6, 5)))
    assert sphere[:4] == [UP] * 4 and len(sphere) > 60
    assert set(sphere[4:]) == {UNKNOWN}


def test_normals_of_shapes_are_not_known() -> None:
    quadric = GLU.gluNewQuadric()
    (batch,) = batches(lambda: GLU.gluSphere(quadric, 1.0, 6, 5))
    assert len(batch.corners) > 60 and batch.normals is None


@pytest.mark.parametrize("mirrored", [False, True])
def test_normals_of_a_list_go_with_its_matrices(mirrored: bool) -> None:
    linear = np.diag([2.0, 0.5, -3.0 if mirrored else 3.0])
    linear[0, 1] = 0.75
    sent = (0.0, 0.0, 4.0), (1.0, 2.0, 3.0), (0.0, -1.0, 1.0), (5.0, 0.0, 0.0)

    def body() -> None:
        matrix = np.eye(4)
        matrix[:3, :3] = linear
        GL.glMultMatrixd(matrix.T)
        square(*sent)

    (batch,) = batches(listed(body))
    assert batch.normals is not None
    wanted = np.array(sent) @ np.linalg.inv(linear)
    points = SQUARE @ linear.T
    if mirrored:  # corners run the other way round
        wanted, points = wanted[::-1], points[::-1]
    assert np.allclose(batch.normals, wanted, atol=1e-6)
    assert np.allclose(batch.positions[batch.corners], points, atol=1e-6)


def test_a_flat_matrix_leaves_normals_unknown() -> None:
    def body() -> None:
        GL.glScalef(1.0, 1.0, 0.0)
        square(UP)

    assert flat(listed(body)) == [UNKNOWN]


def test_keys_tell_normals_apart() -> None:
    def body() -> None:
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, GL.glGenBuffers(1))
        data = np.vstack([SQUARE, np.tile(np.float32(SIDE), (4, 1))])
        GL.glBufferData(GL.GL_ARRAY_BUFFER, data, GL.GL_DYNAMIC_DRAW)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))
        GL.glNormalPointer(GL.GL_FLOAT, 0, ctypes.c_void_p(48))
        for normal in (UP, SIDE, UP):
            GL.glNormal3f(*normal)
            GL.glDrawArrays(GL.GL_QUADS, 0, 4)
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glDrawArrays(GL.GL_QUADS, 0, 4)
        GL.glBufferSubData(GL.GL_ARRAY_BUFFER, 48, 48, np.tile(np.float32(UP), (4, 1)))
        GL.glDrawArrays(GL.GL_QUADS, 0, 4)

    found = batches(body)
    keys = [batch.key for batch in found]
    assert None not in keys and keys[0] == keys[2]
    assert len(set(keys)) == 4
    assert [tuple(b.normals[0].tolist()) for b in found] == [UP, SIDE, UP, SIDE, UP]
    plain = gathered(lambda app: [body()][0], normals=False)
    assert not {batch.key for batch in plain} & set(keys)


def test_normals_that_cannot_be_had_leave_the_polygons() -> None:
    def body() -> None:
        GL.glNormal3f(*UP)
        GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
        GL.glVertexPointer(3, GL.GL_FLOAT, 0, SQUARE)
        GL.glEnableClientState(GL.GL_NORMAL_ARRAY)
        GL.glBindBuffer(GL.GL_ARRAY_BUFFER, GL.glGenBuffers(1))
        GL.glBufferData(GL.GL_ARRAY_BUFFER, np.zeros(9, np.float32), GL.GL_STATIC_DRAW)
        GL.glNormalPointer(GL.GL_FLOAT, 0, ctypes.c_void_p(0))  # three of four
        GL.glDrawArrays(GL.GL_QUADS, 0, 4)

    assert flat(body) == [UNKNOWN]
