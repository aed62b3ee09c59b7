"""Plain values that stylers get and give."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.model.lights import Lighting

Colour = tuple[float, float, float]
"""Red, green, blue in 0..1."""
Uniform = float | int | tuple[float, ...] | tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True)
class Layer:
    """Everything drawn until the depth buffer or the camera stops meaning the same thing."""

    items: tuple[tuple[PolygonBatch, Camera], ...]
    """The batches in the order of drawing, each with the camera that it was drawn with."""
    light: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 0.0)
    """Where GL_LIGHT0 is in eye space, homogeneous: a direction towards it where w = 0."""
    over: bool = False
    """An earlier layer of the frame lies below."""
    fresh: bool = True
    """The depth buffer holds this layer's polygons alone."""
    time: float = 0.0
    """Seconds, from any beginning: what a style that moves by itself goes by."""
    lighting: Lighting | None = None
    """The lights that were on, with GL_LIGHTING, when the first lit polygons of the layer were
    drawn: an app that moves them after that is seen in the light that it began with. None: nothing
    was lit, or not asked for (`glshim.styling.protocol.Styler.wants_lights`)."""
    scale: float = 1.0
    """Pixels for one of the window: more than 1 in a large shot, for lengths that a style has of
    its own. Its options in pixels are scaled already."""
