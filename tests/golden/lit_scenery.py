"""Surfaces that programs light, or do not: more scenes for `scenery`."""

from OpenGL.GL import *  # noqa: F403

from tests.golden.scenery import box, light, look, material, plane

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



MIST = (0.75, 0.8, 0.85)
FOGS = {
    "linear": ((GL_FOG_START, 4.0), (GL_FOG_END, 26.0)),
    "exp": ((GL_FOG_DENSITY, 0.08),),
    "exp2": ((GL_FOG_DENSITY, 0.06),),
}


def fog(mode, colour=MIST):
    glEnable(GL_FOG)
    glFogi(GL_FOG_MODE, {"linear": GL_LINEAR, "exp": GL_EXP, "exp2": GL_EXP2}[mode])
    for name, value in FOGS[mode]:
        glFogf(name, value)
    glFogfv(GL_FOG_COLOR, (*colour, 1.0))


def in_fog(mode, lit=True):
    """Ground and boxes to where nothing is seen, the nearest without fog; mode: None for no fog."""
    look((0.0, 2.0, 7.0), sky=MIST)
    if lit:
        light((2.0, 5.0, 4.0, 0.0))
        glEnable(GL_COLOR_MATERIAL)
    if mode:
        fog(mode)
    glColor3f(0.35, 0.5, 0.3)
    glNormal3f(0.0, 1.0, 0.0)
    glBegin(GL_QUADS)
    plane(-60.0, -140.0, 120.0, 145.0, -1.0)
    glEnd()
    glColor3f(0.8, 0.3, 0.2)
    for k in range(1, 9):
        box((-4.0 + 1.2 * k, 0.0, 2.0 - 4.0 * k), 1.0)
    glDisable(GL_FOG)
    box((-3.0, 0.0, 2.0), 1.0)
