"""Random programs: sequences of GL calls, drawn by hypothesis, run by :func:`play`."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import strategies as st
from OpenGL import GL
from OpenGL.raw.GL.VERSION import GL_1_0 as raw

from glshim.spec.context import compiles_a_list
from tests.differential.world import App

Step = tuple[Any, ...]

_COORDINATE = st.sampled_from((-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0))
_POINT = st.tuples(_COORDINATE, _COORDINATE, _COORDINATE)
_UNIT = st.sampled_from((0.0, 0.25, 0.5, 1.0))
_BYTE = st.integers(-3, 300)
_SWITCH = st.sampled_from(
    (GL.GL_LIGHTING, GL.GL_LIGHT0, GL.GL_COLOR_MATERIAL, GL.GL_CULL_FACE, GL.GL_DEPTH_TEST,
     GL.GL_BLEND, GL.GL_FOG, GL.GL_NORMALIZE, GL.GL_POLYGON_OFFSET_FILL, GL.GL_CLIP_PLANE0,
     GL.GL_TEXTURE_GEN_S, GL.GL_POLYGON_STIPPLE, GL.GL_SCISSOR_TEST, GL.GL_STENCIL_TEST, 0xFFFF)
)  # fmt: skip
_LIST = st.integers(1, 4)
_MODE = st.one_of(st.integers(0, 9), st.integers(4, 9), st.just(14))

_ATTRIBUTES: tuple[tuple[st.SearchStrategy[Step], ...], ...] = (
    (st.tuples(st.just("glColor3f"), _UNIT, _UNIT, _UNIT),
     st.tuples(st.just("glColor3fv"), st.lists(_UNIT, min_size=3, max_size=3))),
    (st.tuples(st.just("glColor3ub"), _BYTE, _BYTE, _BYTE),
     st.tuples(st.just("glColor4f"), _UNIT, _UNIT, _UNIT, _UNIT)),
)  # fmt: skip
"""Colours of one number of components each: Mesa 22.3 mixes them up by its own buffering."""


def programs() -> st.SearchStrategy[list[Step]]:
    """Sequences of calls, most of them legal."""
    return st.sampled_from(_ATTRIBUTES).flatmap(
        lambda colours: st.lists(_step(colours), min_size=1, max_size=24)
    )


def _step(colours: tuple[st.SearchStrategy[Step], ...]) -> st.SearchStrategy[Step]:
    attribute = st.one_of(
        *colours,
        st.tuples(st.just("glNormal3f"), _UNIT, _UNIT, _UNIT),
        st.tuples(st.just("glTexCoord2f"), _UNIT, _UNIT),
        st.tuples(st.just("glEdgeFlag"), st.booleans()),
    )
    vertex = st.one_of(
        st.tuples(st.just("glVertex3f"), _COORDINATE, _COORDINATE, _COORDINATE),
        st.tuples(st.just("glVertex3fv"), _POINT),
        st.tuples(st.just("glVertex3dv"), _POINT.map(np.array)),
    )
    strange = st.one_of(
        st.tuples(st.just("glMaterialf"), st.just(GL.GL_FRONT), st.just(GL.GL_SHININESS), _UNIT),
        st.tuples(st.just("glArrayElement"), st.integers(0, 20)),
        st.tuples(st.just("glMultiTexCoord2f"), st.just(GL.GL_TEXTURE1), _UNIT, _UNIT),
        st.tuples(st.just("glVertex3f"), st.sampled_from(("x", None, 1j)), _UNIT, _UNIT),
        st.tuples(st.just("glVertex3fv"), st.just([1.0, 2.0])),
        st.tuples(st.just("glTranslatef"), _UNIT, _UNIT, _UNIT),
        st.tuples(st.just("glGetFloatv"), st.just(GL.GL_CURRENT_COLOR)),
        st.tuples(st.just("glBegin"), _MODE),
        st.tuples(st.just("raise")),
    )

    def primitive(*more: st.SearchStrategy[Step]) -> st.SearchStrategy[Step]:
        return st.tuples(
            st.just("primitive"), _MODE,
            st.lists(st.one_of(attribute, vertex, vertex), max_size=14),
            st.sampled_from((1, 1, 1, 2, 40, 200)), st.one_of(st.none(), strange, *more),
        )  # fmt: skip

    calling = primitive(st.tuples(st.just("glCallList"), _LIST))
    state = st.one_of(
        st.tuples(st.sampled_from(("glEnable", "glDisable")), _SWITCH),
        st.tuples(st.just("glShadeModel"), st.sampled_from((GL.GL_FLAT, GL.GL_SMOOTH))),
        st.tuples(st.just("glFrontFace"), st.sampled_from((GL.GL_CW, GL.GL_CCW, 3))),
        st.tuples(st.just("glPolygonMode"), st.just(GL.GL_FRONT_AND_BACK),
                  st.sampled_from((GL.GL_FILL, GL.GL_LINE, GL.GL_POINT))),
        st.tuples(st.just("glDepthMask"), st.booleans()),
        st.tuples(st.just("glPushAttrib"), st.just(GL.GL_ALL_ATTRIB_BITS)),
        st.tuples(st.sampled_from(("glPopAttrib", "glPushMatrix", "glPopMatrix", "glLoadIdentity",
                                   "glFlush", "glFinish", "glGetError", "glEnd", "glEndList"))),
        st.tuples(st.just("glTranslatef"), _UNIT, _UNIT, _UNIT),
        st.tuples(st.just("glRotatef"), st.sampled_from((30.0, 90.0, 200.0)), _UNIT, _UNIT, _UNIT),
        st.tuples(st.just("glScalef"), _COORDINATE, _UNIT, _UNIT),
        st.tuples(st.just("glMatrixMode"), st.sampled_from((0x1700, 0x1700, 0x1701, 0x1702))),
        st.tuples(st.just("glClear"), st.sampled_from((0x100, 0x4000, 0x4100, 0xFFFF))),
        st.tuples(st.just("glActiveTexture"), st.sampled_from((0x84C0, 0x84C1, 0x84D4))),
        st.tuples(st.just("glDeleteLists"), _LIST, st.integers(-1, 2)),
    )  # fmt: skip
    draw = st.one_of(
        st.tuples(st.just("glRectf"), _COORDINATE, _COORDINATE, _COORDINATE, _COORDINATE),
        st.tuples(st.just("glDrawArrays"), _MODE, st.integers(-1, 20), st.integers(-1, 20)),
        st.tuples(st.just("glDrawElementsui"), _MODE,
                  st.lists(st.integers(0, 39), max_size=9).map(lambda v: np.array(v, np.uint32))),
        st.tuples(st.sampled_from(("glEnableClientState", "glDisableClientState")),
                  st.sampled_from((GL.GL_VERTEX_ARRAY, GL.GL_COLOR_ARRAY))),
        st.tuples(st.just("glCallList"), _LIST),
        st.tuples(st.just("glCallLists"), st.lists(_LIST, max_size=3)),
        st.tuples(st.just("glNewList"), _LIST, st.sampled_from((GL.GL_COMPILE, 0x1301, 7))),
        st.tuples(st.just("glReadPixels"), st.just(0), st.just(0), st.just(3), st.just(3),
                  st.just(GL.GL_RGB), st.just(GL.GL_UNSIGNED_BYTE)),
    )  # fmt: skip
    inner = st.one_of(calling, attribute, state)
    recorded = st.tuples(st.just("list"), _LIST, st.sampled_from((0x1300, 0x1301)),
                         st.lists(inner, max_size=6))  # fmt: skip
    return st.one_of(calling, calling, attribute, state, draw, recorded)


def play(app: App, program: list[Step]) -> None:
    """Run the steps; whatever a step raises is noted and the next one follows."""
    points = app.keeps(np.linspace(-1.0, 1.0, 120, dtype=np.float32).reshape(40, 3)[:, [0, 2, 1]])
    points[::2, 1] *= -1.0
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, points)
    GL.glColorPointer(3, GL.GL_FLOAT, 0, points)
    for step in program:
        app.tries(_say, app, step)
    for close in (GL.glEnd, GL.glEndList, GL.glEnd):
        app.tries(close)
    app.asks(GL.GL_CURRENT_COLOR)


def _say(app: App, step: Step) -> Any:
    name, *args = step
    if name == "primitive":
        return _primitive(app, *args)
    if name == "list":
        number, mode, body = args
        GL.glNewList(number, mode)
        for inner in body:
            app.tries(_say, app, inner)
        return GL.glEndList()
    if name == "raise":
        raise RuntimeError("the app's own")
    if name == "glVertex3dv":
        return raw.glVertex3dv(*args)
    return getattr(GL, name)(*args)


def _primitive(app: App, mode: int, body: list[Step], times: int, strange: Step | None) -> None:
    if strange is not None and strange[0] == "glCallList" and compiles_a_list():
        strange = None  # plain Mesa 22.3 crashes on it
    GL.glBegin(mode)
    for _ in range(times):
        for step in body:
            _say(app, step)
    if strange is not None:
        _say(app, strange)
        for step in body:
            _say(app, step)
    GL.glEnd()
