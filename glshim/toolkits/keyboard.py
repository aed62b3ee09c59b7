"""Keys that are ours, whichever toolkit tells the program about them.

A toolkit's hook (`glshim.toolkits.keyboards`) asks here about each key before the program hears of
it. A key belongs to one of both: what we act on the program does not get, neither its press nor its
release; all others it gets as ever.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import Protocol

from glshim.notices import say_fault

MODIFIERS = ("ctrl", "alt", "shift")
SPECIAL = ("Insert", "Home", "End", "PageUp", "PageDown")
NAMES = (*(f"F{n}" for n in range(1, 13)), *"ABCDEFGHIJKLMNOPQRSTUVWXYZ", *"0123456789", *SPECIAL)
"""Keys by name, alike in every toolkit."""


class Listener(Protocol):
    """Who acts on keys. Both are called in whatever thread a toolkit tells of them, where no GL may
    be called."""

    def owns(self, chord: str) -> bool:
        """Whether a chord is ours."""

    def claims(self, chord: str) -> bool:
        """Whether it is so even before a toolkit has looked for a shortcut of the app's on it."""

    def press(self, chord: str) -> None:
        """One that is was pressed."""


_listener: Listener | None = None
_held: set[str] = set()
_starters: list[Callable[[], None]] = []
_redraws: list[Callable[[], None]] = []


def chord(name: str, held: Collection[str] = ()) -> str:
    """A key of `NAMES` with the `MODIFIERS` that are held: ``ctrl+shift+F9``."""
    return "+".join((*(modifier for modifier in MODIFIERS if modifier in held), name))


def listen(listener: Listener | None) -> None:
    """Be told of each chord that is pressed; None: nobody is."""
    global _listener
    _listener = listener
    _held.clear()


def listening() -> bool:
    """Whether keys matter to anyone."""
    return _listener is not None


# -- for the toolkits' hooks -----------------------------------------------------------------------


def is_ours(name: str | None, held: Collection[str] = (), *, shortcut: bool = False) -> bool:
    """Whether a key that goes down would be ours (shortcut: be it a shortcut of the app's). Never
    raises."""
    if _listener is None or name is None:
        return False
    try:
        return (_listener.claims if shortcut else _listener.owns)(chord(name, held))
    except Exception as error:
        say_fault("a key went wrong, the program runs on", error)
        return False


def pressed(name: str | None, held: Collection[str] = (), *, again: bool = False) -> bool:
    """A key went down (again: is held, and repeats): whether it is ours. Never raises."""
    if again:
        return name in _held
    if _listener is None or name is None or not is_ours(name, held):
        _held.discard(str(name))
        return False
    _held.add(name)
    try:
        _listener.press(chord(name, held))
    except Exception as error:
        say_fault("a key went wrong, the program runs on", error)
    return True


def released(name: str | None) -> bool:
    """A key went up: whether its press was ours."""
    if name not in _held:
        return False
    _held.discard(str(name))
    return True


def at_frame_ends(start: Callable[[], None]) -> None:
    """Have it called at each frame end: for what can be hooked only once a window is there."""
    _starters.append(start)


def on_redraw(redraw: Callable[[], None]) -> None:
    """What asks the windows of a toolkit for another frame."""
    _redraws.append(redraw)


# -- for who listens -------------------------------------------------------------------------------


def frame_ends() -> None:
    """A window is there, and its context is current."""
    for start in _starters:
        start()


def redraw() -> None:
    """Ask for another frame: programs that draw only on demand would show nothing new."""
    for each in _redraws:
        each()
