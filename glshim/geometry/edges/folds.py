"""How the triangles of a mesh meet: what only connectivity decides, and the angles between them."""

from __future__ import annotations

from collections.abc import Hashable
from functools import cached_property

import numpy as np

from glshim.geometry.edges.edges import dihedral
from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.mesh import Mesh
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.camera import cofactors
from glshim.model.vectors import cross, dot, unit

FLAT = 2e-3
"""Sine of the angle between two parts of a polygon under which their common side is no edge."""
_GRAIN = 1e-5
"""By which the cosine of an angle may miss a threshold: the angle itself decides then."""
_ALIKE = 1e-9
"""Relative difference of two spaces in which angles are taken to be the same."""


class Topology:
    """What of a mesh's edges stays when its positions move."""

    def __init__(self, mesh: Mesh) -> None:
        self.triangles: Indices = mesh.triangles
        """(T, 3) vertices. The very array, by which meshes that moved are found again."""
        self.edges: Indices = mesh.edges
        """(E, 2) vertices."""
        self.a: Rows = mesh.faces[:, 0].astype(np.intp)
        """(E,) triangle A of each edge."""
        alone = mesh.faces[:, 1] < 0
        self.b: Rows = np.where(alone, mesh.faces[:, 0], mesh.faces[:, 1]).astype(np.intp)
        """(E,) triangle B, or A where there is none."""
        self.alone: Flags = alone
        """(E,) A has no B."""
        self.twisted: Flags = mesh.twisted
        self.inner: Flags = ~mesh.true
        """(E,) sides inside of polygons."""
        self.single_sided: Flags = mesh.closed[mesh.faces[:, 0]]
        """(E,) the component is closed: only the side that the app calls front may be seen."""
        self.components: Indices = mesh.components
        """(T,) which hang together."""
        self.closed: Flags = mesh.closed
        """(T,) their component is closed."""
        listed = mesh.marked
        self.plain: Flags = ~alone & ~listed
        """(E,) edges of two triangles that what these are decides about."""
        self.marked_rows: Rows = np.flatnonzero(listed)
        self.open_rows: Rows = np.flatnonzero(alone & mesh.true)
        """Boundary edges. A side inside a polygon that has lost its other part is none."""
        self.name: Hashable = object()
        """What names an object, whatever the order it comes in and however it moves."""
        self._parted: tuple[Flags, Indices, Indices] | None = None

    @cached_property
    def folding(self) -> Rows:
        """(N,) edges that may be creases."""
        return np.flatnonzero(self.plain & ~self.inner)

    def parted(self, creases: Flags) -> tuple[Indices, Indices]:
        """The mesh cut open at creases (E,): (T, 3) triangles of new vertices, a vertex for each
        piece that it belongs to, and (C,) which corner, of all (3 T), the new vertices are."""
        known = self._parted
        if known is None or not np.array_equal(known[0], creases):
            whole = np.flatnonzero(~self.alone & ~creases & ~self.twisted)
            ends = self.edges[whole]
            one, other = (
                np.concatenate([self.corner(of[whole], ends[:, k]) for k in (0, 1)])
                for of in (self.a, self.b)
            )
            found = components(self.triangles.size, one, other)
            known = self._parted = (creases, found.label.reshape(-1, 3), found.first)
        return known[1], known[2]

    def corner(self, triangle: Rows, vertex: Indices) -> Indices:
        """(N,) the number of a vertex's corner in its triangle, of all corners."""
        at = self.triangles[triangle] == vertex[:, None]
        return np.asarray(3 * triangle + at.argmax(axis=1), np.int32)


class Folds:
    """The dihedral angles of a mesh in object space, or in the space that a linear part leads to.

    Only those of edges that fold by something are ever measured."""

    def __init__(
        self,
        topology: Topology,
        positions: Floats,
        normals: tuple[Doubles, Doubles],
        linear: Doubles | None,
    ) -> None:
        """normals (T, 3), unit: of the triangles, and of the polygons that they are of."""
        self._topology, self._positions = topology, positions
        self._linear = linear
        turn = None if linear is None else cofactors(linear).T
        self._parts, self._wholes = (
            own if turn is None else unit(own @ turn) for own in normals
        )
        self._beyond: dict[float, tuple[Rows, Doubles]] = {}

    def holds(self, linear: Doubles | None) -> bool:
        """Whether angles are the same in the space of another linear part: it turns this one."""
        if linear is None or self._linear is None:
            return linear is self._linear
        one, other = (part.T @ part for part in (linear, self._linear))
        way = np.sign(np.linalg.det(linear)) == np.sign(np.linalg.det(self._linear))
        return bool(way and np.abs(one - other).max() <= _ALIKE * np.abs(other).max())

    def ends(self, rows: Rows) -> Doubles:
        """(N, 2, 3) both ends of edges, object space."""
        return self._positions[self._topology.edges[rows]].astype(np.float64)

    def dihedral(self, rows: Rows) -> Doubles:
        """(N,) `glshim.geometry.edges.edges.dihedral` of edges, from the winding side of A."""
        ends = self.ends(rows)
        along = ends[:, 1] - ends[:, 0]
        if self._linear is not None:
            along = along @ self._linear.T
        return dihedral(along, *self._both(rows, self._wholes))

    def sine(self, rows: Rows) -> Doubles:
        """(N,) of the angle between the normals of the triangles at edges."""
        product = cross(*self._both(rows, self._parts))
        return np.asarray(np.sqrt(dot(product, product)))

    def leaning(self, least: float) -> Flags:
        """(E,) whether normals differ by an angle of at least so many radians, 0..pi."""
        return np.asarray((self._cosines <= np.float32(np.cos(least))) & ~self._topology.alone)

    def beyond(self, least: float) -> tuple[Rows, Doubles]:
        """(N,) edges that may be creases and fold by more than an angle (radians, from flat) to
        either side, and (N,) their `dihedral` angles."""
        known = self._beyond.get(least)
        if known is None:
            rows = self._topology.folding
            bound = np.cos(np.clip(least, 0.0, np.pi)) + _GRAIN
            if least > 0.0:
                rows = rows[self._cosines[rows] < bound]
            known = self._beyond[least] = (rows, self.dihedral(rows))
        return known

    @cached_property
    def _cosines(self) -> Floats:
        """(E,) of the angles between the normals of all edges."""
        normals = self._wholes.astype(np.float32)
        one, other = (normals.take(side, axis=0) for side in (self._topology.a, self._topology.b))
        found = np.einsum("ei,ei->e", one, other)
        return np.asarray(np.where(self._topology.twisted, -found, found))

    def _both(self, rows: Rows, normals: Doubles) -> tuple[Doubles, Doubles]:
        """(N, 3), (N, 3) unit normals of A, and of B as if it wound as A does."""
        one, other = (normals[side[rows]] for side in (self._topology.a, self._topology.b))
        return one, np.where(self._topology.twisted[rows, None], -other, other)
