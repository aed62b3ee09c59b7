"""What the programs of different toolkits draw: a cube with a ball in it."""

# ruff: noqa: F403, F405
from OpenGL.GL import *
from OpenGL.GLU import *

angle = 0


def draw(width, height):
    global angle
    angle += 10
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glViewport(0, 0, width, height)
    glClearColor(0.8, 0.85, 0.9, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(45, width / height, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(2, 3, 5, 0, 0, 0, 0, 1, 0)
    glRotatef(angle, 0, 1, 0)
    glBegin(GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            normal = [0, 0, 0]
            normal[axis] = side
            glNormal3fv(normal)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))[::side]:
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, u, v
                glVertex3fv(point)
    glEnd()
    ball = gluNewQuadric()
    gluSphere(ball, 1.3, 16, 12)
    gluDeleteQuadric(ball)
