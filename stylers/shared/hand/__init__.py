"""Styles that are drawn by hand: every line with strokes, again and again, on paper."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from math import floor, radians

from glshim.styling.lines import Lines, Medium
from glshim.styling.media.hand import reseeded
from glshim.styling.values import Colour, Layer
from glshim.styling.wishes import Choice, Features

from ..intersections import looked_for
from ..kinds import SWITCHES, USUAL, FeatureLines
from ..options import folds
from ..strokes import Looks, only, parted


@dataclass(frozen=True, slots=True)
class Hand:
    """Which lines a hand draws, with what, and how often."""

    crease_angle: float
    """Degrees: edges at which polygons turn by at least so much are drawn."""
    medium: Medium
    """Of `glshim.styling.media.hand`."""
    strokes: int = 1
    """How often each line is drawn, one over the other."""
    seed: int = 0
    boil: float = 0.0
    """New motions of the hand a second; 0: it holds still."""
    smooth: bool = False
    """Contours run through polygons (`Features.smooth`)."""
    suggestive: bool = False
    tolerance: float = 0.0
    intersections: str = "off"
    """Lines where polygons pass through each other: on, off, or auto."""
    kinds: Collection[str] = USUAL
    """Those that are drawn."""


@dataclass(frozen=True, slots=True)
class Strokes:
    """What lines that share a picture, or have none, look like."""

    texture: str
    dash: float
    widths: Mapping[str, float]
    """Pixels, by what media call kinds of lines."""
    colours: Mapping[str, Colour]


class ByHand(FeatureLines):
    """A style with the options of what is drawn by hand. They are fields of the style itself, in
    the order in which it wants them told."""

    boil: float
    seed: int
    crease_angle: float
    tolerance: float
    intersections: str

    def by_hand(
        self, medium: Callable[[Strokes], Medium], times: int, layer: Layer
    ) -> Iterator[Lines]:
        """All lines, each drawn so often, by the style's options."""
        for looks in parted(self.looks()):
            yield from strokes(self.hand(medium(_strokes(looks)), times, looks), layer)

    def hand(self, medium: Medium, strokes: int, kinds: Collection[str]) -> Hand:
        """A hand that draws lines of some kinds with a medium, each so often."""
        return Hand(
            self.crease_angle, medium, strokes, self.seed, self.boil, tolerance=self.tolerance,
            intersections=self.intersections, kinds=tuple(kinds),
        )  # fmt: skip


def _strokes(looks: Looks) -> Strokes:
    first = next(iter(looks.values()))
    return Strokes(
        first.texture,
        first.dash,
        {SWITCHES[kind]: look.width for kind, look in looks.items()},
        {SWITCHES[kind]: look.ink for kind, look in looks.items()},
    )


def features(hand: Hand) -> Features:
    """The lines of meshes that are drawn."""
    ridge, valley = folds(hand.crease_angle)
    all_lines = Features(
        contours=True,
        ridge_angle=radians(ridge),
        valley_angle=radians(valley),
        boundary=True,
        smooth=hand.smooth,
        suggestive=hand.suggestive,
        tolerance=hand.tolerance,
    )
    return only(all_lines, (*hand.kinds, *(["suggestive"] if hand.suggestive else [])))


def strokes(hand: Hand, layer: Layer) -> Iterator[Lines]:
    """Every line so often as the hand draws it, each time in a coat of its own."""
    wanted: list[Choice | Features] = []
    if {*hand.kinds} - {"intersection"}:
        wanted.append(features(hand))
    if "intersection" in hand.kinds and looked_for(hand.intersections, layer):
        wanted.append(Choice(intersections=True))
    tick = floor(layer.time * hand.boil) % 997
    for number in range(hand.strokes):
        medium = reseeded(hand.medium, 31 * hand.seed + 7 * number + 13 * tick)
        for choice in wanted:
            yield Lines(layer.bodies, choice, medium, coat=number)
            if layer.glass and isinstance(choice, Features):
                yield Lines(layer.glass_bodies, choice, medium, coat=number)
