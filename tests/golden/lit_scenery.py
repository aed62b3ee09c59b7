"""Surfaces that programs light, or do not: more scenes for `scenery`."""

from OpenGL.GL import *  # noqa: F403

from tests.golden.scenery import (
    ball,
    box,
    flat,
    light,
    look,
    material,
    picture_behind,
    plane,
)

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


PAPER, STONE = (0.9, 0.85, 0.7, 1.0), (0.25, 0.35, 0.3, 1.0)


def say(parameter, face=GL_FRONT_AND_BACK):
    return lambda shade: glMaterialfv(face, parameter, shade)


def cheques(shade, *, one=True):
    """A chequered floor in one primitive, or in one for each cheque; shade: called for each with
    a colour."""
    glNormal3f(0.0, 1.0, 0.0)
    if one:
        glBegin(GL_QUADS)
    for i in range(8):
        for k in range(8):
            shade(PAPER if (i + k) % 2 else STONE)
            if not one:
                glBegin(GL_QUADS)
            plane(i - 4.0, k - 4.0, 1.0, 1.0)
            if not one:
                glEnd()
    if one:
        glEnd()


def floor_of(shade, *, listed=False, tracked=None, within=False, one=True):
    """shade: says a colour. tracked: the parameter that follows glColor; within: the list says so
    by itself."""
    look((0.0, 4.0, 6.0))
    light((2.0, 5.0, 3.0, 0.0))
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, (0.2, 0.2, 0.2, 1.0))
    glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (0.2, 0.2, 0.8, 1.0))

    def follow():
        if tracked:
            glColorMaterial(GL_FRONT_AND_BACK, tracked)
            glEnable(GL_COLOR_MATERIAL)

    if not within:
        follow()
    if listed:
        glNewList(7, GL_COMPILE)
    if within:
        follow()
    cheques(shade, one=one)
    if within:
        glDisable(GL_COLOR_MATERIAL)
    if listed:
        glEndList()
        glCallList(7)
    glDisable(GL_COLOR_MATERIAL)


def colour(shade):
    glColor4f(*shade)


FLOORS = {
    f"{'list' if listed else 'drawn'}-{name}": (shade, {"listed": listed, **how})
    for listed in (False, True)
    for name, shade, how in (
        ("diffuse", say(GL_DIFFUSE), {}),
        ("both", say(GL_AMBIENT_AND_DIFFUSE), {}),
        ("front", say(GL_DIFFUSE, GL_FRONT), {}),
        ("apart", say(GL_DIFFUSE), {"one": False}),
        ("tracked", colour, {"tracked": GL_DIFFUSE}),
        ("tracked_both", colour, {"tracked": GL_AMBIENT_AND_DIFFUSE}),
        ("tracked_within", colour, {"tracked": GL_DIFFUSE, "within": True}),
        ("tracked_apart", colour, {"tracked": GL_DIFFUSE, "within": True, "one": False}),
    )
}


def floor(way):
    shade, how = FLOORS[way]
    floor_of(shade, **how)


def without_light():
    """Strong colours and grey: a program that lights nothing."""
    look((0.0, 2.0, 7.0), sky=(0.5, 0.5, 0.5))
    for k, shade in enumerate(((1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.5, 0.5, 0.5))):
        glColor3f(*shade)
        box((2.4 * k - 2.4, 0.0, 0.0), 0.8)


def under_a_yellow_lamp():
    """A white box, which is yellow there."""
    look((0.0, 2.0, 7.0), sky=(0.5, 0.5, 0.5))
    light((1.0, 2.0, 4.0, 0.0), colour=(1.0, 1.0, 0.0))
    material((1.0, 1.0, 1.0, 1.0))
    box((0.0, 0.0, 0.0), 1.5)


def white_glass(lit=True, additive=False):
    """A white pane and a white ball that are blended over a box and beside it."""
    look((0.0, 2.0, 7.0), sky=(0.1, 0.1, 0.2))
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.8, 0.4, 0.3)
    box((-1.6, 0.0, -1.0), 1.0)
    if not lit:
        glDisable(GL_LIGHTING)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE if additive else GL_ONE_MINUS_SRC_ALPHA)
    glDepthMask(GL_FALSE)
    glColor4f(1.0, 1.0, 1.0, 0.4)
    glNormal3f(0.0, 0.0, 1.0)
    glBegin(GL_QUADS)
    for x, y in ((-1.4, -0.6), (0.2, -0.6), (0.2, 1.0), (-1.4, 1.0)):
        glVertex3f(x, y, 1.0)
    glEnd()
    glTranslatef(2.0, 0.0, 0.0)
    ball(1.0)


def on_a_panel(shade):
    """A translucent panel over a box, flat, with bars as white as text."""
    look((0.0, 2.0, 7.0), sky=(0.1, 0.1, 0.2))
    light((2.0, 5.0, 4.0, 0.0))
    glEnable(GL_COLOR_MATERIAL)
    glColor3f(0.8, 0.4, 0.3)
    box((0.0, 0.0, 0.0), 1.2)
    glDisable(GL_LIGHTING)
    flat()
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glColor4f(*shade)
    glRectf(-0.9, 0.0, 0.1, 0.8)
    glColor4f(1.0, 1.0, 1.0, 1.0)
    glBegin(GL_LINES)
    for k in range(4):
        glVertex2f(-0.8, 0.2 + 0.1 * k)
        glVertex2f(0.0, 0.2 + 0.1 * k)
    glEnd()
    glRasterPos2f(-0.8, 0.65)
    glDisable(GL_BLEND)


def on_a_picture_with_a_margin():
    """A ball on a picture that leaves some of the window free."""
    look((0.0, 2.0, 7.0), sky=(0.0, 0.0, 0.0))
    picture_behind(((-0.9, -0.8), (0.9, -0.9), (0.8, 0.9), (-0.9, 0.9)))
    light((2.0, 5.0, 4.0, 0.0))
    ball(1.0)


def between_lamps():
    """Yellow and cyan from both sides: white between them, as on the screen."""
    look((0.0, 2.0, 7.0), sky=(0.9, 0.9, 0.9))
    light((-1.0, 0.0, 3.0, 0.0), GL_LIGHT0, (1.0, 1.0, 0.0))
    light((1.0, 0.0, 3.0, 0.0), GL_LIGHT1, (0.0, 1.0, 1.0))
    material((1.0, 1.0, 1.0, 1.0))
    ball(1.6)
