"""Calls that go past PyOpenGL's wrappers, straight into the library, between glBegin and glEnd."""

from OpenGL import GL
from OpenGL.platform import PLATFORM
from window import pixels

colour = PLATFORM.GL.glColor3ub
corners = (((-1, -1, 0), (255, 0, 0)), ((1, -1, 0), (0, 255, 0)), ((0, 1, 0), (0, 0, 255)))
GL.glBegin(GL.GL_TRIANGLES)
for corner, shade in corners:
    colour(*shade)
    GL.glVertex3f(*corner)
GL.glEnd()
picture = pixels()
print(picture[2, 4].tolist(), picture[2, 60].tolist(), picture[60, 32].tolist())
