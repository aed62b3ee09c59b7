"""Style ``pencil``: soft graphite, or coloured pencils, on grained paper.

Lines are drawn twice, lightly, by a pencil that presses and lifts; tones are hatched and rubbed:
E. Praun et al., "Real-Time Hatching", SIGGRAPH 2001; M. C. Sousa, J. W. Buchanan, "Observational
Models of Graphite Pencil Materials", Computer Graphics Forum 2000 (graphite is held by the tooth
of the paper, the more the harder one presses, and blenders rub it in).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.lines import Medium
from glshim.styling.media.hand import pencil
from glshim.styling.passes import Pass, Weld
from glshim.styling.protocol import Colour, Layer, Lines, option
from glshim.styling.renamed import Renamed, takes_old_names

from ..shared import options
from ..shared.hand import ByHand, Strokes
from ..shared.hand.hatching import CREASES, Hatching, hatched
from ..shared.kinds import USUAL, former_names
from .rubbing import Rubbing, rubbed


@takes_old_names
@dataclass(frozen=True)
class Pencil(ByHand):
    """Soft pencil lines and tones on grained paper."""

    name: ClassVar[str] = "pencil"
    former: ClassVar[Mapping[str, Renamed]] = former_names(USUAL)

    width: float = options.width(2.6, "outlines", high=32.0)
    inner: float = options.inner(0.7)
    opacity: float = options.opacity(0.75)
    strokes: int = options.repeats(2, most=8)
    jitter: float = options.jitter(1.1)
    overshoot: float = options.overshoot(5.0)
    texture: str = options.texture("pencil")
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    hatching: float = option(0.85, help="strength of hatching in dark areas", low=0.0, high=1.0)
    rubbing: float = option(0.7, help="strength of smudged tone", low=0.0, high=1.0)
    coloured: float = option(
        0.0, help="strength of the program's own colours; 0: graphite, 1: coloured pencils",
        low=0.0, high=1.0,
    )  # fmt: skip
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = options.ink("#2b2a2d", "lines and tones")
    paper: Colour = option("#f8f6f0", help="colour of the paper")
    own_ink: str = options.own_ink()

    @property
    def wants_normals(self) -> bool:
        """Light breaks where they do."""
        return self.hatching > 0.0

    @property
    def wants_lights(self) -> bool:
        """Hatching goes by them."""
        return self.hatching > 0.0

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        weld = Weld(self.tolerance, CREASES) if self.hatching > 0.0 else Weld(self.tolerance)
        yield from rubbed(Rubbing(self.paper, self.ink, self.rubbing, self.coloured, weld), layer)
        yield from hatched(
            Hatching(
                self.ink, self.hatching, apart=4.0 * layer.scale, jitter=2.2 * layer.scale,
                by_picture=0.65, boil=self.boil,
                coloured=self.coloured, soft=1.0, tolerance=self.tolerance,
            ),
            layer,
        )  # fmt: skip

        def medium(look: Strokes) -> Medium:
            return pencil(
                self.width, self.ink, inner=self.inner, widths=look.widths, colours=look.colours,
                opacity=self.opacity, wobble=self.jitter, overshoot=self.overshoot,
                texture=look.texture, texture_length=self.texture_length, dash=look.dash,
                scale=layer.scale,
            )  # fmt: skip

        yield from self.by_hand(medium, self.strokes, layer)

    def share(self, kind: str) -> float:
        return 1.0 if kind in ("contour", "boundary") else self.inner
