"""A window that shows one display list, always from the same side: GLUT."""

import sys
from collections.abc import Callable

from OpenGL import GL, GLU, GLUT

Vector = tuple[float, float, float]
SIZE = (640, 480)


def show(draw: Callable[[], None], eye: Vector, target: Vector, field: float = 30.0) -> None:
    """Open it; z is up, the field of view in degrees. ESC leaves."""
    GLUT.glutInit(sys.argv)
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE | GLUT.GLUT_RGB | GLUT.GLUT_DEPTH)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"Figure")
    GL.glClearColor(1.0, 1.0, 1.0, 1.0)
    for switch in (GL.GL_DEPTH_TEST, GL.GL_CULL_FACE, GL.GL_NORMALIZE, GL.GL_LIGHTING,
                   GL.GL_LIGHT0):  # fmt: skip
        GL.glEnable(switch)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_DIFFUSE, (0.78, 0.78, 0.76, 1.0))
    GL.glLightModelfv(GL.GL_LIGHT_MODEL_AMBIENT, (0.38, 0.38, 0.40, 1.0))
    GL.glMatrixMode(GL.GL_PROJECTION)
    distance = sum((a - b) ** 2 for a, b in zip(eye, target, strict=True)) ** 0.5
    GLU.gluPerspective(field, SIZE[0] / SIZE[1], distance / 8, distance * 8)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLightfv(GL.GL_LIGHT0, GL.GL_POSITION, (-3.0, 5.0, 6.0, 0.0))
    GLU.gluLookAt(*eye, *target, 0.0, 0.0, 1.0)
    shown = GL.glGenLists(1)
    GL.glNewList(shown, GL.GL_COMPILE)
    draw()
    GL.glEndList()

    def display() -> None:
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        GL.glCallList(shown)
        GLUT.glutSwapBuffers()

    def again(_value: int) -> None:
        GLUT.glutPostRedisplay()
        GLUT.glutTimerFunc(16, again, 0)

    def keyboard(key: bytes, _x: int, _y: int) -> None:
        if key == b"\x1b":
            GLUT.glutLeaveMainLoop()

    GLUT.glutDisplayFunc(display)
    GLUT.glutKeyboardFunc(keyboard)
    GLUT.glutTimerFunc(16, again, 0)
    GLUT.glutMainLoop()
