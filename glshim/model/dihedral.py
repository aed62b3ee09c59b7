"""Which dihedral angles make a ridge and which a valley: the one rule for every way lines take.

The dihedral angle of an edge lies in the material, behind its polygons' normals (Raskar 2001,
section 2.2): pi where they are coplanar, less on a ridge, more in a valley. An edge is a ridge
where its angle is at most the ridge angle, a valley where it is greater than the valley angle: each
threshold includes what lies below it. Angles within `GRAIN` of a threshold equal it. All radians.
"""

from __future__ import annotations

import numpy as np

from glshim.model.arrays import Doubles, Flags

GRAIN = 1e-3
"""Radians, 0.06 degrees: rounding of float32 corners moves an angle by less. The sides of a
hexagonal nut fold by exactly the default thresholds, 120 and 240 degrees."""


def is_ridge(angles: Doubles, ridge_angle: float) -> Flags:
    """(N,) of dihedral angles (N,)."""
    return np.asarray(angles <= ridge_angle + GRAIN)


def is_valley(angles: Doubles, valley_angle: float) -> Flags:
    """(N,) of dihedral angles (N,)."""
    return np.asarray(angles > valley_angle + GRAIN)


def crease_limits(ridge_angle: float, valley_angle: float) -> tuple[float, float]:
    """The same rule as McGuire & Hughes 2004, equation 1, states it: what the internal angle of a
    ridge, and the external angle of a valley (2 pi less its dihedral angle), is less than. They ask
    for a ridge angle of at most pi and a valley angle of at least pi."""
    return ridge_angle + GRAIN, max(2.0 * np.pi - valley_angle - GRAIN, 0.0)
