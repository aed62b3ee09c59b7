"""Style ``pencil``: soft graphite, or coloured pencils, on grained paper.

Lines are drawn twice, lightly, by a pencil that presses and lifts; tones are hatched and rubbed:
E. Praun et al., "Real-Time Hatching", SIGGRAPH 2001; M. C. Sousa, J. W. Buchanan, "Observational
Models of Graphite Pencil Materials", Computer Graphics Forum 2000 (graphite is held by the tooth
of the paper, the more the harder one presses, and blenders rub it in).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.media.hand import pencil
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option

from ..shared import options
from ..shared.hand import ByHand, strokes
from ..shared.hand.hatching import Hatching, hatched
from .rubbing import Rubbing, rubbed


@dataclass(frozen=True)
class Pencil(ByHand):
    """Soft pencil lines and tones on grained paper."""

    name: ClassVar[str] = "pencil"

    width: float = option(2.6, help="width of an outline's stroke", low=0.5, high=32.0, unit="px")
    inner: float = option(0.7, help="width of strokes within, of outlines'", low=0.05, high=1.0)
    opacity: float = option(0.75, help="opacity of one stroke", low=0.02, high=1.0)
    strokes: int = option(2, help="how often each line is drawn", low=1, high=8)
    jitter: float = option(1.1, help="how far a stroke strays", low=0.0, high=32.0, unit="px")
    overshoot: float = option(5.0, help="how far strokes go on", low=0.0, high=64.0, unit="px")
    hatching: float = option(0.85, help="strokes in dark places", low=0.0, high=1.0)
    rubbing: float = option(0.7, help="soft tone, rubbed into the paper", low=0.0, high=1.0)
    coloured: float = option(
        0.0, help="the app's own colours: 0 graphite, 1 coloured pencils", low=0.0, high=1.0
    )
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = option("#2b2a2d", help="colour of the graphite")
    paper: Colour = option("#f8f6f0", help="colour of the paper")

    @property
    def wants_normals(self) -> bool:
        """Light breaks where they do."""
        return self.hatching > 0.0

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        yield from rubbed(Rubbing(self.paper, self.ink, self.rubbing, self.coloured), layer)
        yield from hatched(
            Hatching(
                self.ink, self.hatching, apart=4.0 * layer.scale, jitter=2.2 * layer.scale,
                by_picture=0.65, boil=self.boil,
                coloured=self.coloured, soft=1.0, tolerance=self.tolerance,
            ),
            layer,
        )  # fmt: skip
        medium = pencil(
            self.width, self.ink, inner=self.inner, opacity=self.opacity, wobble=self.jitter,
            overshoot=self.overshoot, scale=layer.scale,
        )  # fmt: skip
        yield from strokes(self.hand(medium, self.strokes), layer)
