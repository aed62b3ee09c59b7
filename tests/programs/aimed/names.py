"""Textures by names that were never generated, as compatibility profiles allow, after a frame."""

import numpy as np
from OpenGL import GL
from window import clear, swap, triangle

GL.glEnable(GL.GL_DEPTH_TEST)


def frame():
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
    GL.glDisable(GL.GL_TEXTURE_2D)
    GL.glColor3f(1, 1, 1)
    clear()
    triangle()
    swap()


def content():
    texels = GL.glGetTexImage(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)
    return np.frombuffer(texels, "u1").reshape(-1, 3)[2000].tolist()


def made():
    """What the program is given by each function that makes names."""
    return [
        GL.glGenTextures(1), GL.glGenBuffers(1), GL.glGenFramebuffers(1), GL.glGenRenderbuffers(1),
        GL.glGenLists(1), GL.glCreateProgram(), GL.glCreateShader(GL.GL_VERTEX_SHADER),
        GL.glGenVertexArrays(1), GL.glGenSamplers(1), GL.glGenProgramPipelines(1),
    ]  # fmt: skip


frame()
red = np.zeros((64, 64, 3), "u1")
red[:, :, 0] = 255
print([[bool(known(n)) for n in range(1, 40)] for known in (
    GL.glIsTexture, GL.glIsBuffer, GL.glIsFramebuffer, GL.glIsProgram, GL.glIsShader, GL.glIsList)])
for name in range(1, 9):
    GL.glBindTexture(GL.GL_TEXTURE_2D, name)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGB, 64, 64, 0, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, red)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MIN_FILTER, GL.GL_NEAREST)
    GL.glTexParameteri(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER, GL.GL_NEAREST)
for _ in range(3):
    frame()
    print([int(name) for name in made()])
for name in range(1, 9):
    GL.glBindTexture(GL.GL_TEXTURE_2D, name)
    print(name, content(), GL.glGetTexParameteriv(GL.GL_TEXTURE_2D, GL.GL_TEXTURE_MAG_FILTER))
GL.glDeleteTextures(list(range(1, 1000)))
for _ in range(2):
    frame()
print(GL.glGetError())
