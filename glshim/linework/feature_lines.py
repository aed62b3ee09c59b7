"""From a recovered mesh to the records of its feature lines: what the CPU decides.

McGuire & Hughes 2004, equation 1, as in `glshim.geometry.meshshaders.edge_mesh`, whose
`features` is the oracle of the GPU. Here only the edges that are features go on, in the records
that every line shader reads (`glshim.model.lines.Line`): strokes that know the next one, so that
joins cannot fail.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from glshim.geometry.edges.edges import Edges
from glshim.geometry.edges.folds import FLAT, Folds, Topology
from glshim.geometry.edges.gather import Placement
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.outward import signs_of
from glshim.linework.coherence import Past
from glshim.linework.hand import own_numbers
from glshim.linework.patterns import lay_pattern
from glshim.linework.polygon_lines import (
    SHARP,
    Seen,
    are_similarities,
    run_on,
    seams_of,
    shared_edge_lines,
    single_side_lines,
)
from glshim.linework.side_by_side import mark, mark_shared
from glshim.linework.smooth_lines import SmoothPieces
from glshim.linework.steady import MARGIN, Creases
from glshim.linework.touching import Touching, sharp_sides, touching
from glshim.model.arrays import Doubles, Flags, Floats, Rows
from glshim.model.camera import Camera, cofactors
from glshim.model.dihedral import GRAIN, is_ridge, is_valley
from glshim.model.lines import (
    BOUNDARY,
    CONTOUR,
    FIN,
    HOLLOW,
    MARKED,
    RECORD,
    RIDGE,
    RING,
    VALLEY,
    Line,
    in_group,
    no_lines,
)
from glshim.model.vectors import dot, unit
from glshim.styling.wishes import Choice, Features


@dataclass(frozen=True, slots=True, eq=False)
class Decided:
    """Edges that are features, by row of the mesh's edges."""

    contours: Rows
    ridges: Rows
    valleys: Rows
    marked: Rows
    boundary: Rows


class EdgeLines:
    """What of a mesh's edges does not depend on the viewer."""

    def __init__(
        self, mesh: Mesh, topology: Topology | None = None, creases: Creases | None = None
    ) -> None:
        """topology, creases: of a mesh that this one is `Mesh.moved` from. The mesh itself is not
        held."""
        self.topology = topology or Topology(mesh)
        self.moved = creases is not None
        self.creases = creases or Creases()
        self.positions = mesh.positions
        self.normals: Doubles = mesh.normals
        self._wholes: Doubles = mesh.polygon_normals
        self._spaces: dict[bool, Folds] = {}

    @cached_property
    def planes(self) -> Doubles:
        """(T, 4) the unit normal of each triangle, minus its product with a corner."""
        corner = self.positions[self.topology.triangles[:, 0]].astype(np.float64)
        return np.asarray(np.c_[self.normals, -dot(self.normals, corner)])

    @cached_property
    def pieces(self) -> SmoothPieces:
        """The mesh cut open at its creases."""
        return SmoothPieces(self.topology, self.positions, self.normals, self.folds(None))

    @cached_property
    def sharp(self) -> Rows:
        """(S,) edges of two triangles that are no contours of a smooth surface."""
        return np.flatnonzero(self.folds(None).leaning(np.pi - SHARP) & self.topology.plain)

    @cached_property
    def outward(self) -> Doubles:
        """(T,) +1 where normals point out of a solid, -1 where they point into it, 0 of open
        surfaces."""
        topology = self.topology
        corners = self.positions[topology.triangles].astype(np.float64)
        signs = signs_of(corners, topology.components)[topology.components]
        return np.asarray(np.where(topology.closed, signs, 0.0))

    def folds(self, linear: Doubles | None) -> Folds:
        """The dihedral angles in object space, or in the space that a linear part (3, 3) leads
        to, which are kept: objects that only turn keep their angles."""
        skewed = linear is not None
        known = self._spaces.get(skewed)
        if known is None or not known.holds(linear):
            known = self._spaces[skewed] = Folds(
                self.topology, self.positions, (self.normals, self._wholes), linear
            )
        return known

    def decided(self, modelview: Doubles, camera: Camera, wanted: Features) -> Decided:
        """Which edges are features as a camera sees them, of an object under a modelview."""
        return _Seen(self, camera.under(modelview)).decided(wanted)

    def records(
        self,
        modelview: Doubles,
        camera: Camera,
        wanted: Features,
        touching: Touching | None = None,
    ) -> Floats:
        """(L, 21) records of the features as a camera sees them, of an object under a modelview
        that touches others. Outlines do not know yet where they go on."""
        seen = _Seen(self, camera.under(modelview), touching)
        edges = seen.decided(wanted)
        pieces = []
        if wanted.contours:
            smooth = (
                self.pieces.contours(modelview, camera, touching) if wanted.smooth else None
            )
            if smooth is None:
                rows = edges.contours
                angles = self.folds(None).dihedral(rows)
                shape = np.select([angles <= SHARP, angles <= np.pi], [RING, CONTOUR], HOLLOW)
                smooth = seen.records(rows, shape, outline=True)
            pieces.append(smooth)
        pieces.append(seen.records(edges.ridges, RIDGE))
        pieces.append(seen.records(edges.valleys, VALLEY))
        pieces.append(seen.records(edges.marked, in_group(RIDGE, MARKED)))
        pieces.append(seen.records(edges.boundary, in_group(FIN, BOUNDARY), outline=True))
        if wanted.suggestive:
            suggestive = self.pieces.suggestive(modelview, camera)
            pieces += [] if suggestive is None else [suggestive]
        return np.concatenate(pieces)

    def rims(self, modelview: Doubles) -> Edges:
        """The boundary edges in eye space, which do not know each other yet."""
        rows = self.topology.open_rows
        ends = self.positions[self.topology.edges[rows]] @ modelview[:3, :3].T + modelview[:3, 3]
        normals = unit(self.normals[self.topology.a[rows]] @ cofactors(modelview).T)
        each, nothing = np.arange(len(rows), dtype=np.int32), np.empty(0, np.intp)
        sides = ends.reshape(-1, 6).astype(np.float32)
        return Edges(
            sides, each, np.c_[normals, -dot(normals, ends[:, 0])], normals,
            each.astype(np.intp), nothing, nothing, np.empty(0, np.bool_),
        )  # fmt: skip


class _Seen:
    """Edges as a camera sees them; its modelview is theirs."""

    def __init__(
        self, lines: EdgeLines, camera: Camera, touching: Touching | None = None
    ) -> None:
        self._lines, self._camera, self._touching = lines, camera, touching
        self._ccw: Flags = lines.planes @ camera.object_centre > 0.0
        topology = lines.topology
        self.ccw_a: Flags = self._ccw[topology.a]
        """(E,) whether A winds counter-clockwise in the window."""
        self._apart: Flags = self.ccw_a != self._ccw[topology.b]
        self._apart ^= topology.twisted
        self._apart &= topology.plain

    def decided(self, wanted: Features) -> Decided:
        """Equation 1."""
        topology = self._lines.topology
        none = np.empty(0, np.intp)
        return Decided(
            self._contours() if wanted.contours else none,
            self._ridges(wanted.ridge_angle),
            self._valleys(wanted.valley_angle),
            topology.marked_rows if wanted.marked else none,
            topology.open_rows if wanted.boundary else none,
        )

    def _contours(self) -> Rows:
        """(N,) edges between triangles of unlike facing; of the sides inside polygons those at
        which these are bent."""
        rows = np.flatnonzero(self._apart)
        inner = np.flatnonzero(self._lines.topology.inner[rows])
        if not len(inner):
            return rows
        flat = self._lines.folds(None).sine(rows[inner]) <= FLAT
        return np.delete(rows, inner[flat])

    def _ridges(self, angle: float | None) -> Rows:
        """(N,) edges, see `is_ridge`."""
        if angle is None:
            return np.empty(0, np.intp)
        rows, angles = self._dihedral(np.pi - angle - GRAIN - self._margin)
        found = self._steady("ridge", angle, rows, lambda far: is_ridge(angles, angle - far))
        return rows[found & ~self._apart[rows]]

    def _valleys(self, angle: float | None) -> Rows:
        """(N,) edges, see `is_valley`."""
        if angle is None:
            return np.empty(0, np.intp)
        rows, angles = self._dihedral(angle + GRAIN - np.pi - self._margin)
        found = self._steady("valley", angle, rows, lambda far: is_valley(angles, angle + far))
        return rows[found & ~self._apart[rows]]

    @property
    def _margin(self) -> float:
        """Radians by which edges are looked at that are no creases yet, or any more."""
        return float(MARGIN) if self._lines.moved else 0.0

    def _steady(
        self, kind: str, angle: float, rows: Rows, at: Callable[[float], Flags]
    ) -> Flags:
        """(N,) see `Creases.decided`."""
        lines = self._lines
        return lines.creases.decided((kind, angle), rows, at, moved=lines.moved)

    def _dihedral(self, least: float) -> tuple[Rows, Doubles]:
        """(N,) edges that fold by more than an angle (radians, from flat), and (N,) their dihedral
        angles from the side that the app calls front, or in open components from the side that is
        seen. Eye space."""
        camera, topology = self._camera, self._lines.topology
        if are_similarities(camera.modelview[None])[0]:
            folds, mirrored = self._lines.folds(None), camera.mirrored
        else:
            folds = self._lines.folds(camera.modelview[:3, :3])
            mirrored = float(np.linalg.det(camera.projection)) > 0.0
        rows, angles = folds.beyond(least)
        ahead = np.where(topology.single_sided[rows], camera.front_ccw, self.ccw_a[rows])
        return rows, np.where(ahead != mirrored, angles, 2.0 * np.pi - angles)

    def records(self, rows: Rows, kind: int | Rows, *, outline: bool = False) -> Floats:
        """Records of edges, but of those inside what touches; of an outline with the normal of
        its back-facing triangle."""
        if self._touching is not None:
            kept = ~self._touching.inside[rows]
            rows, kind = rows[kept], kind if isinstance(kind, int) else kind[kept]
        lines, modelview = self._lines, self._camera.modelview
        topology = lines.topology
        records = np.zeros((len(rows), RECORD), np.float32)
        ends = lines.positions[topology.edges[rows]] @ modelview[:3, :3].T + modelview[:3, 3]
        turned = ~self.ccw_a[rows]
        ends[turned] = ends[turned, ::-1]
        with np.errstate(over="ignore"):
            records[:, Line.ENDS] = ends.reshape(-1, 6)
            records[:, Line.ONWARD] = ends[:, 1]
        a, b = topology.a[rows], topology.b[rows]
        own = np.where(self._ccw[a] == self._camera.front_ccw, b, a) if outline else a
        turn = cofactors(modelview)
        normals = unit(lines.normals[own] @ turn.T)
        normals[~self._ccw[own]] *= -1.0
        records[:, Line.NORMAL] = normals
        if not outline:
            records[:, Line.OTHER_NORMAL] = unit(lines.normals[b] @ turn.T)
        records[:, Line.KIND] = kind
        if self._touching is not None:
            mark(records, self._touching.shared[rows])
        records[:, Line.NUMBER] = own_numbers(rows)
        return records


def feature_lines(
    objects: Sequence[tuple[EdgeLines, Doubles]],
    camera: Camera,
    wanted: Features,
    past: Past | None = None,
) -> tuple[Floats, Past | None]:
    """(L, 21) float32 records of the features of objects, each under its modelview (4, 4), eye
    space. The camera's own modelview counts for nothing. With a pattern also what the next frame's
    patterns follow; past is what the frame before gave."""
    own = replace(wanted, boundary=False)
    touches = touching(objects) if len(objects) > 1 else [None] * len(objects)
    parts = [
        _sound(lines.records(modelview, camera, own, touch))
        for (lines, modelview), touch in zip(objects, touches, strict=True)
    ]
    owner = np.repeat(np.arange(len(parts)), [len(part) for part in parts])
    across, whose = _across(objects, camera, wanted)
    sound = np.isfinite(across).all(axis=1)
    across, whose = across[sound], whose[sound]
    if len(objects) > 1 and len(across):
        mark_shared(across, sharp_sides(objects))
    whole = np.concatenate((*parts, across))
    run_on(whole)
    if wanted.pattern is None:
        return whole, None
    modelviews = (modelview for _, modelview in objects)
    placed = tuple(zip(names_of(objects), modelviews, strict=True))
    owner = np.concatenate((owner, whose))
    return whole, lay_pattern(whole, owner, placed, camera, wanted.pattern, past=past)


def _across(
    objects: Sequence[tuple[EdgeLines, Doubles]], camera: Camera, wanted: Features
) -> tuple[Floats, Rows]:
    """(L, 21) records of the edges that boundary edges make with each other, whatever objects they
    are of: a program may cut a shape into pieces that it moves into place. Of those that stay alone
    the boundary, and the fold where they stand on another surface (Raskar 2001, sections 2.2, 2.3).
    And (L,) the object of each, by number."""
    rims = [lines.rims(modelview) for lines, modelview in objects]
    if not sum(map(len, rims)):
        return no_lines(), np.empty(0, np.intp)
    seams = seams_of(rims)
    seen = Seen(seams, Placement.one(np.eye(4), len(seams.planes)), camera)
    choice = Choice(
        silhouettes=wanted.contours,
        ridge_angle=wanted.ridge_angle,
        valley_angle=wanted.valley_angle,
    )
    folds = single_side_lines(seams.singles, seen, replace(choice, silhouettes=False))
    records, sides = seen.records_of_sides(shared_edge_lines(seams, seen, choice) + folds)
    if wanted.boundary:
        alone, own = seen.records_of_sides([(FIN, seams.singles, None)])
        alone[:, Line.KIND] = in_group(FIN, BOUNDARY)
        records, sides = np.concatenate((records, alone)), np.append(sides, own)
    # A rim's sides are polygons of their own, one after the other.
    lasts = np.cumsum([len(rim) for rim in rims])
    return records, np.searchsorted(lasts, seams.polygon[sides], "right")


def names_of(objects: Sequence[tuple[EdgeLines, Doubles]]) -> tuple[Hashable, ...]:
    """What objects are: their connectivity, which stays when they move."""
    return tuple(lines.topology.name for lines, _ in objects)


def _sound(records: Floats) -> Floats:
    """Those that float32 can hold."""
    finite = np.isfinite(records).all(axis=1)
    return records if finite.all() else records[finite]
