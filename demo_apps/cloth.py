# ruff: noqa: F403, F405
"""A cloth that falls over a ball: GLUT, immediate mode with the vector calls, two-sided lighting.

A grid of points, springs between neighbours, one triangle strip a row. r drops it again, w shows
the wires, space stops time, ESC leaves.
"""

import sys

import numpy as np
from numpy.typing import NDArray
from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

ROWS = 26
SIDE = 3.2
REST = SIDE / (ROWS - 1)
BALL = np.array([0.0, -0.2, 0.0])
RADIUS = 0.9
FLOOR = -1.3
STEPS = 6  # steps of the simulation in one frame
Points = NDArray[np.float64]


def grid() -> Points:
    """The cloth at rest above the ball, (ROWS, ROWS, 3)."""
    axis = np.linspace(-SIDE / 2, SIDE / 2, ROWS)
    x, z = np.meshgrid(axis, axis)
    return np.stack([x + 0.25, np.full_like(x, 0.95) + 0.02 * np.sin(9 * x + 5 * z), z], axis=2)


class Cloth:
    def __init__(self) -> None:
        self.now = grid()
        self.before = self.now.copy()

    def step(self) -> None:
        """One Verlet step, then the springs and the obstacles as constraints."""
        drift = (self.now - self.before) * 0.985
        self.before, self.now = self.now, self.now + drift + (0.0, -0.0011, 0.0)
        for _ in range(4):
            self.pull((slice(None), slice(1, None)), (slice(None), slice(None, -1)), 1.0)
            self.pull((slice(1, None), slice(None)), (slice(None, -1), slice(None)), 1.0)
            self.pull((slice(1, None), slice(1, None)), (slice(None, -1), slice(None, -1)), 2**0.5)
            away = self.now - BALL
            length = np.linalg.norm(away, axis=2, keepdims=True)
            inside = length < RADIUS * 1.04
            self.now = np.where(inside, BALL + away / length * RADIUS * 1.04, self.now)
            self.before = np.where(inside, self.before * 0.5 + self.now * 0.5, self.before)
            self.now[..., 1] = np.maximum(self.now[..., 1], FLOOR + 0.02)

    def pull(self, a: tuple[slice, slice], b: tuple[slice, slice], scale: float) -> None:
        """Move the ends of the springs from a to b half way to their length of rest."""
        apart = self.now[a] - self.now[b]
        length = np.linalg.norm(apart, axis=2, keepdims=True)
        move = apart * (0.5 - 0.5 * REST * scale / length) * 0.5
        self.now[a] -= move
        self.now[b] += move

    def normals(self) -> Points:
        along, across = np.gradient(self.now, axis=(0, 1))
        normals = np.cross(along, across)
        return normals / np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-12)


cloth = Cloth()
running = True
size = (640, 480)


def draw_cloth() -> None:
    points, normals = cloth.now.tolist(), cloth.normals().tolist()
    glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, (0.75, 0.16, 0.22, 1.0))
    glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (0.90, 0.72, 0.35, 1.0))
    for row in range(ROWS - 1):
        glBegin(GL_TRIANGLE_STRIP)
        for column in range(ROWS):
            for r in (row, row + 1):
                glNormal3fv(normals[r][column])
                glVertex3fv(points[r][column])
        glEnd()


def draw_room() -> None:
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (0.60, 0.66, 0.68, 1.0))
    glBegin(GL_QUADS)
    glNormal3f(0.0, 1.0, 0.0)
    for x, z in ((-4, -4), (-4, 4), (4, 4), (4, -4)):
        glVertex3f(x, FLOOR, z)
    glEnd()
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (0.35, 0.45, 0.62, 1.0))
    glPushMatrix()
    glTranslatef(*BALL)
    glutSolidSphere(RADIUS, 40, 28)
    glPopMatrix()


def display() -> None:
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(36.0, size[0] / size[1], 1.0, 30.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(2.6, 2.4, 6.6, 0.0, -0.35, 0.0, 0.0, 1.0, 0.0)
    glLightfv(GL_LIGHT0, GL_POSITION, (3.0, 6.0, 4.0, 1.0))
    draw_room()
    draw_cloth()
    glutSwapBuffers()


def advance(_value: int) -> None:
    if running:
        for _ in range(STEPS):
            cloth.step()
        glutPostRedisplay()
    glutTimerFunc(20, advance, 0)


def reshape(width: int, height: int) -> None:
    global size
    size = (width, max(height, 1))
    glViewport(0, 0, *size)


def keyboard(key: bytes, _x: int, _y: int) -> None:
    global cloth, running
    if key == b"\x1b":
        glutLeaveMainLoop()
    elif key == b"r":
        cloth = Cloth()
    elif key == b" ":
        running = not running
    elif key == b"w":
        filled = glGetIntegerv(GL_POLYGON_MODE)[0] == GL_FILL
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE if filled else GL_FILL)
    glutPostRedisplay()


def main() -> None:
    glutInit(sys.argv)
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
    glutInitWindowSize(*size)
    glutCreateWindow(b"Cloth")
    glClearColor(0.88, 0.91, 0.93, 1.0)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE)
    for _ in range(STEPS * 12):  # begin with the cloth about to touch the ball
        cloth.step()
    glutDisplayFunc(display)
    glutReshapeFunc(reshape)
    glutKeyboardFunc(keyboard)
    glutTimerFunc(20, advance, 0)
    glutMainLoop()


if __name__ == "__main__":
    main()
