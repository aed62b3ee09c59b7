"""The edge mesh of McGuire & Hughes 2004, by indices, and which of its edges are features.

An edge vertex of the paper is <v0, v1, v2, v3, n0, n1, r, i>. Here an edge is four indices: the
places and normals are looked up, r is a number hashed from the edge's own, i is the corner that is
being drawn. ``glshim/outputs/gl/shaders/edges.glsl`` does the same on the GPU and is held to this.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.edges.folds import FLAT
from glshim.geometry.recovery.mesh import Mesh
from glshim.model.arrays import Indices
from glshim.model.vectors import dot, unit

CONTOUR, RIDGE, VALLEY, MARKED, BOUNDARY = 1, 2, 4, 8, 16
"""Bits of `features`."""


@dataclass(frozen=True, slots=True, eq=False)
class EdgeMesh:
    """Edges by the vertices of a `Mesh`."""

    indices: Indices
    """(E, 4) v0, v1, v2, v3 (figure 2): triangles A = <v0, v1, v2> and B = <v3, v1, v0>. v3 = v0:
    boundary (also each side of a non-manifold edge); v3 = v1: marked. ~v0: its component is
    open, both sides may be seen; ~v2: a side inside a polygon that is not flat, which may be a
    contour but no crease."""
    rows: Indices
    """(E,) the edge of the `Mesh`."""

    @property
    def nbytes(self) -> int:
        """Memory of the indices."""
        return self.indices.nbytes


def edge_mesh(mesh: Mesh) -> EdgeMesh:
    """The edge mesh of a mesh: all true edges, and those inside of polygons that are not flat."""
    a, b = mesh.faces.T
    normals = mesh.normals
    bent = np.linalg.norm(np.cross(normals[a], normals[np.where(b < 0, a, b)]), axis=1) > FLAT
    rows = np.flatnonzero(mesh.true | bent).astype(np.int32)
    indices = _indices(mesh, rows)
    marked = mesh.marked[rows]
    indices[marked, 3] = indices[marked, 1]
    return EdgeMesh(indices, rows)


def inner_sides(mesh: Mesh, edges: EdgeMesh) -> Indices:
    """(S, 4) the edges that an edge mesh leaves out, in its form. With them each side of each
    triangle is in one row, as whoever builds volumes of single triangles needs it."""
    out = np.ones(len(mesh.edges), np.bool_)
    out[edges.rows] = False
    return _indices(mesh, np.flatnonzero(out))


def _indices(mesh: Mesh, rows: NDArray[np.integer]) -> Indices:
    """(E, 4) edges of a mesh, none of them marked, as `EdgeMesh.indices`."""
    indices = np.empty((len(rows), 4), np.int32)
    indices[:, :2] = mesh.edges[rows]
    indices[:, 2:] = mesh.opposite[rows]
    inner, open_ = ~mesh.true[rows], ~mesh.closed[mesh.faces[rows, 0]]
    indices[inner, 2] = ~indices[inner, 2]
    indices[open_, 0] = ~indices[open_, 0]
    return indices


def features(
    indices: Indices,
    positions: NDArray[np.floating],
    eye: NDArray[np.floating],
    angles: tuple[float, float],
    *,
    facing: float = 1.0,
) -> NDArray[np.uint8]:
    """(E,) bits of equation 1 for edges (E, 4) of positions (V, 3), in object space.

    eye: (4,) homogeneous, a direction towards the viewer where w = 0. angles: those that a
    ridge's internal and a valley's external angle is less than, radians
    (`glshim.model.dihedral.crease_limits`). facing: +1 where counter-clockwise triangles are front
    faces, else -1. In open components a fold is what it is from the side that is seen.
    """
    where = np.asarray(positions, np.float64)
    source = np.asarray(eye, np.float64)
    opened, inner = indices[:, 0] < 0, indices[:, 2] < 0
    v0, v1, v2, v3 = (np.where(i < 0, ~i, i) for i in indices.T)
    p0, p1, p2, p3 = (where[v] for v in (v0, v1, v2, v3))
    out_a = np.cross(p1 - p0, p2 - p0)
    out_b = np.cross(p3 - p0, p1 - p0)
    towards = source[:3] - source[3] * p0
    front_a, front_b = dot(out_a, towards) > 0.0, dot(out_b, towards) > 0.0
    boundary, marked = v3 == v0, v3 == v1
    whole = ~boundary & ~marked
    bits = np.zeros(len(indices), np.uint8)
    bits[whole & (front_a != front_b)] |= CONTOUR
    product = dot(unit(out_a), unit(out_b))
    lift = dot(p3 - p2, out_a) * np.where(opened & ~front_a, -1.0, 1.0)
    lift *= np.where(opened, 1.0, facing)
    crease = whole & ~inner
    bits[crease & (product < -np.cos(angles[0])) & (lift <= 0.0)] |= RIDGE
    bits[crease & (product < -np.cos(angles[1])) & (lift > 0.0)] |= VALLEY
    bits[boundary] |= BOUNDARY
    bits[marked] |= MARKED
    return bits
