"""GLUT by PyOpenGL, double-buffered and single-buffered."""

from __future__ import annotations

import functools
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.glut import GLUT_WINDOW_DOUBLEBUFFER, GLUT_WINDOW_HEIGHT, Glut

from .rig import SIZE, Rig, library_function


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


RIGS: dict[str, Callable[[], Rig]] = {
    "GLUT": GlutRig,
    "GLUT, single-buffered": functools.partial(GlutRig, double=False),
}
