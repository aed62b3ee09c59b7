"""Style ``none``: the app as it is. Capture runs, nothing is added."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.protocol import Layer, Lines, Styler


@dataclass(frozen=True)
class NoStyle(Styler):
    """The program's own picture, unchanged."""

    name: ClassVar[str] = "none"
    wants_polygons: ClassVar[bool] = False

    def draws(self, layer: Layer) -> Iterable[Lines]:
        """Nothing."""
        return ()
