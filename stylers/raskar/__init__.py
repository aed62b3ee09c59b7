"""Style ``raskar``: silhouettes, ridges, valleys and intersections.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001,
sections 2.1 to 2.4. The formulas stand in `glshim.geometry.raskar`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import radians
from typing import ClassVar

from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.wishes import Choice

from ..shared import options
from ..shared.intersections import looked_for
from ..shared.kinds import Contours, Intersections, Look, Ridges, Valleys, former_names
from ..shared.strokes import inked


@takes_old_names
@dataclass(frozen=True)
class Raskar(Intersections, Valleys, Ridges, Contours):
    """Ink on silhouettes, ridges, valleys and intersections (Raskar 2001)."""

    name: ClassVar[str] = "raskar"
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        ("contour", "ridge", "valley", "intersection")
    )

    contours: bool = option(
        True, help="draw contours: where front-facing polygons meet back-facing ones"
    )
    intersections: str = options.intersections("off")
    width: float = options.width(2.5)
    ink: Colour = options.ink("#000000")
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    texture_on: str = option(
        "silhouettes", help="lines that texture applies to", choices=("silhouettes", "all")
    )
    dash: float = options.dash()
    crease_angle: float = options.crease_angle(60.0)
    ridge_angle: float | None = options.ridge_angle()
    valley_angle: float | None = options.valley_angle()
    connectivity: bool = option(
        True, help="find neighbouring polygons; off: depth alone decides, as in the paper"
    )
    fill: str | Colour = options.fill()
    own_ink: str = options.own_ink()

    def usual(self, kind: str) -> Look:
        """Of the lines that `texture_on` leaves out without a texture."""
        found = super().usual(kind)
        textured = kind == "contour" or self.texture_on == "all"
        return found if textured else replace(found, texture="none")

    def draws(self, layer: Layer) -> Iterable[Lines]:
        """Rings around back-facing polygons, strokes on front-facing ones."""
        looks = self.looks()
        if not looks:
            return
        turn = self.crease_angle
        ridge = 180.0 - turn if self.ridge_angle is None else self.ridge_angle
        valley = 180.0 + turn if self.valley_angle is None else self.valley_angle
        wanted = Choice(
            silhouettes=self.contours,
            ridge_angle=radians(ridge) if self.ridges else None,
            valley_angle=radians(valley) if self.valleys else None,
            intersections=looked_for(self.intersections, layer),
            connectivity=self.connectivity,
        )
        yield from inked(layer, wanted, looks, texture_length=self.texture_length)
