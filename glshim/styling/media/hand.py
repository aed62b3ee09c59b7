"""What a hand holds: strokes that stray, swell and overshoot.

NPRQuake (Mohr, Gleicher, *Non-Invasive, Interactive, Stylized Rendering*, 2001) draws every side of
every polygon with a jittered stroke. Here strokes run along chains of lines from corner to corner
(`glshim.linework.hand`), and their jitter lies on them as a pattern does, so that it stays where it
was while the model turns (`glshim.linework.coherence`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import radians
from types import MappingProxyType
from typing import Any

from glshim.model.lines import GROUPS
from glshim.styling.glsl import glsl
from glshim.styling.lines import Medium, Shader
from glshim.styling.media.hand_expansion import expand
from glshim.styling.media.ink import STROKE, TRACE
from glshim.styling.media.kinds import colours_of_each, of_each
from glshim.styling.pictures import Image
from glshim.styling.textures import made
from glshim.styling.values import Colour
from glshim.styling.wishes import Pattern

SHADER = Shader(
    "hand", TRACE + glsl(__file__, "hand", "hand.vert"),
    STROKE + glsl(__file__, "hand", "hand.frag"), vertices=4, expand=expand,
)  # fmt: skip
_NONE: Mapping[str, Any] = MappingProxyType({})
_PERIOD = 220.0
"""Pixels of a stroke after which a hand's motion repeats."""
_SEEDS = 1009
_BRISTLES = 2.2
"""Widths of a stroke over which the hairs of its brush leave the paper."""
_FULL = 7.0
"""Widths long is a stroke that is painted in its full width; small things are painted finer."""


def hand(
    width: float = 2.0,
    colour: Colour | str = "#000000",
    *,
    widths: Mapping[str, float] = _NONE,
    colours: Mapping[str, Colour | str] = _NONE,
    opacity: float = 1.0,
    wobble: float = 0.0,
    overshoot: float = 0.0,
    overshoot_share: float = 0.1,
    pressure: float = 0.0,
    taper: float = 0.0,
    tip: float = 0.0,
    corner: float = 40.0,
    image: Image | None = None,
    length: float = _PERIOD,
    coloured: bool = False,
    bristles: float = 0.0,
    aligned: bool = False,
    straight: bool = False,
    scale: float = 1.0,
    seed: int = 0,
) -> Medium:
    """One stroke a line, as a hand draws it. Lengths in pixels; widths, colours: of lines of some
    kinds, as `Choice` and `Features` call them.

    opacity: of one stroke, 0..1. wobble: amplitude of the jitter. overshoot: how far strokes extend
    beyond their ends, at most a share of their length. pressure: share of the width by which
    strokes swell and thin. taper: length over which they get thin at their ends. tip: length of a
    stroke that has the full width; shorter ones are thinner. corner: degrees of a turn on the
    screen at which a new stroke begins. image: the texture of a brush, its length, whether it has
    colours of its own, and the pixels over which its hairs leave the paper (bristles). aligned:
    strokes begin where the image does, so that dashes lie over each other. straight: only ends that
    strokes run into straight on extend, no curve does. scale: `Layer.scale`.
    seed: another seed gives other jitter.
    """
    tiles = max(round(_PERIOD * scale / length), 1)  # pictures may be short
    period = length * tiles if image is not None else _PERIOD * scale
    medium = Medium(
        SHADER,
        {
            "widths": of_each(width, widths),
            "inks": colours_of_each(colour, colours),
            "hidden_share": 0.0,
            "wobble": wobble,
            "period": period,
            "overshoot": overshoot,
            "overshoot_share": overshoot_share,
            "opacity": opacity,
            "pressure": pressure,
            "taper": taper,
            "tip": tip,
            "textured": float(image is not None),
            "tinted": float(not coloured),
            "tiles": float(tiles),
            "begins": float(not aligned),
            "bristles": bristles,
        },
        image,
        Pattern((period,) * GROUPS, 0.0, radians(corner), straight),
    )
    return reseeded(medium, seed)


def pictured(texture: str, width: float, length: float = 0.0, dash: float = 0.0) -> dict[str, Any]:
    """The arguments of `hand` that a texture and dashes give it, as of `ink`; none where there is
    neither."""
    if texture == "none" and dash <= 0.0:
        return {}
    image, length, coloured = made(texture, width, length, dash)
    return {"image": image, "length": length, "coloured": coloured, "aligned": dash > 0.0}


def reseeded(medium: Medium, seed: int) -> Medium:
    """The same medium with the jitter of another seed."""
    return replace(
        medium, uniforms={**medium.uniforms, "jitter_seed": float(seed % _SEEDS) / 101.0}
    )


def pencil(
    width: float = 2.6,
    colour: Colour | str = "#2b2a2d",
    *,
    inner: float = 0.7,
    widths: Mapping[str, float] | None = None,
    colours: Mapping[str, Colour | str] = _NONE,
    opacity: float = 0.75,
    wobble: float = 1.1,
    overshoot: float = 5.0,
    texture: str = "pencil",
    texture_length: float = 0.0,
    dash: float = 0.0,
    scale: float = 1.0,
    seed: int = 0,
) -> Medium:
    """A soft pencil, whose graphite the tooth of the paper holds. width: pixels of outlines; inner:
    share of it of the other lines, or widths by kind; texture, dash: as of `ink`; the rest as of
    `hand`. Pencil lines are drawn twice or so, with a seed and a coat for each."""
    wide = outlines(width) if widths is None else widths
    return hand(
        2.0 * inner * width, colour, widths={kind: 2.0 * own for kind, own in wide.items()},
        colours=colours, opacity=opacity, wobble=wobble, overshoot=overshoot, pressure=0.35,
        taper=18.0 * scale, tip=50.0 * scale, scale=scale, seed=seed,
        **pictured(texture, 2.0 * width, texture_length, dash),
    )  # fmt: skip


def brush(
    picture: str = "pen2b",
    width: float = 7.0,
    colour: Colour | str = "#1f1b24",
    *,
    inner: float = 0.7,
    widths: Mapping[str, float] | None = None,
    colours: Mapping[str, Colour | str] = _NONE,
    opacity: float = 0.92,
    wobble: float = 1.4,
    overshoot: float = 6.0,
    texture_length: float = 0.0,
    dash: float = 0.0,
    scale: float = 1.0,
    seed: int = 0,
) -> Medium:
    """A brush: one of `glshim.styling.textures.brushes.BRUSHES`, or the path of a picture; the rest
    as of `pencil`."""
    return hand(
        inner * width, colour, widths=outlines(width) if widths is None else widths,
        colours=colours, opacity=opacity, wobble=wobble, overshoot=overshoot, pressure=0.25,
        taper=1.5 * width, bristles=_BRISTLES * width, tip=_FULL * width, scale=scale, seed=seed,
        **pictured(picture, width, texture_length, dash),
    )  # fmt: skip


def outlines(width: float) -> Mapping[str, float]:
    """The widths of lines that are outlines."""
    return {"silhouettes": width, "boundary": width}
