"""Style ``raskar``: silhouettes, ridges, valleys and intersections.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001,
sections 2.1 to 2.4. The formulas stand in `glshim.geometry.raskar`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import radians
from typing import ClassVar

from glshim.styling.media.ink import ink
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from glshim.styling.wishes import Choice

from ..shared import options


@dataclass(frozen=True)
class Raskar(Styler):
    """Ink on silhouettes, ridges, valleys and intersections (Raskar 2001)."""

    name: ClassVar[str] = "raskar"

    silhouettes: bool = option(True, help="ink where front-facing polygons meet back-facing ones")
    ridges: bool = option(True, help="ink where the dihedral angle is at most ridge_angle")
    valleys: bool = option(True, help="ink where the dihedral angle is more than valley_angle")
    intersections: bool = option(
        False, help="ink where polygons pass through each other (draws them twice more)"
    )
    silhouette_width: float = option(
        2.5, help="width of a silhouette, outside the object", low=0.5, high=64.0, unit="px"
    )
    ridge_width: float = option(
        2.5, help="width of a ridge, half on either side of the edge", low=0.5, high=64.0, unit="px"
    )
    valley_width: float = option(
        2.5,
        help="width of a valley, half on either side of the edge",
        low=0.5,
        high=64.0,
        unit="px",
    )
    intersection_width: float = option(
        2.5, help="width of an intersection, half on either side", low=0.5, high=64.0, unit="px"
    )
    ridge_angle: float = option(
        120.0, help="greatest dihedral angle of a ridge", low=0.0, high=360.0, unit="degrees"
    )
    valley_angle: float = option(
        240.0, help="a valley has a greater dihedral angle", low=0.0, high=360.0, unit="degrees"
    )
    connectivity: bool = option(
        True, help="off: no polygon knows its neighbours, depth alone decides, as in the paper"
    )
    texture: str = options.texture("silhouettes")
    texture_length: float = options.texture_length("a silhouette")
    texture_on: str = option(
        "silhouettes", help="the lines that have the texture", choices=("silhouettes", "all")
    )
    ink: Colour = option("#000000", help="colour of the lines")
    fill: str | Colour = options.fill()

    def draws(self, layer: Layer) -> Iterable[Lines]:
        """Rings around back-facing polygons, strokes on front-facing ones."""
        if not (self.silhouettes or self.ridges or self.valleys or self.intersections):
            return
        wanted = Choice(
            silhouettes=self.silhouettes,
            ridge_angle=radians(self.ridge_angle) if self.ridges else None,
            valley_angle=radians(self.valley_angle) if self.valleys else None,
            intersections=self.intersections,
            connectivity=self.connectivity,
        )
        medium = ink(
            colour=self.ink,
            widths={
                "silhouettes": self.silhouette_width, "ridges": self.ridge_width,
                "valleys": self.valley_width, "intersections": self.intersection_width,
            },
            texture=self.texture,
            texture_length=self.texture_length,
            textured=("silhouettes",) if self.texture_on == "silhouettes" else None,
        )  # fmt: skip
        yield Lines(layer.bodies, wanted, medium)
