"""Keys under Qt: an event filter on the application, in the binding that the app uses."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any

from glshim.toolkits import keyboard

_NAMES = {
    **{0x0100002F + n: f"F{n}" for n in range(1, 13)},
    **{ord(name): name for name in keyboard.NAMES if len(name) == 1},
    0x01000006: "Insert", 0x01000010: "Home", 0x01000011: "End",
    0x01000016: "PageUp", 0x01000017: "PageDown",
}  # fmt: skip
"""By Qt::Key, the same in all versions."""
_BITS = {"shift": 0x02000000, "ctrl": 0x04000000, "alt": 0x08000000}
_SHORTCUT, _PRESS, _RELEASE = 51, 6, 7
"""QEvent::Type: whether a shortcut of the app's may have a key comes before the key itself."""


def hook_filter(module: ModuleType) -> Callable[[], None]:
    """For a binding's QtCore: what puts the filter on the application there is, if it lacks it.
    To be called in the application's thread."""
    filtered: list[Any] = []  # the application and its filter, which Qt does not own

    def start() -> None:
        app = module.QCoreApplication.instance()
        if app is not None and (not filtered or filtered[0] is not app):
            event_filter = _filter_class(module)()
            app.installEventFilter(event_filter)
            filtered[:] = [app, event_filter]

    return start


def _filter_class(module: ModuleType) -> Callable[[], Any]:
    class Filter(module.QObject):  # type: ignore[misc, name-defined]
        """Keeps the events of our keys from the app's windows and widgets."""

        def eventFilter(self, watched: Any, event: Any) -> bool:
            try:
                kind = _number(event.type())
                return kind in (_SHORTCUT, _PRESS, _RELEASE) and is_ours(kind, event)
            except Exception:  # PyQt ends the program at one
                return False

    return Filter


def is_ours(kind: int, event: Any) -> bool:
    """Whether a key event, of a number of QEvent::Type, ends here."""
    name = _NAMES.get(_number(event.key()))
    if kind == _RELEASE:
        # A key that is held comes up and down again all the time.
        return keyboard.pressed(name, again=True) if event.isAutoRepeat() else (
            keyboard.released(name)
        )
    mask = _number(event.modifiers())
    held = [modifier for modifier, bit in _BITS.items() if mask & bit]
    if kind == _PRESS:
        return keyboard.pressed(name, held, again=event.isAutoRepeat())
    if keyboard.is_ours(name, held, shortcut=True):
        event.accept()  # then the key comes as such, whatever shortcut the app has on it
        return True
    return False


def _number(value: Any) -> int:
    """An enumerator, of Python's or of a binding's own kind."""
    return int(getattr(value, "value", value))
