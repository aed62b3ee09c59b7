"""Where polygons pass through each other: exact segments, and curves followed along the meshes.

Raskar 2001, section 2.4, has the pixels drawn at which one polygon lies between two depths of
another. That test tells *which* polygons cross where it is seen
(`glshim.outputs.gl.lines.crossings`); here the pairs become lines with an exact
place. Everything is in eye space, in triangles.

A corner within a tolerance of the other triangle's plane counts as lying in it, for both triangles
at its side alike: an intersection along a diagonal or through a corner, which symmetric models are
full of, is found at least once and never falls between two neighbours. Whether surfaces that meet
along such a side pass through each other, or only touch, follows from how the four half-planes
about the line lie.
"""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np

from glshim.geometry.edges import edges
from glshim.geometry.recovery.welding import distinct
from glshim.linework.polygon_lines import ASKEW
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.lines import ENDLESS, INTERSECTION, RECORD, Line
from glshim.model.vectors import cross, dot, unit

_PARALLEL = np.radians(0.5)
"""Angle between planes, radians, below which they have no line in common."""
_SHALLOW = np.radians(20.0)
"""Angle between planes below which surfaces go on in each other, no crease being there: where a
sphere ends a cylinder of its radius, facets pass to and fro through each other."""
_SLACK = 1e-5
"""Over a triangle's size: what is nearer lies in a plane, what is shorter is a point."""
_ROUNDING = 4.0 * float(np.finfo(np.float32).eps)
"""Over the largest coordinate: by how much apps miss a plane that they mean."""
_SLIVER = 1e-6
"""Area over a square of a triangle's size, below which it joins nothing."""
_ROUNDS = 12
"""Triangles by which curves are followed from what was seen: hides the gaps between pixels,
and does not run along all that is hidden."""

class Triangles(Protocol):
    """(T, 3, 3) float64 corners in eye space, of which only some are asked: an array, or made
    on demand."""

    def __getitem__(self, index: Rows, /) -> Doubles: ...


class _Meeting(NamedTuple):
    """How N pairs of triangles lie to each other."""

    touch: Flags
    """(N,) they have a point in common."""
    cross: Flags
    """(N,) they have more than a point in common."""
    ends: Doubles
    """(N, 2, 3) the ends of that."""
    along: Doubles
    """(N, 3) unit direction of the line that the planes have in common."""
    normals: Doubles
    """(2, N, 3) unit normals."""
    sides: Rows
    """(2, N) the side of each (0..2, from the corner of that number) in the other's plane, or -1"""
    shared: Rows
    """(N,) corners that they have in common."""


def neighbours(triangles: Floats, owner: Indices | None = None) -> Rows:
    """(T, 3) the triangle at the other side of each side (corner k to k + 1), -1 for none.

    triangles (T, 3, 3) in one object space. owner (T,) numbers those of one mesh alike: where more
    than two sides lie together, those of one mesh join if they are two.
    """
    found = np.full(len(triangles) * 3, -1, np.intp)
    sides = _sides(triangles)
    with np.errstate(invalid="ignore", over="ignore"):
        exact = np.asarray(triangles, np.float64)
        area = np.abs(cross(exact[:, 1] - exact[:, 0], exact[:, 2] - exact[:, 0])).max(axis=1)
        sound = area > _SLIVER * _size(exact) ** 2
    # A triangle without area lies on a side twice, one without a place would spoil the rest.
    crowd = _pair(found, sides, np.flatnonzero(np.repeat(sound, 3)), None)
    if owner is not None and len(crowd):
        _pair(found, sides, crowd, owner[crowd // 3])
    return np.asarray(found.reshape(-1, 3) // 3)


def bridge(triangles: Triangles, beside: Rows, among: Rows) -> None:
    """Note in beside (T, 3) which sides without a neighbour lie together, in eye space, of the
    triangles in among: how an app cuts a surface into objects does not matter."""
    row, side = np.nonzero(beside[among] < 0)
    if len(row) < 2:
        return
    which = among[row]
    corners = triangles[which]
    at = np.arange(len(which))
    ends = np.concatenate((corners[at, side], corners[at, (side + 1) % 3]), axis=1)
    order, first, _ = edges.neighbours(ends.astype(np.float32), None)
    start = first[np.diff(first, append=len(order)) == 2]
    one, other = order[start], order[start + 1]
    beside[which[one], side[one]], beside[which[other], side[other]] = which[other], which[one]


def _sides(triangles: Floats) -> Floats:
    """(3 T, 6) both ends of each side."""
    corners = np.asarray(triangles, np.float32)
    return np.stack((corners, corners[:, [1, 2, 0]]), axis=2).reshape(-1, 6)


def _pair(
    found: Rows, sides: Floats, among: Rows, owner: Indices | None
) -> Rows:
    """Note the other side of each edge that has two among some sides. Those of edges with more."""
    order, first, _ = edges.neighbours(sides[among], owner)
    counts = np.diff(first, append=len(order))
    at = first[counts == 2]
    one, other = among[order[at]], among[order[at + 1]]
    found[one], found[other] = other, one
    return among[order[np.repeat(counts > 2, counts)]]


def trace(triangles: Triangles, beside: Rows, pairs: Rows) -> Rows:
    """(K, 2) the pairs that touch, and those that follow along the meshes.

    pairs (N, 2), beside (T, 3) as `neighbours` gives. Each round tests the neighbours of either
    triangle of a pair against the other triangle. Where a curve runs through a corner, pairs that
    touch in a point lead on.
    """
    total = len(beside)
    fresh = _codes(pairs, total)
    known, kept = fresh, [np.empty(0, np.intp)]
    for _ in range(_ROUNDS):
        if not len(fresh):
            break
        pair = np.stack(np.divmod(fresh, total), axis=1)
        met = _meet(triangles[pair[:, 0]], triangles[pair[:, 1]])
        kept.append(fresh[met.touch])
        # Around a corner of one mesh all triangles touch: that leads nowhere.
        pair = pair[met.touch & np.where(met.cross, met.shared < 2, met.shared == 0)]
        step = _codes(_steps(beside, pair).reshape(-1, 2), total)
        fresh = np.setdiff1d(step, known, assume_unique=True)
        known = np.concatenate((known, fresh))
    found = np.concatenate(kept)
    return np.stack(np.divmod(found, max(total, 1)), axis=1)


def _codes(pairs: Rows, total: int) -> Rows:
    """(K,) one number for each pair, whatever its order: sorted, each once, no -1 and no pair
    of a triangle with itself."""
    low, high = np.minimum(pairs[:, 0], pairs[:, 1]), np.maximum(pairs[:, 0], pairs[:, 1])
    return distinct((low * np.intp(total) + high)[(low >= 0) & (low != high)])


def segments(triangles: Triangles, beside: Rows, pairs: Rows) -> tuple[Doubles, Rows]:
    """(M, 2, 3) what the interiors of pairs have in common, and (M,) the row in pairs.

    pairs (N, 2) of triangles, beside (T, 3) as `neighbours` gives. Nothing comes of planes within
    half a degree of each other, of points, and of surfaces that touch along a side without
    passing through each other. What lies along a side comes once for both triangles at it.
    """
    one, two = pairs[:, 0], pairs[:, 1]
    met = _meet(triangles[one], triangles[two])
    cross = met.cross.copy()
    across = pairs.copy()  # the triangles at the other side of the line
    doubtful = np.flatnonzero(cross & (met.sides >= 0).any(axis=0))
    if len(doubtful):
        angles = []
        for part in (0, 1):
            which, side = pairs[doubtful, part], met.sides[part, doubtful]
            other = np.where(side >= 0, beside[which, side], which)
            across[doubtful, part] = other
            cross[doubtful[other < 0]] = False
            around = np.stack((which, np.maximum(other, 0)))
            angles.append(_halves(triangles, around, met, part, doubtful))
        cross[doubtful] &= _alternate(*angles)
    rows = np.flatnonzero(cross)
    total = np.intp(len(beside))
    choices = [
        np.minimum(first[rows], second[rows]) * total + np.maximum(first[rows], second[rows])
        for first in (one, across[:, 0])
        for second in (two, across[:, 1])
    ]
    rows = np.sort(rows[np.unique(np.min(choices, axis=0), return_index=True)[1]])
    return met.ends[rows], rows


def records(triangles: Triangles, beside: Rows, pairs: Rows) -> Floats:
    """(L, 21) float32 records (`glshim.model.lines.Line`), eye space, of what `segments` finds
    where the surfaces bend enough."""
    ends, rows = segments(triangles, beside, pairs)
    normals = [_normals(triangles[pairs[rows, part]]) for part in (0, 1)]
    bent = cross(*normals)
    seen = dot(bent, bent) >= np.sin(_SHALLOW) ** 2
    ends, rows, normals = ends[seen], rows[seen], [own[seen] for own in normals]
    # In an order that the place alone decides: what came first makes no difference.
    turned = ends[:, 0] @ ASKEW < ends[:, 1] @ ASKEW
    ends[turned] = ends[turned, ::-1]
    made = np.zeros((len(rows), RECORD), np.float32)
    made[:, Line.ENDS] = ends.reshape(-1, 6)
    made[:, Line.ONWARD] = ends[:, 1]
    later = (normals[0] @ ASKEW < normals[1] @ ASKEW)[:, None]
    made[:, Line.NORMAL] = np.where(later, normals[1], normals[0])
    made[:, Line.OTHER_NORMAL] = np.where(later, normals[0], normals[1])
    made[:, Line.KIND] = INTERSECTION
    made[:, Line.REST] = ENDLESS  # no hand lifts its pen where one triangle ends
    return made


def sift(triangles: Triangles, pairs: Rows) -> tuple[Flags, Flags]:
    """Of pairs (N, 2), before neighbours are known: (N,) which have more than a point and not
    just a side in common, and (N,) which lie near each other without a common corner."""
    met = _meet(triangles[pairs[:, 0]], triangles[pairs[:, 1]])
    return met.cross & (met.shared < 2), ~met.touch & (met.shared == 0)


def approach(triangles: Triangles, beside: Rows, pairs: Rows) -> Rows:
    """(K, 2) pairs around the places to which pairs (N, 2) lead, along both meshes, as long as
    they come nearer to each other.

    Where triangles are smaller than pixels, or seen from the edge, a pixel names such as lie near
    an intersection rather than those that cross.
    """
    total = len(beside)
    fresh, kept = _codes(pairs, total), [np.empty((0, 2), np.intp)]
    for _ in range(_ROUNDS):
        pair = np.stack(np.divmod(fresh, max(total, 1)), axis=1)
        pair = pair[(beside[pair[:, 0]] != pair[:, 1:]).all(axis=1)]  # met at a side: no crossing
        if not len(pair):
            break
        step = np.concatenate((pair[:, None], _steps(beside, pair)), axis=1)
        valid = (step >= 0).all(axis=2) & (step[:, :, 0] != step[:, :, 1])
        named, where = np.unique(np.maximum(step, 0), return_inverse=True)
        middles = triangles[named].sum(axis=1)[where.reshape(step.shape)]
        apart = ((middles[:, :, 0] - middles[:, :, 1]) ** 2).sum(axis=2)
        best = np.where(valid, apart, np.inf).argmin(axis=1)
        kept.append(pair[best == 0])
        moved = best > 0
        fresh = _codes(step[moved, best[moved]], total)
    found = np.concatenate(kept)
    around = np.concatenate((found[:, :, None], beside[found]), axis=2)
    both = np.stack(np.broadcast_arrays(around[:, 0, :, None], around[:, 1, None]), axis=3)
    return np.stack(np.divmod(_codes(both.reshape(-1, 2), total), max(total, 1)), axis=1)


def _steps(beside: Rows, pairs: Rows) -> Rows:
    """(N, 6, 2) pairs (N, 2) with one of the two moved to a neighbour, which may be -1."""
    step = np.repeat(pairs[:, None], 6, axis=1)
    step[:, :3, 0], step[:, 3:, 1] = beside[pairs[:, 0]], beside[pairs[:, 1]]
    return step


def _meet(first: Doubles, second: Doubles) -> _Meeting:
    """How triangles (N, 3, 3) and (N, 3, 3) lie to each other."""
    with np.errstate(all="ignore"):
        normals = np.stack((_normals(first), _normals(second)))
        along = cross(normals[0], normals[1])
        sine = np.sqrt(np.einsum("ni,ni->n", along, along))
        along /= sine[:, None]
        # Distances of corners from the other plane; small means none.
        base = first[:, :1]
        sizes = np.stack((_size(first), _size(second)))
        one, other = _columns(first), _columns(second)
        reach = np.maximum(np.abs(one).max(axis=(0, 1)), np.abs(other).max(axis=(0, 1)))
        slack = _SLACK * sizes + _ROUNDING * reach
        heights = [
            np.einsum("nci,ni->nc", first - second[:, :1], normals[1]),
            np.einsum("nci,ni->nc", second - base, normals[0]),
        ]
        spans = []
        for part, corners in enumerate((first, second)):
            height = heights[part]
            flat = np.where(np.abs(height) <= slack[part][:, None], 0.0, height)
            spans.append(_span(np.einsum("nci,ni->nc", corners - base, along), flat))
        low = np.maximum(spans[0][0], spans[1][0])
        high = np.minimum(spans[0][1], spans[1][1])
        # Where the planes meet, nearest to base, which lies in the first.
        offset = -heights[0][:, 0] / sine
        spot = base[:, 0] + offset[:, None] * cross(along, normals[0])
        ends = spot[:, None] + np.stack((low, high), axis=1)[:, :, None] * along[:, None]
        small = slack.min(axis=0)
        same = np.ones((3, 3, len(first)), np.bool_)
        for axis in range(3):
            same &= np.abs(one[:, None, axis] - other[:, axis]) <= small
        touch = (sine > np.sin(_PARALLEL)) & (high - low >= -slack.sum(axis=0))
        return _Meeting(
            touch,
            touch & (high - low > small),
            ends,
            along,
            normals,
            np.stack((spans[0][2], spans[1][2])),
            same.any(axis=1).sum(axis=0),
        )


def _span(places: Doubles, heights: Doubles) -> tuple[Doubles, Doubles, Rows]:
    """Where triangles meet a plane: (N,) from, (N,) to, and (N,) the side that lies in it or -1.

    places (N, 3) of the corners along the line of the planes, heights (N, 3) above the plane.
    """
    places, heights = np.ascontiguousarray(places.T), np.ascontiguousarray(heights.T)
    turn = [1, 2, 0]
    flat = heights == 0.0
    next_heights = heights[turn]
    through = heights * next_heights < 0.0
    share = heights / (heights - next_heights)
    cut = places + share * (places[turn] - places)
    at, valid = np.concatenate((places, cut)), np.concatenate((flat, through))
    low, high = np.where(valid, at, np.inf).min(axis=0), np.where(valid, at, -np.inf).max(axis=0)
    in_plane = flat & flat[turn]
    side = np.where(in_plane.any(axis=0), in_plane.argmax(axis=0), -1)
    sliver = flat.all(axis=0)
    low[sliver], high[sliver] = np.inf, -np.inf
    return low, high, side


def _halves(
    triangles: Triangles, around: Rows, met: _Meeting, part: int, rows: Rows
) -> Doubles:
    """(2, N) angles about the line, radians, of the two half-planes in which a surface goes on.

    around (2, N): the two triangles at the line, or one twice: then the line is in its interior.
    """
    along, frame = met.along[rows], met.normals[0, rows]
    upward = cross(along, frame)
    flat = cross(along, met.normals[part, rows])
    inside = around[0] == around[1]
    out = np.empty((2, len(rows)))
    for half, sign in ((0, 1.0), (1, -1.0)):
        spokes = triangles[around[half]] - met.ends[rows, :1]
        spokes -= np.einsum("nci,ni->nc", spokes, along)[:, :, None] * along[:, None]
        farthest = np.einsum("nci,nci->nc", spokes, spokes).argmax(axis=1)
        towards = spokes[np.arange(len(rows)), farthest]
        towards[inside] = sign * flat[inside]
        out[half] = np.arctan2(
            np.einsum("ni,ni->n", towards, upward), np.einsum("ni,ni->n", towards, frame)
        )
    return out


def _alternate(first: Doubles, second: Doubles) -> Flags:
    """(N,) whether two angles (2, N) are parted by two others (2, N), none near another."""
    turn = 2.0 * np.pi
    arc = (second[1] - second[0]) % turn
    within = (first - second[0]) % turn
    gaps = (first[:, None] - second[None] + np.pi) % turn - np.pi
    clear = (np.abs(gaps) > _PARALLEL).all(axis=(0, 1))
    return np.asarray(clear & ((within[0] < arc) != (within[1] < arc)))


def _normals(triangles: Doubles) -> Doubles:
    """(N, 3) unit normals of triangles (N, 3, 3), by their winding."""
    corner = triangles[:, 0]
    return unit(cross(triangles[:, 1] - corner, triangles[:, 2] - corner))


def _size(triangles: Doubles) -> Doubles:
    """(N,) the longest side of triangles (N, 3, 3), along one axis."""
    columns = _columns(triangles)
    return np.asarray(np.abs(columns - columns[[1, 2, 0]]).max(axis=(0, 1)))


def _columns(triangles: Doubles) -> Doubles:
    """(3, 3, N) corners and their axes; numpy takes its time over short rows."""
    return np.ascontiguousarray(triangles.transpose(1, 2, 0))
