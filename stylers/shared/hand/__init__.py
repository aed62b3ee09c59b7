"""Styles that are drawn by hand: every line with strokes, again and again, on paper."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import floor, radians

from glshim.styling.lines import Lines, Medium
from glshim.styling.media.hand import reseeded
from glshim.styling.protocol import Styler
from glshim.styling.values import Layer
from glshim.styling.wishes import Choice, Features

from ..intersections import looked_for
from ..options import folds


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


class ByHand(Styler):
    """A style with the options of what is drawn by hand. They are fields of the style itself, in
    the order in which it wants them told."""

    boil: float
    seed: int
    crease_angle: float
    tolerance: float
    intersections: str

    def hand(self, medium: Medium, strokes: int) -> Hand:
        """A hand that draws with a medium, each line so often, by the style's options."""
        return Hand(
            self.crease_angle, medium, strokes, self.seed, self.boil, tolerance=self.tolerance,
            intersections=self.intersections,
        )  # fmt: skip


def features(hand: Hand) -> Features:
    """The lines of meshes that are drawn."""
    ridge, valley = folds(hand.crease_angle)
    return Features(
        contours=True,
        ridge_angle=radians(ridge),
        valley_angle=radians(valley),
        boundary=True,
        smooth=hand.smooth,
        suggestive=hand.suggestive,
        tolerance=hand.tolerance,
    )


def strokes(hand: Hand, layer: Layer) -> Iterator[Lines]:
    """Every line so often as the hand draws it, each time in a coat of its own."""
    wanted: list[Choice | Features] = [features(hand)]
    if looked_for(hand.intersections, layer):
        wanted.append(Choice(intersections=True))
    tick = floor(layer.time * hand.boil) % 997
    for number in range(hand.strokes):
        medium = reseeded(hand.medium, 31 * hand.seed + 7 * number + 13 * tick)
        for choice in wanted:
            yield Lines(layer.bodies, choice, medium, coat=number)
