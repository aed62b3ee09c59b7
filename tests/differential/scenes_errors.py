"""Scenes of what is illegal or rare: errors inside primitives, exceptions of the app's own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from OpenGL import GL

from .registry import each, scene
from .scenes_immediate import shade, spiral
from .world import App


def strip(count: int, start: int = 0) -> None:
    """Some coloured vertices."""
    for i, point in enumerate(spiral(count)[start:]):
        GL.glColor3f(*shade(i))
        GL.glVertex3fv(point)


INSIDE: dict[str, Callable[[App], Any]] = {
    "glTranslatef": lambda app: GL.glTranslatef(1, 0, 0),
    "glEnable": lambda app: GL.glEnable(GL.GL_LIGHTING),
    "glEnable-bad": lambda app: GL.glEnable(0xFFFF),
    "glClear": lambda app: GL.glClear(GL.GL_COLOR_BUFFER_BIT),
    "glGetFloatv": lambda app: GL.glGetFloatv(GL.GL_CURRENT_COLOR),
    "glGetIntegerv": lambda app: GL.glGetIntegerv(GL.GL_VIEWPORT),
    "glGetError": lambda app: app.error(),
    "glIsEnabled": lambda app: GL.glIsEnabled(GL.GL_LIGHTING),
    "glReadPixels": lambda app: GL.glReadPixels(0, 0, 9, 9, GL.GL_RGB, GL.GL_UNSIGNED_BYTE),
    "glBegin": lambda app: GL.glBegin(GL.GL_QUADS),
    "glBegin-bad": lambda app: GL.glBegin(77),
    "glFlush": lambda app: GL.glFlush(),
    "glFinish": lambda app: GL.glFinish(),
    "glNewList": lambda app: GL.glNewList(5, GL.GL_COMPILE),
    "glEndList": lambda app: GL.glEndList(),
    "glGenLists": lambda app: GL.glGenLists(1),
    "glDeleteLists": lambda app: GL.glDeleteLists(1, 1),
    "glPushAttrib": lambda app: GL.glPushAttrib(GL.GL_CURRENT_BIT),
    "glRectf": lambda app: GL.glRectf(-1, -1, 1, 1),
    "glDrawArrays": lambda app: GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3),
    "glBindTexture": lambda app: GL.glBindTexture(GL.GL_TEXTURE_2D, 0),
    "glMaterialfv": lambda app: GL.glMaterialfv(GL.GL_FRONT, GL.GL_DIFFUSE, (0.1, 0.7, 0.2, 1)),
    "glMaterialfv-bad": lambda app: GL.glMaterialfv(77, GL.GL_DIFFUSE, (0.1, 0.7, 0.2, 1)),
    "glMultiTexCoord": lambda app: GL.glMultiTexCoord2f(GL.GL_TEXTURE1, 0.3, 0.6),
    "glMultiTexCoord-0": lambda app: GL.glMultiTexCoord2f(GL.GL_TEXTURE0, 0.3, 0.6),
    "glSecondaryColor": lambda app: GL.glSecondaryColor3f(0.5, 0.1, 0.9),
    "glFogCoord": lambda app: GL.glFogCoordf(0.5),
    "glVertexAttrib": lambda app: GL.glVertexAttrib4f(3, 0.5, 0.1, 0.9, 1.0),
    "glVertexAttrib-0": lambda app: GL.glVertexAttrib3f(0, 0.5, 0.1, 0.0),
    "glIndex": lambda app: GL.glIndexf(7.0),
    "glColor3us": lambda app: GL.glColor3us(60000, 100, 30000),
    "glColor3b": lambda app: GL.glColor3b(100, 50, 25),
    "glNormal3b": lambda app: GL.glNormal3b(100, 50, 25),
    "glEvalCoord": lambda app: GL.glEvalCoord2f(0.5, 0.5),
    "glCallList-none": lambda app: GL.glCallList(4711),
    "glUseProgram": lambda app: GL.glUseProgram(0),
    "glPointSize": lambda app: GL.glPointSize(5),
    "glShadeModel": lambda app: GL.glShadeModel(GL.GL_FLAT),
    "glVertex-str": lambda app: app.tries(GL.glVertex3f, "a", 1, 2),
    "glVertex-few": lambda app: app.tries(GL.glVertex3f, 1, 2),
    "glVertex3fv-few": lambda app: app.tries(GL.glVertex3fv, [1, 2]),
    "glColor3fv-None": lambda app: app.tries(GL.glColor3fv, [None, 1, 2]),
    "swap-buffers": lambda app: None,
}


@each(INSIDE)
def called_inside(app: App, call: Callable[[App], Any]) -> None:
    for count in (9, 150, 9):
        GL.glBegin(GL.GL_TRIANGLE_STRIP)
        strip(count // 2)
        app.tries(call, app)
        strip(count, count // 2)
        app.tries(GL.glEnd)
        app.tries(GL.glColor3f, 0, 1, 0)
        app.tries(GL.glBegin, GL.GL_TRIANGLES)
        strip(6)
        app.tries(GL.glEnd)
        app.asks(GL.GL_CURRENT_COLOR, GL.GL_CURRENT_NORMAL)
        GL.glTranslatef(0.3, 0.2, 0.1)


@each({"enum": 99, "negative": -1, "float": 4.0, "str": "quads", "None": None, "list": [4],
       "numpy": np.int64(4), "uint": np.uint32(7), "bool": True, "14": 14, "10": 10,
       "huge": 2**40 + 4, "array": np.array(4), "complex": 4j})  # fmt: skip
def odd_modes(app: App, mode: Any) -> None:
    app.tries(GL.glBegin, mode)
    app.tries(GL.glColor3f, 1, 0, 0)
    strip(12)
    app.tries(GL.glMaterialf, GL.GL_FRONT, GL.GL_SHININESS, 3.0)
    app.tries(GL.glEnd)
    app.error()
    app.tries(GL.glEnd)
    app.asks(GL.GL_CURRENT_COLOR)


@scene
def odd_arguments_of_begin_and_end(app: App) -> None:
    app.tries(GL.glBegin)
    app.tries(GL.glEnd)
    app.tries(GL.glBegin, 4, 5)
    app.tries(GL.glEnd, 1)
    app.tries(GL.glEnd)
    app.tries(GL.glBegin, mode=GL.GL_TRIANGLES)
    strip(6)
    app.tries(GL.glEnd, 3)
    app.tries(GL.glEnd)
    app.tries(GL.glBegin, which=GL.GL_TRIANGLES)
    app.error()


@scene
def end_without_begin(app: App) -> None:
    app.tries(GL.glEnd)
    app.error()
    strip(4)
    app.tries(GL.glEnd)
    app.asks(GL.GL_CURRENT_COLOR)


def _raises(count: int) -> None:
    GL.glBegin(GL.GL_TRIANGLE_STRIP)
    strip(count)
    raise ValueError("the app's own")


@each({"small": 7, "large": 160})
def exception_inside_and_the_next_frame(app: App, count: int) -> None:
    for _ in range(3):
        app.tries(_raises, count)
        app.tries(GL.glClear, GL.GL_COLOR_BUFFER_BIT)
        app.tries(GL.glTranslatef, 0.1, 0, 0)
        app.error()
    app.tries(GL.glBegin, GL.GL_QUADS)
    strip(8)
    app.tries(GL.glEnd)
    app.error()
    app.tries(GL.glBegin, GL.GL_QUADS)
    strip(8)
    app.tries(GL.glEnd)


@scene
def errors_are_found_by_the_call_after(app: App) -> None:
    from glshim.driver.functions import gl

    for count in (3, 150):
        gl.glEnable(0xFFFF)
        app.tries(GL.glBegin, GL.GL_TRIANGLES)
        strip(count)
        app.tries(GL.glEnd)
        app.error()
        gl.glViewport(0, 0, -1, -1)
        app.tries(GL.glRectf, 0, 0, 1, 1)
        gl.glEnable(0xFFFF)
        app.tries(GL.glClear, GL.GL_DEPTH_BUFFER_BIT)


@scene
def wrong_arguments_of_watched_calls(app: App) -> None:
    for args in ((), ("x",), (None,), (1, 2, 3), (0xFFFFFFFF,), (1.5,), ([1],)):
        for call in (GL.glClear, GL.glCallList, GL.glDrawArrays, GL.glDeleteLists, GL.glNewList,
                     GL.glRectf, GL.glRectfv, GL.glEvalMesh2, GL.glBindFramebuffer,
                     GL.glClipPlane, GL.glBufferData, GL.glFlush, GL.glFinish, GL.glEndList,
                     GL.glDrawElements, GL.glPolygonMode, GL.glCopyPixels, GL.glBitmap,
                     GL.glArrayElement, GL.glMaterialf, GL.glDrawBuffer):  # fmt: skip
            app.tries(call, *args)
    app.tries(GL.glDrawArrays, GL.GL_TRIANGLES, -3, 6)
    app.tries(GL.glDrawArrays, GL.GL_TRIANGLES, 0, -6)
    app.tries(GL.glDrawArrays, 99, 0, 6)
    app.tries(GL.glDrawElements, GL.GL_TRIANGLES, 3, GL.GL_FLOAT, [0, 1, 2])
    app.tries(GL.glCallLists, [1, 2, "x"])
    app.tries(GL.glCallLists, "abc")
    app.tries(GL.glNewList, 0, GL.GL_COMPILE)
    app.tries(GL.glNewList, 3, 99)
    app.tries(GL.glEndList)
    app.tries(GL.glDeleteLists, 1, -1)
    app.tries(GL.glClear, 0xFFFF)
    app.tries(GL.glClear, -1)
    app.tries(GL.glReadPixels, 0, 0, -1, 4, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    app.tries(GL.glRectfv, [0, 0], [1])
    app.tries(GL.glRectdv, [0, 0], [0.5, 1])
    strip(3)
    GL.glBegin(GL.GL_TRIANGLES)
    strip(6)
    app.tries(GL.glEnd)
