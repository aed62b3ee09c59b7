"""Draws when it is asked to, and says which keys it gets."""

import sys

import toolkit_scene
from OpenGL.GLUT import *  # noqa: F403


def display():
    toolkit_scene.angle = 20
    toolkit_scene.draw(320, 240)
    glutSwapBuffers()  # noqa: F405


def typed(key, x, y):
    print("key", key.decode(), flush=True)
    if key == b"\x1b":
        glutLeaveMainLoop()  # noqa: F405


def special(key, x, y):
    print("key", f"F{key}", flush=True)


glutInit(sys.argv)  # noqa: F405
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)  # noqa: F405
glutInitWindowSize(320, 240)  # noqa: F405
glutCreateWindow(b"keys")  # noqa: F405
glutDisplayFunc(display)  # noqa: F405
glutKeyboardFunc(typed)  # noqa: F405
if "deaf" not in sys.argv:
    glutSpecialFunc(special)  # noqa: F405
glutMainLoop()  # noqa: F405
