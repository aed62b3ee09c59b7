"""What is drawn by hand: strokes that stray, swell and overshoot, on paper.

NPRQuake (Mohr, Gleicher, *Non-Invasive, Interactive, Stylized Rendering*, 2001) draws every side of
every polygon with a jittered stroke. Here strokes run along chains of feature edges from corner to
corner (`glshim.linework.hand`), and their jitter lies on them as a pattern does, so that it
stays where it was while the model turns (`glshim.linework.coherence`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from math import cos, floor, radians, sin

from glshim.model.lines import GROUPS
from glshim.styling.pictures import Image
from glshim.styling.protocol import Colour, Layer, Lines, Medium, Shader, Uniform
from glshim.styling.wishes import Choice, Features, Pattern
from stylers.crossings import looked_for
from stylers.hand.expansion import expand
from stylers.options import folds

_HERE = files(__package__)
_RASKAR = files("stylers.raskar")
_PERIOD = 220.0
"""Pixels of a stroke after which a hand's motion repeats."""


def _text(name: str) -> str:
    return (_HERE / f"{name}.glsl").read_text("utf-8")


@cache
def shader() -> Shader:
    """A line record as one stroke of a hand."""
    stroke, trace = ((_RASKAR / f"{name}.glsl").read_text("utf-8") for name in ("stroke", "trace"))
    return Shader(
        "hand",
        stroke + trace + _text("hand") + _text("hand.vert"),
        stroke + _text("hand") + _text("hand.frag"),
        vertices=4,
        expand=expand,
    )


@dataclass(frozen=True, slots=True)
class Hand:
    """How lines are drawn."""

    crease_angle: float
    """Degrees: edges at which polygons turn by at least so much are drawn."""
    widths: tuple[float, float]
    """Pixels: of outlines and of what lies within."""
    inks: tuple[Colour, Colour]
    strokes: int = 1
    """How often each line is drawn, one over the other."""
    opacity: float = 1.0
    """Of one stroke."""
    wobble: float = 0.0
    """Pixels by which the hand strays."""
    overshoot: float = 0.0
    """Pixels by which strokes go on beyond their ends, about."""
    overshoot_share: float = 0.1
    """Of a stroke's length by which it goes on at most."""
    pressure: float = 0.0
    """Share of the width by which strokes swell and thin."""
    taper: float = 0.0
    """Pixels at the ends of strokes over which they grow thin."""
    tip: float = 0.0
    """Pixels of a stroke that is drawn in its full width; shorter ones are thinner, as drawn with
    the tip of the pen."""
    corner: float = 40.0
    """Degrees of a turn on the screen at which the pen is lifted."""
    seed: int = 0
    boil: float = 0.0
    """New motions of the hand a second; 0: it holds still."""
    smooth: bool = False
    """Contours run through polygons (`Features.smooth`)."""
    suggestive: bool = False
    tolerance: float = 0.0
    intersections: str = "off"
    """Lines where polygons pass through each other: on, off, or auto (`stylers.crossings`)."""
    image: Image | None = None
    """A brush."""
    length: float = _PERIOD
    """Pixels of the brush's picture."""
    coloured: bool = False
    """The brush has colours of its own."""
    bristles: float = 0.0
    """Pixels over which its hairs leave the paper at the end of a stroke."""
    scale: float = 1.0
    """Pixels for one of the window (`Layer.scale`): lengths that are no options go by it."""

    @property
    def period(self) -> float:
        """Pixels of a stroke after which brush and motion repeat."""
        return self.length * self.tiles if self.image is not None else _PERIOD * self.scale

    @property
    def tiles(self) -> int:
        """How often the brush repeats while the motion does once: pictures may be short."""
        return max(round(_PERIOD * self.scale / self.length), 1)


def features(hand: Hand) -> Features:
    """The lines that are drawn, as strokes from corner to corner."""
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


def pattern(hand: Hand) -> Pattern:
    """Along which its motions lie, from corner to corner."""
    return Pattern((hand.period,) * GROUPS, 0.0, radians(hand.corner))


def strokes(hand: Hand, layer: Layer) -> Iterator[Lines]:
    """Every line so often as the hand draws it, each time in a coat of its own."""
    choices: list[Choice | Features] = [features(hand)]
    if looked_for(hand.intersections, layer):
        choices.append(Choice(intersections=True))
    common = uniforms(hand)
    tick = floor(layer.time * hand.boil) % 997
    for number in range(hand.strokes):
        seed = float((31 * hand.seed + 7 * number + 13 * tick) % 1009)
        drawn = {**common, "jitter_seed": seed / 101.0}
        medium = Medium(shader(), drawn, hand.image, pattern(hand))
        for choice in choices:
            yield Lines(layer.bodies, choice, medium, coat=number)


def uniforms(hand: Hand) -> dict[str, Uniform]:
    """What the shader asks of a hand, all but the seed of its motions."""
    ridge, valley = (radians(180.0 + side * hand.crease_angle) for side in (-1.0, 1.0))
    outline, inner = hand.widths
    # Outlines are groups 0 and 5 (`glshim.model.lines.GROUPS`).
    outlines = [group in (0, 5) for group in range(GROUPS)]
    return {
        "widths": tuple(outline if of_outline else inner for of_outline in outlines),
        "inks": tuple(hand.inks[not of_outline] for of_outline in outlines),
        "ridge_turn": (cos(ridge), sin(ridge)),
        "valley_turn": (cos(valley), sin(valley)),
        "hidden_share": 0.0,
        "wobble": hand.wobble,
        "period": hand.period,
        "overshoot": hand.overshoot,
        "overshoot_share": hand.overshoot_share,
        "opacity": hand.opacity,
        "pressure": hand.pressure,
        "taper": hand.taper,
        "tip": hand.tip,
        "textured": float(hand.image is not None),
        "tinted": float(not hand.coloured),
        "tiles": float(hand.tiles),
        "bristles": hand.bristles,
    }
