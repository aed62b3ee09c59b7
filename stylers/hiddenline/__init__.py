"""Style ``hiddenline``: polygons in one colour, lines in another, and what is behind them hidden.

G. Humphreys et al., "Chromium: A Stream-Processing Framework for Interactive Rendering on
Clusters", SIGGRAPH 2002: a program that nobody changes, shown as a hidden-line drawing.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, cast

from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names

from ..shared import options
from ..shared.intersections import intersection_lines
from ..shared.kinds import USUAL, FeatureLines, former_names
from ..shared.strokes import inked
from ..shared.tones import tone_passes

_WHITE: Colour = (1.0, 1.0, 1.0)
_PALE = 0.35
"""Of its own colours what scenery without depth keeps, which has no lines to be known by, beside
surfaces in one colour."""


@takes_old_names
@dataclass(frozen=True)
class HiddenLine(FeatureLines):
    """A hidden-line drawing (Chromium's hiddenline unit)."""

    name: ClassVar[str] = "hiddenline"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        USUAL, line=Renamed(("ink",)), polygons=Renamed(("fill",))
    )

    fill: str | Colour = option(
        _WHITE, help="surfaces: in one colour, or as the program draws them (app)",
        choices=("app",), colour=True,
    )  # fmt: skip
    paper: str | Colour = options.paper(_WHITE)
    width: float = options.width(1.5)
    ink: Colour = options.ink("#000000")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    edges: str = option(
        "features", help="lines to draw: contours, creases and boundary edges (features), or the "
        "sides of all polygons", choices=("features", "all"),
    )  # fmt: skip
    crease_angle: float = options.crease_angle(40.0)
    hidden: str = options.hidden()
    intersections: str = options.intersections()
    tolerance: float = options.tolerance()
    own_ink: str = options.own_ink()

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Paper behind the polygons, and lines."""
        yield from tone_passes(
            "app", self.paper, self.ink, layer,
            scenery=1.0 if isinstance(self.fill, str) else _PALE,
        )  # fmt: skip
        # Every side folds by 0 degrees or more one way or the other.
        least = 0.0 if self.edges == "all" else self.crease_angle
        yield from inked(
            layer, self.features(least, tolerance=self.tolerance), self.looks(),
            texture_length=self.texture_length, hidden=cast(Any, self.hidden),
        )  # fmt: skip
        yield from intersection_lines(self, self.intersections, layer)
