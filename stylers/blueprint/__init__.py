"""Style ``blueprint``: white lines on blue, as NPRQuake's."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.media.hand import hand, outlines
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option

from ..shared import options
from ..shared.hand import ByHand, strokes
from ..shared.hand.paper import Paper, under
from .dimensions import dimensions


@dataclass(frozen=True)
class Blueprint(ByHand):
    """White lines on blue that overshoot their corners, with dimensions (NPRQuake)."""

    name: ClassVar[str] = "blueprint"

    width: float = option(1.6, help="width of outlines", low=0.5, high=32.0, unit="px")
    inner_width: float = option(1.0, help="width of other lines", low=0.5, high=32.0, unit="px")
    opacity: float = option(0.55, help="opacity of one stroke", low=0.02, high=1.0)
    strokes: int = option(2, help="how often each line is drawn", low=1, high=16)
    overshoot: float = option(
        0.2, help="how far lines go on beyond their corners, of their length", low=0.0, high=1.0
    )
    overshoot_most: float = option(
        20.0, help="how far they go on at most", low=0.0, high=256.0, unit="px"
    )
    jitter: float = option(0.0, help="how far lines stray", low=0.0, high=32.0, unit="px")
    dimensions: float = option(
        0.2, help="share of straight edges that have arrows and a length", low=0.0, high=1.0
    )
    grid: float = option(16.0, help="printed on the paper; 0: none", low=0.0, high=512.0, unit="px")
    shade: float = option(0.4, help="how much of the app's light", low=0.0, high=1.0)
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(45.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = option("#ffffff", help="colour of the lines")
    paper: Colour = option("#000080", help="colour of the paper")

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """The paper, every line, and dimensions over them."""
        faint = tuple(0.9 * p + 0.1 * i for p, i in zip(self.paper, self.ink, strict=True))
        red, green, blue = faint
        paper = Paper(
            self.paper, shade=self.shade, tooth=0.6, grid=self.grid, rule=(red, green, blue)
        )
        yield from under(paper, layer)
        medium = hand(
            self.inner_width, self.ink, widths=outlines(self.width), opacity=self.opacity,
            wobble=self.jitter, overshoot=self.overshoot_most, overshoot_share=self.overshoot,
            pressure=0.1, corner=30.0, scale=layer.scale,
        )  # fmt: skip
        own = self.hand(medium, self.strokes)
        yield from strokes(own, layer)
        if self.dimensions:
            yield from dimensions(
                own, layer, frequency=self.dimensions, ink=self.ink, coat=own.strokes
            )
