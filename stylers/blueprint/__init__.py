"""Style ``blueprint``: white lines on blue, as NPRQuake's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.lines import Medium
from glshim.styling.media.hand import hand, pictured
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names

from ..shared import options
from ..shared.hand import ByHand, Strokes
from ..shared.hand.paper import Paper, under
from ..shared.kinds import USUAL, former_names
from .dimensions import dimensions

_USUAL = 480.0
"""Pixels of a window's shorter side."""
_INNER = ("ridge_width", "valley_width", "intersection_width")


@takes_old_names
@dataclass(frozen=True)
class Blueprint(ByHand):
    """White lines on blue that overshoot their corners, with dimensions (NPRQuake)."""

    name: ClassVar[str] = "blueprint"
    former: ClassVar[Mapping[str, Renamed]] = former_names(USUAL, inner_width=Renamed(_INNER))

    width: float = options.width(1.6, "outlines", high=32.0)
    inner: float = options.inner(0.625)
    opacity: float = options.opacity(0.55)
    strokes: int = options.repeats(2, most=16)
    overshoot: float = option(
        0.2, help="distance by which lines run past corners, as a share of their length",
        low=0.0, high=1.0,
    )  # fmt: skip
    overshoot_most: float = option(
        20.0, help="upper limit of overshoot, less in windows under 480 pixels",
        low=0.0, high=256.0, unit="px",
    )
    jitter: float = options.jitter(0.0)
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    dimensions: float = option(
        0.2, help="share of straight edges with dimension arrows", low=0.0, high=1.0
    )
    grid: float = option(
        16.0, help="spacing of the printed grid; 0: no grid", low=0.0, high=512.0, unit="px"
    )
    shade: float = option(0.4, help="strength of the program's shading", low=0.0, high=1.0)
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(45.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = options.ink("#ffffff", "all lines and dimensions")
    paper: Colour = option("#000080", help="colour of the paper")
    own_ink: str = options.own_ink()

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """The paper, every line, and dimensions over them."""
        faint = tuple(0.9 * p + 0.1 * i for p, i in zip(self.paper, self.ink, strict=True))
        red, green, blue = faint
        paper = Paper(
            self.paper, shade=self.shade, tooth=0.6, grid=self.grid, rule=(red, green, blue)
        )
        yield from under(paper, layer)

        most = self.overshoot_most * _share_of_window(layer)

        def medium(look: Strokes) -> Medium:
            return hand(
                self.width * self.inner, self.ink, widths=look.widths, colours=look.colours,
                opacity=self.opacity, wobble=self.jitter, overshoot=most,
                overshoot_share=self.overshoot, pressure=0.1, corner=30.0, straight=True,
                scale=layer.scale,
                **pictured(look.texture, self.width, self.texture_length, look.dash),
            )  # fmt: skip

        yield from self.by_hand(medium, self.strokes, layer)
        if self.dimensions:
            widths = {"contours": self.width, "boundary": self.width}
            plain = medium(Strokes("none", 0.0, widths, {}))
            yield from dimensions(
                self.hand(plain, self.strokes, USUAL), layer, frequency=self.dimensions,
                ink=self.ink, coat=self.strokes,
            )  # fmt: skip

    def share(self, kind: str) -> float:
        return 1.0 if kind in ("contour", "boundary") else self.inner


def _share_of_window(layer: Layer) -> float:
    """How long things may be that suit a window of `_USUAL` pixels, in the layer's largest view."""
    sides = [min(body.camera.viewport[2:]) for body in layer.bodies]
    return min(max(sides, default=0) / (_USUAL * layer.scale), 1.0)
