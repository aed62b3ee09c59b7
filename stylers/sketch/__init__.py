"""Style ``sketch``: pencil on paper, as NPRQuake's."""

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
from ..shared.hand.hatching import Hatching, hatched
from ..shared.hand.paper import Paper, under
from ..shared.kinds import USUAL, former_names


@takes_old_names
@dataclass(frozen=True)
class Sketch(ByHand):
    """Jittered pencil strokes, hatched by the light, on paper (NPRQuake)."""

    name: ClassVar[str] = "sketch"
    former: ClassVar[Mapping[str, Renamed]] = former_names(USUAL)

    width: float = options.width(2.0, high=32.0)
    opacity: float = options.opacity(0.25)
    strokes: int = options.repeats(6, most=16)
    jitter: float = options.jitter(1.6)
    overshoot: float = options.overshoot(5.0)
    texture: str = options.texture()
    texture_length: float = options.texture_length()
    dash: float = options.dash()
    hatching: float = option(0.8, help="strength of hatching in dark areas", low=0.0, high=1.0)
    boil: float = options.boil()
    seed: int = options.seed()
    crease_angle: float = options.crease_angle(60.0)
    tolerance: float = options.tolerance()
    intersections: str = options.intersections()
    ink: Colour = options.ink("#1b1b1e", "strokes and hatching")
    paper: Colour = option("#faf8f2", help="colour of the paper")
    tint: float = option(0.3, help="strength of the program's own colours", low=0.0, high=1.0)
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
        """Paper, hatching, and every line so often as it is drawn."""
        yield from under(Paper(self.paper, tint=self.tint), layer)
        yield from hatched(
            Hatching(
                self.ink, self.hatching, apart=6.0 * layer.scale, jitter=3.0 * layer.scale,
                boil=self.boil, tolerance=self.tolerance,
            ),
            layer,
        )  # fmt: skip

        def medium(look: Strokes) -> Medium:
            return hand(
                self.width, self.ink, widths=look.widths, colours=look.colours,
                opacity=self.opacity, wobble=self.jitter, overshoot=self.overshoot, pressure=0.3,
                taper=14.0 * layer.scale, scale=layer.scale,
                **pictured(look.texture, self.width, self.texture_length, look.dash),
            )  # fmt: skip

        yield from self.by_hand(medium, self.strokes, layer)
