"""Lines where polygons pass through each other, for styles whose own lines are of meshes."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.styling.protocol import Colour, Layer, Lines
from stylers.raskar import Raskar

_MANY = 20_000


def is_dense(layer: Layer) -> bool:
    """Whether a layer has so many polygons (20,000) that looking for crossings costs more than it
    shows, and that hidden lines make a thicket."""
    return sum(batch.polygon_count for batch, _ in layer.items) > _MANY


def looked_for(intersections: str, layer: Layer) -> bool:
    """Whether they are: ``on``, ``off``, or ``auto``: where a layer is not dense."""
    return intersections == "on" or (intersections == "auto" and not is_dense(layer))


def crossings(intersections: str, layer: Layer, width: float, ink: Colour) -> Iterable[Lines]:
    """Those of style raskar; intersections: ``auto``, ``on`` or ``off``; width in pixels."""
    if not looked_for(intersections, layer):
        return ()
    lines = Raskar(
        silhouettes=False, ridges=False, valleys=False, intersections=True,
        intersection_width=width, ink=ink,
    )  # fmt: skip
    return lines.draws(layer)
