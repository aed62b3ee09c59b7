"""What the programs of this folder share: a hidden window that is current, and a triangle."""

import re

import glfw
from OpenGL import GL

glfw.init()
glfw.window_hint(glfw.VISIBLE, 0)
glfw.window_hint(glfw.OPENGL_DEBUG_CONTEXT, 1)
window = glfw.create_window(64, 64, "aimed", None, None)
glfw.make_context_current(window)


def triangle():
    GL.glBegin(GL.GL_TRIANGLES)
    for corner in ((-0.5, -0.5, 0), (0.5, -0.5, 0), (0, 0.5, 0)):
        GL.glVertex3f(*corner)
    GL.glEnd()


def clear():
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)


def swap():
    glfw.swap_buffers(window)


def tried(name, call):
    """Print what the call returns, or what it raises."""
    try:
        print(name, "gives", call())
    except Exception as fault:
        said = re.sub("0x[0-9a-f]+", "(address)", str(fault))
        print(name, type(fault).__name__, getattr(fault, "err", said[:200]))


def pixels():
    """The picture, (64, 64, 3) uint8."""
    import numpy as np

    bytes_ = GL.glReadPixels(0, 0, 64, 64, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return np.frombuffer(bytes_, "u1").reshape(64, 64, 3)
