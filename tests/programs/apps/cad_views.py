"""As CAD programs draw: four views by viewport and scissor, interleaved arrays and numpy indices,
tessellated outlines, picking by colour, labels as textures and as pixels."""
# ruff: noqa: F403, F405, B905, PLR0917

import numpy as np
import pygame
from OpenGL.GL import *
from OpenGL.GLU import *

SIZE = (640, 480)


def block():
    """GL_QUADS of a block as T2F_N3F_V3F records and their indices."""
    rows, indices = [], []
    for axis in range(3):
        for sign in (-1, 1):
            u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            n = np.eye(3)[axis] * sign
            corners = [n - u - v, n + u - v, n + u + v, n - u + v]
            indices += [len(rows) + i for i in (range(4) if sign > 0 else range(3, -1, -1))]
            for corner, (s, t) in zip(corners, ((0, 0), (1, 0), (1, 1), (0, 1))):
                rows.append((s, t, *n, *corner))
    return np.array(rows, np.float32), np.array(indices, np.uint16)


RECORDS, INDICES = block()


def letter_list():
    """A letter L with a hole, through the tessellator."""
    tess = gluNewTess()
    gluTessCallback(tess, GLU_TESS_BEGIN, glBegin)
    gluTessCallback(tess, GLU_TESS_VERTEX, glVertex3dv)
    gluTessCallback(tess, GLU_TESS_END, glEnd)
    gluTessCallback(tess, GLU_TESS_COMBINE, lambda at, data, weight: tuple(at))
    gluTessProperty(tess, GLU_TESS_WINDING_RULE, GLU_TESS_WINDING_ODD)
    outline = [(0, 0), (2, 0), (2, 0.7), (0.7, 0.7), (0.7, 2), (0, 2)]
    hole = [(0.2, 0.2), (0.5, 0.2), (0.5, 0.5), (0.2, 0.5)]
    made = glGenLists(1)
    glNewList(made, GL_COMPILE)
    glNormal3f(0, 0, 1)
    gluTessBeginPolygon(tess, None)
    for contour in (outline, hole):
        gluTessBeginContour(tess)
        for x, y in contour:
            gluTessVertex(tess, (x, y, 0.0), (x, y, 0.0))
        gluTessEndContour(tess)
    gluTessEndPolygon(tess)
    glEndList()
    gluDeleteTess(tess)
    return made


def label(text):
    """A texture from a rendered text."""
    font = pygame.font.Font(None, 32)
    surface = font.render(text, True, (20, 20, 120))
    data = pygame.image.tostring(surface, "RGBA", True)
    name = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, name)
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, *surface.get_size(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 data)
    return name, surface.get_size()


def scene(angle, letter, pick=False):
    colours = ((200, 90, 60), (80, 140, 90))
    glPushMatrix()
    glRotatef(angle, 0, 1, 0)
    glColor3ub(*((1, 0, 0) if pick else colours[0]))
    glInterleavedArrays(GL_T2F_N3F_V3F, 0, RECORDS)
    glDrawElements(GL_QUADS, len(INDICES), GL_UNSIGNED_SHORT, INDICES)
    glDisableClientState(GL_VERTEX_ARRAY)
    glDisableClientState(GL_NORMAL_ARRAY)
    glDisableClientState(GL_TEXTURE_COORD_ARRAY)
    glPopMatrix()
    glPushMatrix()
    glTranslatef(-1, -1, 2)
    glColor3ub(*((2, 0, 0) if pick else colours[1]))
    glCallList(letter)
    glPopMatrix()


def view(x, y, width, height, eye, flat):
    glViewport(x, y, width, height)
    glScissor(x, y, width, height)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    ratio = width / height
    if flat:
        glOrtho(-4 * ratio, 4 * ratio, -4, 4, 0.1, 50)
    else:
        gluPerspective(40, ratio, 0.5, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(*eye, 0, 0, 0, 0, 1, 0.001)


def show_label(texture, x, y):
    name, (width, height) = texture
    glPushAttrib(GL_ALL_ATTRIB_BITS)
    glDisable(GL_DEPTH_TEST)
    glDisable(GL_LIGHTING)
    glEnable(GL_TEXTURE_2D)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glViewport(0, 0, *SIZE)
    glDisable(GL_SCISSOR_TEST)
    glMatrixMode(GL_PROJECTION)
    glPushMatrix()
    glLoadIdentity()
    glOrtho(0, SIZE[0], 0, SIZE[1], -1, 1)
    glMatrixMode(GL_MODELVIEW)
    glPushMatrix()
    glLoadIdentity()
    glColor4f(1, 1, 1, 1)
    glBindTexture(GL_TEXTURE_2D, name)
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord2f(s, t)
        glVertex2f(x + s * width, y + t * height)
    glEnd()
    glRasterPos2i(x, y + height + 4)
    glDrawPixels(16, 8, GL_RGB, GL_UNSIGNED_BYTE, np.full((8, 16, 3), 90, np.uint8))
    glPopMatrix()
    glMatrixMode(GL_PROJECTION)
    glPopMatrix()
    glMatrixMode(GL_MODELVIEW)
    glPopAttrib()


def main():
    pygame.init()
    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    letter, texture = letter_list(), label("top / front / side")
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_SCISSOR_TEST)
    glEnable(GL_LIGHT0)
    glEnable(GL_COLOR_MATERIAL)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1)
    width, height = SIZE[0] // 2, SIZE[1] // 2
    views = (
        (0, 0, (0, 0, 10), True), (width, 0, (10, 0, 0), True),
        (0, height, (0, 10, 0), True), (width, height, (5, 4, 7), False),
    )
    clock = pygame.time.Clock()
    for frame in range(60):
        angle = frame * 6
        view(width, height, width, height, (5, 4, 7), False)
        glDisable(GL_LIGHTING)
        glClearColor(0, 0, 0, 0)
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
        scene(angle, letter, pick=True)
        under = glReadPixels(width * 3 // 2, height * 3 // 2, 1, 1, GL_RGB, GL_UNSIGNED_BYTE)
        number = bytearray(under)[0]
        assert number in (0, 1, 2), number
        glEnable(GL_LIGHTING)
        for x, y, eye, flat in views:
            view(x, y, width, height, eye, flat)
            glClearColor(0.95, 0.95, 1 - 0.05 * (x > 0), 1)
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
            scene(angle, letter)
        show_label(texture, 10, 10)
        pygame.display.flip()
        pygame.event.get()
        clock.tick(50)


main()
