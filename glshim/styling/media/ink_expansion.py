"""``ink.vert.glsl`` on the CPU, for OpenGL before 3.3."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

import numpy as np
from numpy.typing import NDArray

from glshim.geometry import raskar
from glshim.model.camera import Camera
from glshim.styling.lines import Expansion
from glshim.styling.values import Uniform


def expand(
    records: NDArray[np.float32],
    camera: Camera,
    uniforms: Mapping[str, Uniform],
    *,
    hair: float,
    blur: float,
) -> Expansion:
    """The strips of `SHADER`, from the numpy reference."""
    # Lines that are not drawn may divide by nothing.
    with np.errstate(all="ignore"):
        strokes = traced(records, camera, uniforms, hair=hair, blur=blur)
        places = raskar.quads(strokes)
    drawn = strokes.drawn
    values = {
        "line_a": strokes.start,
        "line_b": strokes.finish,
        "onwards": strokes.onwards,
        "slopes": strokes.slopes,
        "extent": strokes.extent,
        "repeats": strokes.repeats,
        "grain": strokes.grain,
    }
    return Expansion(places[drawn], {name: rows[drawn] for name, rows in values.items()})


def traced(
    records: NDArray[np.float32],
    camera: Camera,
    uniforms: Mapping[str, Uniform],
    *,
    hair: float,
    blur: float,
) -> raskar.Strokes:
    """What ``trace.glsl`` makes of records."""
    ridge_turn, valley_turn = (_numbers(uniforms[name]) for name in ("ridge_turn", "valley_turn"))
    return raskar.strokes(
        records,
        camera,
        widths=_numbers(uniforms["widths"]),
        ridge_angle=float(np.arctan2(ridge_turn[1], ridge_turn[0])),
        valley_angle=float(np.arctan2(valley_turn[1], valley_turn[0])),
        hair=hair,
        blur=blur,
    )


def _numbers(value: Uniform) -> tuple[float, ...]:
    return cast(tuple[float, ...], value)
