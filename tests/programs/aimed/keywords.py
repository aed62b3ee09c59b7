"""Keyword arguments: ctypes ignores them, PyOpenGL's wrappers know the names of theirs."""

from OpenGL import GL
from window import tried

GL.glBegin(GL.GL_TRIANGLES)
tried("one too many", lambda: GL.glVertex3f(0, 0, 0, extra=1))
tried("by name", lambda: GL.glVertex3f(x=0, y=0, z=0))
tried("colour and more", lambda: GL.glColor4f(1, 1, 1, 1, a=1))
tried("a wrapper's own", lambda: GL.glVertex3fv(v=[0, 0, 0]))
tried("a wrapper's and more", lambda: GL.glNormal3fv([0, 0, 1], x=1))
tried("glEnd", GL.glEnd)
tried("glCallList", lambda: GL.glCallList(1, x=2))
tried("glNewList", lambda: GL.glNewList(1, GL.GL_COMPILE, x=2))
tried("glEndList", lambda: GL.glEndList(x=1))
tried("glClear", lambda: GL.glClear(0x4000, x=1))
tried("glRectf", lambda: GL.glRectf(0, 0, 1, 1, x=1))
tried("glFlush", lambda: GL.glFlush(x=1))
tried("glMaterialf", lambda: GL.glMaterialf(GL.GL_FRONT, GL.GL_SHININESS, 3, x=1))
