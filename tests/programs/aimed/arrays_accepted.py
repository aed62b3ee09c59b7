"""Arrays and numbers that PyOpenGL refuses, or takes, inside glBegin and glEnd."""

import numpy as np
from OpenGL import GL
from window import tried

GL.glBegin(GL.GL_TRIANGLES)
tried("glVertex3fv of >f4", lambda: GL.glVertex3fv(np.zeros(3, ">f4")))
tried("glVertex3fv of f8", lambda: GL.glVertex3fv(np.zeros(3)))
tried("glVertex3fv of bytes", lambda: GL.glVertex3fv(b"0" * 12))
tried("glVertex3fv of two", lambda: GL.glVertex3fv([0, 0]))
tried("glEdgeFlag of numpy's bool", lambda: GL.glEdgeFlag(np.bool_(0)))
tried("glVertex3f of text", lambda: GL.glVertex3f("0", 0, 0))
tried("glVertex3f of two", lambda: GL.glVertex3f(0, 0))
GL.glEnd()
