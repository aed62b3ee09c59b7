"""Lines where polygons pass through each other, for styles whose own lines are of meshes."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.styling.media.ink import ink
from glshim.styling.protocol import Colour, Layer, Lines
from glshim.styling.wishes import Choice

_MANY = 20_000


def is_dense(layer: Layer) -> bool:
    """Whether a layer has so many polygons (20,000) that looking for intersections costs more than
    it shows, and that hidden lines make a thicket."""
    return sum(batch.polygon_count for batch, _ in layer.items) > _MANY


def looked_for(intersections: str, layer: Layer) -> bool:
    """Whether they are: ``on``, ``off``, or ``auto``: where a layer is not dense."""
    return intersections == "on" or (intersections == "auto" and not is_dense(layer))


def intersection_lines(
    intersections: str, layer: Layer, width: float, colour: Colour
) -> Iterable[Lines]:
    """Those of a layer; intersections: ``auto``, ``on`` or ``off``; width in pixels."""
    if looked_for(intersections, layer):
        yield Lines(layer.bodies, Choice(intersections=True), ink(width, colour))
