"""The app's fog as plain values.

The OpenGL Specification, version 2.1, section 3.10 (Fog).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np

from glshim.model.arrays import Doubles
from glshim.model.lights import Shade


class FogMode(IntEnum):
    """How fog thickens with the distance."""

    LINEAR = 1
    EXP = 2
    EXP2 = 3


@dataclass(frozen=True, slots=True)
class Fog:
    """GL_FOG by the distance from the plane of the eye."""

    mode: FogMode
    colour: Shade
    density: float = 1.0
    start: float = 0.0
    """Units of eye space, for `FogMode.LINEAR`, as `end`."""
    end: float = 1.0


def clear_share(fog: Fog, distance: Doubles) -> Doubles:
    """(N,) 0..1 of a surface's own colour that is seen through fog, at distances (N,) in units of
    eye space."""
    if fog.mode is FogMode.LINEAR:
        reach = fog.end - fog.start
        found = (fog.end - distance) / (reach if reach else 1.0)
    else:
        found = np.exp(-((fog.density * distance) ** (1.0 if fog.mode is FogMode.EXP else 2.0)))
    return np.asarray(np.clip(found, 0.0, 1.0))
