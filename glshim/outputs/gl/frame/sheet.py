"""The sheet that a framebuffer is a part of: the window's own, unless a shot is larger than it."""

from __future__ import annotations

from dataclasses import dataclass

_LARGEST = 8192


@dataclass(slots=True)
class Sheet:
    """What patterns that lie on the screen hold on to, and how far drawing goes."""

    origin: tuple[float, float] = (0.0, 0.0)
    """Pixels from the sheet's lower left corner to the framebuffer's."""
    scale: float = 1.0
    """Pixels for one of the window."""
    bounds: tuple[int, int] = (_LARGEST, _LARGEST)
    """Pixels of the framebuffer, at most."""


SHEET = Sheet()
