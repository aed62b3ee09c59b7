"""Style ``brush``: every line painted with a brush, as NPRQuake's.

A. Mohr, M. Gleicher, "Non-Invasive, Interactive, Stylized Rendering", I3D 2001; NPRQuake 2000: a
textured quad along each side of each polygon, of nine strokes, 4 pixels wide and .20 opaque (the
look `nprquake_brush` has these numbers). Here a stroke runs along a chain of edges from corner to
corner, wider and darker, since each is drawn once or twice and not once a polygon; and none is
missing, where NPRQuake leaves out the last line of each polygon of a model.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.lines import Medium
from glshim.styling.media.hand import brush
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names
from glshim.styling.textures import MADE
from glshim.styling.textures.brushes import BRUSHES

from ..shared import options
from ..shared.hand import ByHand, Strokes
from ..shared.kinds import USUAL, former_names
from .paint import Paint, painted


@takes_old_names
@dataclass(frozen=True)
class Brush(ByHand):
    """Brush strokes over surfaces painted in the program's colours (NPRQuake)."""

    name: ClassVar[str] = "brush"
    categories: ClassVar[tuple[str, ...]] = ("paint", "paper")
    former: ClassVar[Mapping[str, Renamed]] = former_names(
        USUAL, brush=Renamed(("texture",)), layers=Renamed(("strokes",))
    )

    texture: str = option(
        "pen2b",
        help="brush: charcoal, fibre pen (pen1), brush pen (pen2a: full, pen2b: dry), broad nib "
        "and marker (pen3), another texture, or a picture; in a grey picture dark is ink",
        choices=(*BRUSHES, *MADE),
        picture=True,
    )
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    width: float = options.width(7.0, "outlines")
    inner: float = options.inner(0.7)
    opacity: float = options.opacity(0.92)
    strokes: int = options.repeats(1, most=4)
    jitter: float = options.jitter(1.4)
    overshoot: float = options.overshoot(6.0)
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = options.ink("#1f1b24")
    paper: Colour = option("#f7f1e3", help="colour of the paper")
    tint: float = option(
        0.9, help="opacity of the paint, in the program's own colours", low=0.0, high=1.0
    )
    dab: float = option(
        13.0, help="length of the dabs of paint on surfaces", low=3.0, high=64.0, unit="px"
    )
    own_ink: str = options.own_ink()

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        paint = Paint(self.paper, self.tint, self.dab, self.boil, tolerance=self.tolerance)
        yield from painted(paint, layer)

        def medium(look: Strokes) -> Medium:
            return brush(
                look.texture, self.width, self.ink, inner=self.inner, widths=look.widths,
                colours=look.colours, opacity=self.opacity, wobble=self.jitter,
                overshoot=self.overshoot, texture_length=self.texture_length, dash=look.dash,
                scale=layer.scale,
            )  # fmt: skip

        yield from self.by_hand(medium, self.strokes, layer)

    def share(self, kind: str) -> float:
        return 1.0 if kind in ("contour", "boundary") else self.inner
