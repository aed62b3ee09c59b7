"""Which keys do what while a program runs: the texts of GLSHIM_KEYS and GLSHIM_STYLES."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from glshim.errors import StyleError, nearest, unknown
from glshim.styling import texts
from glshim.toolkits.keyboard import MODIFIERS, NAMES, SPECIAL, chord

KEYS = "GLSHIM_KEYS"
"""The variable that they are named in."""
DEFAULTS = {"cycle": "F9", "back": "shift+F9", "toggle": "F10", "save": "F11", "overlay": "F12"}
"""The keys of ``GLSHIM_KEYS=on`` by what they do."""
NO_KEYS = ("off", "no", "false", "0")
ALL_KEYS = ("on", "yes", "true", "1")


@dataclass(frozen=True, slots=True)
class Keys:
    """Keys by what they do."""

    chords: Mapping[str, str]
    """Action to chord, as `glshim.toolkits.keyboard.chord` writes it."""
    named: frozenset[str] = frozenset()
    """Actions whose keys the user chose: they are ours also where the program uses them."""

    def action(self, pressed: str) -> str | None:
        """What a chord does."""
        return next((each for each, key in self.chords.items() if key == pressed), None)


@dataclass(frozen=True, slots=True)
class LiveSettings:
    """What the keys do it with."""

    keys: Keys
    styles: tuple[str, ...] = ()
    """Texts of styles to go through; empty: all that are installed."""
    folder: str = ""
    """Where pictures go, absolute."""


def parse_chord(text: str) -> str:
    """``F9``, ``shift+F9``, ``ctrl+alt+k`` as `glshim.toolkits.keyboard.chord` writes it. Raises
    `StyleError`."""
    *modifiers, name = (part.strip() for part in text.split("+"))
    known = {key.lower(): key for key in NAMES}
    key = known.get(name.lower())
    if key is None:
        what = f"unknown key {name!r}"
        if nearest(name, NAMES):
            raise unknown(what, name, NAMES)
        raise StyleError(f"{what}: use F1 to F12, A to Z, 0 to 9, {', '.join(SPECIAL)}")
    for modifier in modifiers:
        if modifier.lower() not in MODIFIERS:
            raise StyleError(f"{modifier!r} is not a modifier: use {', '.join(MODIFIERS)}")
    held = {modifier.lower() for modifier in modifiers}
    if key.isdigit() and "shift" in held:
        raise StyleError(f"{text.strip()}: shift with a digit types another character")
    return chord(key, held)


def parse_keys(text: str, folder: str = "") -> Keys | None:
    """``on``, ``off`` (None) or ``action=key,action=off``; actions that are not named keep their
    keys of `DEFAULTS`. Raises `StyleError`."""
    if text.strip().lower() in NO_KEYS:
        return None
    if text.strip().lower() in ALL_KEYS:
        return Keys(DEFAULTS)
    chords: dict[str, str] = dict(DEFAULTS)
    named: set[str] = set()
    for piece in filter(str.strip, text.split(",")):
        action, equals, key = (part.strip() for part in piece.partition("="))
        if not equals or not key:
            raise StyleError(
                f"{piece.strip()!r} assigns no key: write on, off or ACTION=KEY, "
                f"e.g. cycle=F5,overlay=off; actions: {', '.join(DEFAULTS)}"
            )
        if action not in DEFAULTS:
            raise unknown(f"unknown action {action!r}", action, DEFAULTS)
        named.add(action)
        chords[action] = "" if key.lower() in NO_KEYS else parse_chord(key)
    if "cycle" in named and "back" not in named:  # back goes the same way with shift
        forward = chords["cycle"]
        shiftable = forward and "shift" not in forward and not forward.split("+")[-1].isdigit()
        chords["back"] = parse_chord(f"shift+{forward}") if shiftable else ""
        named.add("back")
    held = {action: key for action, key in chords.items() if key}
    for action, key in held.items():
        other = next((a for a, k in held.items() if k == key and a != action), None)
        if other is not None:
            raise StyleError(f"{key} is assigned to both {action} and {other}")
    return Keys(held, frozenset(named))


def parse_styles(text: str, folder: str = "") -> tuple[str, ...]:
    """A list of style texts, see `glshim.styling.texts.split_styles`; files are taken from the
    folder. Raises `StyleError`."""
    return tuple(texts.anchored(each, folder) for each in texts.split_styles(text))
