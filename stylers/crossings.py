"""Lines where polygons pass through each other, for styles whose own lines are of meshes."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.styling.protocol import Colour, Draw, Layer
from stylers.raskar import Raskar


def crossings(layer: Layer, width: float, ink: Colour) -> Iterable[Draw]:
    """Those of style raskar; width in pixels."""
    lines = Raskar(
        silhouettes=False, ridges=False, valleys=False, intersections=True,
        intersection_width=width, ink=ink,
    )  # fmt: skip
    return lines.draws(layer)
