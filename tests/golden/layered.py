"""An ordinary program whose frames have several pictures: `python layered.py SCENE`.

Menus that are cleared away, views in views, and panels in front of the scene.
"""

import sys

import pygame
from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import gluDeleteQuadric, gluLookAt, gluNewQuadric, gluPerspective, gluSphere

# ruff: noqa: F405

WIDTH, HEIGHT = 480, 360
INSET = (300, 20, 160, 120)
PANEL = (30, 250, 150, 80)  # x, y, width, height from below
SKY, SAND, PANELS = (0.25, 0.45, 0.75), (0.9, 0.8, 0.6), (0.8, 0.2, 0.6)


def box(x, y, z, size, colour):
    glColor3f(*colour)
    glBegin(GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = side
            glNormal3f(*normal)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::side]:
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                glVertex3f(x + size * point[0], y + size * point[1], z + size * point[2])
    glEnd()


def look(x, y, width, height, eye=(4.0, 3.0, 5.0)):
    glViewport(x, y, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(45.0, width / height, 1.0, 30.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(*eye, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)
    glEnable(GL_LIGHTING)
    glEnable(GL_DEPTH_TEST)


def level():
    box(0.0, 0.0, 0.0, 1.0, (0.8, 0.5, 0.3))
    box(-2.2, -0.4, 0.5, 0.6, (0.4, 0.7, 0.4))
    glColor3f(0.5, 0.5, 0.8)
    glPushMatrix()
    glTranslatef(1.6, -0.5, 1.0)
    quadric = gluNewQuadric()
    gluSphere(quadric, 0.6, 24, 16)
    gluDeleteQuadric(quadric)
    glPopMatrix()


def flat():
    """Pixels of the window."""
    glViewport(0, 0, WIDTH, HEIGHT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(0, WIDTH, 0, HEIGHT, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glDisable(GL_LIGHTING)


def panel(depth_test):
    """A panel of plain colours with a textured label."""
    flat()
    (glEnable if depth_test else glDisable)(GL_DEPTH_TEST)
    x, y, width, height = PANEL
    for inner, colour, near in ((0, PANELS, 0.5), (6, (0.95, 0.9, 0.3), 0.6)):
        glColor3f(*colour)
        glBegin(GL_QUADS)
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            glVertex3f(x + inner + u * (width - 2 * inner), y + inner + v * (height / 2 - inner),
                       near)
        glEnd()
    glEnable(GL_TEXTURE_2D)
    glColor3f(1.0, 1.0, 1.0)
    glBegin(GL_QUADS)
    for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord2f(u, v)
        glVertex3f(x + u * width, y + height / 2 + v * height / 2, 0.7)
    glEnd()
    glDisable(GL_TEXTURE_2D)


def clear(bits=GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, colour=SKY):
    glClearColor(*colour, 1.0)
    glClear(bits)


def scissored(box, bits, colour=SAND):
    glEnable(GL_SCISSOR_TEST)
    glScissor(*box)
    clear(bits, colour)
    glDisable(GL_SCISSOR_TEST)


def menu_then_level():
    clear()
    panel(depth_test=True)
    look(0, 0, WIDTH, HEIGHT, (0.0, 6.0, 4.0))
    box(0.0, 0.0, 0.0, 1.5, (0.3, 0.3, 0.9))
    clear()
    look(0, 0, WIDTH, HEIGHT)
    level()


def split():
    """Two halves, each with a clear of its own."""
    for x, eye, colour in ((0, (4.0, 3.0, 5.0), SKY), (WIDTH // 2, (-5.0, 2.0, 3.0), SAND)):
        scissored((x, 0, WIDTH // 2, HEIGHT), GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, colour)
        look(x, 0, WIDTH // 2, HEIGHT, eye)
        level()


def halves():
    """Two halves, with one clear of colour and each of depth."""
    clear(GL_COLOR_BUFFER_BIT)
    for x, eye in ((0, (4.0, 3.0, 5.0)), (WIDTH // 2, (-5.0, 2.0, 3.0))):
        clear(GL_DEPTH_BUFFER_BIT)
        look(x, 0, WIDTH // 2, HEIGHT, eye)
        level()


def inset(bits=GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT):
    """A small view in front of the main one."""
    clear()
    look(0, 0, WIDTH, HEIGHT)
    level()
    scissored(INSET, bits)
    look(*INSET, (-5.0, 2.0, 3.0))
    level()


def inset_over():
    """The same, with the main view behind it."""
    inset(GL_DEPTH_BUFFER_BIT)


def weapon():
    clear()
    look(0, 0, WIDTH, HEIGHT)
    level()
    clear(GL_DEPTH_BUFFER_BIT)
    glLoadIdentity()
    glTranslatef(0.6, -0.7, -2.6)
    glRotatef(30.0, 1.0, 1.0, 0.0)
    box(0.0, 0.0, 0.0, 0.4, (0.6, 0.6, 0.65))


def masked():
    """Clears that clear nothing."""
    clear()
    look(0, 0, WIDTH, HEIGHT)
    box(0.0, 0.0, 0.0, 1.0, (0.8, 0.5, 0.3))
    glColorMask(0, 0, 0, 0)
    glDepthMask(0)
    clear()
    glColorMask(1, 1, 1, 1)
    glDepthMask(1)
    box(-2.2, -0.4, 0.5, 0.6, (0.4, 0.7, 0.4))


def hud(depth_test, cleared=False, first=False):
    clear()
    if first:
        panel(depth_test)
    look(0, 0, WIDTH, HEIGHT, (2.5, 1.0, 3.0))
    level()
    if not first:
        if cleared:
            clear(GL_DEPTH_BUFFER_BIT)
        panel(depth_test)


SCENES = {
    "menu": menu_then_level, "split": split, "halves": halves, "inset": inset,
    "inset_over": inset_over, "weapon": weapon, "masked": masked,
    "hud": lambda: hud(False), "hud_tested": lambda: hud(True, cleared=True),
    "hud_on_depth": lambda: hud(True), "hud_first": lambda: hud(True, first=True),
    "hud_under": lambda: hud(False, first=True),
}  # fmt: skip


def prepare():
    """Once in a context."""
    glBindTexture(GL_TEXTURE_2D, 7)
    stripes = bytes(c for k in range(64) for c in ((20, 20, 20) if k // 2 % 2 else (240, 240, 240)))
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, stripes)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST)
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glEnable(GL_LIGHT0)
    glEnable(GL_COLOR_MATERIAL)


if __name__ == "__main__":
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    prepare()
    for _ in range(3):
        SCENES[sys.argv[1]]()
        pygame.display.flip()
