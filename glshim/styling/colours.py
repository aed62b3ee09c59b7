"""Colours as texts."""

from __future__ import annotations

import re

from glshim.errors import StyleError
from glshim.styling.values import Colour

_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")


def is_colour(text: str) -> bool:
    """Whether a text is ``#rrggbb``."""
    return bool(_COLOUR.match(text))


def parse_colour(text: str) -> Colour:
    """``#rrggbb`` to floats in 0..1. Raises `StyleError` for any other text."""
    if not is_colour(text):
        raise StyleError(f"{text!r} is not a colour: write #rrggbb, e.g. #1a2b3c")
    red, green, blue = (int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue


def format_colour(colour: Colour) -> str:
    """Floats in 0..1 to ``#rrggbb``."""
    return "#" + "".join(f"{round(channel * 255):02x}" for channel in colour)
