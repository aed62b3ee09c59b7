"""Valid calls with ctypes numbers and pointers."""

import ctypes

import numpy as np
import OpenGL.raw.GL.VERSION.GL_1_1 as raw
from OpenGL import GL
from window import clear, swap, tried

GL.glEnable(GL.GL_DEPTH_TEST)
INDICES = (ctypes.c_uint * 3)(0, 1, 2)
UNSIGNED = GL.GL_UNSIGNED_INT
GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
GL.glVertexPointer(3, GL.GL_FLOAT, 0, np.eye(3, dtype="f"))
calls = {
    "mode": lambda: GL.glDrawArrays(ctypes.c_uint(4), 0, 3),
    "byref": lambda: raw.glDrawElements(4, 3, UNSIGNED, ctypes.byref(INDICES)),
    "pointer": lambda: raw.glDrawElements(4, 3, UNSIGNED, ctypes.pointer(INDICES)),
    "list": lambda: GL.glCallList(ctypes.c_uint(1)),
    "rectangle": lambda: GL.glRectf(*map(ctypes.c_float, (0, 0, 1, 1))),
    "mesh of a bad mode": lambda: GL.glEvalMesh2(5, 0, 3, 0, 3),
    "flat projection": lambda: GL.glOrtho(0, 0, 0, 0, 0, 0),
    "endless number of lists": lambda: GL.glDeleteLists(1, 2**31 - 1),
    "not a number": lambda: GL.glRectd(float("nan"), 0, 1, 1),
}
for name, call in calls.items():
    clear()
    tried(name, call)
    swap()
