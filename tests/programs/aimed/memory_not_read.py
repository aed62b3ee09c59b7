"""Draws that the driver refuses, or that do not read what a pointer points to. Argument: which."""

import ctypes
import sys

import numpy as np
from OpenGL import GL
from window import swap, tried

POINTS = np.random.RandomState(0).rand(40, 3).astype("f")
INDICES = np.array([2**32 - 1, 2**32 - 2, 2**32 - 3], "u4")


def gone():
    """Point to memory that cannot be read, as freed memory may be."""
    GL.glVertexPointer(3, GL.GL_FLOAT, 0, ctypes.c_void_p(4096))


def incomplete():
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, GL.glGenFramebuffers(1))
    gone()
    GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)


def reversed_range():
    nowhere = ctypes.c_void_p(64)
    GL.glDrawRangeElements(GL.GL_TRIANGLES, 5, 2, 3, GL.GL_UNSIGNED_INT, nowhere)


def far_element():
    GL.glBegin(GL.GL_TRIANGLES)
    GL.glArrayElement(2**30)
    GL.glEnd()


def too_few():
    gone()
    GL.glDrawArrays(GL.GL_TRIANGLES, 0, 2)


def generic_zero():
    gone()
    GL.glEnableVertexAttribArray(0)
    GL.glVertexAttribPointer(0, 3, GL.GL_FLOAT, 0, 0, POINTS)
    GL.glDrawArrays(GL.GL_TRIANGLES, 0, 3)


def base_wraps():
    GL.glDrawElementsBaseVertex(GL.GL_TRIANGLES, 3, GL.GL_UNSIGNED_INT, INDICES, 4)


GL.glEnable(GL.GL_DEPTH_TEST)
GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
GL.glVertexPointer(3, GL.GL_FLOAT, 0, POINTS)
tried(sys.argv[1], globals()[sys.argv[1]])
swap()
print("alive")
