"""Smooth and suggestive contours of recovered meshes, with their creases kept.

McGuire & Hughes 2004, appendix A. Normals and curvatures are of the smooth pieces that creases part
a mesh into: what blends the two sides of a fold would say nothing about either.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from glshim.geometry.contour.contours import facing, suggestive_contours, zero_segments
from glshim.geometry.contour.curvature import (
    Curvature,
    curvature_derivatives,
    principal_curvatures,
    vertex_normals,
)
from glshim.geometry.edges.folds import Folds, Topology
from glshim.linework.polygon_lines import SHARP
from glshim.linework.side_by_side import mark
from glshim.linework.steady import View
from glshim.linework.touching import Touching
from glshim.model.arrays import Doubles, Floats, Indices, Rows
from glshim.model.camera import Camera, cofactors
from glshim.model.lines import (
    CONTOUR,
    HOLLOW,
    RECORD,
    RIDGE,
    RING,
    SUGGESTIVE,
    Line,
    in_group,
)
from glshim.model.vectors import cross, dot, unit

_BENT = 0.02
"""Sine of the angle between a polygon and the smooth surface from which it counts as bent."""
_BEFORE = 0.1
"""Share of that by which suggestive contours come nearer: they lie on what is seen."""
_NEAREST = 0.2
"""Share of the way to the viewer that lines come nearer at most."""


class SmoothPieces:
    """A mesh cut open at its creases."""

    def __init__(
        self, topology: Topology, positions: Floats, planes: Doubles, folds: Folds
    ) -> None:
        """positions (V, 3), unit normals (T, 3) and folds of a mesh, object space."""
        self._corners = positions[topology.triangles]
        self._planes, self._folds, self._topology = planes, folds, topology
        creases = folds.leaning(np.pi - SHARP)
        self.triangles: Indices
        """(T, 3) indices of `positions`: a vertex for each piece that it belongs to."""
        self.triangles, first = topology.parted(creases)
        self.positions: Floats = self._corners.reshape(-1, 3)[first]
        """(C, 3) object space."""
        self._creases = np.flatnonzero(creases)
        self._last = View()

    @cached_property
    def normals(self) -> Floats:
        """(C, 3) unit, object space."""
        return vertex_normals(self.positions, self.triangles).astype(np.float32)

    @cached_property
    def curvature(self) -> Curvature:
        """Principal curvatures at the vertices."""
        return principal_curvatures(self.positions, self.triangles, self.normals)

    @cached_property
    def derivatives(self) -> Floats:
        """(C, 4) of the curvatures."""
        return curvature_derivatives(self.positions, self.triangles, self.curvature)

    @cached_property
    def lift(self) -> Floats:
        """(C,) how far, in object units, the smooth surface's contours may lie behind the
        polygons: a polygon's width, none where they are flat."""
        sides = self._corners.astype(np.float64)
        sides = sides - sides[:, [1, 2, 0]]
        longest = np.sqrt((sides**2).sum(axis=2)).max(axis=1)
        area = cross(sides[:, 0], sides[:, 1])
        width = np.sqrt(dot(area, area)) / np.maximum(longest, 1e-300)
        found = np.zeros(len(self.positions), np.float32)
        for corner in self.triangles.T:
            bent = self.normals[corner] - self._planes
            share = np.minimum(np.sqrt(dot(bent, bent)) / _BENT, 1.0)
            np.maximum.at(found, corner, (share * width).astype(np.float32))
        return found

    @cached_property
    def _flanks(self) -> Indices:
        """(N, 2, 2) of creases, the vertices of A and of B at both ends."""
        rows, at = self._creases, self._topology
        ends = at.edges[rows]
        found = [[at.corner(of[rows], ends[:, k]) for k in (0, 1)] for of in (at.a, at.b)]
        return np.asarray(self.triangles.ravel()[np.array(found)].transpose(2, 0, 1))

    def contours(
        self, modelview: Doubles, camera: Camera, touching: Touching | None = None
    ) -> Floats | None:
        """(L, 21) records of smooth contours as outlines (Hertzmann & Zorin 2000), and of creases
        as far as the smooth surfaces on either side face unlike ways: contours of one end where
        those of the other go on. None without a viewer in object space."""
        eye = _eye(modelview, camera)
        if eye is None:
            return None
        front = facing(self.positions, self.normals, eye)
        found = zero_segments(self.positions, self.triangles, front)
        lift = found.interpolate(self.triangles, self.lift)
        view = _View(modelview, camera)
        smooth = self._records(found.ends, found.triangle, lift, view)
        smooth[:, Line.KIND] = CONTOUR
        return np.concatenate((smooth, self._folded(front, view, touching)))

    def _folded(self, front: Floats, view: _View, touching: Touching | None) -> Floats:
        """(L, 21) records of parts of creases, by which way the vertices face (C,)."""
        at, flanks = self._topology, self._flanks
        faces = front[flanks].astype(np.float64)
        faces[at.twisted[self._creases], 1] *= -1.0
        begins = (faces[:, 0, 0] >= 0.0) != (faces[:, 1, 0] >= 0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            share = faces[:, :, 0] / (faces[:, :, 0] - faces[:, :, 1])
        changes = (faces[:, :, 0] >= 0.0) != (faces[:, :, 1] >= 0.0)
        share = np.where(changes, np.clip(share, 0.0, 1.0), 1.0)
        cuts = np.c_[np.zeros(len(share)), np.sort(share, axis=1), np.ones(len(share))]
        apart = np.stack((begins, ~begins, begins), axis=1) & (cuts[:, :-1] < cuts[:, 1:])
        if touching is not None:
            apart &= ~touching.inside[self._creases, None]
        which, part = np.nonzero(apart)
        rows = self._creases[which]
        along = np.stack((cuts[which, part], cuts[which, part + 1]), axis=1)
        first = (mix(faces[which, 0], along).sum(axis=1) >= 0.0) != view.mirrored
        own = np.where(first == view.front_ccw, at.b[rows], at.a[rows])
        ends = self._folds.ends(rows)
        ends = ends[:, :1] + along[:, :, None] * (ends[:, 1:] - ends[:, :1])
        lift = mix(self.lift[flanks[which]].min(axis=1).astype(np.float64), along)
        # Where A faces away it lies at the right of the edge in the window.
        back = first == view.mirrored
        ends[back], lift[back] = ends[back, ::-1], lift[back, ::-1]
        found = self._records(ends, own, lift, view)
        angles = self._folds.dihedral(rows)
        found[:, Line.KIND] = np.select([angles <= SHARP, angles <= np.pi], [RING, CONTOUR], HOLLOW)
        if touching is not None:
            mark(found, touching.shared[rows])
        return found

    def suggestive(self, modelview: Doubles, camera: Camera) -> Floats | None:
        """(L, 21) records of suggestive contours (DeCarlo et al. 2003)."""
        eye = _eye(modelview, camera)
        if eye is None:
            return None
        found = suggestive_contours(
            self.positions, self.triangles, self.normals, self.curvature, eye,
            derivatives=self.derivatives, before=self._last.before(eye),
        )  # fmt: skip
        near = np.zeros(len(self.positions), np.bool_)
        near[self.triangles[found.triangle]] = True
        self._last.keep(eye, near)
        lift = found.interpolate(self.triangles, np.float32(_BEFORE) * self.lift)
        records = self._records(found.ends, found.triangle, lift, _View(modelview, camera))
        records[:, Line.OTHER_NORMAL] = records[:, Line.NORMAL]
        records[:, Line.KIND] = in_group(RIDGE, SUGGESTIVE)
        return records

    def _records(
        self, ends: Floats | Doubles, triangle: Indices | Rows, lift: Floats | Doubles, view: _View
    ) -> Floats:
        """Records of lines (N, 2, 3) that run with the surface at the left where windings are as
        the app sent them, moved along the lines of sight by (N, 2) object units: the polygons lie
        about the surface that is meant."""
        records = np.zeros((len(ends), RECORD), np.float32)
        linear = view.modelview[:3, :3]
        places = ends.astype(np.float64) @ linear.T + view.modelview[:3, 3]
        normals = unit(self._planes[triangle] @ cofactors(view.modelview).T)
        towards = view.centre[:3] - view.centre[3] * places[:, 0]
        normals[dot(normals, towards) <= 0.0] *= -1.0
        sight = view.viewpoint[:3] - view.viewpoint[3] * places
        distance = np.sqrt((sight**2).sum(axis=2))
        away = lift * np.cbrt(abs(float(np.linalg.det(linear))))
        if view.viewpoint[3] != 0.0:
            away = np.minimum(away, _NEAREST * distance)
        places += sight / np.maximum(distance, 1e-300)[:, :, None] * away[:, :, None]
        if view.mirrored:
            places = places[:, ::-1]
        with np.errstate(over="ignore"):
            records[:, Line.ENDS] = places.reshape(-1, 6)
        records[:, Line.ONWARD] = records[:, Line.B]
        records[:, Line.NORMAL] = normals
        return records


class _View:
    """A camera over an object."""

    def __init__(self, modelview: Doubles, camera: Camera) -> None:
        self.modelview = modelview
        self.centre, self.viewpoint = camera.centre, camera.viewpoint
        self.front_ccw = camera.front_ccw
        self.mirrored = camera.under(modelview).mirrored


def mix(values: Doubles, along: Doubles) -> Doubles:
    """(N, 2) values between both ends (N, 2), at shares (N, 2) of the way."""
    return np.asarray(values[:, :1] + along * (values[:, 1:] - values[:, :1]))


def _eye(modelview: Doubles, camera: Camera) -> Doubles | None:
    """(4,) the viewer in object space, or a direction to it; None where there is none."""
    try:
        return np.asarray(np.linalg.inv(modelview) @ camera.viewpoint)
    except np.linalg.LinAlgError:
        return None
