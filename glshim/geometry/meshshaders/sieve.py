"""Which edges or triangles may have lines, before the GPU decides; what surely has none goes.

Of 200,000 edges a few thousand remain. One product a triangle and one look-up an edge finds them,
which a processor does sooner than a driver in software runs equation 1 for every vertex.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.crease.creases import Creases
from glshim.geometry.meshshaders.edge_mesh import BOUNDARY, CONTOUR, MARKED, RIDGE, VALLEY, EdgeMesh
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.outward import outward
from glshim.model.arrays import Flags, Floats, Indices, Rows
from glshim.model.vectors import dot

CREASE, SMOOTH = 32, 64
"""Bits of triangles beside those of `features`: one that is seen has a crease; contours of the
smooth surface, zeros of n.c, pass through it."""
_ROUNDING = 2e-6
"""Of float32 in a facing test, over the lengths that go into it; for slivers it is more."""
_SLACK = 1e-4
"""Of the cosine between normals in float32."""
_BACK, _FRONT, _EITHER = 0, 1, 2


class Facing:
    """Which side of the triangles of a mesh is seen."""

    def __init__(self, mesh: Mesh) -> None:
        corners = [mesh.positions[mesh.triangles[:, k]].astype(np.float64) for k in range(3)]
        middle = np.mean(corners, axis=0)
        sides = [corners[k] - corners[k - 1] for k in range(3)]
        longest = np.max([dot(side, side) for side in sides], axis=0, initial=0.0)
        area = np.linalg.norm(np.cross(sides[1], sides[2]), axis=1)
        planes = np.concatenate((mesh.normals, -dot(mesh.normals, middle)[:, None]), axis=1)
        self._planes = np.ascontiguousarray(planes.T, np.float32)
        slack = _ROUNDING * (1.0 + longest / np.maximum(area, 1e-300))
        self._slack = np.minimum(slack, 1e30).astype(np.float32)
        self._radius = float(np.abs(mesh.positions).max(initial=0.0)) * 3**0.5
        self._last: tuple[bytes, NDArray[np.uint8]] = (b"", np.empty(0, np.uint8))

    def doubtful(self, eye: NDArray[np.floating]) -> Rows:
        """The triangles of which rounding decides which side is seen from eye (4,), homogeneous."""
        return np.flatnonzero(self.seen(eye) == _EITHER)

    def seen(self, eye: NDArray[np.floating]) -> NDArray[np.uint8]:
        """(T,) front, back, or either where rounding decides, from eye (4,) homogeneous."""
        key = eye.tobytes()
        if key != self._last[0]:
            slack = self._slack * np.float32(reach_of(eye, self._radius))
            value = _at(eye, self._planes)
            found: NDArray[np.uint8] = (value > slack).view(np.uint8)
            found[np.abs(value) <= slack] = _EITHER
            self._last = key, found
        return self._last[1]


def reach_of(eye: NDArray[np.floating], radius: float) -> float:
    """What lengths go into a product with an eye (4,), of points within a radius."""
    return float(np.linalg.norm(eye[:3])) + radius * abs(float(eye[3]))


def _at(eye: NDArray[np.floating], planes: Floats) -> Floats:
    """(N,) products of planes (4, N) with an eye (4,)."""
    # No matrix product: its threads would wait for those that draw.
    x, y, z, w = np.asarray(eye, np.float32)
    value = planes[0] * x
    for part, plane in zip((y, z, w), planes[1:], strict=True):
        value += part * plane
    return np.asarray(value)


class EdgeSieve:
    """Candidates among the edges of a mesh that does not move."""

    def __init__(self, mesh: Mesh, edges: EdgeMesh) -> None:
        normals = mesh.normals
        self.facing = Facing(mesh)
        a, b = mesh.faces[edges.rows].T
        b = np.where(b < 0, a, b)
        self._a, self._b = a.astype(np.intp), b.astype(np.intp)
        self._twisted = np.flatnonzero(mesh.twisted[edges.rows])
        v0, v1, _, v3 = (np.where(i < 0, ~i, i) for i in edges.indices.T)
        self._boundary, self._marked = v3 == v0, v3 == v1
        self._creases = ~self._boundary & ~self._marked & (edges.indices[:, 2] >= 0)
        self._product = dot(normals[self._a], normals[self._b])
        self._product[self._twisted] = -1.0
        self._fixed = lru_cache(maxsize=4)(self._fixed_now)

    def candidates(
        self, eye: NDArray[np.floating], wanted: int, angles: tuple[float, float]
    ) -> Indices:
        """The rows of the edge mesh that may have one of the wanted bits of `features`, seen from
        eye (4,) homogeneous, in rising order. angles: as of `features`."""
        kept = self._fixed(wanted, angles)
        if wanted & CONTOUR:
            facing = self.facing.seen(eye)
            one, other = facing.take(self._a), facing.take(self._b)
            contours = one != other
            contours |= one == _EITHER
            contours[self._twisted] = True
            contours &= ~self._boundary
            kept = kept | contours
        return np.flatnonzero(kept).astype(np.int32)

    def _fixed_now(self, wanted: int, angles: tuple[float, float]) -> Flags:
        """(E,) what may be a feature from everywhere."""
        kept = np.zeros(len(self._a), np.bool_)
        if wanted & BOUNDARY:
            kept |= self._boundary
        if wanted & MARKED:
            kept |= self._marked
        for bit, angle in zip((RIDGE, VALLEY), angles, strict=True):
            if wanted & bit:
                kept |= self._creases & (self._product < -np.cos(angle) + _SLACK)
        return kept


class TriangleSieve:
    """Candidates among the triangles of a mesh that does not move."""

    def __init__(self, creases: Creases) -> None:
        mesh = creases.mesh
        self._facing = Facing(mesh)
        self._creased = np.flatnonzero(creases.sides.any(axis=1))
        self._open = ~mesh.closed[self._creased]
        inside_out = outward(mesh)[mesh.triangles[self._creased, 0]] < 0.0
        self._away = np.where(inside_out, np.uint8(_FRONT), np.uint8(_BACK))
        points = mesh.positions[creases.vertices].astype(np.float64)
        products = -dot(creases.normals.astype(np.float64), points)
        self._planes = np.ascontiguousarray(np.c_[creases.normals, products].T, np.float32)
        self._triangles = np.ascontiguousarray(creases.triangles.T, np.intp)
        self._radius = float(np.abs(mesh.positions).max(initial=0.0)) * 3**0.5

    def candidates(self, eye: NDArray[np.floating], wanted: int) -> Indices:
        """Triangles that may have one of the wanted lines, ``CREASE`` and ``SMOOTH``, seen from
        eye (4,) homogeneous, in rising order."""
        kept = np.zeros(self._triangles.shape[1], np.bool_)
        if wanted & CREASE:
            facing = self._facing.seen(eye).take(self._creased)
            kept[self._creased] = self._open | (facing != self._away)
        if wanted & SMOOTH:
            value = _at(eye, self._planes)
            slack = np.float32(_ROUNDING * reach_of(eye, self._radius))
            before, behind = value > -slack, value < slack
            some = np.logical_or.reduce([before.take(row) for row in self._triangles])
            some &= np.logical_or.reduce([behind.take(row) for row in self._triangles])
            kept |= some
        return np.flatnonzero(kept).astype(np.int32)
