"""Surfaces that programs light, or do not: more scenes for `scenery`."""

from OpenGL.GL import *  # noqa: F403

from tests.golden.scenery import light, look, material

# ruff: noqa: F405


def sheet(toward, x):
    """Upright, with a normal that looks to the viewer (1) or away (-1)."""
    glNormal3f(0.0, 0.0, toward)
    glBegin(GL_QUADS)
    for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        glVertex3f(x + u, v, 0.0)
    glEnd()


def sheets(both_sides=False):
    """The light stands behind the viewer; the right one looks away from it."""
    look((0.0, 0.0, 7.0), sky=(0.5, 0.5, 0.5))
    light((0.0, 0.0, 1.0, 0.0))
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, both_sides)
    material((0.8, 0.3, 0.2, 1.0))
    sheet(1.0, -1.5)
    glFrontFace(GL_CW)  # its back, as the normal says
    sheet(-1.0, 1.5)


def sheets_of_two_sides():
    sheets(both_sides=True)

