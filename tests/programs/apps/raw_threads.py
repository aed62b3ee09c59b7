"""Without a net: PyOpenGL's checks off, its raw functions, two windows drawn from two threads with
a context each, both at once, and one window closed while the other goes on."""

import ctypes
import threading

import glfw
import OpenGL

OpenGL.ERROR_CHECKING = False
OpenGL.ERROR_LOGGING = False
from OpenGL.GL import glLight, glMaterial, glNormal, glVertexPointerf  # noqa: E402
from OpenGL.raw.GL.VERSION import GL_1_0 as raw  # noqa: E402
from OpenGL.raw.GL.VERSION import GL_1_1 as raw11  # noqa: E402

POINTS = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
FACES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]


def prepare(aspect):
    raw.glEnable(0x0B71)
    raw.glEnable(0x0B50)
    raw.glEnable(0x4000)
    glLight(0x4000, 0x1203, (1.0, 2.0, 3.0, 0.0))
    raw.glMatrixMode(0x1701)
    raw.glLoadIdentity()
    raw.glFrustum(-0.5 * aspect, 0.5 * aspect, -0.5, 0.5, 1, 20)
    raw.glMatrixMode(0x1700)
    raw.glClearColor(0.85, 0.9, 0.85, 1)


def solid(angle, arrays):
    raw.glClear(0x4100)
    raw.glLoadIdentity()
    raw.glTranslated(0, 0, -4)
    raw.glRotated(angle, 1, 1, 0)
    glMaterial(0x0408, 0x1602, (0.6, 0.4, 0.8, 1.0))
    if arrays:
        corners = [POINTS[i] for face in FACES for i in face]
        raw11.glEnableClientState(0x8074)
        glVertexPointerf(corners)
        raw11.glDrawArrays(4, 0, len(corners))
        raw11.glDisableClientState(0x8074)
        return
    raw.glBegin(4)
    for face in FACES:
        normal = [sum(POINTS[i][k] for i in face) for k in range(3)]
        glNormal(*normal)
        for i in face:
            raw.glVertex3fv((ctypes.c_float * 3)(*POINTS[i]))
    raw.glEnd()


def draw_elsewhere(window, frames, start, done):
    start.wait()
    glfw.make_context_current(window)
    prepare(1.0)
    for frame in range(frames):
        solid(frame * 9, arrays=True)
        raw11.glFinish()
    picture = (ctypes.c_ubyte * (200 * 200 * 3))()
    raw.glPixelStorei(0x0D05, 1)
    raw.glReadPixels(0, 0, 200, 200, 0x1907, 0x1401, picture)
    done.append(bytes(picture))
    glfw.make_context_current(None)


def main():
    glfw.init()
    glfw.window_hint(glfw.RESIZABLE, False)
    first = glfw.create_window(400, 300, "first", None, None)
    glfw.set_window_pos(first, 0, 0)
    glfw.window_hint(glfw.VISIBLE, False)
    second = glfw.create_window(200, 200, "second", None, None)
    glfw.make_context_current(first)
    prepare(4 / 3)
    start, done = threading.Event(), []
    thread = threading.Thread(target=draw_elsewhere, args=(second, 5, start, done))
    thread.start()
    start.set()
    frame = 0
    while not glfw.window_should_close(first) and frame < 60:
        glfw.make_context_current(first)
        solid(frame * 5, arrays=False)
        glfw.swap_buffers(first)
        glfw.poll_events()
        frame += 1
        if frame == 2:
            thread.join()
            glfw.destroy_window(second)
            assert len(set(done[0])) > 2
    glfw.terminate()


main()
