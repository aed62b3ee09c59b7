"""Qt, the same in PyQt and PySide: a widget's picture is finished when its `paintGL` returns, an
item's of QML when `render` does; a program that swaps by itself says so. What is drawn under or
over a scene of QML ends where the program gives OpenGL back to Qt. Keys come by an event filter on
the application."""

from __future__ import annotations

import functools
import inspect
import sys
import threading
import weakref
from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import replace
from types import FunctionType
from typing import Any

from glshim.driver.ask import integer
from glshim.spec.constants import GL_DRAW_FRAMEBUFFER_BINDING
from glshim.toolkits import frames, keyboard
from glshim.toolkits.base import Changes, Hook, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Moment
from glshim.toolkits.qtclock import QtClock, enumerator

_PAINTED, _SWAPPED = "the return of paintGL", "swapBuffers"
_RENDERED = "the return of render (QQuickFramebufferObject)"
_GIVEN_BACK = "endExternalCommands (QQuickWindow), in Qt 5 resetOpenGLState"
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

_TESTED = {
    "PyQt5": "PyQt5 5.15.11 on X and Wayland", "PyQt6": "PyQt6 6.11 on X",
    "PySide6": "PySide6 6.12 on X and Wayland",
}  # fmt: skip


class Qt(Toolkit):
    """One binding. Qt calls back from C++: PyQt aborts on an exception."""

    may_raise = False
    hears_threads = True
    def __init__(self, package: str, moment: Moment = MOMENT) -> None:
        super().__init__(moment)
        self.name = self.package = package
        self.tested = _TESTED.get(package, "")
        self._painting: set[int] = set()
        """Threads in which something is painted: QML has one of its own."""
        self._classes: weakref.WeakKeyDictionary[Any, str] = weakref.WeakKeyDictionary()
        """Those whose method of that name is ours."""
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
        quick = f"{self.package}.QtQuick"
        yield Hook(Part.FRAMES, quick, self.hook_items, _RENDERED)
        yield Hook(Part.FRAMES, quick, self.hook_scenes, _GIVEN_BACK)
        for module, name in (("QtGui", "QOpenGLContext"), ("QtOpenGL", "QGLWidget")):
            swaps = functools.partial(self.hook_swaps, name)
            yield Hook(Part.FRAMES, f"{self.package}.{module}", swaps, _SWAPPED)
        yield Hook(Part.KEYS, f"{self.package}.QtCore", self.hook_keys, "an event filter")
        yield Hook(Part.CLOCK, f"{self.package}.QtCore", self.hold_clock, "QTimer, QElapsedTimer")

    def size(self, widget: Any) -> Size:
        target = getattr(widget, "framebufferObject", None)
        if target is not None:
            size = target().size()
            return size.width(), size.height()
        ratio = widget.devicePixelRatio()
        return round(widget.width() * ratio), round(widget.height() * ratio)

    def framebuffer(self, widget: Any) -> int:
        own = getattr(widget, "defaultFramebufferObject", None)
        if own is not None:
            return int(own())
        target = getattr(widget, "framebufferObject", None)
        return int(target().handle()) if target is not None else 0

    def drawable(self, widget: Any = None) -> Drawable:
        with suppress(TypeError):  # not all that swaps can be referred to weakly
            self._widgets.add(widget)
        return super().drawable(widget)

    def redraw(self) -> None:
        """Have every widget or window that has painted do so again. From any thread."""
        for widget in list(self._widgets):
            name = "update" if hasattr(widget, "update") else "requestUpdate"
            with suppress(Exception):  # its C++ half may be gone
                if threading.current_thread() is threading.main_thread():
                    getattr(widget, name)()
                else:
                    self._later(widget, name)

    def leave(self) -> bool:
        """`exec` returns 0. No window is asked whether it may be closed; each is hidden as if it
        had been, since programs are used to that: some crash when Qt does it at the very end. Qt
        does all that when it likes: QML's thread may wait for Python meanwhile."""
        core = sys.modules.get(f"{self.package}.QtCore")
        app = core.QCoreApplication.instance() if core is not None else None
        if core is None or app is None:
            return False
        in_main_thread = threading.current_thread() is threading.main_thread()
        if in_main_thread and not core.QThread.currentThread().loopLevel():
            return False
        for window in app.topLevelWindows():
            self._later(window, "hide")
        self._later(app, "quit")
        return True

    def _later(self, target: Any, slot: str) -> None:
        """Have Qt call a slot from its main loop."""
        core = sys.modules[f"{self.package}.QtCore"]
        kinds = getattr(core.Qt, "ConnectionType", core.Qt)
        later = getattr(kinds, "QueuedConnection", None) or core.Qt.QueuedConnection
        core.QMetaObject.invokeMethod(target, slot, later)

    # -- frame ends ------------------------------------------------------------------------------

    def hook_painting(self, names: Iterable[str], module: Any, changes: Changes) -> None:
        """`paintGL` of whatever derives from the module's widget classes of these names is a
        frame."""
        for name in names:
            base = getattr(module, name, None)
            if base is not None:
                self._follow_subclasses(base, "paintGL", changes)

    def hook_items(self, module: Any, changes: Changes) -> None:
        """`render` of renderers of QML's items, which paint into framebuffer objects."""
        item = getattr(module, "QQuickFramebufferObject", None)
        if item is not None:
            self._follow_subclasses(item.Renderer, "render", changes)

    def hook_scenes(self, module: Any, changes: Changes) -> None:
        """What is drawn into a window of QML, between or beside what Qt draws."""
        base, lent = module.QQuickWindow, set[int]()

        def giving_back(name: str, plain: Callable[..., Any]) -> Callable[..., Any]:
            @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
            def give_back(window: Any) -> Any:
                thread = threading.get_ident()
                if name == "endExternalCommands":
                    lent.discard(thread)
                if thread not in lent and frames.listening():
                    bound = integer(GL_DRAW_FRAMEBUFFER_BINDING)
                    on = replace(self.drawable(window), framebuffer=lambda: bound)
                    return frames.present(plain, window, on=on)
                return plain(window)

            return give_back

        def lending(begin: Callable[..., Any]) -> Callable[..., Any]:
            def lend(window: Any) -> Any:
                lent.add(threading.get_ident())  # until endExternalCommands
                return begin(window)

            return lend

        if hasattr(base, "beginExternalCommands"):  # from Qt 5.14 on
            changes.set(base, "beginExternalCommands", lending(base.beginExternalCommands))
        for name in ("endExternalCommands", "resetOpenGLState"):
            if hasattr(base, name):
                changes.set(base, name, giving_back(name, getattr(base, name)))

    def hook_swaps(self, name: str, module: Any, changes: Changes) -> None:
        """The module's class of that name swaps by a method."""
        base = getattr(module, name, None)
        if base is not None:
            changes.set(base, "swapBuffers", self._swapping(base.swapBuffers))

    def _follow_subclasses(self, base: Any, method: str, changes: Changes) -> None:
        def follow(cls: Any, /, **named: Any) -> None:
            super(base, cls).__init_subclass__(**named)
            self._follow_painting(cls, method)

        changes.set(base, "__init_subclass__", classmethod(follow))
        changes.add(self._unfollow)
        waiting = base.__subclasses__()
        while waiting:
            cls = waiting.pop()
            self._follow_painting(cls, method)
            waiting += cls.__subclasses__()

    def _follow_painting(self, cls: Any, method: str) -> None:
        """The class's own method, or one that it has from a class that is no widget."""
        plain = inspect.getattr_static(cls, method, None)
        if isinstance(plain, FunctionType) and not hasattr(plain, "glshim_plain"):
            ours: Any = self._painted(plain)
            ours.glshim_inherited = method not in vars(cls)
            setattr(cls, method, ours)
            self._classes[cls] = method

    def _unfollow(self) -> None:
        for cls, method in list(self._classes.items()):
            ours = vars(cls).get(method)
            if hasattr(ours, "glshim_plain"):
                if ours.glshim_inherited:
                    delattr(cls, method)
                else:
                    setattr(cls, method, ours.glshim_plain)
        self._classes.clear()

    def _painted(self, plain: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(plain)
        def paint(widget: Any, *arguments: Any, **named: Any) -> Any:
            # One paintGL may call another: one frame.
            thread = threading.get_ident()
            if thread in self._painting or not frames.listening():
                return plain(widget, *arguments, **named)
            before = frames.presented()
            self._painting.add(thread)
            try:
                with frames.drawing(self.drawable(widget)):
                    result = plain(widget, *arguments, **named)
                    if frames.presented() == before:
                        frames.present(_shown_by_qt)
                    return result
            finally:
                self._painting.discard(thread)

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


    # -- clock -----------------------------------------------------------------------------------

    def hold_clock(self, module: Any, changes: Changes) -> None:
        """Timers and QElapsedTimer by the moment. Animations run on."""
        QtClock(module, self.moment).serve(changes)


def _shown_by_qt() -> None:
    """Qt puts the widget's picture on the screen after `paintGL`, when it likes."""


def _filter_class(module: Any) -> Callable[[], Any]:
    class Filter(module.QObject):  # type: ignore[misc]
        """Keeps the events of our keys from the app's windows and widgets."""

        def eventFilter(self, watched: Any, event: Any) -> bool:
            try:
                kind = enumerator(event.type())
                return kind in (SHORTCUT_OVERRIDE, KEY_PRESS, KEY_RELEASE) and is_ours(kind, event)
            except Exception:  # PyQt ends the program at one
                return False

    return Filter


def is_ours(kind: int, event: Any) -> bool:
    """Whether a key event, of a number of QEvent::Type, ends here."""
    name = _KEYS.get(enumerator(event.key()))
    if kind == KEY_RELEASE:
        # A key that is held comes up and down again all the time.
        if event.isAutoRepeat():
            return keyboard.pressed(name, again=True)
        return keyboard.released(name)
    held = keyboard.modifiers(enumerator(event.modifiers()), _MODIFIERS)
    if kind == KEY_PRESS:
        return keyboard.pressed(name, held, again=event.isAutoRepeat())
    if keyboard.is_ours(name, held, shortcut=True):
        event.accept()  # then the key comes as such, whatever shortcut the app has on it
        return True
    return False


TOOLKITS = tuple(Qt(package) for package in ("PyQt5", "PySide2", "PyQt6", "PySide6"))
