"""The toolkits whose frame ends are hooked: a row each in `TOOLKITS`.

A hook must reach the app's calls however it imported them. Functions that ctypes made are changed
in place (their class), so that names taken long before are hooked too; a
module's own function is replaced right after the module's import, before anyone else sees it.
"""

from __future__ import annotations

import ctypes
import functools
from collections.abc import Callable
from contextlib import contextmanager
from dataclasses import dataclass
from types import ModuleType
from typing import TYPE_CHECKING, Any

from glshim.bindings.pyopengl.raw import hook_function, original_call
from glshim.toolkits import frames
from glshim.toolkits.frames import Size, Surface
from glshim.toolkits.qt import hook_painting, hook_swaps

if TYPE_CHECKING:
    from collections.abc import Iterator

# From GLUT's header, where they are the stable ABI of every implementation.
_GLUT_WINDOW_WIDTH, _GLUT_WINDOW_HEIGHT, _GLUT_WINDOW_DOUBLEBUFFER = 102, 103, 115


@dataclass(frozen=True, slots=True)
class Toolkit:
    """One present function of one toolkit."""

    name: str
    module: str
    """The module after whose import the hook is put."""
    hook: Callable[[ModuleType], None]
    how: str
    """What ends a frame, for people."""


# --- GLUT ---------------------------------------------------------------------------------------


def _glut() -> Any:
    from OpenGL.platform import PLATFORM

    return PLATFORM.GLUT


def _glut_size() -> Size:
    get = _glut().glutGet
    return get(_GLUT_WINDOW_WIDTH), get(_GLUT_WINDOW_HEIGHT)


# GLUT calls back from C: an exception would be printed there and the loop go on.
_GLUT_WINDOW = Surface(_glut_size, may_raise=False)


def _hook_glut_swap(module: ModuleType) -> None:
    if not module.glutSwapBuffers:  # GLUT is not installed
        return
    function = _unlogged(module.glutSwapBuffers)
    swap = original_call(function)
    hook_function(function, functools.partial(frames.present, swap, on=_GLUT_WINDOW))


def _unlogged(function: Any) -> Any:
    """The ctypes object inside PyOpenGL's logging proxies, which keep it under no name."""
    while not hasattr(type(function), "_flags_"):
        function = getattr(function, "")
    return function


def _hook_glut_display(module: ModuleType) -> None:
    """Single-buffered windows: the frame ends when the display callback returns, unless it ended
    at a glFlush before."""
    register = module.glutDisplayFunc
    plain = register.wrappedOperation

    def wrapped_operation(callback: Any, *arguments: Any) -> None:
        if callable(callback):
            # A second callback around the app's: what PyOpenGL prints of an exception in the
            # app's own stays as it is. It lives exactly as long as the app's.
            callback.glshim_outer = type(callback)(functools.partial(_display, callback))
            plain(callback.glshim_outer, *arguments)
        else:
            plain(callback, *arguments)

    register.wrappedOperation = wrapped_operation


def _display(callback: Callable[[], None]) -> None:
    before = frames.presented()
    with frames.drawing(_GLUT_WINDOW):
        callback()
        if frames.presented() == before and not _glut().glutGet(_GLUT_WINDOW_DOUBLEBUFFER):
            frames.present(_shown_already)


def _shown_already() -> None:
    """A single-buffered window shows what is drawn as it is drawn."""


# --- glfw ---------------------------------------------------------------------------------------


def _hook_glfw(module: ModuleType) -> None:
    library = module._glfw
    plain = library.glfwSwapBuffers

    def size_of(window: Any) -> Size:
        width, height = ctypes.c_int(), ctypes.c_int()
        library.glfwGetFramebufferSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    @functools.wraps(plain, assigned=("__name__", "__doc__"), updated=())
    def swap_buffers(window: Any) -> Any:
        if not frames.listening():
            return plain(window)
        with _current_in_glfw(library, window):
            return frames.present(plain, window, on=Surface(functools.partial(size_of, window)))

    library.glfwSwapBuffers = swap_buffers


@contextmanager
def _current_in_glfw(library: Any, window: Any) -> Iterator[None]:
    """glfw swaps any window; a frame ends in the context of the window that is swapped."""
    current = library.glfwGetCurrentContext()
    if not current or not window or _address(current) == _address(window):
        yield
        return
    library.glfwMakeContextCurrent(window)
    try:
        yield
    finally:
        library.glfwMakeContextCurrent(current)


def _address(pointer: Any) -> int | None:
    return ctypes.cast(pointer, ctypes.c_void_p).value


# --- pygame -------------------------------------------------------------------------------------


def _hook_pygame(module: ModuleType) -> None:
    for name in ("flip", "update"):
        setattr(module, name, _pygame_present(module, getattr(module, name)))


def _pygame_present(module: ModuleType, plain: Callable[..., None]) -> Callable[..., None]:
    surface = Surface(module.get_window_size)

    @functools.wraps(plain)
    def flip(*arguments: Any, **named: Any) -> None:
        shown = module.get_surface() if frames.listening() else None
        if shown is None or shown.get_flags() & (_OPENGL | _PREALLOC) != _OPENGL:
            return plain(*arguments, **named)
        return frames.present(plain, *arguments, on=surface, named=named)

    return flip


# pygame.OPENGL and pygame.PREALLOC: SDL shows a window without OpenGL by way of GL of its own, with
# the first flag too, but keeps that window's pixels itself.
_OPENGL, _PREALLOC = 0x2, 0x1000000


# --- pyglet, SDL2, wx, GLX ----------------------------------------------------------------------


def _hook_pyglet(module: ModuleType) -> None:
    plain = module.Window.flip

    @functools.wraps(plain)
    def flip(window: Any) -> None:
        frames.present(plain, window, on=Surface(window.get_framebuffer_size))

    module.Window.flip = flip


def _hook_sdl2(module: ModuleType) -> None:
    function = module.SDL_GL_SwapWindow
    swap = original_call(function)

    def size_of(window: Any) -> Size:
        width, height = ctypes.c_int(), ctypes.c_int()
        module.SDL_GL_GetDrawableSize(window, ctypes.byref(width), ctypes.byref(height))
        return width.value, height.value

    def swap_window(window: Any, *more: Any) -> Any:
        on = Surface(functools.partial(size_of, window))
        return frames.present(swap, window, *more, on=on)

    hook_function(function, swap_window)


def _hook_wx(module: ModuleType) -> None:
    plain = module.GLCanvas.SwapBuffers

    def size_of(canvas: Any) -> Size:
        width, height = canvas.GetClientSize()
        ratio = canvas.GetContentScaleFactor()
        return round(width * ratio), round(height * ratio)

    @functools.wraps(plain)
    def swap_buffers(canvas: Any) -> Any:
        on = Surface(functools.partial(size_of, canvas), may_raise=False)
        return frames.present(plain, canvas, on=on)

    module.GLCanvas.SwapBuffers = swap_buffers


def _hook_glx(module: ModuleType) -> None:
    if not module.glXSwapBuffers:  # which loads it; none without GLX
        return
    function = type(module.glXSwapBuffers)
    function.__call__ = staticmethod(functools.partial(frames.present, function.__call__))


# --- Qt -----------------------------------------------------------------------------------------

_PAINTED, _SWAPPED = "the return of paintGL", "swapBuffers"
_QT = (
    ("QtGui", hook_painting("QOpenGLWindow"), _PAINTED),
    ("QtGui", hook_swaps(QOpenGLContext="swapBuffers"), _SWAPPED),
    ("QtWidgets", hook_painting("QOpenGLWidget"), _PAINTED),
    ("QtOpenGL", hook_painting("QGLWidget", "QOpenGLWindow"), _PAINTED),
    ("QtOpenGL", hook_swaps(QGLWidget="swapBuffers"), _SWAPPED),
    ("QtOpenGLWidgets", hook_painting("QOpenGLWidget"), _PAINTED),
)
"""Modules of one Qt binding: where a class lies differs between Qt 5 and 6."""


TOOLKITS = (
    Toolkit("GLUT", "OpenGL.raw.GLUT", _hook_glut_swap, "glutSwapBuffers"),
    Toolkit(
        "GLUT, single-buffered",
        "OpenGL.GLUT.special",
        _hook_glut_display,
        "return of the display callback",
    ),
    Toolkit("glfw", "glfw", _hook_glfw, "glfw.swap_buffers"),
    Toolkit("pygame", "pygame.display", _hook_pygame, "pygame.display.flip"),
    Toolkit("pyglet", "pyglet.window", _hook_pyglet, "Window.flip"),
    Toolkit("SDL2", "sdl2.video", _hook_sdl2, "SDL_GL_SwapWindow"),
    Toolkit("wx", "wx.glcanvas", _hook_wx, "GLCanvas.SwapBuffers"),
    Toolkit("GLX, Tk by pyopengltk", "OpenGL.raw.GLX.VERSION.GLX_1_0", _hook_glx, "glXSwapBuffers"),
    *(
        Toolkit(package, f"{package}.{part}", hook, how)
        for package in ("PyQt5", "PySide2", "PyQt6", "PySide6")
        for part, hook, how in _QT
    ),
)
