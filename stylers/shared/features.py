"""Outlines and creases in ink, as several styles over shaded surfaces have them."""

from __future__ import annotations

from collections.abc import Iterator
from math import radians

from glshim.styling.media.ink import Hidden, ink
from glshim.styling.protocol import Colour, Layer, Lines
from glshim.styling.wishes import Features

from .options import folds


def feature_lines(
    layer: Layer,
    colour: Colour,
    *,
    outlines: float | None,
    open_sides: float,
    creases: float | None = None,
    crease_angle: float = 180.0,
    ridge_colour: Colour | None = None,
    hidden: Hidden = "none",
    hidden_share: float = 1.0,
    tolerance: float = 0.0,
) -> Iterator[Lines]:
    """Lines of recovered meshes. outlines, open_sides, creases: widths in pixels of contours, of
    edges that have one polygon only, and of edges at which polygons turn by at least crease_angle,
    degrees; None: no such lines. tolerance: object units within which corners are one."""
    ridge, valley = map(radians, folds(crease_angle))
    wanted = Features(
        contours=outlines is not None,
        ridge_angle=None if creases is None else ridge,
        valley_angle=None if creases is None else valley,
        boundary=True,
        tolerance=tolerance,
    )
    given = {"contours": outlines, "boundary": open_sides, "ridges": creases, "valleys": creases}
    medium = ink(
        colour=colour,
        widths={kind: width for kind, width in given.items() if width is not None},
        colours={} if ridge_colour is None else {"ridges": ridge_colour},
        hidden=hidden,
        hidden_share=hidden_share,
    )
    yield Lines(layer.bodies, wanted, medium)
