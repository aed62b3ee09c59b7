"""Text in lines of a width."""

from __future__ import annotations

from collections.abc import Callable


def wrapped(text: str, width_of: Callable[[str], float], room: float) -> list[str]:
    """A text as lines, parted at spaces, that are no wider than there is room; a word that is
    wider stands alone. width_of: the width of a text, in units of the room."""
    lines: list[str] = []
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and width_of(longer) <= room:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
