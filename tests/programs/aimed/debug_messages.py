"""The program's debug callback, while an error waits at the end of a frame."""

import ctypes

import OpenGL

OpenGL.ERROR_CHECKING = False
from OpenGL import GL  # noqa: E402
from window import clear, swap, triangle  # noqa: E402

heard = []


@GL.GLDEBUGPROC
def hear(*words):
    heard.append(ctypes.string_at(words[5], words[4]).decode()[:80])


GL.glEnable(GL.GL_DEBUG_OUTPUT)
GL.glEnable(GL.GL_DEBUG_OUTPUT_SYNCHRONOUS)
GL.glDebugMessageCallback(hear, None)
GL.glEnable(GL.GL_DEPTH_TEST)
for _ in range(3):
    clear()
    triangle()
    GL.glPopMatrix()
    swap()
    GL.glGetError()
print(len(heard), sorted(set(heard)))
