"""An ARB vertex program moves the triangle: no lines belong where it would have been."""

import numpy as np
from OpenGL import GL
from OpenGL.GL.ARB import vertex_program as arb
from window import clear, pixels, swap

SOURCE = b"""!!ARBvp1.0
TEMP p;
MUL p, vertex.position, {0.3, 0.3, 1, 1};
ADD p, p, {0.5, 0.5, 0, 0};
MOV result.position, p;
MOV result.color, {1, 0, 0, 1};
END
"""
GL.glEnable(GL.GL_DEPTH_TEST)
name = np.zeros(1, "u4")
arb.glGenProgramsARB(1, name)
arb.glBindProgramARB(arb.GL_VERTEX_PROGRAM_ARB, int(name[0]))
arb.glProgramStringARB(
    arb.GL_VERTEX_PROGRAM_ARB, arb.GL_PROGRAM_FORMAT_ASCII_ARB, len(SOURCE), SOURCE)
GL.glEnable(arb.GL_VERTEX_PROGRAM_ARB)
GL.glClearColor(1, 1, 1, 1)
for _ in range(2):
    clear()
    GL.glBegin(GL.GL_TRIANGLES)
    GL.glVertex3f(-0.9, -0.9, 0)
    GL.glVertex3f(0.9, -0.9, 0)
    GL.glVertex3f(0, 0.9, 0)
    GL.glEnd()
    picture = pixels()
    red, black = (picture == [255, 0, 0]).all(2).sum(), (picture == 0).all(2).sum()
    print("red", red, "black", black, "other", 4096 - red - black)
    swap()
