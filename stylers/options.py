"""Options that several styles have: what surfaces look like, and what lines are drawn with."""

from __future__ import annotations

from typing import Any

from glshim.styling.protocol import option
from stylers.strokes import MADE


def fill(what: str = "the surfaces") -> Any:
    """``fill``: `Styler.surface`."""
    return option(
        "app",
        help=f"{what}: as the app drew them, none, or flat in a colour",
        choices=("app", "none"),
        colour=True,
    )


def texture(lines: str) -> Any:
    """``texture``: of lines, a word for those that have it; see `stylers.strokes.made`."""
    return option(
        "none",
        help=f"what {lines} are drawn with; dark is ink in a grey picture, others keep colours",
        choices=("none", *MADE),
        picture=True,
    )


def texture_length(line: str) -> Any:
    """``texture_length``, of a line."""
    return option(
        0.0,
        help=f"length of {line} after which the texture repeats; 0: what suits it",
        low=0.0,
        high=4096.0,
        unit="px",
    )
