"""What a styler is, what it gets (`Layer`) and what it gives (`Lines`, `Pass`, `BackFaces`).

A styler is a frozen dataclass whose fields are its options; it says what to draw and never
calls GL::

    @dataclass(frozen=True)
    class Dots(Styler):
        name: ClassVar[str] = "dots"
        size: float = option(4.0, help="diameter", low=1, high=64, unit="px")
        ink: Colour = option("#000000", help="colour of the dots")

        def draws(self, layer: Layer) -> list[Lines]:
            dots = Medium(DOTS, {"size": self.size, "ink": self.ink})
            return [Lines(layer.bodies, Choice(silhouettes=True), dots)]
"""

from __future__ import annotations

import difflib
import math
import os
import re
from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import MISSING, Field, dataclass, field, fields
from typing import Any, ClassVar, Literal

from glshim.errors import StyleError
from glshim.styling.fixed import BackFaces
from glshim.styling.lines import Draw, Expand, Expansion, Lines, Medium, Shader
from glshim.styling.passes import Pass
from glshim.styling.pictures import read_image
from glshim.styling.values import Colour, Layer, Uniform

__all__ = [
    "BackFaces", "Colour", "Draw", "Expand", "Expansion", "Layer", "Lines", "Medium", "Option",
    "Pass", "Shader", "Styler", "Uniform", "format_colour", "option", "options_of", "parse_colour",
]  # fmt: skip

Kind = Literal["number", "colour", "switch", "choice", "choice or colour", "choice or picture"]

SURFACES = ("app", "none", "paint", "colours")
"""Words of `Styler.surface`."""
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")
_KEY = "glshim.option"


def parse_colour(text: str) -> Colour:
    """``#rrggbb`` to floats in 0..1. Raises `StyleError` for any other text."""
    if not _COLOUR.match(text):
        raise StyleError(f"{text!r} is no colour: write #rrggbb, e.g. #1a2b3c")
    red, green, blue = (int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue


def format_colour(colour: Colour) -> str:
    """Floats in 0..1 to ``#rrggbb``."""
    return "#" + "".join(f"{round(channel * 255):02x}" for channel in colour)


@dataclass(frozen=True, slots=True)
class Option:
    """One option of a styler, as `options_of` lists it. Plain data for parsers and help texts."""

    name: str
    kind: Kind
    default: Any
    """The stored value: a float, bool, `Colour`, one of choices or the path of a picture."""
    help: str
    low: float | None = None
    """Least allowed value of a number (inclusive)."""
    high: float | None = None
    """Greatest allowed value of a number (inclusive)."""
    unit: str = ""
    """``px``, ``degrees`` or empty."""
    choices: tuple[str, ...] = ()
    """Allowed words of kinds ``choice`` and ``choice or ...``."""

    @property
    def allowed(self) -> str:
        """The range in words, for help texts and errors."""
        unit = f" {self.unit}" if self.unit else ""
        if self.kind == "number":
            low = "" if self.low is None else f"{self.low:g}"
            high = "" if self.high is None else f"{self.high:g}"
            return f"{low}..{high}{unit}" if low or high else f"a number{unit}"
        if self.kind == "switch":
            return "on, off"
        if self.kind == "colour":
            return "#rrggbb"
        words = ", ".join(self.choices)
        if self.kind == "choice or picture":
            return f"{words} or PATH.png"
        return f"{words} or #rrggbb" if self.kind == "choice or colour" else words

    def parse(self, text: str, folder: str = "") -> Any:
        """The stored value that a text stands for; relative paths are taken from the folder.
        Raises `StyleError`, naming the option."""
        text = text.strip()
        if self.kind == "number":
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
        if self.kind != "choice" and _COLOUR.match(text):
            return parse_colour(text)
        raise self._refuse(text)

    def check(self, value: Any, folder: str = "") -> Any:
        """The stored value for a Python value (TOML, a constructor's argument); text colours
        and whole numbers are welcome. Raises `StyleError`, naming the option."""
        if self.kind == "switch":
            if isinstance(value, bool):
                return value
        elif self.kind == "number":
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                low = -math.inf if self.low is None else self.low
                high = math.inf if self.high is None else self.high
                if math.isfinite(value) and low <= value <= high:
                    return float(value)
        elif isinstance(value, str):
            return self.parse(value, folder)
        elif self.kind in ("colour", "choice or colour") and _is_colour(value):
            return tuple(float(channel) for channel in value)
        raise self._refuse(value)

    def show(self, value: Any) -> str:
        """A stored value as `parse` reads it."""
        if isinstance(value, bool):
            return "on" if value else "off"
        if isinstance(value, tuple):
            return format_colour(value)
        return f"{value:g}" if isinstance(value, float) else str(value)

    def _picture(self, text: str, folder: str) -> str:
        """The whole path of a picture, which can be read."""
        if not text:
            raise self._refuse(text)
        path = os.path.abspath(os.path.join(folder, os.path.expanduser(text)))
        try:
            read_image(path)
        except StyleError as error:
            near = difflib.get_close_matches(text, self.choices, n=1)
            hint = f"did you mean {near[0]}?" if near else f"give {self.allowed}"
            raise StyleError(f"{self.name}={text}: {error}; {hint}") from error
        return path

    def _refuse(self, value: object) -> StyleError:
        return StyleError(f"{self.name}={value} is not allowed: give {self.allowed}")


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
) -> Any:
    """A dataclass field that is an option of a styler; its kind follows from the default.

    ``True``/``False``: switch. A number: number within low..high, in unit. ``"#rrggbb"``:
    colour, stored as `Colour`. One of choices: choice, or with ``colour=True`` choice or colour,
    with ``picture=True`` choice or the path of a picture file, stored whole.
    """
    kind: Kind
    if isinstance(default, bool):
        kind = "switch"
    elif isinstance(default, (int, float)):
        kind, default = "number", float(default)
    elif choices:
        kind = "choice or colour" if colour else "choice or picture" if picture else "choice"
    else:
        kind, default = "colour", parse_colour(default)
    described = Option("", kind, default, help, low, high, unit, choices)
    return field(default=default, metadata={_KEY: described})


@dataclass(frozen=True)
class Styler:
    """Base of all stylers. Options that are not allowed raise `StyleError` at construction."""

    name: ClassVar[str] = ""
    """The word in a style text, and of the entry point."""
    wants_polygons: ClassVar[bool] = True
    """False: nothing is assembled and `draws` is never called."""

    @property
    def wants_colours(self) -> bool:
        """Whether `PolygonBatch.regions` shall say which polygons have the same colour."""
        return False

    @property
    def wants_normals(self) -> bool:
        """Whether `PolygonBatch.normals` shall hold the normals that the app sends."""
        return False

    @property
    def wants_lights(self) -> bool:
        """Whether `Camera.lit`, `gleams` and `textured`, and `Layer.lighting` shall say how the
        app lights its polygons."""
        return False

    @property
    def surface(self) -> str | Colour:
        """How the base polygons look: ``"app"`` (untouched), ``"none"`` (depth only), ``"paint"``
        (the app's colours and textures without its light), ``"colours"`` (without its textures
        and fog, too), a colour. It is the option ``fill`` of styles that have one."""
        fill: str | Colour = getattr(self, "fill", "app")
        return fill

    @abstractmethod
    def draws(self, layer: Layer) -> Iterable[Lines | Pass | BackFaces]:
        """What to add to a finished layer. Pure: equal layers give equal draws."""
        raise NotImplementedError

    def __post_init__(self) -> None:
        for described in options_of(type(self)):
            value = described.check(getattr(self, described.name))
            object.__setattr__(self, described.name, value)


def options_of(styler: type[Styler]) -> tuple[Option, ...]:
    """The options of a styler's class, in the order of its fields."""
    return tuple(_named(f) for f in fields(styler) if _KEY in f.metadata)


def _named(f: Field[Any]) -> Option:
    found: Option = f.metadata[_KEY]
    assert f.default is not MISSING
    return Option(
        f.name, found.kind, found.default, found.help, found.low, found.high, found.unit,
        found.choices,
    )  # fmt: skip
