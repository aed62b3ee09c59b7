"""Scenes of display lists, and of arrays and buffer objects."""

from __future__ import annotations

import ctypes
from collections.abc import Callable

import numpy as np
from OpenGL import GL, GLU
from OpenGL.arrays import vbo

from .registry import each, scene
from .scenes_immediate import MODES, shade, spiral
from .scenes_state import mesh
from .world import App, restart_at

COMPILE = {"compile": GL.GL_COMPILE, "execute": GL.GL_COMPILE_AND_EXECUTE}


def square(size: float = 0.5) -> None:
    GL.glBegin(GL.GL_QUADS)
    for i, (x, y) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
        GL.glColor3f(*shade(i))
        GL.glVertex2f(x * size, y * size)
    GL.glEnd()


def recorded(name: int, body: Callable[[], None], mode: int = GL.GL_COMPILE) -> None:
    GL.glNewList(name, mode)
    body()
    GL.glEndList()


@each({f"{how}-{count}": (mode, count) for how, mode in COMPILE.items() for count in (12, 300)})
def lists_of_everything(app: App, which: tuple[int, int]) -> None:
    mode, count = which
    quadric = GLU.gluNewQuadric()

    def body() -> None:
        mesh(count)
        GL.glPushMatrix()
        GL.glTranslatef(0.3, 0.2, 0.1)
        GL.glRotatef(20, 0, 0, 1)
        GL.glScalef(-0.5, 0.5, 0.5)
        GL.glFrontFace(GL.GL_CW)
        mesh(count, colours=False)
        GL.glPopMatrix()
        GL.glRectf(-0.2, -0.9, 0.2, -0.6)
        GLU.gluSphere(quadric, 0.2, 6, 5)
        GL.glDisable(GL.GL_DEPTH_TEST)
        GL.glColor3ub(200, 100, 50)
        GL.glMaterialfv(GL.GL_FRONT, GL.GL_DIFFUSE, (0.3, 0.4, 0.5, 1))
        square(0.1)
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glPushAttrib(GL.GL_ENABLE_BIT)

    recorded(1, body, mode)
    app.asks(GL.GL_CURRENT_COLOR, GL.GL_MODELVIEW_MATRIX)
    for _ in range(2):
        GL.glTranslatef(0.2, 0.1, -0.1)
        app.tries(GL.glCallList, 1)
    app.asks(GL.GL_CURRENT_COLOR, GL.GL_ATTRIB_STACK_DEPTH)


@each(COMPILE)
def nested_lists_defined_later(app: App, mode: int) -> None:
    recorded(3, lambda: [GL.glTranslatef(0.1, 0, 0), GL.glCallList(4), GL.glCallList(5)][0], mode)
    recorded(4, square)
    app.tries(GL.glCallList, 3)
    recorded(5, lambda: GL.glRectf(0, 0, 0.3, 0.9))
    app.tries(GL.glCallList, 3)
    recorded(4, lambda: mesh(30))
    app.tries(GL.glCallList, 3)
    GL.glDeleteLists(5, 1)
    app.tries(GL.glCallList, 3)
    app.tries(GL.glIsList, 5)
    recorded(6, lambda: GL.glCallList(6))  # endless
    app.tries(GL.glCallList, 6)


def _each_called(app: App, names: tuple[int, ...]) -> None:
    for name in names:
        app.tries(GL.glCallList, name)


TYPES = {
    "byte": (GL.GL_BYTE, "i1"), "ubyte": (GL.GL_UNSIGNED_BYTE, "u1"), "short": (GL.GL_SHORT, "i2"),
    "ushort": (GL.GL_UNSIGNED_SHORT, "u2"), "int": (GL.GL_INT, "i4"),
    "uint": (GL.GL_UNSIGNED_INT, "u4"), "float": (GL.GL_FLOAT, "f4"),
}  # fmt: skip


@each(TYPES)
def call_lists_of_type(app: App, which: tuple[int, str]) -> None:
    from OpenGL.raw.GL.VERSION import GL_1_1 as raw

    type_, dtype = which
    for k in range(4):
        recorded(70 + k, lambda k=k: [GL.glTranslatef(0.3, 0, 0), square(0.1 + 0.05 * k)][0])
    names = app.keeps(np.array([0, 2, 1, 3], dtype))
    GL.glListBase(70)
    app.tries(raw.glCallLists, 4, type_, names)
    app.tries(GL.glCallLists, names)
    app.tries(GL.glCallLists, [0, 1])
    GL.glListBase(70 - ord("a"))
    app.tries(GL.glCallLists, "abd")
    app.tries(GL.glCallLists, b"ca")
    recorded(90, lambda: [GL.glListBase(71), GL.glCallLists(names[:2])][0])
    app.tries(GL.glCallList, 90)
    app.asks(GL.GL_LIST_BASE)
    two_bytes = app.keeps(np.array([0, 72], "u1"))
    GL.glListBase(0)
    app.tries(raw.glCallLists, 1, GL.GL_2_BYTES, two_bytes)


@each({f"{how}-{count}": (mode, count) for how, mode in COMPILE.items() for count in (9, 300)})
def begun_in_one_list_and_ended_in_another(app: App, which: tuple[int, int]) -> None:
    mode, count = which
    points = spiral(count)

    def vertices(part: slice) -> None:
        for i, point in enumerate(points[part]):
            GL.glColor3f(*shade(i))
            GL.glVertex3fv(point)

    third = count // 3
    recorded(1, lambda: [GL.glBegin(GL.GL_TRIANGLES), vertices(slice(third))][0])
    recorded(2, lambda: vertices(slice(third, 2 * third)))
    recorded(3, lambda: [vertices(slice(2 * third, count)), GL.glEnd()][0])
    for name in (1, 2, 3):
        app.tries(GL.glCallList, name)
    app.error()
    GL.glTranslatef(0.3, 0.2, 0.1)
    GL.glBegin(GL.GL_TRIANGLES)
    vertices(slice(third))
    app.tries(GL.glCallList, 2)
    GL.glCallLists([2])
    vertices(slice(third))
    app.tries(GL.glEnd)
    app.error()
    GL.glTranslatef(0.3, 0.2, 0.1)
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    vertices(slice(third))
    app.tries(GL.glCallList, 3)
    app.error()
    app.tries(GL.glEnd)
    recorded(4, lambda: _each_called(app, (1, 2, 3)), mode)
    app.tries(GL.glCallList, 4)
    app.error()
    recorded(7, lambda: [GL.glBegin(GL.GL_POLYGON), vertices(slice(5)), GL.glCallList(2),
                         vertices(slice(4)), GL.glEnd()][0], mode)  # fmt: skip
    app.tries(GL.glCallList, 7)
    app.asks(GL.GL_CURRENT_COLOR)


@each(COMPILE)
def errors_while_compiling(app: App, mode: int) -> None:
    app.tries(GL.glNewList, 1, mode)
    app.tries(GL.glNewList, 2, mode)
    app.tries(GL.glEnd)
    app.tries(GL.glEnable, 0xFFFF)
    app.tries(GL.glBegin, GL.GL_QUADS)
    app.tries(GL.glTranslatef, 1, 1, 1)
    app.tries(GL.glVertex3f, "a", 1, 1)
    app.tries(GL.glBegin, GL.GL_QUADS)
    app.tries(GL.glVertex3f, 0, 1, 1)
    app.tries(GL.glEnd)
    app.tries(GL.glGetFloatv, GL.GL_CURRENT_COLOR)
    app.error()
    app.tries(GL.glGenLists, 2)
    app.tries(GL.glReadPixels, 0, 0, 1, 1, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    app.tries(GL.glFlush)
    app.tries(GL.glFinish)
    app.tries(GL.glEndList)
    app.tries(GL.glEndList)
    app.tries(GL.glCallList, 1)
    app.error()
    app.tries(square)


@scene
def list_compiled_across_an_exception(app: App) -> None:
    def fails() -> None:
        GL.glNewList(9, GL.GL_COMPILE)
        square()
        raise KeyError("the app's own")

    app.tries(fails)
    app.tries(GL.glClear, GL.GL_COLOR_BUFFER_BIT)
    app.tries(square, 0.9)
    app.tries(GL.glEndList)
    app.tries(GL.glCallList, 9)


@scene
def arrays_read_when_the_list_is_compiled(app: App) -> None:
    points = app.keeps(np.array(spiral(30), np.float32))
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
    GL.glNewList(1, GL.GL_COMPILE)
    GL.glDrawArrays(GL.GL_TRIANGLE_STRIP, 0, 20)
    GL.glBegin(GL.GL_TRIANGLES)
    for i in (20, 24, 28):
        GL.glArrayElement(i)
    GL.glEnd()
    GL.glEndList()
    points[:] = 0.0
    GL.glDisableClientState(GL.GL_VERTEX_ARRAY)
    app.tries(GL.glCallList, 1)


def _client(app: App, points: np.ndarray, colours: np.ndarray) -> None:
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, app.keeps(points))
    GL.glColorPointer(3, GL.GL_FLOAT, 0, app.keeps(colours))


def _buffers(app: App, points: np.ndarray, colours: np.ndarray) -> None:
    buffer = app.keeps(vbo.VBO(np.concatenate([points, colours])))
    buffer.bind()
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, buffer)
    GL.glColorPointer(3, GL.GL_FLOAT, 0, buffer + points.nbytes)
    buffer.unbind()


def _interleaved(app: App, points: np.ndarray, colours: np.ndarray) -> None:
    GL.glInterleavedArrays(GL.GL_C3F_V3F, 0, app.keeps(np.hstack([colours, points])))


@each({f"{f.__name__[1:]}-{mode}": (f, value) for f in (_client, _buffers, _interleaved)
       for mode, value in MODES.items()})  # fmt: skip
def array_draws(app: App, which: tuple[Callable[..., None], int]) -> None:
    source, mode = which
    points = np.array(spiral(60), np.float32)
    colours = np.array([shade(i) for i in range(60)], np.float32)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glEnableClientState(GL.GL_COLOR_ARRAY)
    source(app, points, colours)
    indices = app.keeps(np.arange(59, 10, -1, dtype=np.uint32))
    app.tries(GL.glDrawArrays, mode, 3, 40)
    GL.glTranslatef(0.1, 0.1, 0)
    app.tries(GL.glDrawElementsui, mode, indices)
    app.tries(GL.glDrawElements, mode, 7, GL.GL_UNSIGNED_BYTE, app.keeps(np.arange(7, dtype="u1")))
    GL.glTranslatef(0.1, 0.1, 0)
    app.tries(GL.glDrawRangeElements, mode, 0, 59, 9, GL.GL_UNSIGNED_INT, indices)
    app.tries(GL.glDrawElementsBaseVertex, mode, 7, GL.GL_UNSIGNED_INT, indices, -5)
    GL.glTranslatef(0.1, 0.1, 0)
    app.tries(GL.glMultiDrawArrays, mode, np.array([0, 20], "i4"), np.array([5, 9], "i4"), 2)
    app.tries(GL.glDrawArraysInstanced, mode, 0, 5, 2)
    GL.glTranslatef(0.1, 0.1, 0)
    square()
    mesh(200)
    app.tries(GL.glDrawArrays, mode, 0, 3)
    app.tries(GL.glDrawArrays, mode, 0, 0)
    app.tries(GL.glDrawElements, mode, 3, GL.GL_FLOAT, indices)
    app.asks(GL.GL_CURRENT_COLOR)


@scene
def element_buffer_and_mapped_buffer(app: App) -> None:
    points = np.array(spiral(60), np.float32)
    buffers = GL.glGenBuffers(2)
    GL.glBindBuffer(GL.GL_ARRAY_BUFFER, buffers[0])
    GL.glBufferData(GL.GL_ARRAY_BUFFER, points, GL.GL_DYNAMIC_DRAW)
    GL.glBindBuffer(GL.GL_ELEMENT_ARRAY_BUFFER, buffers[1])
    GL.glBufferData(GL.GL_ELEMENT_ARRAY_BUFFER, np.arange(60, dtype=np.uint16), GL.GL_STATIC_DRAW)
    GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(0))
    for _ in range(3):
        app.tries(GL.glDrawElements, GL.GL_QUADS, 40, GL.GL_UNSIGNED_SHORT, ctypes.c_void_p(8))
        GL.glBufferSubData(GL.GL_ARRAY_BUFFER, 0, np.array([0.5, 0.5, 0.5], np.float32))
        GL.glTranslatef(0.2, 0, 0)
    GL.glMapBuffer(GL.GL_ARRAY_BUFFER, GL.GL_WRITE_ONLY)
    app.tries(GL.glDrawArrays, GL.GL_QUADS, 0, 40)
    GL.glUnmapBuffer(GL.GL_ARRAY_BUFFER)
    restart_at(7)
    app.tries(GL.glDrawElements, GL.GL_QUADS, 40, GL.GL_UNSIGNED_SHORT, ctypes.c_void_p(0))
    app.tries(GL.glMultiDrawElements, GL.GL_TRIANGLES, np.array([3, 6], "i4"),
              GL.GL_UNSIGNED_SHORT, (ctypes.c_void_p * 2)(6, 20), 2)  # fmt: skip
