"""Old tricks: a stencil reflection, a planar shadow, a picture in a texture by way of a framebuffer
object, a GLSL 1.20 shader beside the fixed functions, and the accumulation buffer."""
# ruff: noqa: F403, F405

import sys

import numpy as np
from OpenGL.GL import *
from OpenGL.GL import shaders
from OpenGL.GLU import *
from OpenGL.GLUT import *

VERTEX = """#version 120
varying vec3 normal;
void main() { normal = gl_NormalMatrix * gl_Normal; gl_Position = ftransform(); }
"""
FRAGMENT = """#version 120
varying vec3 normal;
void main() { gl_FragColor = vec4(vec3(max(dot(normalize(normal), vec3(0, 0, 1)), 0.2)), 1.0); }
"""
turn = 0.0
made = {}


def setup():
    made["texture"] = glGenTextures(1)
    glBindTexture(GL_TEXTURE_2D, made["texture"])
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, None)
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR)
    made["frame"] = glGenFramebuffers(1)
    glBindFramebuffer(GL_FRAMEBUFFER, made["frame"])
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           made["texture"], 0)
    depth = glGenRenderbuffers(1)
    glBindRenderbuffer(GL_RENDERBUFFER, depth)
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 256, 256)
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth)
    assert glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
    glBindFramebuffer(GL_FRAMEBUFFER, 0)
    made["program"] = shaders.compileProgram(
        shaders.compileShader(VERTEX, GL_VERTEX_SHADER),
        shaders.compileShader(FRAGMENT, GL_FRAGMENT_SHADER))
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHT0)
    glEnable(GL_NORMALIZE)
    glEnable(GL_COLOR_MATERIAL)


def thing():
    glColor3f(0.8, 0.5, 0.3)
    glPushMatrix()
    glRotatef(turn, 0, 1, 0)
    glutSolidCube(1.2)
    glTranslatef(0, 1.1, 0)
    glRotatef(-90, 1, 0, 0)
    glutSolidCone(0.6, 1.0, 24, 4)
    glPopMatrix()


def floor():
    glBegin(GL_QUADS)
    glNormal3f(0, 1, 0)
    for x, z in ((-3, -3), (-3, 3), (3, 3), (3, -3)):
        glVertex3f(x, 0, z)
    glEnd()


def inset():
    """The thing from above, into the texture."""
    glBindFramebuffer(GL_FRAMEBUFFER, made["frame"])
    glViewport(0, 0, 256, 256)
    glClearColor(0.8, 0.9, 1, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1, 1, 20)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(1, 6, 3, 0, 0.5, 0, 0, 1, 0)
    glEnable(GL_LIGHTING)
    thing()
    glBindFramebuffer(GL_FRAMEBUFFER, 0)


def picture():
    glViewport(0, 0, 500, 400)
    glClearColor(0.9, 0.9, 0.9, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluPerspective(40, 1.25, 1, 50)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    gluLookAt(4, 4, 8, 0, 0.8, 0, 0, 1, 0)
    # where the floor is
    glDisable(GL_DEPTH_TEST)
    glColorMask(0, 0, 0, 0)
    glEnable(GL_STENCIL_TEST)
    glStencilOp(GL_REPLACE, GL_REPLACE, GL_REPLACE)
    glStencilFunc(GL_ALWAYS, 1, 0xFF)
    floor()
    glColorMask(1, 1, 1, 1)
    glEnable(GL_DEPTH_TEST)
    # the mirror image, only there
    glStencilFunc(GL_EQUAL, 1, 0xFF)
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP)
    glPushMatrix()
    glScalef(1, -1, 1)
    glFrontFace(GL_CW)
    glEnable(GL_LIGHTING)
    glTranslatef(0, 0.7, 0)
    thing()
    glFrontFace(GL_CCW)
    glPopMatrix()
    # the floor over it, then a flat shadow
    glDisable(GL_LIGHTING)
    glEnable(GL_BLEND)
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
    glColor4f(0.7, 0.7, 0.9, 0.6)
    floor()
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR)
    glDisable(GL_DEPTH_TEST)
    glPushMatrix()
    shadow = np.identity(4, "f")
    shadow[1] = (-0.5, 0, -0.3, 0)
    glMultMatrixf(shadow)
    glTranslatef(0, 0.7, 0)
    glDisable(GL_COLOR_MATERIAL)
    glColor4f(0, 0, 0, 0.3)
    glutSolidCube(1.2)
    glEnable(GL_COLOR_MATERIAL)
    glPopMatrix()
    glEnable(GL_DEPTH_TEST)
    glDisable(GL_BLEND)
    glDisable(GL_STENCIL_TEST)
    # the thing itself, and one with a shader of its own
    glEnable(GL_LIGHTING)
    glPushMatrix()
    glTranslatef(0, 0.7, 0)
    thing()
    glPopMatrix()
    glPushMatrix()
    glTranslatef(-2, 0.6, 0)
    glUseProgram(made["program"])
    glutSolidTorus(0.2, 0.5, 12, 24)
    glUseProgram(0)
    glPopMatrix()
    # the texture in a corner
    glDisable(GL_LIGHTING)
    glEnable(GL_TEXTURE_2D)
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    gluOrtho2D(0, 500, 0, 400)
    glMatrixMode(GL_MODELVIEW)
    glLoadIdentity()
    glColor3f(1, 1, 1)
    glBegin(GL_QUADS)
    for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
        glTexCoord2f(s, t)
        glVertex2f(360 + 130 * s, 260 + 130 * t)
    glEnd()
    glDisable(GL_TEXTURE_2D)


def display():
    global turn
    if not made:
        setup()
    inset()
    glClear(GL_ACCUM_BUFFER_BIT)
    for step in range(2):
        turn += step * 3
        picture()
        glAccum(GL_ACCUM, 0.5)
    glAccum(GL_RETURN, 1)
    glutSwapBuffers()


def tick(_):
    global turn
    turn += 10
    glutPostRedisplay()
    glutTimerFunc(20, tick, 0)


def main():
    glutInit(sys.argv)
    glutInitDisplayMode(
        GLUT_DOUBLE | GLUT_RGBA | GLUT_DEPTH | GLUT_STENCIL | GLUT_ACCUM)
    glutInitWindowSize(500, 400)
    glutCreateWindow(b"effects")
    glutDisplayFunc(display)
    glutTimerFunc(20, tick, 0)
    glutMainLoop()


main()
