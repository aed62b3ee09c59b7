"""``hand.vert.glsl`` on the CPU, for OpenGL before 3.3."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

import numpy as np
from numpy.typing import NDArray

from glshim.model.camera import Camera
from glshim.model.lines import Line
from glshim.model.vectors import unit
from glshim.styling.lines import Expansion
from glshim.styling.media.ink_expansion import traced
from glshim.styling.values import Uniform

Doubles = NDArray[np.float64]

_AT_END = 0.02
"""Pixels; `hand.glsl` has the same."""


def expand(
    records: NDArray[np.float32],
    camera: Camera,
    uniforms: Mapping[str, Uniform],
    *,
    hair: float,
    blur: float,
) -> Expansion:
    """The strips of the shader of `glshim.styling.media.hand`. Every pixel asks whether its line is
    seen."""
    with np.errstate(all="ignore"):  # lines that are not drawn may divide by nothing
        found = traced(records, camera, uniforms, hair=hair, blur=blur)
        drawn = found.drawn
        a, b = (end[drawn][:, :2] for end in (found.start, found.finish))
    rows, repeats, kind = records[drawn].astype(float), found.repeats[drawn], found.extent[drawn, 2]
    wobble, most, share = (float(cast(float, uniforms[name]))
                           for name in ("wobble", "overshoot", "overshoot_share"))  # fmt: skip
    width = found.extent[drawn, 1] - found.extent[drawn, 0]
    before, after = rows[:, Line.BEFORE], rows[:, Line.AFTER]
    span = np.hypot(*(b - a).T)
    way = np.where(repeats[:, 1] < repeats[:, 0], -1.0, 1.0)
    length = np.minimum(before + span + after, 1e5)
    beyond = np.minimum(most, share * length) * (0.5 + _chance(17.0 + way, uniforms))

    reach = 0.75 * width + 1.6 * wobble + 1.0
    along = unit(b - a)
    aside = reach[:, None] * np.c_[along[:, 1], -along[:, 0]]
    first, last = (reach + np.where(rest < _AT_END, beyond, 0.0) for rest in (before, after))
    ends = (a - first[:, None] * along, b + last[:, None] * along)
    places = np.stack([end + side for end in ends for side in (-aside, aside)], axis=1)
    values = {
        "line_a": found.start[drawn],
        "line_b": found.finish[drawn],
        "onwards": found.onwards[drawn],
        "slopes": found.slopes[drawn],
        "extent": np.c_[-0.5 * width, 0.5 * width, kind],
        "repeats": repeats,
        "grain": found.grain[drawn],
        "hand": np.c_[before, after, beyond, np.zeros(len(rows))],
    }
    return Expansion(places, values)


def _chance(number: Doubles, uniforms: Mapping[str, Uniform]) -> Doubles:
    """`chance` of ``hand.glsl``."""
    seed = float(cast(float, uniforms["jitter_seed"]))
    return np.asarray(np.sin(12.9898 * number + 78.233 * seed) * 43758.5453 % 1.0)
