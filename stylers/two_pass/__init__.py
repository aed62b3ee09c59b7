"""Style ``two_pass``: silhouettes as they were drawn before there were shaders.

P. Rideout, "Silhouette Extraction", The Little Grasshopper, 2010, "Old School Silhouettes", after
J. Lander, "Under the Shade of the Rendering Tree", Game Developer, 2000: front faces are filled
(depth less), then back faces are drawn as lines (depth less-or-equal). What the front faces do not
hide of those lines is the outer half along silhouettes. No creases; the inside of an open surface
shows the sides of all its polygons.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import ClassVar

from glshim.styling.protocol import BackFaces, Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.wishes import Features

from ..shared import options
from ..shared.intersections import intersection_lines
from ..shared.kinds import (
    Intersections,
    Ridges,
    Valleys,
    dash_of,
    former_names,
    ink_of,
    width_of,
)
from ..shared.strokes import inked


@takes_old_names
@dataclass(frozen=True)
class TwoPass(Intersections, Valleys, Ridges):
    """Silhouettes by fixed-function GL alone: back faces as lines (Lander 2000, Rideout 2010)."""

    name: ClassVar[str] = "two_pass"
    alone: ClassVar[str] = "its lines lie below all that others draw; take crease or raskar"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        ("contour", "ridge", "valley", "intersection")
    )

    contours: bool = option(True, help="draw contours: back faces as lines")
    contour_width: float | None = width_of("contours")
    contour_ink: Colour | None = ink_of("contours")
    contour_dash: float | None = dash_of("contours")
    ridges: bool = option(False, help="draw ridges, by shaders: creases that stand out")
    valleys: bool = option(False, help="draw valleys, by shaders: creases that lie in")
    width: float = option(
        5.0, help="width of contours, half of it outside the object; limited by the driver",
        low=1.0, high=64.0, unit="px",
    )  # fmt: skip
    ink: Colour = options.ink("#000000")
    texture: str = options.texture("none", "ridges, valleys and intersections")
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    crease_angle: float = options.crease_angle(60.0)
    intersections: str = options.intersections("off")
    tolerance: float = options.tolerance()
    smooth: bool = option(True, help="antialias contours (GL_LINE_SMOOTH)")
    fill: str | Colour = options.fill("front faces")
    own_ink: str = options.own_ink()

    @property
    def surface(self) -> str | Colour:
        """Depth alone under flat front faces: those need no shader, as a colour here would."""
        contour = self.looks().get("contour")
        filled = self.fill == "app" or contour is None or contour.dash > 0.0
        return self.fill if filled else "none"

    def share(self, kind: str) -> float:
        return 1.0 if kind == "contour" else 0.5

    def draws(self, layer: Layer) -> Iterable[BackFaces | Lines]:
        """All contours at once, and creases, if they are asked for. Dashes go on from edge to edge
        and stay where they were, which those of glLineStipple do not."""
        fill = None if isinstance(self.fill, str) else self.fill
        looks = self.looks()
        contour = looks.pop("contour", None)
        if contour is not None and contour.dash > 0.0:
            outer = replace(contour, width=0.5 * contour.width, texture="none")
            yield from inked(layer, Features(contours=True, tolerance=self.tolerance),
                             {"contour": outer})  # fmt: skip
        elif contour is not None:
            yield BackFaces(layer.bodies, contour.width, contour.ink, fill, self.smooth)
        looks.pop("intersection", None)
        if looks:
            wanted = self.features(self.crease_angle, tolerance=self.tolerance)
            yield from inked(layer, wanted, looks, texture_length=self.texture_length)
        yield from intersection_lines(self, self.intersections, layer)
