"""Qt by each of its bindings: a widget that paints, or a window that swaps."""

from __future__ import annotations

import functools
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any, ClassVar

from glshim.toolkits.qt import Qt

from .rig import SIZE, Rig


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
        self.elapsed: Any = None
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
        elapsed = type("Elapsed", (), {"start": lambda _: None, "elapsed": lambda _: 99000})
        core = SimpleNamespace(
            QObject=object, QCoreApplication=SimpleNamespace(instance=lambda: app),
            QElapsedTimer=elapsed)
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

    def seconds(self) -> float:
        if self.elapsed is None:
            self.elapsed = self.modules[f"{self.binding}.QtCore"].QElapsedTimer()
            self.elapsed.start()
        return float(self.elapsed.elapsed() / 1000)


class QmlRig(QtRig):
    """A scene under a window's items, or (item) one of an item's own."""

    def __init__(self, binding: str, *, item: bool) -> None:
        super().__init__(binding)
        self.item, self.shows_by_itself = item, item
        self.framebuffer = 7 if item else 0
        rig = self

        class Target:
            def size(self) -> Any:
                return SimpleNamespace(width=lambda: SIZE[0], height=lambda: SIZE[1])

            def handle(self) -> int:
                return 7

        class Renderer:
            def framebufferObject(self) -> Any:
                return Target()

            def update(self) -> None:
                rig.asked += 1

        class Window(self.widget_class):  # type: ignore[misc, name-defined]
            def beginExternalCommands(self) -> None:
                """What follows is the app's."""

            def resetOpenGLState(self) -> None:
                """In between: no end."""

            def endExternalCommands(self) -> int:
                return rig.shown()

        self.modules[f"{binding}.QtQuick"] = SimpleNamespace(
            QQuickFramebufferObject=SimpleNamespace(Renderer=Renderer), QQuickWindow=Window)
        self.renderer_class: Any = Renderer
        self.window_class: Any = Window

    def take(self) -> None:
        if self.item:
            rig = self

            class App(self.renderer_class):  # type: ignore[misc]
                def render(self) -> int:
                    return rig.shown()

            self.renderer_class = App

    def open(self) -> None:
        self.window = (self.renderer_class if self.item else self.window_class)()

    def present(self) -> Any:
        if self.item:
            return self.window.render()
        self.window.beginExternalCommands()
        self.window.resetOpenGLState()
        return self.window.endExternalCommands()


RIGS: dict[str, Callable[[], Rig]] = {
    "PyQt5, QML window": functools.partial(QmlRig, "PyQt5", item=False),
    "PySide6, QML item": functools.partial(QmlRig, "PySide6", item=True),
    **{f"{binding}, painting": functools.partial(QtRig, binding) for binding in QtRig.MODULES},
    **{f"{binding}, swapping": functools.partial(QtRig, binding, swaps=True)
       for binding in QtRig.MODULES},
}  # fmt: skip
