"""Smooth and suggestive contours of recovered meshes, with their creases kept.

McGuire & Hughes 2004, appendix A. Normals and curvatures are of the smooth pieces that creases part
a mesh into: what blends the two sides of a fold would say nothing about either.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera, cofactors
from glshim.geometry.contours import Segments, smooth_contours, suggestive_contours
from glshim.geometry.curvature import (
    Curvature,
    curvature_derivatives,
    principal_curvatures,
    vertex_normals,
)
from glshim.geometry.folds import Topology
from glshim.geometry.lines import CONTOUR, GROUP, RECORD, RIDGE, SUGGESTIVE
from glshim.geometry.vectors import Doubles, unit

Floats = NDArray[np.float32]
Flags = NDArray[np.bool_]


class SmoothPieces:
    """A mesh cut open at its creases."""

    def __init__(
        self, topology: Topology, positions: Floats, planes: Doubles, creases: Flags
    ) -> None:
        """positions (V, 3) and unit normals (T, 3) of a mesh; creases: (E,) its edges that are
        folds, not a smooth surface."""
        self._corners = positions[topology.triangles]
        self._planes = planes
        self.triangles: NDArray[np.int32]
        """(T, 3) indices of `positions`: a vertex for each piece that it belongs to."""
        self.triangles, first = topology.parted(creases)
        self.positions: Floats = self._corners.reshape(-1, 3)[first]
        """(C, 3) object space."""

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
    def size(self) -> Doubles:
        """(T,) half the longest side of each triangle."""
        corners = self._corners.astype(np.float64)
        sides = corners - corners[:, [1, 2, 0]]
        return np.asarray(np.sqrt((sides**2).sum(axis=2)).max(axis=1) / 2.0)

    def contours(self, modelview: Doubles, camera: Camera) -> Floats:
        """(L, 18) records of smooth contours as outlines (Hertzmann & Zorin 2000)."""
        eye = _eye(modelview, camera)
        if eye is None:
            return np.empty((0, RECORD), np.float32)
        found = smooth_contours(self.positions, self.triangles, self.normals, eye)
        return self._records(found, modelview, camera, CONTOUR, 1.0)

    def suggestive(self, modelview: Doubles, camera: Camera) -> Floats:
        """(L, 18) records of suggestive contours (DeCarlo et al. 2003)."""
        eye = _eye(modelview, camera)
        if eye is None:
            return np.empty((0, RECORD), np.float32)
        found = suggestive_contours(
            self.positions, self.triangles, self.normals, self.curvature, eye,
            derivatives=self.derivatives,
        )  # fmt: skip
        kind = RIDGE + GROUP * (SUGGESTIVE - 3)
        return self._records(found, modelview, camera, kind, 0.1)

    def _records(
        self, found: Segments, modelview: Doubles, camera: Camera, kind: int, lift: float
    ) -> Floats:
        """Records of segments, moved along the lines of sight by lift times their triangle's size:
        the polygons lie about the surface that is meant."""
        records = np.zeros((len(found), RECORD), np.float32)
        if not len(found):
            return records
        linear = modelview[:3, :3]
        ends = found.ends.astype(np.float64) @ linear.T + modelview[:3, 3]
        normals = unit(self._planes[found.triangle] @ cofactors(modelview).T)
        placed = camera.under(modelview)
        first = ends[:, 0]
        ccw = np.einsum("ni,ni->n", normals, placed.centre[:3] - placed.centre[3] * first) > 0.0
        viewpoint = camera.viewpoint
        sight = viewpoint[:3] - viewpoint[3] * ends
        distance = np.sqrt((sight**2).sum(axis=2))
        scale = np.cbrt(abs(float(np.linalg.det(linear))))
        away = np.minimum(lift * scale * self.size[found.triangle][:, None], 0.2 * distance)
        if viewpoint[3] == 0.0:
            away = np.repeat(lift * scale * self.size[found.triangle][:, None], 2, axis=1)
        ends += sight / np.maximum(distance, 1e-300)[:, :, None] * away[:, :, None]
        # The side that faces the viewer lies on the left where triangles wind counter-clockwise.
        mirrored = float(np.linalg.det(camera.projection)) > 0.0
        turned = np.full(len(ends), mirrored != (float(np.linalg.det(linear)) < 0.0))
        ends[turned] = ends[turned, ::-1]
        normals[~ccw] *= -1.0
        records[:, 0:6] = ends.reshape(-1, 6)
        records[:, 6:9] = ends[:, 1]
        records[:, 9:12] = normals
        if kind != CONTOUR:
            records[:, 12:15] = normals
        records[:, 15] = kind
        return records


def _eye(modelview: Doubles, camera: Camera) -> Doubles | None:
    """(4,) the viewer in object space, or a direction to it; None where there is none."""
    try:
        return np.asarray(np.linalg.inv(modelview) @ camera.viewpoint)
    except np.linalg.LinAlgError:
        return None
