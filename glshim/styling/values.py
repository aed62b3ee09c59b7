"""Plain values that stylers get and give."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

from glshim.model.batch import Item, PolygonBatch
from glshim.model.boxes import Box
from glshim.model.camera import Camera
from glshim.model.lights import Lighting

Colour = tuple[float, float, float]
"""Red, green, blue in 0..1."""
Uniform = float | int | tuple[float, ...] | tuple[tuple[float, ...], ...]
"""A number, a vector, or an array of either: the value of a uniform."""
Place = tuple[float, float, float, float]
"""Homogeneous: a point where w = 1, the direction towards one at infinity where w = 0."""


@dataclass(frozen=True, slots=True)
class Body:
    """Batches that share a camera, and so an object space: one mesh is recovered from them."""

    batches: tuple[PolygonBatch, ...]
    camera: Camera
    order: tuple[int, ...] = ()
    """The position of each batch in the layer's order of drawing; empty: body by body."""


def in_order(bodies: Iterable[Body]) -> list[Item]:
    """The batches of bodies, each with its camera, in the order in which the app drew them."""
    items = [(batch, body.camera) for body in bodies for batch in body.batches]
    order = [place for body in bodies for place in body.order]
    if len(order) != len(items):
        return items
    return [items[k] for k in sorted(range(len(items)), key=order.__getitem__)]


@dataclass(frozen=True)
class Layer:
    """Everything drawn until the depth buffer or the camera stops meaning the same thing."""

    items: tuple[Item, ...]
    """The batches in the order of drawing, each with the camera that it was drawn with."""
    light: Place = (0.0, 0.0, 1.0, 0.0)
    """Where GL_LIGHT0 is in eye space."""
    over: bool = False
    """An earlier layer of the frame lies below, in some of its views."""
    fresh: bool = True
    """The depth buffer holds this layer's polygons alone, in its views."""
    time: float = 0.0
    """Seconds since an arbitrary moment, for styles that move by themselves."""
    lighting: Lighting | None = None
    """The lights that were on, with GL_LIGHTING, when the first lit polygons of the layer were
    drawn; `Camera.lighting` has those of each batch. None: nothing was lit, or the style did not
    ask (`glshim.styling.protocol.Styler.wants_lights`)."""
    scale: float = 1.0
    """Pixels of the picture for each pixel of the window: more than 1 in a large shot. For constant
    lengths of a style; its options in pixels are already scaled."""
    bare: tuple[Box, ...] = ()
    """If the layer lies over others: the parts of its views in which there is nothing below,
    because the program has cleared them or drawn nothing there. Pixels of the framebuffer."""

    glass: tuple[Item, ...] = ()
    """Solids that the program blended over the layer without writing depth, as batches and cameras:
    they may have outlines, and hide nothing."""
    backed: bool = False
    """The background of its views (of a layer over others: of `bare`) was laid in the style's own
    colour before the program drew on it (`glshim.styling.protocol.Styler.background`): what differs
    from that is drawn, with depth or without."""
    own_background: Colour = (0.0, 0.0, 0.0)
    """The program's own, where it is `backed`: the colour that it clears to."""

    @cached_property
    def glass_bodies(self) -> tuple[Body, ...]:
        """The batches of glass by camera."""
        return replace(self, items=self.glass).bodies

    @cached_property
    def bodies(self) -> tuple[Body, ...]:
        """The batches by camera, in the order of their first batches."""
        found: dict[object, tuple[list[PolygonBatch], Camera, list[int]]] = {}
        known: dict[int, tuple[list[PolygonBatch], Camera, list[int]]] = {}
        for place, (batch, camera) in enumerate(self.items):
            own = known.get(id(camera))
            if own is None:
                own = known[id(camera)] = found.setdefault(camera.key, ([], camera, []))
            own[0].append(batch)
            own[2].append(place)
        return tuple(
            Body(tuple(batches), camera, tuple(order)) for batches, camera, order in found.values()
        )
