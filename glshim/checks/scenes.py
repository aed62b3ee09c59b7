"""Small programs, as an app would write them, to be drawn plain and under a style."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from OpenGL import GL

from glshim.checks import layers
from glshim.model.batch import PolygonBatch

Scene = Callable[[], None]


def prepare(side: int) -> None:
    """A grey ground, depth test, light, and a camera."""
    GL.glViewport(0, 0, side, side)
    GL.glClearColor(0.6, 0.6, 0.6, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT | GL.GL_STENCIL_BUFFER_BIT)
    GL.glEnable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_LIGHTING)
    GL.glEnable(GL.GL_LIGHT0)
    GL.glEnable(GL.GL_COLOR_MATERIAL)
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadMatrixd(np.ascontiguousarray(layers.perspective().T))
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadMatrixd(np.ascontiguousarray(layers.camera().modelview.T))
    GL.glColor3f(0.8, 0.6, 0.3)


def draw(mesh: PolygonBatch) -> None:
    """Polygons between glBegin and glEnd, as they are wound."""
    normals = mesh.normals if mesh.normals is not None else np.zeros((len(mesh.corners), 3))
    for begin, end in zip(mesh.starts[:-1], mesh.starts[1:], strict=True):
        GL.glBegin(GL.GL_POLYGON)
        for corner in range(begin, end):
            GL.glNormal3f(*normals[corner].tolist())
            GL.glVertex3f(*mesh.positions[mesh.corners[corner]].tolist())
        GL.glEnd()


def solids() -> None:
    """Two solids, one in another, in a state of the app's own."""
    GL.glShadeModel(GL.GL_FLAT)
    GL.glLineWidth(3.0)
    GL.glPointSize(5.0)
    draw(layers.cube())
    GL.glPushMatrix()
    GL.glRotatef(30.0, 1.0, 2.0, 3.0)
    draw(layers.torus())
    GL.glColor3f(0.1, 0.2, 0.3)


def display_list() -> None:
    """A list, called twice."""
    name = int(GL.glGenLists(1))
    GL.glNewList(name, GL.GL_COMPILE)
    draw(layers.torus())
    GL.glEndList()
    for way in (-0.5, 0.5):
        GL.glPushMatrix()
        GL.glTranslatef(way, 0.0, way)
        GL.glCallList(name)
        GL.glPopMatrix()


def hud() -> None:
    """A solid, and flat letters over it."""
    draw(layers.cube())
    GL.glMatrixMode(GL.GL_PROJECTION)
    GL.glLoadIdentity()
    GL.glOrtho(0.0, 100.0, 0.0, 100.0, -1.0, 1.0)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glDisable(GL.GL_DEPTH_TEST)
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE)
    GL.glColor4f(0.2, 0.9, 0.4, 0.5)
    GL.glRectf(5.0, 5.0, 40.0, 15.0)


def two_views() -> None:
    """The same solid in two views, with the depth buffer cleared between them."""
    for place in (0, layers.SIDE // 2):
        GL.glViewport(place, 0, layers.SIDE // 2, layers.SIDE)
        GL.glClear(GL.GL_DEPTH_BUFFER_BIT)
        draw(layers.cube())


def degenerate() -> None:
    """Points, needles and corners that are no numbers."""
    draw(layers.degenerate())
    draw(layers.open_surface())


def textured() -> None:
    """A solid with a texture, and a stencil test."""
    GL.glBindTexture(GL.GL_TEXTURE_2D, int(GL.glGenTextures(1)))
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
    pixels = np.arange(4 * 4 * 3, dtype=np.uint8).reshape(4, 4, 3) * 5
    GL.glTexImage2D(
        GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 4, 4, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, pixels
    )
    GL.glEnable(GL.GL_TEXTURE_2D)
    GL.glEnable(GL.GL_STENCIL_TEST)
    GL.glStencilFunc(GL.GL_ALWAYS, 1, 0xFF)
    GL.glStencilOp(GL.GL_KEEP, GL.GL_KEEP, GL.GL_REPLACE)
    draw(layers.cube())
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)  # its number may be another under a style


def one_half() -> None:
    """A solid in the left half of the window."""
    GL.glViewport(0, 0, layers.SIDE // 2, layers.SIDE)
    GL.glEnable(GL.GL_SCISSOR_TEST)
    GL.glScissor(0, 0, layers.SIDE // 2, layers.SIDE)
    draw(layers.cube())


def empty() -> None:
    """Nothing but the ground."""


def lines_and_points() -> None:
    """Nothing with a surface."""
    for mode in (GL.GL_LINE_LOOP, GL.GL_POINTS):
        GL.glBegin(mode)
        for place in layers.torus().positions[::7].tolist():
            GL.glVertex3f(*place)
        GL.glEnd()


def flat() -> None:
    """Polygons without depth test: a window of two dimensions."""
    GL.glDisable(GL.GL_DEPTH_TEST)
    draw(layers.cube())


RESTYLED = (solids, display_list, hud, two_views, degenerate, textured, one_half)
"""What may look different under a style."""
UNTOUCHED = (empty, lines_and_points, flat)
"""What carries no lines, and so looks as it does plain."""
