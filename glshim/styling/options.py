"""Options of stylers: the fields of their dataclasses, each with its kind, range and help."""

from __future__ import annotations

import math
import os
from dataclasses import MISSING, Field, dataclass, field, fields, replace
from typing import Any, Literal

from glshim.errors import StyleError, nearest, shown
from glshim.styling.colournames import COLOUR_NAMES
from glshim.styling.colours import HOW, format_colour, is_colour, parse_colour
from glshim.styling.pictures import read_image

Kind = Literal[
    "number", "integer", "colour", "switch", "choice", "choice or colour", "choice or picture"
]
_NUMBERS = ("number", "integer")
_KEY = "glshim.option"
AUTO = "auto"
"""The word for None: another option decides."""


@dataclass(frozen=True, slots=True)
class Option:
    """One option of a styler, as `options_of` lists it. Plain data for parsers and help texts."""

    name: str
    kind: Kind
    default: Any
    """The stored value: a float, int, bool, `Colour`, one of choices or the path of a picture."""
    help: str
    low: float | None = None
    """Least allowed value of a number (inclusive)."""
    high: float | None = None
    """Greatest allowed value of a number (inclusive)."""
    unit: str = ""
    """``px``, ``degrees`` or empty."""
    choices: tuple[str, ...] = ()
    """Allowed words of kinds ``choice`` and ``choice or ...``."""
    follows: str = ""
    """The option that decides while this one is None (`AUTO` in texts), as it is by default."""

    @property
    def allowed(self) -> str:
        """The range in words, for help texts and errors."""
        return f"{self._range} or {AUTO}" if self.follows else self._range

    @property
    def _range(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        if self.kind in _NUMBERS:
            low = "" if self.low is None else f"{self.low:g}"
            high = "" if self.high is None else f"{self.high:g}"
            whole = self.kind == "integer"
            if low or high:
                return f"{low}..{high}{unit}{', whole' if whole else ''}"
            return f"a {'whole ' if whole else ''}number{unit}"
        if self.kind == "switch":
            return "on, off"
        if self.kind == "colour":
            return HOW
        words = ", ".join(self.choices)
        if self.kind == "choice or picture":
            return f"{words} or PATH.png"
        return f"{words}, {HOW}" if self.kind == "choice or colour" else words

    def parse(self, text: str, folder: str = "") -> Any:
        """The stored value that a text stands for; relative paths are taken from the folder.
        Raises `StyleError`, naming the option."""
        text = text.strip()
        if self.follows and text.lower() == AUTO:
            return None
        if self.kind in _NUMBERS:
            try:
                return self.check(float(text))
            except ValueError:
                raise self._refuse(text) from None
        if self.kind == "switch":
            words = {"on": True, "off": False, "true": True, "false": False}
            words |= {"yes": True, "no": False, "1": True, "0": False}
            if text.lower() not in words:
                raise self._refuse(text)
            return words[text.lower()]
        if text in self.choices:
            return text
        if self.kind == "choice or picture":
            return self._picture(text, folder)
        if self.kind != "choice" and is_colour(text):
            return parse_colour(text)
        raise self._refuse(text)

    def check(self, value: Any, folder: str = "") -> Any:
        """The stored value for a Python value (TOML, a constructor's argument); text colours
        and whole numbers are welcome. Raises `StyleError`, naming the option."""
        if value is None and self.follows:
            return None
        if self.kind == "switch":
            if isinstance(value, bool):
                return value
        elif self.kind in _NUMBERS:
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                low = -math.inf if self.low is None else self.low
                high = math.inf if self.high is None else self.high
                if low <= value <= high and _is_finite(value):
                    if self.kind == "number":
                        return float(value)
                    if value == int(value):
                        return int(value)
        elif isinstance(value, bool) and {"on", "off"} <= {*self.choices}:
            return "on" if value else "off"
        elif isinstance(value, str):
            return self.parse(value, folder)
        elif self.kind in ("colour", "choice or colour") and _is_colour(value):
            return tuple(float(channel) for channel in value)
        raise self._refuse(value)

    def show(self, value: Any) -> str:
        """A stored value as `parse` reads it."""
        if value is None:
            return AUTO
        if isinstance(value, bool):
            return "on" if value else "off"
        if isinstance(value, tuple):
            return format_colour(value)
        return f"{value:g}" if isinstance(value, float) else str(value)

    def _picture(self, text: str, folder: str) -> str:
        """The whole path of a picture, which can be read."""
        if not text:
            raise self._refuse(text)
        try:
            path = os.path.abspath(os.path.join(folder, os.path.expanduser(text)))
            read_image(path)
        except (StyleError, ValueError) as error:  # ValueError: not a path
            near = nearest(text, self.choices)
            hint = f"did you mean {near[0]}?" if near else f"give {self.allowed}"
            raise StyleError(f"{self.name}={shown(text)}: {error}; {hint}") from error
        return path

    def _refuse(self, value: object) -> StyleError:
        words = (*self.choices, *(COLOUR_NAMES if "colour" in self.kind else ()))
        near = nearest(value, words) if isinstance(value, str) else ()
        hint = f"did you mean {near[0]}? Give" if near else "give"
        return StyleError(f"{self.name}={shown(value)} is not allowed: {hint} {self.allowed}")


def _is_finite(value: float) -> bool:
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number that no float can hold
        return False


def _is_colour(value: object) -> bool:
    return (
        isinstance(value, (tuple, list))
        and len(value) == 3
        and all(isinstance(v, (int, float)) and 0.0 <= v <= 1.0 for v in value)
    )


def option(
    default: Any,
    *,
    help: str,
    low: float | None = None,
    high: float | None = None,
    unit: str = "",
    choices: tuple[str, ...] = (),
    colour: bool = False,
    picture: bool = False,
    follows: str = "",
) -> Any:
    """A dataclass field that is an option of a styler; its kind follows from the default.

    ``True``/``False``: switch. An int: whole number within low..high, in unit; a float, or an int
    of a field that is declared a float: any number there. ``"#rrggbb"``: colour, stored as
    `Colour`. One of choices: choice, or with ``colour=True`` choice or colour, with
    ``picture=True`` choice or the path of a picture file, stored whole. follows: the option that
    decides while this one is None, as it then is by default.
    """
    kind: Kind
    if isinstance(default, bool):
        kind = "switch"
    elif isinstance(default, int):
        kind = "integer"
    elif isinstance(default, float):
        kind = "number"
    elif choices:
        kind = "choice or colour" if colour else "choice or picture" if picture else "choice"
    else:
        kind, default = "colour", parse_colour(default)
    default = None if follows else default
    described = Option("", kind, default, help, low, high, unit, choices, follows)
    return field(default=default, metadata={_KEY: described})


def options_of(styler: type) -> tuple[Option, ...]:
    """The options of a styler's class, in the order of its fields, those that follow others after
    all that do not."""
    found = [_named(f) for f in fields(styler) if _KEY in f.metadata]
    return tuple(sorted(found, key=lambda option: bool(option.follows)))


def _named(f: Field[Any]) -> Option:
    found: Option = f.metadata[_KEY]
    assert f.default is not MISSING
    kind, default = found.kind, found.default
    if kind == "integer" and f.type in ("float", float, "float | None", float | None):
        kind, default = "number", None if default is None else float(default)
    return replace(found, name=f.name, kind=kind, default=default)
