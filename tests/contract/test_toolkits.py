"""Frame ends of toolkits that need not be installed: stand-ins in the shape of their modules."""

from __future__ import annotations

import functools
from types import SimpleNamespace
from typing import Any

import pytest

from glshim.toolkits import frames
from glshim.toolkits.base import Changes
from glshim.toolkits.qt import Qt
from glshim.toolkits.wx import Wx


@pytest.fixture
def log(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What happened, with a context current and a listener that says where it was called."""
    happened: list[str] = []
    monkeypatch.setattr(frames, "_context_is_current", lambda: True)
    monkeypatch.setattr(frames, "_listeners", ())
    frames.listen(
        frames.Stage.DRAW,
        before=lambda: happened.append(
            f"{frames.drawable_size()} in {frames.drawable_framebuffer()}"),
    )
    return happened


class Widget:
    """As Qt's: C++ calls the app's paintGL through `show`."""

    def devicePixelRatio(self) -> float:
        return 2.0

    def width(self) -> int:
        return 30

    def height(self) -> int:
        return 20

    def defaultFramebufferObject(self) -> int:
        return 7

    def paintGL(self) -> None:
        raise AssertionError("the app's own is called")

    def show(self) -> Any:
        return self.paintGL()


def module_with(base: type) -> Any:
    return SimpleNamespace(QOpenGLWidget=base)


def fresh_base() -> Any:
    return type("QOpenGLWidget", (Widget,), {})


@pytest.mark.parametrize("late", [False, True])
def test_a_qt_frame_ends_after_painting(log: list[str], late: bool) -> None:
    base = fresh_base()
    hook = functools.partial(Qt("PyQt6").hook_painting, ("QOpenGLWidget", "NotThere"))
    if not late:
        hook(module_with(base), Changes())

    class App(base):  # type: ignore[misc]
        def paintGL(self) -> str:
            log.append("painted")
            return "result"

    if late:
        hook(module_with(base), Changes())
    assert App().show() == "result"
    assert App.paintGL.__name__ == "paintGL"
    assert log == ["painted", "(60, 40) in 7"]


def test_painting_through_super_is_one_frame(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class Scene(base):  # type: ignore[misc]
        def paintGL(self) -> None:
            log.append("scene")

    class App(Scene):
        def paintGL(self) -> None:
            super().paintGL()
            log.append("more")

    App().show()
    assert log == ["scene", "more", "(60, 40) in 7"]


def test_painting_that_a_mixin_does(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class Paints:
        def paintGL(self) -> None:
            log.append("painted")

    class App(Paints, base):  # type: ignore[misc]
        pass

    App().show()
    assert log == ["painted", "(60, 40) in 7"]
    Paints().paintGL()  # the mixin itself stays what it was
    assert log[2:] == ["painted"]


def test_what_painting_raises_is_the_apps(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class App(base):  # type: ignore[misc]
        fails = True

        def paintGL(self) -> None:
            if self.fails:
                raise ValueError("the app's own")

    app = App()
    with pytest.raises(ValueError, match="the app's own"):
        app.show()
    assert log == []
    app.fails = False
    app.show()
    assert log == ["(60, 40) in 7"]


def test_a_qt_program_that_swaps_by_itself(log: list[str]) -> None:
    swapped = type("QGLWidget", (Widget,), {"swapBuffers": lambda self: log.append("swapped")})
    module = SimpleNamespace(QGLWidget=swapped)
    qt = Qt("PyQt5")
    qt.hook_swaps("QGLWidget", module, Changes())
    qt.hook_painting(("QGLWidget",), module, Changes())

    class App(swapped):  # type: ignore[misc, valid-type]
        def paintGL(self) -> None:
            self.swapBuffers()

    App().show()
    assert log == ["(60, 40) in 7", "swapped"]


def test_a_method_is_not_asked_for_its_docstring(log: list[str]) -> None:
    class Method:  # as PySide's: its docstring cannot be made yet
        __name__ = __qualname__ = "swapBuffers"

        @property
        def __doc__(self) -> str:  # type: ignore[override]
            log.append("asked")
            return ""

        def __call__(self, context: Any, surface: Any) -> None:
            log.append("swapped")

    context = type("QOpenGLContext", (), {"swapBuffers": Method()})
    Qt("PySide6").hook_swaps(
        "QOpenGLContext", SimpleNamespace(QOpenGLContext=context), Changes())
    context().swapBuffers(Widget())
    assert log == ["(60, 40) in 7", "swapped"]


def test_wx(log: list[str]) -> None:
    def swap(canvas: Any) -> bool:
        log.append("swapped")
        return True

    canvas = type("GLCanvas", (), {
        "SwapBuffers": swap, "GetClientSize": lambda self: (30, 20),
        "GetContentScaleFactor": lambda self: 2.0})
    Wx().hook_swaps(SimpleNamespace(GLCanvas=canvas), Changes())
    assert canvas().SwapBuffers() is True
    assert log == ["(60, 40) in 0", "swapped"]
