"""From a recovered mesh to the records of its feature lines: what the CPU decides.

McGuire & Hughes 2004, equation 1, as in `glshim.geometry.edge_mesh`, whose `features` is the oracle
of the GPU. Here only the edges that are features go on, in the records that every line shader reads
(`glshim.geometry.lines.RECORD`): strokes that know the next one, so that joins cannot fail.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera, cofactors
from glshim.geometry.chains import Pattern, measure
from glshim.geometry.coherence import Drawn, Past, follow, keep
from glshim.geometry.edge_mesh import EdgeMesh, edge_mesh
from glshim.geometry.edges import dihedral
from glshim.geometry.lines import (
    BOUNDARY,
    CONTOUR,
    FIN,
    GROUP,
    HOLLOW,
    MARKED,
    RECORD,
    RIDGE,
    RING,
    SHARP,
    VALLEY,
    are_similarities,
    group_of,
    run_on,
)
from glshim.geometry.mesh import Mesh
from glshim.geometry.smooth_lines import SmoothPieces
from glshim.geometry.vectors import Doubles, unit

Floats = NDArray[np.float32]
Flags = NDArray[np.bool_]
Rows = NDArray[np.intp]


@dataclass(frozen=True, slots=True)
class Features:
    """Which feature edges a style wants."""

    contours: bool
    ridge_angle: float | None
    """A ridge's dihedral angle is less, radians; None for no ridges."""
    valley_angle: float | None
    """A valley's dihedral angle is more, radians; None for no valleys."""
    marked: bool = False
    boundary: bool = False
    smooth: bool = False
    """Whether contours on smooth surfaces run through polygons, where interpolated normals are
    perpendicular to the view, rather than along edges."""
    suggestive: bool = False
    """Suggestive contours."""
    tolerance: float = 0.0
    """Distance in object units at which positions count as one vertex."""
    pattern: Pattern | None = None
    """What repeats along strokes, or None."""


class EdgeLines:
    """What of a mesh's edges does not depend on the viewer."""

    def __init__(self, mesh: Mesh) -> None:
        self.mesh = mesh
        self.edges: EdgeMesh = edge_mesh(mesh)
        rows = self.edges.rows
        self.a, b = mesh.faces[rows].T.astype(np.intp)
        self.open = b < 0
        """(E,) boundary edges."""
        self.b = np.where(self.open, self.a, b)
        v0, _, v2, v3 = self.edges.indices.T
        self.ends = mesh.edges[rows]
        self.inner = v2 < 0
        self.marked = (v3 == self.ends[:, 1]) & ~self.open
        self.plain = ~self.open & ~self.marked
        self.single_sided = v0 >= 0
        """(E,) the component is closed: only the side that the app calls front may be seen."""
        self.twisted = mesh.twisted[rows]

    @cached_property
    def planes(self) -> Doubles:
        """(T, 4) the unit normal of each triangle, minus its product with a corner."""
        corner = self.mesh.positions[self.mesh.triangles[:, 0]].astype(np.float64)
        normals: Doubles = self.mesh.normals
        return np.asarray(np.c_[normals, -np.einsum("ti,ti->t", normals, corner)])

    @cached_property
    def folds(self) -> Doubles:
        """(E,) `dihedral` angles from the winding side of A, object space."""
        return self.folds_in(None)

    @cached_property
    def sharp(self) -> Flags:
        """(E,) folds at which no smooth surface goes on."""
        return np.asarray(np.abs(self.folds - np.pi) >= np.pi - SHARP)

    @cached_property
    def pieces(self) -> SmoothPieces:
        """The mesh cut open at its creases."""
        creases = np.zeros(len(self.mesh.edges), np.bool_)
        creases[self.edges.rows] = self.sharp
        return SmoothPieces(self.mesh, creases)

    def folds_in(self, linear: Doubles | None) -> Doubles:
        """The same in the space that a linear part (3, 3) leads to."""
        along = self.mesh.positions[self.ends].astype(np.float64)
        along = along[:, 1] - along[:, 0]
        one, other = self.mesh.normals[self.a], self.mesh.normals[self.b]
        other = np.where(self.twisted[:, None], -other, other)
        if linear is not None:
            turn = cofactors(linear)
            one, other, along = unit(one @ turn.T), unit(other @ turn.T), along @ linear.T
        return dihedral(along, one, other)

    def found(self, modelview: Doubles, camera: Camera, wanted: Features) -> Floats:
        """(L, 18) records of the features as a camera sees them, of an object under a modelview.
        Outlines do not know yet where they go on."""
        seen = _Seen(self, modelview, camera)
        pieces = []
        contours = self.plain & (seen.ccw_a != seen.ccw_b)
        if wanted.contours:
            rows = np.flatnonzero(contours)
            folds = self.folds[rows]
            if wanted.smooth:
                rows = rows[self.sharp[rows]]
                folds = self.folds[rows]
                pieces.append(self.pieces.contours(modelview, camera))
            shape = np.select([folds <= SHARP, folds <= np.pi], [RING, CONTOUR], HOLLOW)
            pieces.append(seen.records(rows, shape, outline=True))
        creases = self.plain & ~contours & ~self.inner
        for angle, kind in ((wanted.ridge_angle, RIDGE), (wanted.valley_angle, VALLEY)):
            if angle is not None:
                apt = seen.folds < angle if kind == RIDGE else seen.folds > angle
                pieces.append(seen.records(np.flatnonzero(creases & apt), kind))
        if wanted.marked:
            rows = np.flatnonzero(self.marked)
            pieces.append(seen.records(rows, RIDGE + GROUP * (MARKED - 3)))
        if wanted.boundary:
            rows = np.flatnonzero(self.open)
            pieces.append(seen.records(rows, FIN + GROUP * (BOUNDARY - 3), outline=True))
        if wanted.suggestive:
            pieces.append(self.pieces.suggestive(modelview, camera))
        return np.concatenate(pieces) if pieces else np.empty((0, RECORD), np.float32)


class _Seen:
    """Edges as a camera sees them."""

    def __init__(self, lines: EdgeLines, modelview: Doubles, camera: Camera) -> None:
        self._lines = lines
        placed = camera.under(modelview)
        self._camera = placed
        self._ccw: Flags = lines.planes @ placed.object_centre > 0.0
        self.ccw_a: Flags = self._ccw[lines.a]
        self.ccw_b: Flags = self._ccw[lines.b] != lines.twisted
        """(E,) whether A, and B if it wound as A does, winds counter-clockwise in the window."""

    @property
    def folds(self) -> Doubles:
        """(E,) dihedral angles from the side that the app calls front, or in open components from
        the side that is seen. Eye space."""
        lines, camera = self._lines, self._camera
        if are_similarities(camera.modelview[None])[0]:
            folds, mirrored = lines.folds, camera.mirrored
        else:
            folds = lines.folds_in(camera.modelview[:3, :3])
            mirrored = float(np.linalg.det(camera.projection)) > 0.0
        ahead = np.where(lines.single_sided, camera.front_ccw, self.ccw_a) != mirrored
        return np.where(ahead, folds, 2.0 * np.pi - folds)

    def records(self, rows: Rows, kind: int | Rows, *, outline: bool = False) -> Floats:
        """Records of edges; of an outline with the normal of its back-facing triangle."""
        lines, modelview = self._lines, self._camera.modelview
        found = np.zeros((len(rows), RECORD), np.float32)
        ends = lines.mesh.positions[lines.ends[rows]] @ modelview[:3, :3].T + modelview[:3, 3]
        turned = ~self.ccw_a[rows]
        ends[turned] = ends[turned, ::-1]
        found[:, 0:6] = ends.reshape(-1, 6)
        found[:, 6:9] = ends[:, 1]
        a, b = lines.a[rows], lines.b[rows]
        own = np.where(self._ccw[a] == self._camera.front_ccw, b, a) if outline else a
        turn = cofactors(modelview)
        normals = unit(lines.mesh.normals[own] @ turn.T)
        normals[~self._ccw[own]] *= -1.0
        found[:, 9:12] = normals
        if not outline:
            found[:, 12:15] = unit(lines.mesh.normals[b] @ turn.T)
        found[:, 15] = kind
        return found


def feature_lines(
    objects: Sequence[tuple[EdgeLines, Doubles]],
    camera: Camera,
    wanted: Features,
    past: Past | None = None,
) -> tuple[Floats, Past | None]:
    """(L, 18) float32 records of the features of objects, each under its modelview (4, 4), eye
    space. The camera's own modelview counts for nothing. With a pattern also what the next frame's
    patterns follow; past is what the frame before gave."""
    found = [lines.found(modelview, camera, wanted) for lines, modelview in objects]
    whole = np.concatenate(found) if found else np.empty((0, RECORD), np.float32)
    run_on(whole)
    if wanted.pattern is None:
        return whole, None
    group = group_of(whole)
    walk = measure(whole[:, 0:3], whole[:, 3:6], group, camera, wanted.pattern)
    owner = np.repeat(np.arange(len(found)), [len(part) for part in found])
    named = tuple((number, modelview) for number, (_, modelview) in enumerate(objects))
    a, b = (whole[:, at : at + 3].astype(np.float64) for at in (0, 3))
    drawn = Drawn(walk, a, b, group, owner, named)
    if past is not None:
        drawn = replace(drawn, walk=follow(drawn, camera, past))
    turns = np.floor(drawn.walk.begin)
    whole[:, 16], whole[:, 17] = drawn.walk.begin - turns, drawn.walk.finish - turns
    return whole, keep(drawn)
