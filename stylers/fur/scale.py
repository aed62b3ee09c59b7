"""How long, in object units, hairs of so many pixels are."""

from __future__ import annotations

from math import log2
from typing import NamedTuple

import numpy as np

from glshim.styling.values import Body

_MOST = 0.4
"""Share of its object's radius that a hair may be long."""


class Scale(NamedTuple):
    """Lengths of a body, object units."""

    length: float
    """Of a hair."""
    spacing: float
    """Between hairs: the number of pixels asked for, in steps of half an octave, so that a pattern
    stays what it is for a while as its object comes nearer."""
    reach: float
    """Of the body, from its middle."""
    pixels: float
    """What a hair is long in the window, at the middle of the body."""


def scale_of(body: Body, length: float, spacing: float) -> Scale | None:
    """Lengths for hairs of length and spacing in pixels at the middle of a body. None where it is
    nowhere, or no larger than a point."""
    camera = body.camera.affine()
    points = np.concatenate([batch.positions for batch in body.batches])
    points = points[np.isfinite(points).all(axis=1)]
    if not len(points):
        return None
    low, high = points.min(axis=0).astype(np.float64), points.max(axis=0).astype(np.float64)
    reach = float(np.linalg.norm(high - low)) / 2.0  # in float64: no overflow
    middle = camera.modelview @ (*((low + high) / 2.0), 1.0)
    with np.errstate(all="ignore"):
        grown = float(np.cbrt(abs(np.linalg.det(camera.modelview[:3, :3]))))
        # Nearer than its own radius only a part of it is seen.
        away = np.maximum(camera.projection[3] @ middle,
                          np.linalg.norm(camera.projection[3, :3]) * reach * grown)  # fmt: skip
        across = camera.viewport[3] / 2.0 * np.linalg.norm(camera.projection[1, :3]) / away
        pixel = float(np.reciprocal(np.float64(across * grown)))
    if not (np.isfinite(pixel) and pixel > 0.0 and 0.0 < reach < np.inf):
        return None
    long = min(length * pixel, _MOST * reach)
    return Scale(long, 2.0 ** (round(2.0 * log2(spacing * pixel)) / 2.0), reach, long / pixel)
