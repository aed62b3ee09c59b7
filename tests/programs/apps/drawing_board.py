"""A GLUT program with what goes by pixels: viewports, scissor boxes, widths, text, readbacks.

`python drawing_board.py WIDTH HEIGHT K [counting]`: a window of that size in which lines and points
are K times as wide. It says what GL says about its state at the end of each frame; `counting` has it
move with every frame that it draws.
"""

import sys

from OpenGL.GL import *  # noqa: F403
from OpenGL.GLUT import *  # noqa: F403

WIDTH, HEIGHT, K = int(sys.argv[1]), int(sys.argv[2]), float(sys.argv[3])
COUNTING = "counting" in sys.argv
ARROW = bytes((0x18, 0x3C, 0x7E, 0xFF, 0x18, 0x18, 0x18, 0x18))
turn = 0.0


def box():
    for axis in range(3):
        for side in (-1, 1):
            normal = [0.0, 0.0, 0.0]
            normal[axis] = side
            glNormal3f(*normal)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = [0.0, 0.0, 0.0]
                corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, a * side, b
                glVertex3f(*corner)


def rails():
    """A display list with widths of its own."""
    glNewList(1, GL_COMPILE)
    glLineWidth(2 * K)
    glBegin(GL_LINES)
    for x in (-1.6, 1.6):
        glVertex3f(x, -1.4, 0)
        glVertex3f(x, 1.4, 0)
    glEnd()
    glLineWidth(K)
    glEndList()


def scene():
    global turn
    turn += 4.0 if COUNTING else 0.0
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glFrustum(-0.5, 0.5, -0.375 * 1.0, 0.375, 1.0, 20.0)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glTranslatef(0, 0, -5)
    glColor3f(0.1, 0.3, 0.6)
    glCallList(1)
    glRotatef(30 + turn, 1, 0.4, 0)
    glRotatef(40, 0, 1, 0)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glBegin(GL_QUADS)
    box()
    glEnd()
    glDisable(GL_LIGHTING)


def flat():
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    glOrtho(0, 160, 0, 120, -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()


def display():
    glViewport(0, 0, WIDTH, HEIGHT)
    glClearColor(0.9, 0.88, 0.84, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    scene()
    glDisable(GL_DEPTH_TEST)
    glEnable(GL_SCISSOR_TEST)  # a panel
    glScissor(WIDTH * 3 // 4, 0, WIDTH // 4, HEIGHT // 3)
    glClearColor(0.2, 0.25, 0.3, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glDisable(GL_SCISSOR_TEST)
    glViewport(WIDTH * 3 // 4, 0, WIDTH // 4, HEIGHT // 3)
    glEnable(GL_DEPTH_TEST)
    scene()
    glDisable(GL_DEPTH_TEST)
    glViewport(0, 0, WIDTH, HEIGHT)
    flat()
    colour = glReadPixels(WIDTH // 2, HEIGHT // 2, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)
    glColor3ub(*bytes(colour)[:3])  # a swatch of what lies in the middle
    glRectf(4, 4, 24, 16)
    glColor3f(0.7, 0.1, 0.1)
    glPointSize(6 * K)
    glBegin(GL_POINTS)
    glVertex2f(30, 10)
    glVertex2f(40, 10)
    glEnd()
    glEnable(GL_LINE_STIPPLE)
    glLineStipple(int(2 * K), 0x0F0F)
    glLineWidth(3 * K)
    glBegin(GL_LINES)
    glVertex2f(4, 110.25)
    glVertex2f(150, 110.25)
    glEnd()
    glDisable(GL_LINE_STIPPLE)
    glColor3f(0, 0, 0)
    glRasterPos2f(50, 6)
    if K == 1:
        glBitmap(8, 8, 0, 0, 12, 0, ARROW)
        for letter in b"GL 12":
            glutBitmapCharacter(GLUT_BITMAP_HELVETICA_12, letter)
    state = [list(map(int, glGetIntegerv(GL_VIEWPORT))), list(map(int, glGetIntegerv(GL_SCISSOR_BOX))),
             float(glGetFloatv(GL_LINE_WIDTH)), float(glGetFloatv(GL_POINT_SIZE)),
             int(glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING)), int(glGetIntegerv(GL_DRAW_BUFFER)),
             bool(glGetBooleanv(GL_DOUBLEBUFFER)), int(glGetIntegerv(GL_LINE_STIPPLE_REPEAT)),
             int(glGetError())]
    print("state", state, file=sys.stderr, flush=True)
    glFlush()
    glutSwapBuffers()


glutInit(sys.argv[:1])
glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
glutInitWindowSize(WIDTH, HEIGHT)
glutCreateWindow(b"drawing board")
glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
rails()
glutDisplayFunc(display)
glutMainLoop()
