"""Qt's frame ends, the same in PyQt and PySide: a widget's picture is finished when its `paintGL`
returns; a program that swaps by itself says so."""

from __future__ import annotations

import functools
import inspect
import weakref
from collections.abc import Callable
from contextlib import suppress
from types import FunctionType, ModuleType
from typing import Any

from glshim.toolkits import frames
from glshim.toolkits.frames import Size, Surface

_painting = False
_painted_widgets: weakref.WeakSet[Any] = weakref.WeakSet()
"""What has painted or swapped, and may be asked to do so again."""


def update_widgets() -> None:
    """Have every widget or window that has painted do so again."""
    for widget in list(_painted_widgets):
        ask = getattr(widget, "update", None) or getattr(widget, "requestUpdate", None)
        with suppress(Exception):  # its C++ half may be gone
            if ask is not None:
                ask()


def hook_painting(*names: str) -> Callable[[ModuleType], None]:
    """A hook on the module's widget classes of these names: `paintGL` of whatever derives from
    them is a frame."""

    def hook(module: ModuleType) -> None:
        for name in names:
            base = getattr(module, name, None)
            if base is not None:
                _follow_subclasses(base)

    return hook


def hook_swaps(**names: str) -> Callable[[ModuleType], None]:
    """A hook on methods that swap, by the class that has each."""

    def hook(module: ModuleType) -> None:
        for class_name, method in names.items():
            base = getattr(module, class_name, None)
            if base is not None:
                setattr(base, method, _swapping(getattr(base, method)))

    return hook


def _follow_subclasses(base: Any) -> None:
    def follow(cls: Any, /, **named: Any) -> None:
        super(base, cls).__init_subclass__(**named)
        _follow_painting(cls)

    base.__init_subclass__ = classmethod(follow)
    waiting = base.__subclasses__()
    while waiting:
        cls = waiting.pop()
        _follow_painting(cls)
        waiting += cls.__subclasses__()


def _follow_painting(cls: Any) -> None:
    """The class's own `paintGL`, or one that it has from a class that is no widget."""
    plain = inspect.getattr_static(cls, "paintGL", None)
    if isinstance(plain, FunctionType) and not hasattr(plain, "glshim_plain"):
        cls.paintGL = _painted(plain)


def _painted(plain: Callable[..., Any]) -> Callable[..., Any]:
    @functools.wraps(plain)
    def paint(widget: Any, *arguments: Any, **named: Any) -> Any:
        global _painting
        if _painting or not frames.listening():  # one paintGL may call another: one frame
            return plain(widget, *arguments, **named)
        before = frames.presented()
        _painting = True
        try:
            with frames.drawing(_surface(widget)):
                result = plain(widget, *arguments, **named)
                if frames.presented() == before:
                    frames.present(_shown_by_qt)
                return result
        finally:
            _painting = False

    paint.glshim_plain = plain  # type: ignore[attr-defined]
    return paint


def _swapping(plain: Callable[..., Any]) -> Callable[..., Any]:
    # Not its docstring: PySide makes that when asked, and cannot while it is being imported.
    @functools.wraps(plain, assigned=("__name__", "__qualname__"), updated=())
    def swap(this: Any, *arguments: Any) -> Any:
        return frames.present(plain, this, *arguments, on=_surface(*arguments, this))

    return swap


def _surface(widget: Any, *_: Any) -> Surface:
    with suppress(TypeError):  # not all that swaps can be referred to weakly
        _painted_widgets.add(widget)

    def size() -> Size:
        ratio = widget.devicePixelRatio()
        return round(widget.width() * ratio), round(widget.height() * ratio)

    def framebuffer() -> int:
        own = getattr(widget, "defaultFramebufferObject", None)
        return int(own()) if own is not None else 0

    # Qt calls back from C++: PyQt aborts on an exception.
    return Surface(size, may_raise=False, framebuffer=framebuffer)


def _shown_by_qt() -> None:
    """Qt puts the widget's picture on the screen after `paintGL`, when it likes."""
