"""Colours as texts."""

from __future__ import annotations

import re

from glshim.errors import StyleError, nearest, shown
from glshim.notices import say_once
from glshim.styling.colournames import COLOUR_NAMES
from glshim.styling.values import Colour

HOW = "a colour name or #rrggbb"
"""How a colour is written, for messages and lists; names are those of CSS."""
_DIGITS = re.compile(r"#(?:[0-9a-fA-F]{3,4}|[0-9a-fA-F]{6}|[0-9a-fA-F]{8})\Z")


def is_colour(text: str) -> bool:
    """Whether `parse_colour` takes a text."""
    return text.lower() in COLOUR_NAMES or bool(_DIGITS.match(text))


def parse_colour(text: str) -> Colour:
    """A CSS name, ``#rgb`` or ``#rrggbb`` to floats in 0..1. Lines and paper are opaque: the alpha
    of ``#rgba`` and ``#rrggbbaa`` is not used, which is said once. Raises `StyleError`."""
    if not is_colour(text):
        near = nearest(text, COLOUR_NAMES)
        hint = f"did you mean {near[0]}?" if near else f"give {HOW}"
        raise StyleError(f"'{shown(text)}' is not a colour: {hint}")
    digits = COLOUR_NAMES.get(text.lower(), text[1:])
    if len(digits) < 6:
        digits = "".join(2 * digit for digit in digits)
    if len(digits) == 8 and digits[6:].lower() != "ff":
        say_once(f"colours of styles are opaque: the alpha of {text} is not used")
    red, green, blue = (int(digits[i : i + 2], 16) / 255.0 for i in (0, 2, 4))
    return red, green, blue


def format_colour(colour: Colour) -> str:
    """Floats in 0..1 to ``#rrggbb``."""
    return "#" + "".join(f"{round(channel * 255):02x}" for channel in colour)
