"""Keys that are ours, whichever toolkit tells the program about them.

A toolkit's hook asks here about each key before the program hears of it. A key is ours or the
program's: one that we act on the program does not get, neither its press nor its release; all
others it gets as ever.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Protocol

from glshim.notices import say_fault
from glshim.system.interrupts import is_ours as is_fault

MODIFIERS = ("ctrl", "alt", "shift")
SPECIAL = ("Insert", "Home", "End", "PageUp", "PageDown")
NAMES = (*(f"F{n}" for n in range(1, 13)), *"ABCDEFGHIJKLMNOPQRSTUVWXYZ", *"0123456789", *SPECIAL)
"""Keys by name, alike in every toolkit."""


class KeyListener(Protocol):
    """Who acts on keys. Both are called in whatever thread a toolkit tells of them, where no GL may
    be called."""

    def owns(self, chord: str) -> bool:
        """Whether a chord is ours."""

    def claims(self, chord: str) -> bool:
        """Whether it is so even before a toolkit has looked for a shortcut of the app's on it."""

    def press(self, chord: str) -> None:
        """One that is was pressed."""


_listener: KeyListener | None = None
_held: set[str] = set()


def chord(name: str, held: Collection[str] = ()) -> str:
    """A key of `NAMES` with the `MODIFIERS` that are held: ``ctrl+shift+F9``."""
    return "+".join((*(modifier for modifier in MODIFIERS if modifier in held), name))


def modifiers(mask: int, bits: Mapping[str, int]) -> set[str]:
    """The `MODIFIERS` of a mask, by a toolkit's bits of each."""
    return {modifier for modifier, bit in bits.items() if mask & bit}


def listen(listener: KeyListener | None) -> None:
    """Be told of each chord that is pressed; None: nobody is."""
    global _listener
    _listener = listener
    _held.clear()


def listening() -> bool:
    """Whether keys matter to anyone."""
    return _listener is not None


# -- for the toolkits' hooks -----------------------------------------------------------------------


def is_ours(name: str | None, held: Collection[str] = (), *, shortcut: bool = False) -> bool:
    """Whether a key that goes down would be ours (shortcut: be it a shortcut of the app's). Raises
    nothing of ours."""
    if _listener is None or name is None:
        return False
    try:
        return (_listener.claims if shortcut else _listener.owns)(chord(name, held))
    except Exception as error:
        if not is_fault(error):
            raise
        say_fault("an error in live control; the program runs on", error)
        return False


def pressed(name: str | None, held: Collection[str] = (), *, again: bool = False) -> bool:
    """A key went down (again: is held, and repeats): whether it is ours. Raises nothing
    of ours."""
    if again:
        return name in _held
    if _listener is None or name is None or not is_ours(name, held):
        _held.discard(str(name))
        return False
    _held.add(name)
    try:
        _listener.press(chord(name, held))
    except Exception as error:
        if not is_fault(error):
            raise
        say_fault("an error in live control; the program runs on", error)
    return True


def released(name: str | None) -> bool:
    """A key went up: whether its press was ours."""
    if name not in _held:
        return False
    _held.discard(str(name))
    return True
