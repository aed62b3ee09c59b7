"""Curves on a mesh where a number given at the vertices is zero: smooth and suggestive contours.

McGuire and Hughes 2004, appendix A. A number that is linear within each triangle has zeros along
one segment of a triangle whose corners differ in sign. A segment ends on sides, at places that
the two vertices of the side alone decide: neighbours share the end to the bit. Zero counts as
positive, so that every mixed triangle has exactly one segment; one may be a point.

Everything is in object space, and which segments are hidden is for others to say.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.contour.curvature import (
    Curvature,
    radial_curvature,
    radial_derivative,
    towards,
)
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.vectors import cross, dot, unit

THETA = float(np.radians(20.0))
"""Radians between normal and view, below which a suggestive contour is too uncertain."""
SLOPE = 1.0
"""Least derivative of radial curvature, of an object of radius 1."""
HYSTERESIS = 0.25
"""The lower threshold over the higher."""
STAYS, COMES = 0.7, 1.2
"""Shares of limits between which lines are as they were in the view before."""

_NONE = -1


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """S segments, each within a triangle, with the positive side at the left as seen from where
    the triangle winds counter-clockwise: the end of one is the start of the next."""

    ends: Floats
    """(S, 2, 3) places, in the space of the positions."""
    triangle: Indices
    """(S,) the triangle."""
    weights: Floats
    """(S, 2, 3) barycentric coordinates of the ends in the triangle."""
    side: NDArray[np.int64]
    """(S, 2) which side the ends lie on: one number for both triangles at it, -1 for an end
    within the triangle, where a segment was cut."""

    def __len__(self) -> int:
        return len(self.triangle)

    def take(self, index: Flags | Rows) -> Segments:
        """Some of them."""
        return Segments(
            self.ends[index], self.triangle[index], self.weights[index], self.side[index]
        )

    def interpolate(self, triangles: Indices, values: Floats) -> Floats:
        """(S, 2, ...) values (V, ...) of the vertices, at the ends."""
        return np.asarray(
            np.einsum("sek,sk...->se...", self.weights, values[triangles[self.triangle]])
        )

    def chains(self) -> Rows:
        """(S,) a number for each segment, alike for those that link up."""
        _, node = np.unique(self.side, return_inverse=True)
        node = node.reshape(-1, 2)
        count = int(node.max(initial=-1)) + 1
        cut = self.side == _NONE
        node[cut] = count + np.arange(np.count_nonzero(cut))
        label = np.arange(count + np.count_nonzero(cut))
        while len(node):
            ends = label[node]
            least = ends.min(axis=1)
            if (ends == least[:, None]).all():
                break
            # Roots hang under the least they touch, then all paths are made short.
            np.minimum.at(label, ends.ravel(), np.repeat(least, 2))
            while True:
                further = label[label]
                if np.array_equal(further, label):
                    break
                label = further
        return np.asarray(label[node[:, 0]])


def zero_segments(positions: Floats, triangles: Indices, values: Floats) -> Segments:
    """Zeros of values (V,) on a mesh of positions (V, 3) and triangles (T, 3).

    Triangles with a corner twice, with numbers that are not finite or out of which the segment
    would not be finite have none.
    """
    positive = values >= 0.0
    one, two, three = (positive[triangles[:, k]] for k in range(3))
    which = np.flatnonzero((one != two) | (two != three))
    corners = triangles[which]
    sign = positive[corners]
    a = _lone(sign)
    rows = np.arange(len(which))
    start, end = (a + 1) % 3, (a + 2) % 3
    turn = sign[rows, a]
    other = np.stack((np.where(turn, start, end), np.where(turn, end, start)), axis=1)
    alone = corners[rows, a][:, None]
    ends = corners[rows[:, None], other]
    low, high = np.minimum(alone, ends), np.maximum(alone, ends)

    with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
        below = np.asarray(values[low], np.float64)
        along = np.clip(below / (below - values[high]), 0.0, 1.0)
        origin = np.asarray(positions[low], np.float64)
        spots = (origin + along[..., None] * (positions[high] - origin)).astype(np.float32)
    sound = np.isfinite(spots).all(axis=(1, 2)) & (corners[:, 1] != corners[:, 2])
    sound &= (corners[:, 0] != corners[:, 1]) & (corners[:, 0] != corners[:, 2])

    share = np.where(low == alone, along, 1.0 - along)  # towards the other vertex
    weights = np.zeros((len(which), 2, 3), np.float32)
    for k in range(2):
        weights[rows, k, other[:, k]] = share[:, k]
        weights[rows, k, a] = 1.0 - share[:, k]
    side = low.astype(np.int64) * len(positions) + high
    return Segments(spots, which.astype(np.int32), weights, side).take(sound)


def smooth_contours(
    positions: Floats, triangles: Indices, normals: Floats, eye: Doubles
) -> Segments:
    """Where interpolated normals (V, 3) are perpendicular to the view (Hertzmann and Zorin 2000):
    zeros of ``n . (eye - p)``, the side that faces the viewer at the left.

    eye (4,) as in `towards`.
    """
    return zero_segments(positions, triangles, facing(positions, normals, eye))


def facing(positions: Floats, normals: Floats, eye: Doubles) -> Floats:
    """(V,) ``n . (eye - p)``, positive where a surface faces the viewer."""
    return np.asarray(np.einsum("ij,ij->i", normals, towards(positions, eye)))


def suggestive_contours(
    positions: Floats,
    triangles: Indices,
    normals: Floats,
    curvature: Curvature,
    eye: Doubles,
    *,
    derivatives: Floats | None = None,
    theta: float = THETA,
    slope: float = SLOPE,
    hysteresis: float = HYSTERESIS,
    radius: float | None = None,
    paper: bool = False,
    before: Flags | None = None,
) -> Segments:
    """Where radial curvature turns from concave to convex towards the viewer (DeCarlo et al.
    2003): its zeros where the surface faces the viewer, and where its derivative along the
    projected view w is large enough. Cut at the smooth contours, which they run into.

    theta: radians that the view is away from the normal at least (DeCarlo's theta_c).
    slope: the least derivative (t_d), times the square of radius, so that neither scale nor units
    of the object matter. radius is half the diagonal of the box about the triangles, unless given.
    hysteresis: segments above this share of slope stay if they link up with one above slope.
    1 switches that off.
    derivatives (V, 4) as of `curvature_derivatives`; without them the derivative comes from how
    radial curvature differs between the corners of a triangle.

    before (V,): vertices of triangles that had lines in the view before. There lines stay down to
    `STAYS` of all limits; new ones come from `COMES` of slope on.

    paper: reject valleys as McGuire and Hughes 2004, appendix A, do, and nothing else: no segment
    of a triangle in which radial curvature falls along w by either of the two sides that it runs
    between. (They let E run from the eye to the vertex, which would reject all but the valleys; e
    in the same text runs to the eye, and so does E here.) A side tells the derivative along
    itself only: one that lies askew to w can fall where the curvature as a whole rises. The
    gradient of the whole triangle, which we take, has no such holes.
    """
    radial = radial_curvature(curvature, positions, eye)
    found = zero_segments(positions, triangles, radial)
    front = facing(positions, normals, eye)
    found = _cut(found, found.interpolate(triangles, front))
    if paper:
        return found.take(~_valley(found, positions, triangles, radial, eye))

    corners = triangles[found.triangle]
    # From here on only the vertices of these triangles matter.
    used, local = np.unique(corners, return_inverse=True)
    local = local.reshape(-1, 3)
    place, normal = positions[used], normals[used]
    sight = towards(place, eye)
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = front[used] / np.sqrt(np.einsum("ij,ij->i", sight, sight))
    if derivatives is None:
        rise = _rise(place[local], radial[corners], normal[local], sight[local])
    else:
        part = Curvature(*(np.asarray(x)[used] for x in curvature))
        rising = radial_derivative(part, derivatives[used], normal, place, eye)
        rise = _middle(found, rising[local])
    if radius is None:
        radius = _radius(positions, triangles) if len(found) else 1.0
    steep = slope / max(radius, 1e-300) ** 2
    stays = np.asarray(_middle(found, cosine[local]) < np.cos(theta))
    least = np.full(len(found), steep)
    if before is not None:
        drawn = before[corners].any(axis=1)
        least *= np.where(drawn, STAYS, COMES)
        low_share = np.where(drawn, STAYS, 1.0)
    else:
        low_share = np.ones(len(found))
    high = np.asarray(stays & (rise > np.maximum(least, 0.0)))
    if hysteresis >= 1.0:
        return found.take(high)
    low = np.flatnonzero(stays & (rise > np.maximum(low_share * steep * hysteresis, 0.0)))
    kept = found.take(low)
    chain = kept.chains()
    return kept.take(np.flatnonzero(np.isin(chain, chain[high[low]])))


def _lone(sign: Flags) -> Rows:
    """(S,) which of three corners (S, 3) differs from both others."""
    last = np.where(sign[:, 0] == sign[:, 2], 1, 2)
    return np.asarray(np.where(sign[:, 1] == sign[:, 2], 0, last))


def _middle(segments: Segments, values: Floats) -> Floats:
    """(S,) values (S, 3) of the triangles' corners, in the middle of each segment."""
    return np.asarray(np.einsum("sek,sk->s", segments.weights, values) / 2)


def _cut(segments: Segments, values: Floats) -> Segments:
    """What is left of segments where values (S, 2), given at the ends, are positive."""
    kept = np.flatnonzero((values > 0.0).any(axis=1))
    segments, values = segments.take(kept), values[kept]
    row, end = np.nonzero(~(values > 0.0))
    if not len(row):
        return segments
    stays, goes = values[row, 1 - end], values[row, end]
    share = stays / (stays - goes)
    ends, weights, side = segments.ends.copy(), segments.weights.copy(), segments.side.copy()
    for x in (ends, weights):
        x[row, end] = x[row, 1 - end] + share[:, None] * (x[row, end] - x[row, 1 - end])
    side[row, end] = _NONE
    cut = replace(segments, ends=ends, weights=weights, side=side)
    return cut.take(np.flatnonzero(np.isfinite(ends).all(axis=(1, 2))))


def _rise(corners: Floats, values: Floats, normals: Floats, sight: Floats) -> Floats:
    """(S,) derivative along w of numbers (S, 3) at corners (S, 3, 3); 0 without an area."""
    place = np.asarray(corners, np.float64)
    one, two = place[:, 1] - place[:, 0], place[:, 2] - place[:, 0]
    up = cross(one, two)
    square = np.maximum(dot(up, up), 1e-300)
    b = (values[:, 1] - values[:, 0]).astype(np.float64)
    c = (values[:, 2] - values[:, 0]).astype(np.float64)
    gradient = cross(b[:, None] * two - c[:, None] * one, up) / square[:, None]
    normal = unit(normals.sum(axis=1, dtype=np.float64))
    view = sight.sum(axis=1, dtype=np.float64)
    w = unit(view - normal * dot(normal, view)[:, None])
    return np.asarray(dot(gradient, w), np.float32)


def _valley(
    segments: Segments, positions: Floats, triangles: Indices, radial: Floats, eye: Doubles
) -> Flags:
    """(S,) the paper's test of the sides AB and AC, A the corner whose sign is its own."""
    corners = triangles[segments.triangle]
    place = np.asarray(positions[corners], np.float64)
    values = radial[corners]
    normal = unit(cross(place[:, 1] - place[:, 0], place[:, 2] - place[:, 0]))
    a = _lone(values >= 0.0)
    rows = np.arange(len(a))
    apex = place[rows, a]
    sight = np.asarray(towards(apex.astype(np.float32), eye), np.float64)
    w = unit(sight - normal * dot(normal, sight)[:, None])
    falls = np.zeros(len(a), np.bool_)
    for k in (1, 2):
        other = (a + k) % 3
        change = values[rows, other] - values[rows, a]
        falls |= change * dot(place[rows, other] - apex, w) < 0.0
    return falls


def _radius(positions: Floats, triangles: Indices) -> float:
    """Half the diagonal of the box about all triangles."""
    used = np.zeros(len(positions), np.bool_)
    used[triangles.ravel()] = True
    place = positions[used & np.isfinite(positions).all(axis=1)].astype(np.float64)
    return float(np.linalg.norm(np.ptp(place, axis=0))) / 2
