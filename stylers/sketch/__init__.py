"""Style ``sketch``: pencil on paper, as NPRQuake's."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from glshim.styling.passes import Pass
from glshim.styling.protocol import Colour, Layer, Lines, Styler, option
from stylers import options
from stylers.hand import Hand, strokes
from stylers.hand.hatching import Hatching, hatched
from stylers.hand.paper import Paper, under


@dataclass(frozen=True)
class Sketch(Styler):
    """Jittered pencil strokes, hatched by the light, on paper (NPRQuake)."""

    name: ClassVar[str] = "sketch"

    width: float = option(2.0, help="width of a stroke", low=0.5, high=32.0, unit="px")
    opacity: float = option(0.25, help="of one stroke", low=0.02, high=1.0)
    strokes: float = option(6.0, help="how often each line is drawn", low=1.0, high=16.0)
    jitter: float = option(1.6, help="how far a stroke strays", low=0.0, high=32.0, unit="px")
    overshoot: float = option(5.0, help="how far strokes go on", low=0.0, high=64.0, unit="px")
    hatching: float = option(0.8, help="of dark places", low=0.0, high=1.0)
    boil: float = options.boil()
    seed: float = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = option("#1b1b1e", help="colour of the strokes")  # noqa: RUF009
    paper: Colour = option("#faf8f2", help="colour of the paper")  # noqa: RUF009
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
        hand = Hand(
            self.crease_angle, (self.width, self.width), (self.ink, self.ink),
            strokes=round(self.strokes), opacity=self.opacity, wobble=self.jitter,
            overshoot=self.overshoot, pressure=0.3, taper=14.0 * layer.scale, boil=self.boil,
            scale=layer.scale, intersections=self.intersections, seed=round(self.seed),
            tolerance=self.tolerance,
        )  # fmt: skip
        yield from strokes(hand, layer)
