"""Errors that wait while a frame ends: the program asks for them later."""

import OpenGL

OpenGL.ERROR_CHECKING = False
from OpenGL import GL  # noqa: E402
from window import clear, swap, triangle  # noqa: E402

GL.glEnable(GL.GL_DEPTH_TEST)
GL.glGetError()


def bad_enum():
    GL.glEnable(0xFFFF)


def bad_value():
    GL.glViewport(0, 0, -1, -1)


def bad_operation():
    GL.glBufferData(GL.GL_ARRAY_BUFFER, 0, None, GL.GL_STATIC_DRAW)


def underflow():
    GL.glPopMatrix()


def overflow():
    for _ in range(40):
        GL.glPushMatrix()


def incomplete():
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, GL.glGenFramebuffers(1))
    GL.glClear(GL.GL_COLOR_BUFFER_BIT)
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)


for fault in (bad_enum, bad_value, bad_operation, underflow, overflow, incomplete):
    for first, then in ((fault, triangle), (triangle, fault)):
        clear()
        first()
        then()
        swap()
        print(fault.__name__, "first" if first is fault else "last",
              GL.glGetError(), GL.glGetError())  # fmt: skip
        for _ in range(40):
            GL.glPopMatrix()
        while GL.glGetError():
            pass
