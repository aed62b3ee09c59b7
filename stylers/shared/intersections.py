"""Lines where polygons pass through each other, for styles whose own lines are of meshes."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.styling.protocol import Layer, Lines
from glshim.styling.wishes import Choice

from .kinds import LineStyle
from .strokes import inked

_MANY = 20_000


def is_dense(layer: Layer) -> bool:
    """Whether a layer has so many polygons (20,000) that looking for intersections costs more than
    it shows, and that hidden lines make a thicket."""
    return sum(batch.polygon_count for batch, _ in layer.items) > _MANY


def looked_for(intersections: str, layer: Layer) -> bool:
    """Whether they are: ``on``, ``off``, or ``auto``: where a layer is not dense."""
    return intersections == "on" or (intersections == "auto" and not is_dense(layer))


def intersection_lines(style: LineStyle, intersections: str, layer: Layer) -> Iterable[Lines]:
    """Those of a layer, as a style has them; intersections: ``auto``, ``on`` or ``off``."""
    if looked_for(intersections, layer):
        looks = {"intersection": style.look("intersection")}
        yield from inked(
            layer, Choice(intersections=True), looks, texture_length=style.texture_length
        )
