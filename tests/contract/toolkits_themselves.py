"""The contract of toolkits on those that are installed, each in a process of its own:
``python -m tests.contract.toolkits_themselves glfw`` prints ``ok`` for each check that holds."""

from __future__ import annotations

import ctypes
import functools
import sys
from collections.abc import Callable
from typing import Any

from glshim.bindings.pyopengl.raw import hook_function_below
from glshim.toolkits import Part

from .toolkit_checks import CHECKS
from .toolkits import SIZE, Rig


class GlfwItself(Rig):
    def __init__(self) -> None:
        import glfw

        from glshim.toolkits.glfw import Glfw

        super().__init__(Glfw())
        self.glfw, self.library = glfw, glfw._glfw
        self.modules = {"glfw": glfw}
        self.asked = 0
        self.callbacks: dict[int, Any] = {}
        glfw.init()
        glfw.window_hint(glfw.VISIBLE, False)
        set_callback = self.library.glfwSetKeyCallback

        def note_callback(window: Any, callback: Any) -> Any:
            self.callbacks[ctypes.cast(window, ctypes.c_void_p).value or 0] = callback
            return set_callback(window, callback)

        self.library.glfwSetKeyCallback = note_callback
        self.library.glfwSwapBuffers = self.after(self.library.glfwSwapBuffers, self.shown)
        self.library.glfwPostEmptyEvent = self.after(self.library.glfwPostEmptyEvent, self.wake)

    def after(self, plain: Callable[..., Any], note: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any) -> Any:
            result = plain(*arguments)
            note()
            return result

        return call

    def wake(self) -> None:
        self.asked += 1

    def take(self) -> None:
        self.swap, self.time = self.glfw.swap_buffers, self.glfw.get_time

    def open(self) -> None:
        glfw = self.glfw
        self.window = glfw.create_window(*SIZE, "app", None, None)
        glfw.make_context_current(self.window)

        def on_key(window: Any, key: int, scancode: int, action: int, mods: int) -> None:
            self.got.append(({glfw.KEY_F5: "F5", glfw.KEY_X: "X"}[key], action == glfw.PRESS))

        glfw.set_key_callback(self.window, on_key)

    def present(self) -> Any:
        return self.swap(self.window)

    def key(self, name: str, down: bool) -> None:
        code = getattr(self.glfw, f"KEY_{name}")
        callback = self.callbacks[ctypes.cast(self.window, ctypes.c_void_p).value or 0]
        callback(self.window, code, 0, int(down), 0)

    def redraws(self) -> int:
        return self.asked

    def seconds(self) -> float:
        return float(self.time())


class PygameItself(Rig):
    def __init__(self) -> None:
        import pygame

        from glshim.toolkits.pygame import Pygame

        super().__init__(Pygame())
        self.pygame = pygame
        names = ("pygame.display", "pygame.event", "pygame.time")
        self.modules = {name: sys.modules[name] for name in names}
        self.asked = 0
        pygame.display.init()
        self.get_plainly = pygame.event.get
        for name in ("flip", "update"):
            setattr(pygame.display, name, self.before(getattr(pygame.display, name)))

    def before(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(plain)
        def call(*arguments: Any) -> Any:
            self.shown()
            return plain(*arguments)

        return call

    def take(self) -> None:
        self.flip, self.get = self.pygame.display.flip, self.pygame.event.get
        self.ticks = self.pygame.time.get_ticks

    def open(self) -> None:
        self.pygame.display.set_mode(SIZE, self.pygame.OPENGL | self.pygame.DOUBLEBUF)
        self.get_plainly()

    def present(self) -> Any:
        return self.flip()

    def key(self, name: str, down: bool) -> None:
        pygame = self.pygame
        names = {pygame.K_F5: "F5", pygame.K_x: "X"}
        (code,) = (code for code in names if names[code] == name)
        kinds = {pygame.KEYDOWN: True, pygame.KEYUP: False}
        kind = pygame.KEYDOWN if down else pygame.KEYUP
        pygame.event.post(pygame.event.Event(kind, key=code, mod=0))
        for event in self.get():
            if event.type in kinds:
                self.got.append((names[event.key], kinds[event.type]))

    def redraws(self) -> int:
        kinds = [event.type for event in self.get_plainly()]
        self.asked += kinds.count(self.pygame.VIDEOEXPOSE)
        return self.asked

    def seconds(self) -> float:
        return float(self.ticks()) / 1000


class GlutItself(Rig):
    takes_early = True
    has_a_user = False

    def __init__(self, *, double: bool = True) -> None:
        from OpenGL import GLUT
        from OpenGL.GLUT import special

        from glshim.toolkits.glut import Glut

        super().__init__(Glut())
        self.double, self.shows_by_itself = double, not double
        self.glut = GLUT
        self.modules = {
            "OpenGL.raw.GLUT": sys.modules["OpenGL.raw.GLUT"], "OpenGL.GLUT.special": special,
            "OpenGL.GLUT": GLUT,
        }  # fmt: skip
        self.drawn = 0

        def swapping(plain: Callable[..., Any]) -> Callable[..., Any]:
            def swap(*arguments: Any) -> Any:
                self.shown()
                return plain(*arguments)

            return swap

        hook_function_below(GLUT.glutSwapBuffers, swapping)
        GLUT.glutInit(["app"])
        GLUT.glutInitDisplayMode(GLUT.GLUT_DOUBLE if double else GLUT.GLUT_SINGLE)
        GLUT.glutInitWindowSize(*SIZE)
        self.window = 0

    def take(self) -> None:
        self.swap, self.get = self.glut.glutSwapBuffers, self.glut.glutGet

    def open(self) -> None:
        if self.window:
            self.glut.glutDestroyWindow(self.window)
        self.window = self.glut.glutCreateWindow(b"app")
        self.is_due = False
        self.glut.glutDisplayFunc(self.display)
        for _ in range(20):  # until it is on the screen
            self.turn()

    def display(self) -> None:
        self.drawn += 1
        if self.is_due and self.double:
            self.swap()
        elif self.is_due:
            self.shown()
        self.is_due = False

    def turn(self) -> None:
        from OpenGL.GLUT.freeglut import glutMainLoopEvent

        glutMainLoopEvent()

    def present(self) -> Any:
        self.is_due = True
        self.glut.glutPostRedisplay()
        self.turn()
        assert not self.is_due

    def redraws(self) -> int:
        self.turn()
        return self.drawn

    def seconds(self) -> float:
        return float(self.get(self.glut.GLUT_ELAPSED_TIME)) / 1000


RIGS: dict[str, Callable[[], Rig]] = {
    "glfw": GlfwItself,
    "pygame": PygameItself,
    "GLUT": GlutItself,
    "GLUT, single-buffered": functools.partial(GlutItself, double=False),
}


def main() -> None:
    import OpenGL.GL  # noqa: F401 (else no frame matters to us)

    rig = RIGS[sys.argv[1]]()
    for check in CHECKS:
        rig.toolkit = type(rig.toolkit)()
        rig.log.clear()
        rig.got.clear()
        check(rig)
        for part in Part:
            rig.toolkit.release(part)
        print("ok", flush=True)


if __name__ == "__main__":
    main()
