"""An ordinary program with surfaces as programs make them: `python scenery.py SCENE`.

Floors under glNormal's default, materials inside glBegin, glass, fog, and ground without depth.
"""

import sys

import pygame
from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import gluLookAt, gluPerspective

# ruff: noqa: F405

WIDTH, HEIGHT = 400, 300
SKY = (0.45, 0.6, 0.85)


def look(eye, at=(0.0, 0.0, 0.0), sky=SKY):
    glClearColor(*sky, 1.0)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glViewport(0, 0, WIDTH, HEIGHT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(50.0, WIDTH / HEIGHT, 0.1, 3000.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(*eye, *at, 0.0, 1.0, 0.0)


def light(place=(0.0, 300.0, 0.0, 1.0), number=GL_LIGHT0, colour=(1.0, 1.0, 1.0)):
    glEnable(GL_LIGHTING)
    glEnable(number)
    glLightfv(number, GL_POSITION, place)
    glLightfv(number, GL_DIFFUSE, (*colour, 1.0))


def plane(x, z, width, depth, y=0.0):
    """Level, from a corner."""
    for u, v in ((0, 0), (0, 1), (1, 1), (1, 0)):
        glVertex3f(x + u * width, y, z + v * depth)


def floor(normal):
    """A road to the horizon."""
    look((0.0, 60.0, 100.0), (0.0, 40.0, -100.0))
    light()
    glEnable(GL_COLOR_MATERIAL)
    glNormal3f(*normal)
    glColor3f(0.6, 0.6, 0.6)
    glBegin(GL_QUADS)
    plane(-80.0, -900.0, 160.0, 950.0)
    glEnd()


def floor_with_gls_normal():
    floor((0.0, 0.0, 1.0))


def floor_with_its_own():
    floor((0.0, 1.0, 0.0))


SCENES = {
    function.__name__: function
    for function in (floor_with_gls_normal, floor_with_its_own)
}  # fmt: skip


def draw(scene):
    """A frame, with the state that a context begins with."""
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glEnable(GL_DEPTH_TEST)
    SCENES[scene]()
    glPopAttrib()


if __name__ == "__main__":
    pygame.display.init()
    pygame.display.set_mode((WIDTH, HEIGHT), pygame.OPENGL | pygame.DOUBLEBUF)
    for _ in range(100):
        draw(sys.argv[1])
        pygame.display.flip()
