"""Connectivity recovered from a stream of polygons: what is one vertex, and who meets at an edge.

McGuire & Hughes 2004, figure 2 and section 3: an edge (v0, v1), its faces A = (v0, v1, v2) and
B = (v3, v1, v0). The edge mesh is made of these.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.recovery.adjacency import Adjacency, Sides, adjacency, meet, repeated
from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.cutting import Blend, Joints, cut_at_junctions, rims_welded
from glshim.geometry.recovery.fans import Fans, fans
from glshim.geometry.recovery.welding import weld
from glshim.model.arrays import Doubles, Flags, Floats, Indices
from glshim.model.batch import PolygonBatch
from glshim.model.vectors import cross, dot, unit

__all__ = ["Mesh", "Report", "mesh", "weld"]


_TOPOLOGY = ("components", "closed", "rim", "report")
"""What is derived from the connectivity alone, so that a moved mesh takes it along."""
_POSED = (*_TOPOLOGY, "_area_vectors", "normals", "polygon_normals", "vertex_normals")
"""And what its positions are enough for."""


@dataclass(frozen=True, slots=True)
class Report:
    """Counts of a mesh: a diagnosis in one line. Vertices are those that triangles use; edges
    that several triangles share, even more than two, count once."""

    vertices: int
    triangles: int
    edges: int
    boundary: int
    non_manifold: int
    turned: int
    twisted: int
    components: int
    closed: int

    def __str__(self) -> str:
        return (
            f"{self.vertices} vertices, {self.triangles} triangles, {self.edges} edges "
            f"({self.boundary} boundary, {self.non_manifold} non-manifold, {self.twisted} "
            f"twisted), {self.turned} triangles turned, {self.components} components "
            f"({self.closed} closed)"
        )


@dataclass(frozen=True, eq=False)
class Mesh:
    """Welded vertices, oriented triangles and their edges. Object space.

    Windings agree over every edge of two triangles, but for those that are `twisted`.
    """

    positions: Floats
    """(V, 3) the vertices."""
    weld: Indices
    """(N,) vertex of each position of the batch."""
    first: Indices
    """(V,) the position of the batch that stands for each vertex."""
    slack: float
    """How far a position may be from its vertex's: the tolerance, or the length of a chain."""
    tolerance: float
    """Absolute, object units, that positions were welded with."""
    triangles: Indices
    """(T, 3) vertices. Polygons are fans from their first corner; what has no area is left out,
    and a triangle that came again with the same winding."""
    polygon: Indices
    """(T,) polygon of each triangle in the batch."""
    flat: Indices
    """(F, 3) vertices of triangles that were left out: without area, or not finite."""
    edges: Indices
    """(E, 2) vertices v0, v1 as triangle A winds, in the order of the triangles A."""
    faces: Indices
    """(E, 2) triangles A and B, B = -1 where there is none. An edge of three triangles and more
    has a row for each, without B."""
    opposite: Indices
    """(E, 2) vertices v2 of A and v3 of B; without B, v3 = v0 (equation 1)."""
    halves: Indices
    """(E, 2) the halfedges of A and B: 3 t + k for the side from corner k of triangle t; without B,
    -1. A twisted edge's run the same way."""
    true: Flags
    """(E,) a true side of a polygon, of any there: no diagonal."""
    manifold: Flags
    """(E,) one or two triangles meet here."""
    turned: Flags
    """(T,) wound against the app's winding, for the majority of the neighbours' sake."""
    twisted: Flags
    """(E,) A and B both wind v0 to v1: no winding suits the component (a Moebius strip)."""
    regions: NDArray[np.uint32] | None = None
    """(T,) the colour of each triangle by number, 0 where it is not known (`PolygonBatch`)."""
    corners: Indices | None = None
    """(T, 3) corner of the batch that each corner of a triangle is; None without normals."""
    corner_normals: Floats | None = None
    """(T, 3, 3) the normal that the app sent at each corner of triangles, as sent, zero where it
    is not known (`PolygonBatch`). A triangle that was turned keeps those of its corners."""
    blend: Blend | None = None
    """With corners, where triangles were cut at vertices that lie on their sides."""
    joints: Joints | None = None
    """Which vertices lay on sides: their triangles are cut there. None: none did."""
    mixed: bool = False
    """The app winds polygons that have a whole side in common both ways. What only ends on
    another's side (a wall on a floor) may be wound as it likes."""

    @property
    def marked(self) -> Flags:
        """(E,) two triangles of known and different colours meet."""
        if self.regions is None:
            return np.zeros(len(self.edges), np.bool_)
        a, b = self.faces.T
        one, other = self.regions[a], self.regions[b]
        return np.asarray((b >= 0) & (one != other) & (one > 0) & (other > 0))

    @cached_property
    def _area_vectors(self) -> Doubles:
        points = self.positions.astype(np.float64)
        a, b, c = (points.take(corner, axis=0) for corner in self.triangles.T)
        return cross(b - a, c - a)

    @cached_property
    def normals(self) -> Doubles:
        """(T, 3) unit normals of the triangles; zero where a moved one has no area now."""
        with np.errstate(invalid="ignore", over="ignore"):
            return np.nan_to_num(unit(self._area_vectors), copy=False, posinf=0.0, neginf=0.0)

    @cached_property
    def polygon_normals(self) -> Doubles:
        """(T, 3) unit normals of the polygons that triangles are of: folds between bent polygons
        are those of the wholes, which programs light by one normal."""
        count = int(self.polygon.max(initial=-1)) + 1
        if len(self.triangles) <= count and (np.bincount(self.polygon) <= 1).all():
            return self.normals
        vectors = np.nan_to_num(self._area_vectors, posinf=0.0, neginf=0.0)
        total = [np.bincount(self.polygon, weights=axis, minlength=count) for axis in vectors.T]
        whole = unit(np.stack(total, axis=1))[self.polygon]
        # One half of a bow tie may cancel the other, and one part of it may lie the other way.
        sound = dot(whole, self.normals) > 0.0
        return np.where(sound[:, None], whole, self.normals)

    @cached_property
    def vertex_normals(self) -> Doubles:
        """(V, 3) unit normals: of the triangles' around, weighted by their angles (Thuermer &
        Wuethrich 1998). Zero where there is none."""
        total = np.zeros((3, len(self.positions)))
        points = self.positions.astype(np.float64)
        corners = [points.take(corner, axis=0) for corner in self.triangles.T]
        with np.errstate(invalid="ignore", over="ignore"):
            area = np.sqrt(dot(self._area_vectors, self._area_vectors))
            for k in range(3):
                here, ahead, behind = corners[k], corners[(k + 1) % 3], corners[(k + 2) % 3]
                angle = np.nan_to_num(np.arctan2(area, dot(ahead - here, behind - here)))
                for axis in range(3):
                    total[axis] += np.bincount(
                        self.triangles[:, k],
                        weights=angle * self.normals[:, axis],
                        minlength=len(points),
                    )
        return unit(np.ascontiguousarray(total.T))

    @cached_property
    def components(self) -> Indices:
        """(T,) which triangles hang together over edges of two; numbered from 0."""
        one, other = self.faces[self.faces[:, 1] >= 0].T
        return components(len(self.triangles), one, other).label

    @cached_property
    def closed(self) -> Flags:
        """(T,) the triangle's component has neither a boundary nor a non-manifold edge."""
        if not len(self.triangles):
            return np.zeros(0, np.bool_)
        ends = np.zeros(int(self.components.max()) + 1, np.bool_)
        ends[self.components[self.faces[self.faces[:, 1] < 0, 0]]] = True
        return np.asarray(~ends[self.components])

    @cached_property
    def rim(self) -> Indices:
        """(R,) vertices at the ends of edges without B."""
        on = np.zeros(len(self.positions), np.bool_)
        on[self.edges[self.faces[:, 1] < 0]] = True
        return np.flatnonzero(on).astype(np.int32)

    @cached_property
    def report(self) -> Report:
        """Counts."""
        used = np.zeros(len(self.positions), np.bool_)
        used[self.triangles] = True
        crowded = np.sort(self.edges[~self.manifold], axis=1).astype(np.int64)
        many = len(np.unique(crowded[:, 0] << np.int64(32) | crowded[:, 1]))
        labels = self.components
        return Report(
            vertices=int(used.sum()),
            triangles=len(self.triangles),
            edges=int(self.manifold.sum()) + many,
            boundary=int((self.manifold & (self.faces[:, 1] < 0)).sum()),
            non_manifold=many,
            turned=int(self.turned.sum()),
            twisted=int(self.twisted.sum()),
            components=int(labels.max(initial=-1)) + 1,
            closed=len(np.unique(labels[self.closed])),
        )

    @property
    def nbytes(self) -> int:
        """Memory of the arrays, the derived ones among them, for caches."""
        own = (getattr(self, field.name) for field in fields(self))
        derived = 53 * len(self.triangles) + 28 * len(self.positions)
        return sum(a.nbytes for a in own if isinstance(a, np.ndarray)) + derived

    def moved(self, positions: Floats, normals: Floats | None = None) -> Mesh | None:
        """The same connectivity with other positions (N, 3) and normals (C, 3) of a batch with the
        same polygons, and with normals if this one had some.

        None if what was one vertex is no longer, or if the positions would be connected
        otherwise: ends of open edges that meet now, triangles that were left out and have an area
        now. Triangles that have no area now stay. This mesh itself if nothing moved.
        """
        if len(positions) != len(self.weld) or (normals is None) != (self.corners is None):
            return None
        points = np.asarray(positions, np.float32)
        held = points.take(self.first, axis=0) + np.float32(0.0)
        probe = slice(0, 1024)  # most meshes that are not meant show it at once
        if not (self._held(points, held, probe) and self._held(points, held, slice(None))):
            return None
        if self.joints is not None and not self.joints.hold(held):
            return None
        given, before = _sent(normals, self.corners, self.blend), self.corner_normals
        same = given is None or before is None or np.array_equal(given, before, equal_nan=True)
        if np.array_equal(held, self.positions):
            return self if same else self._with(_POSED, corner_normals=given)
        rim = held[self.rim]
        if len(weld(rim, self.tolerance)[0]) < len(rim) or _area(held, self.flat).any():
            return None
        return self._with(_TOPOLOGY, positions=held, corner_normals=given)

    def _with(self, derived: Iterable[str], **changes: Floats | None) -> Mesh:
        """With other values of fields; what was derived from the rest is taken along."""
        found = replace(self, **changes)  # type: ignore[arg-type]
        found.__dict__.update({k: self.__dict__[k] for k in derived if k in self.__dict__})
        return found

    def _held(self, points: Floats, held: Floats, part: slice) -> bool:
        """Whether a part of the points (N, 3) lie at their vertices, held (V, 3)."""
        points, vertex = points[part], self.weld[part]
        there = held.take(vertex, axis=0)
        if np.array_equal(points, there):
            return True
        at = np.flatnonzero((points != there).any(axis=1))
        if self.slack > 0.0:
            with np.errstate(invalid="ignore", over="ignore"):
                apart = points[at].astype(np.float64) - there[at]
                at = at[~(dot(apart, apart) <= self.slack * self.slack)]
        # NaN differs from itself, which parts nothing where it stands for itself.
        return np.array_equal(self.first[vertex[at]], at + (part.start or 0))


def mesh(batch: PolygonBatch, tolerance: float = 0.0) -> Mesh:
    """The mesh that the polygons of a batch are.

    Positions weld where they are equal or no further apart than tolerance (object units); at sides
    that know no neighbour, also those that rounding parted (a seam computed twice). Triangles are
    cut where such a side runs along several others (`cutting`). Left out are triangles with fewer
    than three distinct vertices, without area, or not finite.
    """
    first, vertex = weld(batch.positions, tolerance)
    positions = np.asarray(batch.positions, np.float32)[first] + np.float32(0.0)
    drawn, flat, sides = _met(batch, vertex, positions)
    closer = rims_welded(drawn.triangles, positions, sides)
    if closer is not None:
        vertex = closer[vertex]
        drawn, flat, sides = _met(batch, vertex, positions)
    cut = cut_at_junctions(drawn, positions, sides, tolerance)
    sent = drawn, sides
    if cut is not None:
        drawn, sides = cut.drawn, meet(cut.drawn.triangles, len(positions))
    found = adjacency(drawn.triangles, drawn.true, sides)
    mixed = _is_mixed(found)
    if mixed and cut is not None:
        mixed = _is_mixed(adjacency(sent[0].triangles, sent[0].true, sent[1]))
    corners, blend = drawn.corners, None if cut is None else cut.blend
    if corners is not None and found.turned.any():
        corners = np.where(found.turned[:, None], corners[:, (0, 2, 1)], corners)
        blend = None if blend is None else blend.turned(found.turned)
    return Mesh(
        regions=None if batch.regions is None else batch.regions[drawn.polygon],
        corners=corners,
        corner_normals=_sent(batch.normals, corners, blend),
        blend=blend,
        joints=None if cut is None else cut.joints,
        mixed=mixed,
        positions=positions,
        weld=vertex,
        first=first,
        slack=(
            _slack(batch.positions, positions[vertex], tolerance)
            if tolerance > 0.0 or closer is not None
            else 0.0
        ),
        tolerance=tolerance,
        polygon=drawn.polygon,
        flat=flat,
        **found._asdict(),
    )


def _is_mixed(found: Adjacency) -> bool:
    return bool(found.turned.any() or found.twisted.any())


def _met(
    batch: PolygonBatch, vertex: Indices, positions: Floats
) -> tuple[Fans, Indices, Sides]:
    """The triangles of a batch, vertex (N,) being that of each position; those without area
    (F, 3); and which sides lie on one edge."""
    drawn = fans(batch, vertex)
    sound = _area(positions, drawn.triangles)
    flat = drawn.triangles[~sound]
    if len(flat):
        drawn = drawn.only(sound)
    sides = meet(drawn.triangles, len(positions))
    again = repeated(drawn.triangles, sides)
    if len(again):
        drawn = drawn.only(np.delete(np.arange(len(drawn.triangles)), again))
        sides = meet(drawn.triangles, len(positions))
    return drawn, flat, sides


def _sent(normals: Floats | None, corners: Indices | None, blend: Blend | None) -> Floats | None:
    """(T, 3, 3) the normals (C, 3) at corners (T, 3)."""
    if normals is None:
        return None
    found = normals[corners]
    return found if blend is None else blend.of(normals, found)


def _slack(points: Floats, held: Floats, tolerance: float) -> float:
    """The tolerance, or the longest way from a point (N, 3) to its vertex (N, 3)."""
    with np.errstate(invalid="ignore"):
        apart = points.astype(np.float64) - held
    ways = np.nan_to_num(dot(apart, apart), posinf=0.0)
    return max(tolerance, float(np.sqrt(ways.max(initial=0.0))))


def _area(positions: Floats, triangles: Indices) -> Flags:
    """(T,) which triangles have a finite area above zero. Exact for float32 corners of like
    size: however thin, a sliver keeps the surface together."""
    a, b, c = np.ascontiguousarray(triangles.T)
    with np.errstate(invalid="ignore", over="ignore"):
        x, y, z = (
            (axis.take(b) - start, axis.take(c) - start)
            for axis in np.ascontiguousarray(positions.T, np.float64)
            for start in [axis.take(a)]
        )
        area = np.abs(x[0] * y[1] - x[1] * y[0])
        area += np.abs(y[0] * z[1] - y[1] * z[0])
        area += np.abs(z[0] * x[1] - z[1] * x[0])
        return np.asarray((area > 0.0) & (area < np.inf))
