"""Regular marks: dots and dashes."""

from __future__ import annotations

import numpy as np

from glshim.styling.textures.fields import Doubles, inside, places


def dotted(width: float, length: float) -> Doubles:
    """One round dot as wide as the line, or less where dots would touch."""
    along, across, grain = places(width, length)
    radius = min(width, 0.8 * length) / 2.0
    return inside(np.hypot(along, across) - radius, grain)


def dashed(width: float, length: float) -> Doubles:
    """One dash with rounded corners."""
    along, across, grain = places(width, length)
    half, round_ = 0.3 * length, min(0.35 * width, 0.2 * length)
    x = np.maximum(np.abs(along) - half + round_, 0.0)
    y = np.maximum(np.abs(across) - width / 2.0 + round_, 0.0)
    return inside(np.hypot(x, y) - round_, grain)
