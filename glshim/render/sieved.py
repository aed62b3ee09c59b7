"""The elements that a sieve leaves of a recovered mesh: their numbers as a texture, and indices of
triangles with adjacency."""

from __future__ import annotations

from collections.abc import Hashable

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.edge_mesh import EdgeMesh
from glshim.geometry.recovery.halfedges import twins, with_adjacency
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.sieve import EdgeSieve
from glshim.render.driver import gl
from glshim.render.uploads import Indices, delete, upload
from glshim.styling.passes import Element, Sieve

UNIT = 12
"""Texture unit of the numbers."""
Ints = NDArray[np.int32]


def adjacency_of(mesh: Mesh) -> Ints:
    """(T, 6) the triangles of a mesh with their neighbours' vertices."""
    return with_adjacency(mesh.triangles, twins(mesh))


class Sieved:
    """Of one mesh, for the last eye that looked. Use it inside the guard."""

    def __init__(self, mesh: Mesh, edges: EdgeMesh) -> None:
        self._source = mesh, edges
        self._sieve: EdgeSieve | None = None
        self._last: Hashable = None
        self._adjacency: Ints | None = None
        self._indices: Indices | None = None
        self._texture = self._count = 0

    def bind(self, eye: NDArray[np.float64], sieve: Sieve, element: Element) -> int:
        """Bind the texture of the elements that remain at `UNIT`, and of triangles their indices to
        the vertex array; how many those are."""
        key = eye.tobytes(), sieve, element
        if key != self._last:
            if self._sieve is None:
                self._sieve = EdgeSieve(*self._source)
            rows = self._sieve.candidates(eye, sieve.wanted, sieve.angles)
            if element == "adjacency":
                rows = self._triangles(rows)
            self._forget()
            texels = np.zeros((len(rows), 4), np.int32)
            texels[:, 0] = rows
            self._texture, self._count, self._last = upload(texels), len(rows), key
        if element == "adjacency" and self._indices is not None:
            self._indices.bind()
        gl.glActiveTexture(0x84C0 + UNIT)
        gl.glBindTexture(0x0DE1, self._texture)
        return self._count

    def _triangles(self, rows: Ints) -> Ints:
        """The triangles at edges (rows of the edge mesh), and their indices."""
        mesh, edges = self._source
        if self._adjacency is None:
            self._adjacency = adjacency_of(mesh)
        if self._indices is None:
            self._indices = Indices()
        here = np.zeros(len(mesh.triangles) + 1, np.bool_)  # the last one is none, -1
        here[mesh.faces[edges.rows[rows]]] = True
        found = np.flatnonzero(here[:-1]).astype(np.int32)
        self._indices.fill(self._adjacency.take(found, axis=0))
        return found

    def _forget(self) -> None:
        if self._texture:
            delete((self._texture,))
            self._texture, self._last = 0, None

    def free(self) -> None:
        """Delete what it made."""
        self._forget()
        if self._indices is not None:
            self._indices.free()
            self._indices = None
