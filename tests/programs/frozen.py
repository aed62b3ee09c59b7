"""Run one program unmodified, with its clock and its luck frozen, and save what it presents.

`python frozen.py OUT FRAMES TARGET [ARGS...]` runs the script TARGET (or the module `-m NAME`)
as `__main__`. Of glshim it imports what holds clocks alone, and it draws nothing: each picture is
read from the X screen after the program's own call that presents it, so it is the same code, with
the same result, whether or not another program has hooked OpenGL above or below these hooks.

Time stands still while a frame is made (`glshim.running.clocks`), so that every run sees the
same sequence of events.
"""

import ctypes
import ctypes.util
import importlib.abc
import importlib.util
import os
import runpy
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from glshim.running import clocks, luck
from glshim.spec.constants import GL_DOUBLEBUFFER
from glshim.toolkits.base import Changes
from glshim.toolkits.glfw import Glfw
from glshim.toolkits.glut import GlutLoop
from glshim.toolkits.moment import Moment, real_clock, real_sleep
from glshim.toolkits.pygame import Pygame

Z_PIXMAP, ALL_PLANES = 2, ctypes.c_ulong(0xFFFFFFFF)


class XImage(ctypes.Structure):
    _fields_ = (
        ("width", ctypes.c_int),
        ("height", ctypes.c_int),
        ("xoffset", ctypes.c_int),
        ("format", ctypes.c_int),
        ("data", ctypes.c_void_p),
        ("byte_order", ctypes.c_int),
        ("bitmap_unit", ctypes.c_int),
        ("bitmap_bit_order", ctypes.c_int),
        ("bitmap_pad", ctypes.c_int),
        ("depth", ctypes.c_int),
        ("bytes_per_line", ctypes.c_int),
        ("bits_per_pixel", ctypes.c_int),
    )


class Screen:
    """The part of the X screen that the current window covers, as pixels."""

    def __init__(self) -> None:
        x, gl = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libGL.so.1")
        gl.glXGetCurrentDisplay.restype = ctypes.c_void_p
        gl.glXGetCurrentDrawable.restype = ctypes.c_ulong
        x.XGetImage.restype = ctypes.POINTER(XImage)
        x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x, self.gl = x, gl

    def double_buffered(self) -> bool:
        answer = ctypes.c_ubyte()
        self.gl.glGetBooleanv(GL_DOUBLEBUFFER, ctypes.byref(answer))
        return bool(answer.value)

    def grab(self, handle: int = 0) -> "np.ndarray[Any, Any] | None":
        """(height, width, 3) uint8, or None where no window is current.

        `handle` is the X window where GL draws to a GLX window instead (glfw does so).
        """
        x, window = self.x, ctypes.c_ulong(handle or self.gl.glXGetCurrentDrawable())
        display = ctypes.c_void_p(self.gl.glXGetCurrentDisplay())
        if not window or not display:
            return None
        x.XSync(display, 0)
        root = ctypes.c_ulong(x.XDefaultRootWindow(display))
        extent = [self.geometry(display, handle) for handle in (window, root)]
        (width, height), (root_width, root_height) = extent
        at_x, at_y, child = ctypes.c_int(), ctypes.c_int(), ctypes.c_ulong()
        x.XTranslateCoordinates(display, window, root, 0, 0, ctypes.byref(at_x),
                                ctypes.byref(at_y), ctypes.byref(child))
        left, top = max(at_x.value, 0), max(at_y.value, 0)
        right = min(at_x.value + width, root_width)
        bottom = min(at_y.value + height, root_height)
        if left >= right or top >= bottom:
            return None
        return self.region(display, (left, top, right, bottom))

    def grab_all(self) -> "np.ndarray[Any, Any]":
        """The whole screen."""
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        root = ctypes.c_ulong(self.x.XDefaultRootWindow(display))
        return self.region(display, (0, 0, *self.geometry(display, root)))

    def region(self, display: ctypes.c_void_p, box: tuple[int, int, int, int]
               ) -> "np.ndarray[Any, Any]":
        """(height, width, 3) uint8 of the screen between left, top, right and bottom."""
        x, (left, top, right, bottom) = self.x, box
        root = ctypes.c_ulong(x.XDefaultRootWindow(display))
        image = x.XGetImage(display, root, left, top, right - left, bottom - top,
                            ALL_PLANES, Z_PIXMAP)
        header = image.contents
        raw = ctypes.string_at(header.data, header.bytes_per_line * header.height)
        x.XDestroyImage(image)
        rows = np.frombuffer(raw, np.uint8).reshape(bottom - top, -1, 4)
        return rows[:, : right - left, 2::-1].copy()

    def geometry(self, display: ctypes.c_void_p, window: ctypes.c_ulong) -> tuple[int, int]:
        root, at_x, at_y = ctypes.c_ulong(), ctypes.c_int(), ctypes.c_int()
        width, height, border, depth = (ctypes.c_uint() for _ in range(4))
        answers = (root, at_x, at_y, width, height, border, depth)
        self.x.XGetGeometry(display, window, *(ctypes.byref(a) for a in answers))
        return width.value, height.value


class Recorder:
    """Counts presented frames, moves the clock, saves pictures and ends the program."""

    def __init__(self, out: Path, frames: int) -> None:
        self.out, self.frames = out, frames
        self.moment = Moment()
        self.pictures: list[np.ndarray[Any, Any]] = []
        self.last_seen = real_clock()
        self.screen = Screen()

    def presented(self, window: int = 0) -> None:
        picture = self.screen.grab(window)
        self.last_seen = real_clock()
        if picture is None:
            return
        self.pictures.append(picture)
        self.moment.frame_ends()
        if self.moment.frames >= self.frames:
            self.finish()

    def flushed(self) -> None:
        if not self.screen.double_buffered():
            self.presented()

    def finish(self) -> None:
        shimmed = "glshim.pipeline" in sys.modules
        np.savez(self.out, *self.pictures, shimmed=np.array(shimmed))
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(0)

    def watch(self, patience: float) -> None:
        """End a program that draws on demand once it has shown something and gone quiet."""

        def look() -> None:
            while True:
                real_sleep(0.2)
                if self.moment.frames and real_clock() - self.last_seen > patience:
                    self.finish()

        threading.Thread(target=look, daemon=True).start()


def around(module: Any, name: str, after: Callable[[], None]) -> None:
    """Replace `module.name` by itself followed by `after`."""
    original = getattr(module, name, None)
    if original is None:
        return

    def call(*args: Any, **kwargs: Any) -> Any:
        result = original(*args, **kwargs)
        after()
        return result

    setattr(module, name, call)


def freeze_pygame(pygame: ModuleType, recorder: Recorder) -> None:
    for name in ("flip", "update"):
        around(pygame.display, name, recorder.presented)
    Pygame(recorder.moment).hold_clock(pygame.time, Changes())


def freeze_glfw(glfw: ModuleType, recorder: Recorder) -> None:
    swap = glfw.swap_buffers

    def swap_buffers(window: Any) -> None:
        swap(window)
        recorder.presented(glfw.get_x11_window(window))

    glfw.swap_buffers = swap_buffers  # type: ignore[attr-defined]
    Glfw(recorder.moment).hold_clock(glfw, Changes())


def freeze_glut(glut: ModuleType, recorder: Recorder) -> None:
    around(glut, "glutSwapBuffers", recorder.presented)
    GlutLoop(glut, recorder.moment, recorder.finish).serve(Changes())


def freeze_togl(tkinter: ModuleType, recorder: Recorder) -> None:
    plain = tkinter.BaseWidget.__init__

    def begin(widget: Any, *arguments: Any, **named: Any) -> None:
        plain(widget, *arguments, **named)
        if widget.widgetName == "togl":
            widget.tk.createcommand("shown", shown)
            widget.tk.call("trace", "add", "execution", str(widget), "leave", "shown")

    def shown(command: str, *_: str) -> None:
        widget, what = command.split()
        if what == "swapbuffers":
            recorder.presented(int(tkinter._default_root.tk.call("winfo", "id", widget), 16))

    tkinter.BaseWidget.__init__ = begin


def freeze_wx(glcanvas: ModuleType, recorder: Recorder) -> None:
    around(glcanvas.GLCanvas, "SwapBuffers", recorder.presented)


def freeze_glx(glx: ModuleType, recorder: Recorder) -> None:
    around(glx, "glXSwapBuffers", recorder.presented)


def freeze_sdl2(sdl2: ModuleType, recorder: Recorder) -> None:
    around(sdl2, "SDL_GL_SwapWindow", recorder.presented)


def freeze_pyglet(window: ModuleType, recorder: Recorder) -> None:
    plain = window.Window.flip

    def flip(shown: Any) -> None:
        plain(shown)
        recorder.presented(shown._window)

    window.Window.flip = flip


def freeze_qt(widgets: ModuleType, recorder: Recorder) -> None:
    """Qt puts its widgets together unseen: take the whole screen once the windows stand still."""
    core = importlib.import_module(widgets.__name__.replace("QtWidgets", "QtCore"))
    application = widgets.QApplication

    def look() -> None:
        picture = recorder.screen.grab_all()
        recorder.pictures.append(picture)
        recorder.finish()

    def around_loop(run: Callable[..., Any]) -> Callable[..., Any]:
        def loop(*_arguments: Any) -> Any:
            core.QTimer.singleShot(2000, look)
            return run()

        return loop

    for name in ("exec", "exec_"):
        if hasattr(application, name):
            setattr(application, name, around_loop(getattr(application, name)))


def freeze_gl(gl: ModuleType, recorder: Recorder) -> None:
    around(gl, "glFlush", recorder.flushed)
    around(gl, "glFinish", recorder.flushed)


class AfterImport(importlib.abc.MetaPathFinder):
    """Calls a function on a module once it has been imported by the program."""

    def __init__(self, hooks: dict[str, Callable[[ModuleType], None]]) -> None:
        self.hooks = hooks

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> Any:
        if fullname not in self.hooks:
            return None
        hook = self.hooks.pop(fullname)
        spec = importlib.util.find_spec(fullname)
        if spec is None or spec.loader is None:
            return spec
        execute = spec.loader.exec_module

        def exec_module(module: ModuleType) -> None:
            execute(module)
            hook(module)

        spec.loader.exec_module = exec_module  # type: ignore[method-assign]
        return spec


def main() -> None:
    out, frames, *command = sys.argv[1:]
    recorder = Recorder(Path(out), int(frames))
    luck.hold()
    clocks.hold(recorder.moment)
    hooks = {"OpenGL.GL": freeze_gl, "OpenGL.GLUT": freeze_glut, "pygame": freeze_pygame,
             "glfw": freeze_glfw, "OpenGL.GLX": freeze_glx, "tkinter": freeze_togl,
             "sdl2": freeze_sdl2, "pyglet.window": freeze_pyglet, "PyQt5.QtWidgets": freeze_qt,
             "PyQt6.QtWidgets": freeze_qt, "PySide6.QtWidgets": freeze_qt,
             "wx.glcanvas": freeze_wx}
    sys.meta_path.insert(0, AfterImport(
        {name: lambda module, hook=hook: hook(module, recorder) for name, hook in hooks.items()}))
    recorder.watch(patience=10.0)
    sys.path.pop(0)  # this folder is none of the program's business
    if command[0] == "-m":
        sys.argv = command[1:]
        sys.path.insert(0, os.getcwd())
        runpy.run_module(command[1], run_name="__main__", alter_sys=True)
    else:
        sys.argv = command
        sys.path.insert(0, str(Path(command[0]).parent))
        runpy.run_path(command[0], run_name="__main__")
    recorder.finish()


if __name__ == "__main__":
    main()
