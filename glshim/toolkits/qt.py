"""Qt, the same in PyQt and PySide: a widget's picture is finished when its `paintGL` returns; a
program that swaps by itself says so. Keys come by an event filter on the application."""

from __future__ import annotations

import functools
import inspect
import sys
import threading
import weakref
from collections.abc import Callable, Iterable
from contextlib import suppress
from types import FunctionType
from typing import Any, ClassVar

from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Moment

_PAINTED, _SWAPPED = "the return of paintGL", "swapBuffers"
# Qt's enumerators, the same in all versions and bindings.
_KEYS = {
    **{0x0100002F + n: f"F{n}" for n in range(1, 13)},
    **{ord(name): name for name in keyboard.NAMES if len(name) == 1},
    0x01000006: "Insert", 0x01000010: "Home", 0x01000011: "End",
    0x01000016: "PageUp", 0x01000017: "PageDown",
}  # fmt: skip
"""Qt::Key."""
_MODIFIERS = {"shift": 0x02000000, "ctrl": 0x04000000, "alt": 0x08000000}
"""Qt::KeyboardModifier."""
KEY_PRESS, KEY_RELEASE, SHORTCUT_OVERRIDE = 6, 7, 51
"""QEvent::Type; the last, which asks whether a shortcut of the app's may have a key, comes before
the key itself."""

_TESTED = {"PyQt5": "PyQt5 5.15.11 on X"}


class Qt(Toolkit):
    """One binding. Qt calls back from C++: PyQt aborts on an exception."""

    may_raise = False
    lacks: ClassVar[Lacks] = {Part.CLOCK: "QTimer, QElapsedTimer and animations run on"}

    def __init__(self, package: str, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self.name = self.package = package
        self.tested = _TESTED.get(package, "")
        self._painting = False
        self._classes: weakref.WeakSet[Any] = weakref.WeakSet()
        """Those whose `paintGL` is ours."""
        self._widgets: weakref.WeakSet[Any] = weakref.WeakSet()
        """What has painted or swapped, and may be asked to do so again."""
        self._core: Any = None
        self._filtered: tuple[Any, Any] = (None, None)
        """The application and its event filter, which Qt does not own."""

    def hooks(self) -> Iterable[Hook]:
        # Where a class lies differs between Qt 5 and 6.
        for module, names in (
            ("QtGui", ("QOpenGLWindow",)), ("QtWidgets", ("QOpenGLWidget",)),
            ("QtOpenGL", ("QGLWidget", "QOpenGLWindow")), ("QtOpenGLWidgets", ("QOpenGLWidget",)),
        ):  # fmt: skip
            put = functools.partial(self.hook_painting, names)
            yield Hook(Part.FRAMES, f"{self.package}.{module}", put, _PAINTED)
        for module, name in (("QtGui", "QOpenGLContext"), ("QtOpenGL", "QGLWidget")):
            swaps = functools.partial(self.hook_swaps, name)
            yield Hook(Part.FRAMES, f"{self.package}.{module}", swaps, _SWAPPED)
        yield Hook(Part.KEYS, f"{self.package}.QtCore", self.hook_keys, "an event filter")

    def size(self, widget: Any) -> Size:
        ratio = widget.devicePixelRatio()
        return round(widget.width() * ratio), round(widget.height() * ratio)

    def framebuffer(self, widget: Any) -> int:
        own = getattr(widget, "defaultFramebufferObject", None)
        return int(own()) if own is not None else 0

    def drawable(self, widget: Any = None) -> Drawable:
        with suppress(TypeError):  # not all that swaps can be referred to weakly
            self._widgets.add(widget)
        return super().drawable(widget)

    def redraw(self) -> None:
        """Have every widget or window that has painted do so again."""
        for widget in list(self._widgets):
            ask = getattr(widget, "update", None) or getattr(widget, "requestUpdate", None)
            with suppress(Exception):  # its C++ half may be gone
                if ask is not None:
                    ask()

    def leave(self) -> bool:
        """`exec` returns 0. No window is asked whether it may be closed; each is hidden as if it
        had been, since programs are used to that: some crash when Qt does it at the very end."""
        core = sys.modules.get(f"{self.package}.QtCore")
        app = core.QCoreApplication.instance() if core is not None else None
        if core is None or app is None or not core.QThread.currentThread().loopLevel():
            return False
        app.aboutToQuit.connect(functools.partial(_hide_windows, app))
        app.exit(0)
        return True

    # -- frame ends ------------------------------------------------------------------------------

    def hook_painting(self, names: Iterable[str], module: Any, changes: Changes) -> None:
        """`paintGL` of whatever derives from the module's widget classes of these names is a
        frame."""
        for name in names:
            base = getattr(module, name, None)
            if base is not None:
                self._follow_subclasses(base, changes)

    def hook_swaps(self, name: str, module: Any, changes: Changes) -> None:
        """The module's class of that name swaps by a method."""
        base = getattr(module, name, None)
        if base is not None:
            changes.set(base, "swapBuffers", self._swapping(base.swapBuffers))

    def _follow_subclasses(self, base: Any, changes: Changes) -> None:
        def follow(cls: Any, /, **named: Any) -> None:
            super(base, cls).__init_subclass__(**named)
            self._follow_painting(cls)

        changes.set(base, "__init_subclass__", classmethod(follow))
        changes.add(self._unfollow)
        waiting = base.__subclasses__()
        while waiting:
            cls = waiting.pop()
            self._follow_painting(cls)
            waiting += cls.__subclasses__()

    def _follow_painting(self, cls: Any) -> None:
        """The class's own `paintGL`, or one that it has from a class that is no widget."""
        plain = inspect.getattr_static(cls, "paintGL", None)
        if isinstance(plain, FunctionType) and not hasattr(plain, "glshim_plain"):
            inherited = "paintGL" not in vars(cls)
            cls.paintGL = self._painted(plain)
            cls.paintGL.glshim_inherited = inherited
            self._classes.add(cls)

    def _unfollow(self) -> None:
        for cls in list(self._classes):
            ours = vars(cls).get("paintGL")
            if hasattr(ours, "glshim_plain"):
                if ours.glshim_inherited:
                    del cls.paintGL
                else:
                    cls.paintGL = ours.glshim_plain
        self._classes.clear()

    def _painted(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(plain)
        def paint(widget: Any, *arguments: Any, **named: Any) -> Any:
            # One paintGL may call another: one frame.
            if self._painting or not frames.listening():
                return plain(widget, *arguments, **named)
            before = frames.presented()
            self._painting = True
            try:
                with frames.drawing(self.drawable(widget)):
                    result = plain(widget, *arguments, **named)
                    if frames.presented() == before:
                        frames.present(_shown_by_qt)
                    return result
            finally:
                self._painting = False

        paint.glshim_plain = plain  # type: ignore[attr-defined]
        return paint

    def _swapping(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        # Not its docstring: PySide makes that when asked, and cannot while it is being imported.
        @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
        def swap(this: Any, *arguments: Any) -> Any:
            window = arguments[0] if arguments else this
            return frames.present(plain, this, *arguments, on=self.drawable(window))

        return swap

    # -- keys ------------------------------------------------------------------------------------

    def hook_keys(self, module: Any, changes: Changes) -> None:
        """A filter on the application's events, once there is one."""
        self._core = module
        changes.add(self._unfilter)

    def window_is_there(self) -> None:
        if threading.current_thread() is not threading.main_thread():
            return
        app = self._core.QCoreApplication.instance()
        if app is not None and self._filtered[0] is not app:
            event_filter = _filter_class(self._core)()
            app.installEventFilter(event_filter)
            self._filtered = app, event_filter

    def _unfilter(self) -> None:
        app, event_filter = self._filtered
        self._filtered = None, None
        with suppress(Exception):  # the application may be gone
            if app is not None:
                app.removeEventFilter(event_filter)


def _shown_by_qt() -> None:
    """Qt puts the widget's picture on the screen after `paintGL`, when it likes."""


def _hide_windows(app: Any) -> None:
    for window in app.topLevelWindows():
        window.hide()


def _filter_class(module: Any) -> Callable[[], Any]:
    class Filter(module.QObject):  # type: ignore[misc]
        """Keeps the events of our keys from the app's windows and widgets."""

        def eventFilter(self, watched: Any, event: Any) -> bool:
            try:
                kind = _number(event.type())
                return kind in (SHORTCUT_OVERRIDE, KEY_PRESS, KEY_RELEASE) and is_ours(kind, event)
            except Exception:  # PyQt ends the program at one
                return False

    return Filter


def is_ours(kind: int, event: Any) -> bool:
    """Whether a key event, of a number of QEvent::Type, ends here."""
    name = _KEYS.get(_number(event.key()))
    if kind == KEY_RELEASE:
        # A key that is held comes up and down again all the time.
        if event.isAutoRepeat():
            return keyboard.pressed(name, again=True)
        return keyboard.released(name)
    held = keyboard.modifiers(_number(event.modifiers()), _MODIFIERS)
    if kind == KEY_PRESS:
        return keyboard.pressed(name, held, again=event.isAutoRepeat())
    if keyboard.is_ours(name, held, shortcut=True):
        event.accept()  # then the key comes as such, whatever shortcut the app has on it
        return True
    return False


def _number(value: Any) -> int:
    """An enumerator, of Python's or of a binding's own kind."""
    return int(getattr(value, "value", value))


TOOLKITS = tuple(Qt(package) for package in ("PyQt5", "PySide2", "PyQt6", "PySide6"))
