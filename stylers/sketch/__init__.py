"""Style ``sketch``: pencil on paper, as NPRQuake's."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.media.hand import hand
from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, option

from ..shared import options
from ..shared.hand import ByHand, strokes
from ..shared.hand.hatching import Hatching, hatched
from ..shared.hand.paper import Paper, under


@dataclass(frozen=True)
class Sketch(ByHand):
    """Jittered pencil strokes, hatched by the light, on paper (NPRQuake)."""

    name: ClassVar[str] = "sketch"

    width: float = option(2.0, help="width of a stroke", low=0.5, high=32.0, unit="px")
    opacity: float = option(0.25, help="opacity of one stroke", low=0.02, high=1.0)
    strokes: int = option(6, help="how often each line is drawn", low=1, high=16)
    jitter: float = option(1.6, help="how far a stroke strays", low=0.0, high=32.0, unit="px")
    overshoot: float = option(5.0, help="how far strokes go on", low=0.0, high=64.0, unit="px")
    hatching: float = option(0.8, help="how darkly dark places are hatched", low=0.0, high=1.0)
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = option("#1b1b1e", help="colour of the strokes")
    paper: Colour = option("#faf8f2", help="colour of the paper")
    tint: float = option(0.3, help="how much of the app's own colours", low=0.0, high=1.0)

    @property
    def wants_normals(self) -> bool:
        """Light breaks where they do."""
        return self.hatching > 0.0

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        """Paper, hatching, and every line so often as it is drawn."""
        yield from under(Paper(self.paper, tint=self.tint), layer)
        yield from hatched(
            Hatching(
                self.ink, self.hatching, apart=6.0 * layer.scale, jitter=3.0 * layer.scale,
                boil=self.boil, tolerance=self.tolerance,
            ),
            layer,
        )  # fmt: skip
        medium = hand(
            self.width, self.ink, opacity=self.opacity, wobble=self.jitter,
            overshoot=self.overshoot, pressure=0.3, taper=14.0 * layer.scale, scale=layer.scale,
        )  # fmt: skip
        yield from strokes(self.hand(medium, self.strokes), layer)
