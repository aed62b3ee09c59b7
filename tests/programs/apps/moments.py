"""A picture of the moment: how often a timer came (red), and what a clock says (green).
``moments.py KIND [MILLISECONDS]``."""

import sys
import time

from OpenGL.GL import GL_COLOR_BUFFER_BIT, glClear, glClearColor

KIND, PERIOD = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 0
SIZE = 120, 90
STARTED = time.monotonic()
ticks = 0


def draw(seconds):
    glClearColor(ticks * 8 / 255, seconds * 1000 / 2 % 256 / 255, 0.0, 1.0)
    glClear(GL_COLOR_BUFFER_BIT)


def tick(*_):
    global ticks
    ticks += 1


def glut():
    from OpenGL import GLUT

    def show():
        draw(GLUT.glutGet(GLUT.GLUT_ELAPSED_TIME) / 1000)
        GLUT.glutSwapBuffers()

    def again(_value=0):
        tick()
        GLUT.glutPostRedisplay()
        if PERIOD:
            GLUT.glutTimerFunc(PERIOD, again, 0)

    GLUT.glutInit(sys.argv[:1])
    GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE)
    GLUT.glutInitWindowSize(*SIZE)
    GLUT.glutCreateWindow(b"moments")
    GLUT.glutDisplayFunc(show)
    if PERIOD:
        GLUT.glutTimerFunc(PERIOD, again, 0)
    else:
        GLUT.glutIdleFunc(again)
    GLUT.glutMainLoop()


def glfw():
    import glfw

    glfw.init()
    window = glfw.create_window(*SIZE, "moments", None, None)
    glfw.make_context_current(window)
    while not glfw.window_should_close(window):
        draw(glfw.get_time())
        glfw.swap_buffers(window)
        glfw.poll_events()
        time.sleep(PERIOD / 1000)


def pygame():
    import pygame

    pygame.display.set_mode(SIZE, pygame.OPENGL | pygame.DOUBLEBUF)
    clock, passed = pygame.time.Clock(), 0
    if PERIOD:
        pygame.time.set_timer(pygame.USEREVENT, PERIOD)
    while True:
        for event in [pygame.event.wait()] if PERIOD else pygame.event.get():
            if event.type == pygame.USEREVENT:
                tick()
        if not PERIOD:
            passed += clock.tick(60)
        draw(pygame.time.get_ticks() / 1000 if PERIOD else passed / 1000)
        pygame.display.flip()


def qt():
    from PyQt5.QtCore import QElapsedTimer, QTimer
    from PyQt5.QtWidgets import QApplication, QOpenGLWidget

    class Widget(QOpenGLWidget):
        def paintGL(self):
            draw(elapsed.elapsed() / 1000)

    app = QApplication(sys.argv[:1])
    widget, elapsed, timer = Widget(), QElapsedTimer(), QTimer()
    elapsed.start()
    widget.resize(*SIZE)
    if PERIOD:
        timer.timeout.connect(tick)
        timer.timeout.connect(widget.update)
        timer.start(PERIOD)
    widget.show()
    app.exec_()


def tk():
    import tkinter

    from pyopengltk import OpenGLFrame

    class Frame(OpenGLFrame):
        def initgl(self):
            if PERIOD:
                self.after(PERIOD, self.again)

        def again(self):
            tick()
            self._display()
            self.after(PERIOD, self.again)

        def redraw(self):
            draw(time.monotonic() - STARTED)

    root = tkinter.Tk()
    Frame(root, width=SIZE[0], height=SIZE[1]).pack()
    root.mainloop()


def pyglet():
    import pyglet

    window = pyglet.window.Window(*SIZE, config=pyglet.gl.Config(double_buffer=True))
    window.set_handler("on_draw", lambda: draw(time.monotonic() - STARTED))
    pyglet.clock.schedule_interval(tick, PERIOD / 1000)
    pyglet.app.run()


globals()[KIND]()
