"""Style ``hiddenline``: polygons in one colour, lines in another, and what is behind them hidden.

G. Humphreys et al., "Chromium: A Stream-Processing Framework for Interactive Rendering on
Clusters", SIGGRAPH 2002: a program that nobody changes, shown as a hidden-line drawing.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from stylers import options
from stylers.crossings import crossings
from stylers.edge_mesh import EdgeMesh
from stylers.edge_mesh.tones import tone_passes

_WHITE: Colour = (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class HiddenLine(Styler):
    """A hidden-line drawing (Chromium's hiddenline unit)."""

    name: ClassVar[str] = "hiddenline"

    polygons: str | Colour = option(  # noqa: RUF009
        _WHITE, help="colour of the polygons; app: as the app drew them",
        choices=("app",), colour=True,
    )  # fmt: skip
    line: Colour = option("#000000", help="colour of the lines")  # noqa: RUF009
    width: float = option(1.5, help="width of the lines", low=0.5, high=64.0, unit="px")
    paper: str | Colour = options.paper(_WHITE)  # noqa: RUF009
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
        yield from self._lines.draws(layer)
        yield from crossings(self.intersections, layer, self.width, self.line)

    @property
    def _lines(self) -> EdgeMesh:
        """Every side folds by 0 degrees or more one way or the other."""
        ridge, valley = options.folds(0.0 if self.edges == "all" else self.crease_angle)
        return EdgeMesh(
            ridge_angle=ridge, valley_angle=valley, contour_width=self.width,
            boundary_width=self.width, ridge_width=self.width, valley_width=self.width,
            contour_ink=self.line, boundary_ink=self.line, ridge_ink=self.line,
            valley_ink=self.line, hidden=self.hidden, tolerance=self.tolerance,
        )  # fmt: skip
