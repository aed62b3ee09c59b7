"""Which way is out of a recovered mesh: apps wind their polygons either way."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.welding import weld
from glshim.model.arrays import Doubles, Floats
from glshim.model.vectors import cross, dot

_HOLLOW = 0.01
"""Volume over area to the power of 1.5 from which on a component has an inside (sphere: 0.094)."""


def outward(mesh: Mesh) -> Floats:
    """(V,) for each vertex +1 where its normal points out of its component, -1 where it points
    into it, 0 where the component encloses next to nothing: an open surface has no outside.

    The sign is that of the volume that the component encloses seen from its middle, which holds
    for a bowl or a bent pipe too.
    """
    found = np.zeros(len(mesh.positions), np.float32)
    if not len(mesh.triangles):
        return found
    label = mesh.components
    sign = signs_of(mesh.positions[mesh.triangles].astype(np.float64), label)
    found[mesh.triangles] = sign[label][:, None]
    return found


def outward_sign(triangles: NDArray[np.floating]) -> float:
    """+1 where the normals of triangles (T, 3, 3) point out of what they enclose, -1 where they
    point into it, 0 where that is next to nothing. What hangs together by equal corners is taken
    by itself, as a floor under a figure encloses nothing; where none of it does, all as one."""
    corners = np.asarray(triangles, np.float64)
    sound = corners[np.isfinite(corners).all(axis=(1, 2))]
    if not len(sound):
        return 0.0
    vertex = weld(sound.reshape(-1, 3).astype(np.float32))[1].reshape(-1, 3)
    sides = np.concatenate((vertex[:, :2], vertex[:, 1:]))
    label = components(int(vertex.max()) + 1, sides[:, 0], sides[:, 1]).label[vertex[:, 0]]
    volume, share = _enclosed(sound, label)
    hollow = np.abs(share) >= _HOLLOW
    if hollow.any():
        return float(np.sign(volume[hollow].sum()))
    return float(signs_of(sound, np.zeros(len(sound), np.intp))[0])


def signs_of(corners: Doubles, label: NDArray[np.integer]) -> Doubles:
    """(L,) of each label that triangles (T, 3, 3) bear (T,): the sign of the volume that they
    enclose, 0 where that is next to nothing."""
    share = _enclosed(corners, label)[1]
    return np.asarray(np.where(np.abs(share) >= _HOLLOW, np.sign(share), 0.0))


def _enclosed(corners: Doubles, label: NDArray[np.integer]) -> tuple[Doubles, Doubles]:
    """(L,) of each label that triangles (T, 3, 3) bear (T,): the volume that they enclose, seen
    from their middle, and (L,) its share of their area to the power of 1.5."""
    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        middle = corners.mean(axis=1)
        total = np.bincount(label)
        centre = np.stack([np.bincount(label, middle[:, k]) / total for k in range(3)], axis=1)
        a, b, c = (corners[:, k] - centre[label] for k in range(3))
        volume = np.bincount(label, dot(a, cross(b, c)) / 6.0)
        vector = cross(b - a, c - a)
        area = np.bincount(label, np.sqrt(dot(vector, vector)) / 2.0)
        return np.asarray(volume), np.asarray(np.nan_to_num(volume / area**1.5))
