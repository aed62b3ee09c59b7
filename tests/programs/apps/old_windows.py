"""As GLUT programs were written: two windows and a subwindow, a menu, lists built when they are
first needed, picking by glRenderMode, a HUD, and attribute stacks."""
# ruff: noqa: F403, F405, B905

import sys

from OpenGL.GL import *
from OpenGL.GLU import *
from OpenGL.GLUT import *

angle = 0
lists = {}
windows = {}
picked = []


def box(size):
    s = size / 2
    corners = [(x, y, z) for x in (-s, s) for y in (-s, s) for z in (-s, s)]
    faces = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    normals = ((-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1))
    glBegin(GL_QUADS)
    for face, normal in zip(faces, normals):
        glNormal3fv(normal)
        for corner in face:
            glVertex3fv(corners[corner])
    glEnd()


def part(name):
    """A list per window and part, compiled inside display, nested lists included."""
    key = (glutGetWindow(), name)
    if key not in lists:
        inner = None
        if name == "tower":
            inner = part("box")
        number = lists[key] = glGenLists(1)
        glNewList(number, GL_COMPILE)
        glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT)
        glEnable(GL_COLOR_MATERIAL)
        if name == "box":
            glColor3ub(120, 160, 220)
            box(1.0)
        else:
            for level in range(3):
                glPushMatrix()
                glTranslatef(0, level * 0.9, 0)
                glRotatef(level * 20, 0, 1, 0)
                glScalef(1 - level * 0.2, 0.7, 1 - level * 0.2)
                glCallList(inner)
                glPopMatrix()
        glPopAttrib()
        glEndList()
    return lists[key]


def lights():
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_NORMALIZE)
    glEnable(GL_LIGHTING)
    glEnable(GL_LIGHT0)
    glLightfv(GL_LIGHT0, GL_POSITION, (2, 4, 5, 0))


def camera(width, height, pick=None):
    glViewport(0, 0, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    if pick:
        gluPickMatrix(pick[0], pick[1], 5, 5, glGetIntegerv(GL_VIEWPORT))
    gluPerspective(45, width / max(height, 1), 1, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(3, 3, 6, 0, 0.7, 0, 0, 1, 0)


def scene():
    glRotatef(angle, 0, 1, 0)
    glLoadName(1)
    glCallList(part("tower"))
    glLoadName(2)
    glPushMatrix()
    glTranslatef(2, 0, 0)
    glutSolidTorus(0.2, 0.5, 12, 24)
    glPopMatrix()
    glLoadName(3)
    glPushMatrix()
    glTranslated(-2, 0, 0)
    glutSolidTeapot(0.6)
    glPopMatrix()


def pick(x, y, width, height):
    glSelectBuffer(64)
    glRenderMode(GL_SELECT)
    glInitNames()
    glPushName(0)
    camera(width, height, (x, y))
    scene()
    picked[:] = [hit.names for hit in glRenderMode(GL_RENDER)]


def hud(width, height, text):
    glPushAttrib(GL_LIGHTING_BIT | GL_DEPTH_BUFFER_BIT | GL_CURRENT_BIT)
    glDisable(GL_LIGHTING)
    glMatrixMode(GL_PROJECTION)
    glPushMatrix()
    glLoadIdentity()
    gluOrtho2D(0, width, 0, height)
    glMatrixMode(GL_MODELVIEW)
    glPushMatrix()
    glLoadIdentity()
    glColor3f(0.2, 0.25, 0.2)
    glRectf(8, 8, 200, 40)
    glDepthFunc(GL_ALWAYS)
    glColor3f(1, 1, 0.4)
    glRasterPos2i(16, 18)
    for letter in text:
        glutBitmapCharacter(GLUT_BITMAP_HELVETICA_18, ord(letter))
    glMatrixMode(GL_PROJECTION)
    glPopMatrix()
    glMatrixMode(GL_MODELVIEW)
    glPopMatrix()
    glPopAttrib()


def display():
    width, height = glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT)
    lights()
    glClearColor(0.9, 0.9, 0.85, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    pick(width // 2, height // 2, width, height)
    camera(width, height)
    scene()
    hud(width, height, f"hits {len(picked)}")
    glutSwapBuffers()


def display_small():
    lights()
    glClearColor(0.3, 0.3, 0.4, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    camera(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT))
    glutSolidIcosahedron()
    glutSwapBuffers()


def display_second():
    lights()
    glClearColor(1, 1, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    camera(glutGet(GLUT_WINDOW_WIDTH), glutGet(GLUT_WINDOW_HEIGHT))
    glCallList(part("tower"))
    glutSwapBuffers()


def idle():
    global angle
    angle += 7
    for window in windows.values():
        glutSetWindow(window)
        glutPostRedisplay()


def main():
    glutInit(sys.argv)
    glutInitDisplayMode(GLUT_DOUBLE | GLUT_RGB | GLUT_DEPTH)
    glutInitWindowSize(500, 400)
    glutInitWindowPosition(0, 0)
    windows["main"] = glutCreateWindow(b"main")
    glutDisplayFunc(display)
    menu = glutCreateMenu(lambda entry: 0)
    glutAddMenuEntry(b"nothing", 1)
    glutAttachMenu(GLUT_RIGHT_BUTTON)
    windows["small"] = glutCreateSubWindow(windows["main"], 360, 20, 120, 100)
    glutDisplayFunc(display_small)
    glutInitWindowPosition(600, 0)
    windows["second"] = glutCreateWindow(b"second")
    glutReshapeWindow(300, 300)
    glutDisplayFunc(display_second)
    glutIdleFunc(idle)
    assert menu
    glutMainLoop()


main()
