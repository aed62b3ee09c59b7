"""glMultiDrawArrays of -1 draws fails; what comes after it is as before."""

import numpy as np
from OpenGL import GL
from window import clear, swap, tried

GL.glEnable(GL.GL_DEPTH_TEST)
GL.glEnableClientState(GL.GL_VERTEX_ARRAY)
GL.glVertexPointer(3, GL.GL_FLOAT, 0, np.eye(3, dtype="f"))
first, count = np.array([0], "i4"), np.array([3], "i4")
for draws in (-1, 1, -(2**31), 0):
    clear()
    tried(draws, lambda: GL.glMultiDrawArrays(GL.GL_TRIANGLES, first, count, draws))  # noqa: B023
    swap()
