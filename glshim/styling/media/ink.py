"""Ink: strokes of an exact width on the lines that are seen, plain, dashed or textured.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001, sections 2.1
to 2.4. The formulas stand in `glshim.geometry.raskar`.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from types import MappingProxyType
from typing import Any, Literal

from glshim.geometry.raskar import INWARD
from glshim.model.lines import GROUPS
from glshim.styling.glsl import glsl
from glshim.styling.lines import Medium, Shader
from glshim.styling.media.ink_expansion import expand
from glshim.styling.media.kinds import colours_of_each, group_of_kind, of_each
from glshim.styling.textures import made
from glshim.styling.values import Colour
from glshim.styling.wishes import Pattern

STROKE = glsl(__file__, "stroke")
"""A line as a stroke in the window, and whether it is seen: for shaders of others, too."""
TRACE = glsl(__file__, "stroke", "trace")
"""The same, and what makes a stroke of a line record, for vertex shaders."""
SHADER = Shader(
    "ink", TRACE + glsl(__file__, "ink.vert"), STROKE + glsl(__file__, "ink.frag"), vertices=4,
    expand=expand,
)  # fmt: skip
Hidden = Literal["none", "dashed", "dimmed", "solid"]
_NONE: Mapping[str, Any] = MappingProxyType({})
_DASH = 12.0
"""Pixels of a dash of a hidden line with the gap after it."""
_DIMMED = 0.3
"""Share of the ink of dimmed lines."""


def ink(
    width: float = 2.5,
    colour: Colour | str = "#000000",
    *,
    widths: Mapping[str, float] = _NONE,
    colours: Mapping[str, Colour | str] = _NONE,
    texture: str = "none",
    texture_length: float = 0.0,
    dash: float = 0.0,
    textured: Collection[str] | None = None,
    hidden: Hidden = "none",
    hidden_share: float = 1.0,
) -> Medium:
    """Ink. width: pixels; of silhouettes all of it lies outside the object, of other lines half on
    either side.

    widths, colours: of lines of some kinds, as `Choice` and `Features` call them. texture: one of
    `glshim.styling.textures.MADE`, or the path of a picture, which repeats after texture_length
    pixels (0: what suits it), on narrower lines sooner; dash: pixels of a dash with the gap after
    it, 0 for none; textured: kinds of lines that have both, None for all. hidden: what is behind
    surfaces; of dashed and solid lines hidden_share of the ink.
    """
    wide = of_each(width, widths)
    measure = group_of_kind("silhouettes")
    outline = wide[measure]
    if textured and measure not in map(group_of_kind, textured):
        measure = group_of_kind(next(iter(textured)))
    first = wide[measure]
    image, pattern, coloured = None, None, False
    middle = outline / 2.0 - INWARD
    if texture != "none" or dash > 0.0:
        image, length, coloured = made(texture, first, texture_length, dash)
        groups = range(GROUPS) if textured is None else {group_of_kind(kind) for kind in textured}
        lengths = (length * own / first if k in groups else 0.0 for k, own in enumerate(wide))
        pattern = Pattern(tuple(lengths), middle)
    elif hidden == "dashed":
        pattern = Pattern((_DASH,) * GROUPS, middle)
    dashes = 0.0
    if hidden == "dashed" and pattern is not None:
        dashes = max(round(pattern.lengths[0] / _DASH), 1.0)
    return Medium(
        SHADER,
        {
            "widths": wide,
            "inks": colours_of_each(colour, colours),
            "textured": float(image is not None),
            "tinted": float(not coloured),
            "hidden_share": {"none": 0.0, "dimmed": _DIMMED}.get(hidden, hidden_share),
            "dashes": dashes,
        },
        image,
        pattern,
    )


def dashes(
    width: float = 2.5, colour: Colour | str = "#000000", *, length: float = 12.0
) -> Medium:
    """Dashed ink: a dash with the gap after it takes so many pixels."""
    return ink(width, colour, dash=length)
