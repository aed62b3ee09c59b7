"""What the contract of toolkits runs on: for each toolkit its package, or a stand-in of its shape,
and a program that uses it.

A rig gives the modules to be hooked, opens one window, and acts as a program and its user do.
"""

from __future__ import annotations

import ctypes
import functools
from collections import deque
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, ClassVar

from glshim.toolkits import Toolkit
from glshim.toolkits.glfw import Glfw
from glshim.toolkits.glut import GLUT_WINDOW_DOUBLEBUFFER, GLUT_WINDOW_HEIGHT, Glut
from glshim.toolkits.glx import Glx
from glshim.toolkits.pygame import Pygame
from glshim.toolkits.pyglet import Pyglet
from glshim.toolkits.qt import Qt
from glshim.toolkits.sdl2 import Sdl2
from glshim.toolkits.stub import Stub
from glshim.toolkits.wx import Wx

SIZE = (60, 40)
"""Pixels of every rig's window."""
Log = list[str]


class Rig:
    """One program under one toolkit."""

    takes_early = False
    """Whether names that were taken before the hooks are followed, too."""
    shows_by_itself = False
    """Whether the picture is there before the frame ends: nothing is presented by a call."""
    framebuffer = 0
    has_a_user = True
    """Whether keys can be pressed; else `tests/programs/test_live.py` has a hand at them."""

    def __init__(self, toolkit: Toolkit) -> None:
        self.toolkit = toolkit
        self.log: Log = []
        """What the toolkit and the program do."""
        self.got: list[Any] = []
        """Key events that reach the program, as (name, down)."""
        self.modules: dict[str, Any] = {}
        """By full name."""

    def take(self) -> None:
        """Take names as ``from toolkit import ...`` does."""
        raise NotImplementedError

    def open(self) -> None:
        """Make a window."""

    def present(self) -> Any:
        """Show a frame by the names taken; gives 7, what the toolkit's own call gives, where that
        gives anything."""
        raise NotImplementedError

    def key(self, name: str, down: bool) -> None:
        """The user presses or releases a key."""
        raise NotImplementedError

    def redraws(self) -> int:
        """How often another frame was asked for."""
        raise NotImplementedError

    def seconds(self) -> float:
        """What the toolkit's clock shows."""
        raise NotImplementedError

    def shown(self, *_: Any) -> int:
        """The toolkit's own present."""
        self.log.append("shown")
        return 7


def library_function(function: Callable[..., Any], *types: Any) -> Any:
    """One that ctypes made, as those of loaded libraries."""
    return ctypes.CFUNCTYPE(ctypes.c_int, *types)(function)


def fill(width: Any, height: Any) -> None:
    """Answer a question for a size through two pointers."""
    for pointer, value in zip((width, height), SIZE, strict=True):
        ctypes.cast(pointer, ctypes.POINTER(ctypes.c_int)).contents.value = value


class StubRig(Rig):
    framebuffer = 7

    def __init__(self) -> None:
        super().__init__(Stub())
        self.events: deque[Any] = deque()
        self.asked = 0
        self.modules = {"stub": SimpleNamespace(
            show=self.shown, next_event=lambda: self.events.popleft() if self.events else None,
            seconds=lambda: 99.0)}  # fmt: skip

    def take(self) -> None:
        self.kit = SimpleNamespace(**vars(self.modules["stub"]))

    def open(self) -> None:
        class Window:
            size, framebuffer = SIZE, 7

            def repaint(_: Any) -> None:
                self.asked += 1

        self.window = Window()

    def present(self) -> Any:
        return self.kit.show(self.window)

    def key(self, name: str, down: bool) -> None:
        event = SimpleNamespace(key=name.lower(), kind="down" if down else "up", held=0)
        self.events.append(event)
        while (event := self.kit.next_event()) is not None:
            self.got.append((event.key.upper(), event.kind == "down"))

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.kit.seconds())


class Callback:
    """As ctypes': a callable that attributes may be put on."""

    def __init__(self, function: Callable[..., None]) -> None:
        self.function = function

    def __call__(self, *arguments: Any) -> None:
        self.function(*arguments)


class GlutRig(Rig):
    takes_early = True

    def __init__(self, *, double: bool = True) -> None:
        super().__init__(Glut())
        self.double, self.shows_by_itself = double, not double
        self.registered: dict[str, Any] = {}
        self.asked = 0
        self.special = SimpleNamespace(INITIALIZED=True)
        for kind in ("Display", "Special", "SpecialUp", "Keyboard", "KeyboardUp"):
            register = functools.partial(self.registered.__setitem__, kind)
            setattr(self.special, f"glut{kind}Func",
                    SimpleNamespace(wrappedOperation=register, callbackType=Callback))  # fmt: skip
        self.raw = SimpleNamespace(glutSwapBuffers=library_function(self.shown))
        self.glut = SimpleNamespace(GLUT_ELAPSED_TIME=700, glutGet=lambda what: 99)
        self.modules = {
            "OpenGL.raw.GLUT": self.raw, "OpenGL.GLUT.special": self.special,
            "OpenGL.GLUT": self.glut,
            "OpenGL.platform": SimpleNamespace(PLATFORM=SimpleNamespace(
                GLUT=self, GetCurrentContext=lambda: 1)),
        }  # fmt: skip

    # The library.

    def glutGet(self, what: int) -> int:
        if what == GLUT_WINDOW_DOUBLEBUFFER:
            return int(self.double)
        return SIZE[what == GLUT_WINDOW_HEIGHT]

    def glutGetModifiers(self) -> int:
        return 0

    def glutGetWindow(self) -> int:
        return 1

    def glutPostWindowRedisplay(self, window: int) -> None:
        self.asked += 1

    # The program.

    def take(self) -> None:
        self.swap = self.raw.glutSwapBuffers
        self.get = self.glut.glutGet

    def open(self) -> None:
        def display() -> None:
            if self.double:
                self.result = self.swap()
            else:
                self.log.append("shown")
                self.result = 7

        def keys(name_of: Callable[[Any], str], down: bool) -> Callback:
            return Callback(lambda key, x, y: self.got.append((name_of(key), down)))

        self.special.glutDisplayFunc.wrappedOperation(Callback(display))
        for kind, down in (("", True), ("Up", False)):
            for family, name_of in (("Special", "F{}".format), ("Keyboard", bytes.decode)):
                register = getattr(self.special, f"glut{family}{kind}Func")
                register.wrappedOperation(keys(name_of, down))

    def present(self) -> Any:
        self.registered["Display"]()
        return self.result

    def key(self, name: str, down: bool) -> None:
        special = len(name) > 1
        code: Any = int(name[1:]) if special else name.encode()
        kind = ("Special" if special else "Keyboard") + ("" if down else "Up")
        self.registered[kind](code, 0, 0)

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.glut.glutGet(700)) / 1000


class GlfwRig(Rig):
    def __init__(self) -> None:
        super().__init__(Glfw())
        self.callbacks: dict[int, Any] = {}
        self.asked = 0
        self.window = ctypes.c_void_p(77)

        def set_callback(window: Any, callback: Any) -> None:
            self.callbacks[window.value] = callback

        def wake() -> None:
            self.asked += 1

        self.library = SimpleNamespace(
            glfwSwapBuffers=self.shown, glfwGetCurrentContext=lambda: self.window,
            glfwGetFramebufferSize=lambda window, width, height: fill(width, height),
            glfwCreateWindow=lambda: self.window, glfwSetKeyCallback=set_callback,
            glfwPostEmptyEvent=wake,
        )  # fmt: skip
        self.modules = {"glfw": SimpleNamespace(
            _glfw=self.library, _GLFWkeyfun=lambda function: function, get_time=lambda: 99.0,
            swap_buffers=self.swap_buffers)}  # fmt: skip

    def swap_buffers(self, window: Any) -> Any:
        return self.library.glfwSwapBuffers(window)

    def take(self) -> None:
        self.swap, self.time = self.modules["glfw"].swap_buffers, self.modules["glfw"].get_time

    def open(self) -> None:
        self.library.glfwCreateWindow()

        def on_key(window: Any, key: int, scancode: int, action: int, mods: int) -> None:
            self.got.append((f"F{key - 289}" if key > 256 else chr(key), bool(action)))

        self.library.glfwSetKeyCallback(self.window, on_key)

    def present(self) -> Any:
        return self.swap(self.window)

    def key(self, name: str, down: bool) -> None:
        code = 289 + int(name[1:]) if len(name) > 1 else ord(name)
        self.callbacks[77](self.window, code, 0, int(down), 0)

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.time())


class PygameRig(Rig):
    def __init__(self) -> None:
        super().__init__(Pygame())
        import pygame

        self.pygame = pygame
        self.queue: deque[Any] = deque()
        surface = SimpleNamespace(get_flags=lambda: pygame.OPENGL)
        self.modules = {
            "pygame.display": SimpleNamespace(
                flip=self.shown, update=self.shown, get_surface=lambda: surface,
                get_window_size=lambda: SIZE),
            "pygame.event": SimpleNamespace(
                get=lambda: [self.queue.popleft() for _ in range(len(self.queue))],
                poll=self.poll, wait=self.poll, post=self.queue.append,
                Event=lambda kind: SimpleNamespace(type=kind)),
            "pygame.time": SimpleNamespace(get_ticks=lambda: 99, wait=None, delay=None, Clock=None),
        }  # fmt: skip

    def poll(self) -> Any:
        nothing = SimpleNamespace(type=self.pygame.NOEVENT)
        return self.queue.popleft() if self.queue else nothing

    def take(self) -> None:
        self.flip, self.get = self.modules["pygame.display"].flip, self.modules["pygame.event"].get
        self.ticks = self.modules["pygame.time"].get_ticks

    def present(self) -> Any:
        return self.flip()

    def key(self, name: str, down: bool) -> None:
        kinds = {self.pygame.KEYDOWN: True, self.pygame.KEYUP: False}
        kind = self.pygame.KEYDOWN if down else self.pygame.KEYUP
        names = {self.pygame.K_F5: "F5", self.pygame.K_x: "X"}
        (code,) = (code for code in names if names[code] == name)
        self.queue.append(SimpleNamespace(type=kind, key=code, mod=0))
        for event in self.get():
            if event.type in kinds:
                self.got.append((names[event.key], kinds[event.type]))
            else:
                self.queue.append(event)

    def redraws(self) -> int:
        return [event.type for event in self.queue].count(self.pygame.VIDEOEXPOSE)

    def seconds(self) -> float:
        return float(self.ticks()) / 1000


class MethodRig(Rig):
    """Toolkits whose windows are shown by a method of their class."""

    takes_early = True

    def __init__(self, toolkit: Toolkit, module: str, name: str, method: str, **more: Any) -> None:
        super().__init__(toolkit)
        self.method = method
        # The rig's own, so that it logs, under a function of the class.
        cls = type(name, (), {method: lambda window, *_: self.shown(), **more})
        self.modules = {module: SimpleNamespace(**{name: cls})}
        self.name, self.module = name, module

    def take(self) -> None:
        self.kind = getattr(self.modules[self.module], self.name)

    def open(self) -> None:
        self.window = self.kind()

    def present(self) -> Any:
        return getattr(self.window, self.method)()


class Sdl2Rig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Sdl2())
        self.modules = {"sdl2.video": SimpleNamespace(
            SDL_GL_SwapWindow=library_function(self.shown, ctypes.c_void_p),
            SDL_GL_GetDrawableSize=lambda window, width, height: fill(width, height))}  # fmt: skip

    def take(self) -> None:
        self.swap = self.modules["sdl2.video"].SDL_GL_SwapWindow

    def present(self) -> Any:
        return self.swap(None)


class GlxRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Glx())
        cls = type("glXSwapBuffers", (), {"__call__": staticmethod(self.shown)})
        self.modules = {"OpenGL.raw.GLX.VERSION.GLX_1_0": SimpleNamespace(glXSwapBuffers=cls())}

    def take(self) -> None:
        (module,) = self.modules.values()
        self.swap = module.glXSwapBuffers

    def present(self) -> Any:
        return self.swap(1, 2)


class QtRig(Rig):
    """A widget that paints, or (swaps) a window that swaps by itself."""

    takes_early = True
    framebuffer = 7
    MODULES: ClassVar = {
        "PyQt5": ("QtWidgets", "QOpenGLWidget", "QtGui", "QOpenGLContext"),
        "PySide2": ("QtGui", "QOpenGLWindow", "QtGui", "QOpenGLContext"),
        "PyQt6": ("QtOpenGLWidgets", "QOpenGLWidget", "QtGui", "QOpenGLContext"),
        "PySide6": ("QtOpenGL", "QOpenGLWindow", "QtOpenGL", "QGLWidget"),
    }
    """Where a binding has the classes of the rig."""

    def __init__(self, binding: str, *, swaps: bool = False) -> None:
        super().__init__(Qt(binding))
        self.binding, self.swaps = binding, swaps
        self.shows_by_itself = not swaps
        self.asked = 0
        self.filters: list[Any] = []

        class Widget:
            def devicePixelRatio(_: Any) -> float:
                return 2.0

            def width(_: Any) -> int:
                return SIZE[0] // 2

            def height(_: Any) -> int:
                return SIZE[1] // 2

            def defaultFramebufferObject(_: Any) -> int:
                return 7

            def update(_: Any) -> None:
                self.asked += 1

        self.widget_class = type("Widget", (Widget,), {})
        self.swapper = type("Swapper", (), {"swapBuffers": lambda this, *_: self.shown()})
        app = SimpleNamespace(
            installEventFilter=self.filters.append, removeEventFilter=self.filters.remove)
        paints, widget, swap, swapper = self.MODULES[binding]
        core = SimpleNamespace(
            QObject=object, QCoreApplication=SimpleNamespace(instance=lambda: app))
        parts: dict[str, Any] = {f"{binding}.QtCore": core}
        for part in ("QtGui", "QtWidgets", "QtOpenGL", "QtOpenGLWidgets"):
            parts[f"{binding}.{part}"] = SimpleNamespace()
        setattr(parts[f"{binding}.{paints}"], widget, self.widget_class)
        setattr(parts[f"{binding}.{swap}"], swapper, self.swapper)
        self.modules = parts

    def take(self) -> None:
        if self.swaps:
            return
        rig = self

        class App(self.widget_class):  # type: ignore[misc, name-defined]
            def paintGL(self) -> int:
                return rig.shown()

        self.app_class = App

    def open(self) -> None:
        self.window = (self.widget_class if self.swaps else self.app_class)()

    def present(self) -> Any:
        if self.swaps:
            return self.swapper().swapBuffers(self.window)
        return self.window.paintGL()

    def key(self, name: str, down: bool) -> None:
        code = 0x0100002F + int(name[1:]) if len(name) > 1 else ord(name)
        event = SimpleNamespace(
            type=lambda: 6 if down else 7, key=lambda: code, modifiers=lambda: 0,
            isAutoRepeat=lambda: False)  # fmt: skip
        if not any(each.eventFilter(None, event) for each in self.filters):
            self.got.append((name, down))

    def redraws(self) -> int:
        return self.asked


RIGS: dict[str, Callable[[], Rig]] = {
    "stub": StubRig,
    "GLUT": GlutRig,
    "GLUT, single-buffered": functools.partial(GlutRig, double=False),
    "glfw": GlfwRig,
    "pygame": PygameRig,
    "pyglet": lambda: MethodRig(Pyglet(), "pyglet.window", "Window", "flip",
                                get_framebuffer_size=lambda window: SIZE),
    "SDL2": Sdl2Rig,
    "wx": lambda: MethodRig(Wx(), "wx.glcanvas", "GLCanvas", "SwapBuffers",
                            GetClientSize=lambda canvas: (SIZE[0] // 2, SIZE[1] // 2),
                            GetContentScaleFactor=lambda canvas: 2.0),
    "GLX": GlxRig,
    **{f"{binding}, painting": functools.partial(QtRig, binding) for binding in QtRig.MODULES},
    **{f"{binding}, swapping": functools.partial(QtRig, binding, swaps=True)
       for binding in QtRig.MODULES},
}  # fmt: skip
"""Every toolkit's, and every way in which it ends a frame."""
