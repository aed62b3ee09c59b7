"""Lists that are executed as they are compiled, where Mesa takes a primitive for open that is not:
what is asked of it there makes an error that the program reads."""

import OpenGL

OpenGL.ERROR_CHECKING = False  # PyOpenGL would ask after each call
import glfw  # noqa: E402
from OpenGL import GL  # noqa: E402

glfw.init()
glfw.window_hint(glfw.VISIBLE, glfw.FALSE)
glfw.make_context_current(glfw.create_window(64, 48, "", None, None))


def steps(first: int, second: int, vertex: bool, last: str) -> None:
    GL.glBegin(first)
    GL.glVertex3d(0, 0, 1)
    GL.glColor3s(1, 2, 3)
    GL.glEnd()
    GL.glBegin(second)
    if vertex:
        GL.glVertex3d(0, 0, 1)
    GL.glEnd()
    if last == "normal":
        GL.glNormal3d(0, 0, 1)
    elif last == "colour":
        GL.glColor3s(1, 2, 3)
    elif last == "clip":
        GL.glClipPlane(GL.GL_CLIP_PLANE0, (0, 0, 1, 0))


for first in (GL.GL_LINE_STRIP, GL.GL_POLYGON):
    for second in (GL.GL_POLYGON, GL.GL_TRIANGLES):
        for vertex in (False, True):
            for last in ("normal", "colour", "clip", ""):
                GL.glNewList(1, GL.GL_COMPILE_AND_EXECUTE)
                steps(first, second, vertex, last)
                before = GL.glGetError()
                GL.glEndList()
                print(first, second, vertex, last, before, GL.glGetError())
