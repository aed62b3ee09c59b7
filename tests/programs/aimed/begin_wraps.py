"""glBegin(2**32 + 4): ctypes wraps, and a primitive is open."""

from OpenGL import GL
from window import tried

tried("glBegin", lambda: GL.glBegin(2**32 + 4))
tried("glCallList", lambda: GL.glCallList(3))
tried("glEnd", GL.glEnd)
tried("glEnd again", GL.glEnd)
