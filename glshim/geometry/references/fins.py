"""Fins: quads in the window along the edges where a surface turns away, and along open edges.

The numpy reference of ``stylers/fins/fins.geom.glsl``. P. Rideout, "Silhouette Extraction", 2010,
"Basic Fins" and "Mind the Gap!". He tests the facing of projected triangles; here planes are held
against the viewer, so that triangles that reach behind it count right.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from glshim.model.arrays import Doubles, Flags, Indices
from glshim.model.camera import Camera
from glshim.model.vectors import cross, dot

SHORTEST = 1e-3
"""Pixels of an edge that has a fin."""


class Sides(NamedTuple):
    """Sides of triangles that are drawn, in the order of the triangles."""

    triangle: Indices
    """(S,)"""
    side: Indices
    """(S,) 0 to 2: it begins at that corner."""
    open: Flags
    """(S,) nothing is across."""


class Fins(NamedTuple):
    """Fins in the window, pixels of the framebuffer."""

    side: Indices
    """(F,) which of the `Sides`; those that cannot be seen have none."""
    ends: Doubles
    """(F, 2, 3) where the edge runs from and to, with its triangles on the left: pixels and window
    depth."""
    reach: Doubles
    """(F, 4, 2) of the corners: pixels along the edge, and to the right of it."""
    corners: Doubles
    """(F, 4, 2) a triangle strip."""


def facing(corners: Doubles, camera: Camera) -> Doubles:
    """(N,) positive where triangles (N, 3, 3) of object space wind counter-clockwise in the window,
    times twice their area and the length of the viewer's homogeneous place."""
    a, b, c = np.moveaxis(corners, 1, 0)
    centre = camera.object_centre
    return np.asarray(dot(cross(b - a, c - a), centre[:3] - centre[3] * a))


def drawn_sides(six: Indices, positions: NDArray[np.floating], camera: Camera) -> Sides:
    """The sides of triangles with adjacency (T, 6) of vertices (V, 3) that have a fin: where one of
    two triangles faces the viewer (drawn once, by the one whose corner off the edge has the lesser
    number), and open ones. Windings of the two may agree or not: both are taken as one of them has
    the edge, so that at a twisted edge they face alike where one folds over the other."""
    where = np.asarray(positions, np.float64)
    front = facing(where[six[:, ::2]], camera) > 0.0
    drawn = np.zeros((len(six), 3), np.bool_)
    alone = six[:, 1::2] == six[:, ::2]
    for side in range(3):
        a, across, b, c = (six[:, (2 * side + step) % 6] for step in (0, 1, 2, 4))
        other = facing(where[np.stack((a, across, b), axis=1)], camera) > 0.0
        drawn[:, side] = alone[:, side] | ((front != other) & (c <= across))
    triangle, which = (found.astype(np.int32) for found in np.nonzero(drawn))
    return Sides(triangle, which, alone[triangle, which])


def fins(
    six: Indices,
    positions: NDArray[np.floating],
    sides: Sides,
    camera: Camera,
    *,
    half_width: float,
    overhang: float = 0.0,
    rounded: bool = False,
) -> Fins:
    """Quads along sides, cut at the near plane and the app's clip planes. half_width: pixels;
    overhang: share of its length by which a fin goes on at both ends; rounded: it goes on by half
    its width instead."""
    where = np.asarray(positions, np.float64)
    corners = [
        _moved(where[six[sides.triangle, (2 * sides.side + step) % 6]], camera.modelview)
        for step in (0, 2, 4, 1)
    ]
    near = camera.projection[2] + camera.projection[3]
    a, b, left = _cut(corners[0], corners[1], [near, *map(np.asarray, camera.clip_planes)])
    beside = np.where(sides.open[:, None], corners[2], corners[2] + corners[3])
    at = [_moved(eye, camera.projection)[:, (0, 1, 3)] for eye in (a, b, beside)]
    swap = dot(cross(at[0], at[1]), at[2]) < 0.0
    a, b = np.where(swap[:, None], b, a), np.where(swap[:, None], a, b)
    ends = np.stack((_window(a, camera), _window(b, camera)), axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        along = ends[:, 1, :2] - ends[:, 0, :2]
        size = np.hypot(*along.T)
        along /= size[:, None]
    kept = np.flatnonzero(left & (size >= SHORTEST)).astype(np.int32)
    ends, along, size = ends[kept], along[kept], size[kept]
    side = half_width
    beyond = np.full_like(size, side) if rounded else overhang * size
    t = np.stack((-beyond, -beyond, size + beyond, size + beyond), axis=1)
    s = np.broadcast_to((-side, side, -side, side), t.shape)
    right = np.stack((along[:, 1], -along[:, 0]), axis=1)
    quads = ends[:, :1, :2] + t[..., None] * along[:, None] + s[..., None] * right[:, None]
    return Fins(kept, ends, np.stack((t, s), axis=2), quads)


def _moved(points: Doubles, matrix: Doubles) -> Doubles:
    """(N, 4) homogeneous, of points (N, 3) or (N, 4)."""
    return np.asarray(points @ matrix[:, : points.shape[1]].T
                      + (matrix[:, 3] if points.shape[1] == 3 else 0.0))  # fmt: skip


def _cut(a: Doubles, b: Doubles, planes: list[Doubles]) -> tuple[Doubles, Doubles, Flags]:
    """Segments in eye space (N, 4) up to planes (4,), and whether something is left."""
    left = np.ones(len(a), np.bool_)
    for plane in planes:
        at_a, at_b = a @ plane, b @ plane
        left &= (at_a >= 0.0) | (at_b >= 0.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            met = a + (at_a / (at_a - at_b))[:, None] * (b - a)
        a, b = (
            np.where(((at < 0.0) & (other >= 0.0))[:, None], met, end)
            for at, other, end in ((at_a, at_b, a), (at_b, at_a, b))
        )
    return a, b, left


def _window(eye: Doubles, camera: Camera) -> Doubles:
    """(N, 3) pixels and window depth."""
    clip = _moved(eye, camera.projection)
    with np.errstate(invalid="ignore", divide="ignore"):
        ndc = clip[:, :3] / clip[:, 3:]
    x, y, width, height = camera.viewport
    near, far = camera.depth_range
    scale = np.array((width / 2.0, height / 2.0, (far - near) / 2.0))
    return np.asarray(ndc * scale + (x + width / 2.0, y + height / 2.0, (near + far) / 2.0))
