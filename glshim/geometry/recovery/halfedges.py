"""Halfedges: the sides of a mesh's triangles, and across each the triangle that it meets.

Halfedge 3 t + k runs from corner k of triangle t to the next corner. P. Rideout, "Silhouette
Extraction", 2010, "Computing Adjacency", has the same table with pointers.
"""

from __future__ import annotations

import numpy as np

from glshim.geometry.recovery.mesh import Mesh
from glshim.model.arrays import Indices


def twins(mesh: Mesh) -> Indices:
    """(3 T,) the halfedge on the other side of each, -1 where an edge has one triangle, or more
    than two. Of a twisted edge both run the same way."""
    found = np.full(mesh.triangles.size, -1, np.int32)
    met = np.flatnonzero(mesh.halves[:, 1] >= 0)
    one, other = (side.take(met) for side in mesh.halves.T)
    found[one], found[other] = other, one
    return found


def with_adjacency(triangles: Indices, twin: Indices) -> Indices:
    """(T, 6) what GL_TRIANGLES_ADJACENCY wants: the corners (T, 3), and after each the vertex
    across the side that begins there; where nothing is, that corner itself (a triangle without
    area). twin (3 T,) as `twins` gives it; triangles may have numbers of their own for corners."""
    corner = triangles.ravel()
    across = corner.reshape(-1, 3)[:, (2, 0, 1)].ravel()  # of side k: the corner before it
    found = np.empty((len(corner), 2), triangles.dtype)
    found[:, 0] = corner
    found[:, 1] = np.where(twin >= 0, across[twin], corner)
    return found.reshape(-1, 6)
