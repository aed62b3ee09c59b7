"""Style ``hiddenline``: polygons in one colour, lines in another, and what is behind them hidden.

G. Humphreys et al., "Chromium: A Stream-Processing Framework for Interactive Rendering on
Clusters", SIGGRAPH 2002: a program that nobody changes, shown as a hidden-line drawing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, ClassVar, cast

from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option

from ..shared import options
from ..shared.features import feature_lines
from ..shared.intersections import intersection_lines
from ..shared.tones import tone_passes

_WHITE: Colour = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class HiddenLine(Styler):
    """A hidden-line drawing (Chromium's hiddenline unit)."""

    name: ClassVar[str] = "hiddenline"

    polygons: str | Colour = option(
        _WHITE, help="colour of the polygons; app: as the app drew them",
        choices=("app",), colour=True,
    )  # fmt: skip
    line: Colour = option("#000000", help="colour of the lines")
    width: float = option(1.5, help="width of the lines", low=0.5, high=64.0, unit="px")
    paper: str | Colour = options.paper(_WHITE)
    edges: str = option(
        "features", help="outlines, creases and open edges, or the sides of all polygons",
        choices=("features", "all"),
    )  # fmt: skip
    crease_angle: float = options.crease_angle(40.0)
    hidden: str = option(
        "none", help="lines behind polygons", choices=("none", "dashed", "dimmed")
    )
    intersections: str = options.intersections()
    tolerance: float = options.tolerance()

    @property
    def surface(self) -> str | Colour:
        """The option `polygons`."""
        return self.polygons

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Paper behind the polygons, and lines."""
        yield from tone_passes("app", self.paper, self.line, layer)
        # Every side folds by 0 degrees or more one way or the other.
        least = 0.0 if self.edges == "all" else self.crease_angle
        yield from feature_lines(
            layer, self.line, outlines=self.width, open_sides=self.width, creases=self.width,
            crease_angle=least, hidden=cast(Any, self.hidden), tolerance=self.tolerance,
        )  # fmt: skip
        yield from intersection_lines(self.intersections, layer, self.width, self.line)
