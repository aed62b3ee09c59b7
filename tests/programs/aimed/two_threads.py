"""Two threads draw in windows of their own, switched as often as Python can."""

import sys
import threading
import zlib

import OpenGL

OpenGL.ERROR_CHECKING = False  # PyOpenGL knows of one open primitive alone
import glfw  # noqa: E402
import numpy as np  # noqa: E402
from OpenGL import GL  # noqa: E402

sys.setswitchinterval(1e-6)
glfw.init()
glfw.window_hint(glfw.VISIBLE, glfw.FALSE)
windows = [glfw.create_window(64, 48, "", None, None) for _ in range(2)]
seen: dict[int, list[int]] = {0: [], 1: []}


def block(x: int, y: int) -> bytes:
    """As a program picks: so few pixels are the app's own in every style."""
    return GL.glReadPixels(x, y, 8, 8, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)


def draw(number: int) -> None:
    glfw.make_context_current(windows[number])
    random = np.random.default_rng(number)
    for _ in range(6):
        GL.glClear(GL.GL_COLOR_BUFFER_BIT)
        for _ in range(4):
            GL.glColor3f(*random.uniform(0, 1, 3).tolist())
            GL.glBegin(GL.GL_TRIANGLES)
            for corner in random.uniform(-1, 1, (600, 3)).tolist():
                GL.glVertex3f(*corner)
                GL.glColor3f(*map(abs, corner))
            GL.glEnd()
            GL.glNormal3f(0, 0, 1)
        pixels = b"".join(block(x, y) for x in range(0, 64, 8) for y in range(0, 48, 8))
        seen[number].append(zlib.crc32(pixels))
        glfw.swap_buffers(windows[number])
    glfw.make_context_current(None)


threads = [threading.Thread(target=draw, args=(number,)) for number in range(2)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(seen)
