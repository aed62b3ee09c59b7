"""Style ``brush``: every line painted with a brush, as NPRQuake's.

A. Mohr, M. Gleicher, "Non-Invasive, Interactive, Stylized Rendering", I3D 2001; NPRQuake 2000: a
textured quad along each side of each polygon, of nine strokes, 4 pixels wide and .20 opaque (the
look `nprquake_brush` has these numbers). Here a stroke runs along a chain of edges from corner to
corner, wider and darker, since each is drawn once or twice and not once a polygon; and none is
missing, where NPRQuake leaves out the last line of each polygon of a model.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.media.hand import brush
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.textures.brushes import BRUSHES

from ..shared import options
from ..shared.hand import ByHand, strokes
from .paint import Paint, painted


@dataclass(frozen=True)
class Brush(ByHand):
    """Lines painted with a brush over surfaces painted in the app's colours (NPRQuake)."""

    name: ClassVar[str] = "brush"
    categories: ClassVar[tuple[str, ...]] = ("paint", "paper")

    brush: str = option(
        "pen2b",
        help="the brush: charcoal, a fibre pen (pen1), a brush pen (pen2: full, dry), a broad nib "
        "and a marker (pen3), or a picture; dark is ink in a grey one, others keep colours",
        choices=BRUSHES,
        picture=True,
    )
    width: float = option(7.0, help="width of an outline's stroke", low=0.5, high=64.0, unit="px")
    inner: float = option(0.7, help="width of strokes within, of outlines'", low=0.05, high=1.0)
    opacity: float = option(0.92, help="opacity of one stroke", low=0.02, high=1.0)
    layers: int = option(1, help="how often each line is painted", low=1, high=4)
    jitter: float = option(1.4, help="how far a stroke strays", low=0.0, high=32.0, unit="px")
    overshoot: float = option(6.0, help="how far strokes go on", low=0.0, high=64.0, unit="px")
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = option("#1f1b24", help="colour of the strokes")
    paper: Colour = option("#f7f1e3", help="colour of the paper")
    tint: float = option(
        0.9, help="how much of the paper the app's own colours cover", low=0.0, high=1.0
    )
    dab: float = option(13.0, help="length of a dab of paint", low=3.0, high=64.0, unit="px")

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        yield from painted(Paint(self.paper, self.tint, self.dab, self.boil), layer)
        medium = brush(
            self.brush, self.width, self.ink, inner=self.inner, opacity=self.opacity,
            wobble=self.jitter, overshoot=self.overshoot, scale=layer.scale,
        )  # fmt: skip
        yield from strokes(self.hand(medium, self.layers), layer)
