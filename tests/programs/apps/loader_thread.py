"""A thread with a context of its own that fills buffers and draws while the main thread is between
glBegin and glEnd."""

# ruff: noqa: F403, F405
import threading

import glfw
import numpy as np
from OpenGL.GL import *

CORNERS = [(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (-0.8, 0.8)]
asked, done, over = threading.Event(), threading.Event(), threading.Event()


def load(window):
    glfw.make_context_current(window)
    buffer = glGenBuffers(1)
    while asked.wait() and not over.is_set():
        asked.clear()
        glBindBuffer(GL_ARRAY_BUFFER, buffer)
        glBufferData(GL_ARRAY_BUFFER, np.array(CORNERS, np.float32), GL_STATIC_DRAW)
        glEnableClientState(GL_VERTEX_ARRAY)
        glVertexPointer(2, GL_FLOAT, 0, None)
        glDrawArrays(GL_QUADS, 0, 4)
        glFinish()
        done.set()


glfw.init()
shown = glfw.create_window(300, 200, "shown", None, None)
glfw.set_window_pos(shown, 0, 0)
glfw.window_hint(glfw.VISIBLE, False)
hidden = glfw.create_window(100, 100, "hidden", None, shown)
thread = threading.Thread(target=load, args=(hidden,))
thread.start()
glfw.make_context_current(shown)
for _ in range(8):
    glEnable(GL_DEPTH_TEST)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glBegin(GL_QUADS)
    for number, corner in enumerate(CORNERS):
        glColor3f(1, number / 3, 0)
        glVertex2f(*corner)
        if number == 1:
            asked.set()
            done.wait()
            done.clear()
    glEnd()
    glfw.swap_buffers(shown)
over.set()
asked.set()
thread.join()
glfw.terminate()
