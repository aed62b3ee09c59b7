"""Which sides of which polygons become lines under a camera, and what kind of line."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera, cofactors
from glshim.geometry.strokes.chains import Pattern, link, measure
from glshim.geometry.strokes.edges import Doubles, Edges, Flags, Indices, neighbours
from glshim.geometry.strokes.gather import Places
from glshim.geometry.strokes.hand import own_numbers
from glshim.geometry.vectors import unit

Floats = NDArray[np.float32]

RING, CONTOUR, HOLLOW, FIN, RIDGE, LONE_RIDGE, VALLEY, LONE_VALLEY, INTERSECTION = range(9)
OUTLINES = (RING, CONTOUR, HOLLOW, FIN)
"""Kinds of line.

RING: the enlargement of a polygon beyond a side (Raskar 2001, section 2.1) at a sharp edge. At the
foot of a box it lies on the floor.
CONTOUR: the same where the surface turns away smoothly.
HOLLOW: the same where the fold is hollow on the winding side: hidden in a solid, seen in a sheet or
where the windings are inside out, so only well before what lies behind it.
FIN: the outline of an open side, but not where what is drawn beside it meets it: a neighbour may be
there after all (a seam, a T-junction).
RIDGE, VALLEY: an edge whose two polygons are known to fold below or above the threshold.
LONE_RIDGE (2.2), LONE_VALLEY (2.3): the quad at the threshold angle, where no neighbour is known:
depth decides.
INTERSECTION: where two polygons pass through each other (2.4)."""

RECORD = 21
"""Floats of one record, eye space: a, b, c (3 each; the own polygon lies left of a to b in the
window, c is where an outline goes on from b, or b), unit normals of the own and of the other
polygon (3 each; the other's is zero where none is known), kind, repeats of a pattern at a and at b
(the same where there is none), pixels of its stroke before a and after b (`Pattern.corner`), and a
number in 0..1 that an edge keeps (0 for lines that are none)."""

GROUPS = 8
"""Groups of lines that have a width and a colour of their own: 0 silhouettes, 1 ridges, 2 valleys,
3 intersections; and 4 marked edges, 5 boundary edges, 6 suggestive contours, whose records hold
their kind plus `GROUP` times (group - 3)."""
GROUP = 16
MARKED, BOUNDARY, SUGGESTIVE = 4, 5, 6

SHARP = np.radians(150.0)
"""Greatest dihedral angle at which a contour is a sharp edge."""
_ANGLE_GRAIN = 1e-3
"""Radians by which a fold may miss the threshold for rounding: a hexagonal nut has 120 degrees."""

_CROWD = 12
"""Most polygons on an edge whose folds are all looked at; of more, depth decides."""

ASKEW = np.array((0.571, 0.733, 0.369))
"""A direction that no app has in mind."""

_Found = list[tuple[int, Indices, Indices | None]]
"""Lines of a kind: their sides, and the other polygon's sides on the same edges."""


@dataclass(frozen=True, slots=True)
class Choice:
    """Which lines a style wants."""

    silhouettes: bool
    ridge_angle: float | None
    """Greatest dihedral angle of a ridge in radians, or None for no ridges."""
    valley_angle: float | None = None
    """Dihedral angle in radians above which an edge is a valley, or None for no valleys."""
    intersections: bool = False
    connectivity: bool = True
    """Whether neighbours are looked for. Without, depth alone decides, as in the paper."""
    pattern: Pattern | None = None
    """What repeats along strokes (the last floats of a record), or None for plain lines."""


def lines(parts: Sequence[tuple[Edges, Places]], camera: Camera, choice: Choice) -> Floats:
    """(L, 21) float32 records of the lines, eye space; see `RECORD`. All but intersections.

    The camera's own modelview counts for nothing. Per side, as in the paper: a ring where its
    polygon is back-facing, a quad where it is front-facing. Where another side lies on its edge,
    what that polygon hides anyway is left out: a ring stays only where all polygons of the edge
    lie on one side of it in the window (the occluding contour, whatever the windings), a ridge or
    a valley only where they lie on both. Sides that find no neighbour in their own part look for
    one in the others, in eye space: how an app cuts its polygons into objects does not matter.
    """
    several = choice.connectivity and sum(len(places.modelviews) for _, places in parts) > 1
    records: list[Floats] = []
    lone: list[Edges] = []
    for edges, places in parts:
        seen = Seen(edges, places, camera)
        if not choice.connectivity:
            everything = np.arange(len(edges), dtype=np.intp)
            records.append(seen.records(alone_of(everything, seen, choice)))
            continue
        found = together(edges, seen, choice)
        if several:
            lone.append(seen.moved(edges.singles))
        else:
            found += alone_of(edges.singles, seen, choice)
        records.append(seen.records(found))
    if lone and sum(map(len, lone)):
        seams = seams_of(lone)
        seen = Seen(seams, Places.one(np.eye(4), len(seams.planes)), camera)
        found = together(seams, seen, choice) + alone_of(seams.singles, seen, choice)
        records.append(seen.records(found))
    whole = np.concatenate(records) if records else np.empty((0, RECORD), np.float32)
    run_on(whole)
    if choice.pattern is not None:
        lay_pattern(whole, camera, choice.pattern)
    return whole


def lay_pattern(records: Floats, camera: Camera, pattern: Pattern) -> None:
    """Write into records (L, 21) how far along a pattern each line lies, whatever their kinds."""
    group = group_of(records)
    found = measure(records[:, 0:3], records[:, 3:6], group, camera, pattern)
    turns = np.floor(found.begin)
    records[:, 16], records[:, 17] = found.begin - turns, found.finish - turns


def kind_of(records: Floats) -> Indices:
    """(L,) kinds of line of records (L, 21)."""
    return np.asarray(records[:, 15].astype(np.intp) % GROUP)


def group_of(records: Floats) -> Indices:
    """(L,) groups of records (L, 21), see `GROUPS`."""
    kind, extra = kind_of(records), records[:, 15].astype(np.intp) // GROUP
    return np.where(extra > 0, extra + 3, np.maximum(kind - FIN + 1, 0) // 2)


def run_on(records: Floats) -> None:
    """Write into records of outlines where each goes on from its end b."""
    outlines = np.flatnonzero(kind_of(records) <= FIN)
    if len(outlines):
        following = link(records[outlines, 0:3], records[outlines, 3:6])
        goes_on = following >= 0
        records[outlines[goes_on], 6:9] = records[outlines[following[goes_on]], 3:6]


class Seen:
    """The sides of one `Edges` as a camera sees them."""

    def __init__(self, edges: Edges, places: Places, camera: Camera) -> None:
        self.edges, self._places, self._camera = edges, places, camera
        centres = places.centres(camera)[places.polygon]
        ccw = np.einsum("pi,pi->p", edges.planes, centres) > 0.0
        self.ccw: Flags = ccw[edges.polygon]
        """(E,) whether the side's polygon winds counter-clockwise in the window."""
        self.front: Flags = self.ccw == camera.front_ccw
        self.left: Flags = self.ccw == edges.forward
        """(E,) on which side of its edge, as it runs, the polygon lies in the window."""

    def folds(self, first: Indices, second: Indices, folds: Doubles) -> Doubles:
        """Dihedral angles (radians, eye space) of pairs of sides as the viewer sees them; folds
        are those in object space, from the winding side of first."""
        places = self._places
        owner = places.polygon[self.edges.polygon[first]]
        flipped = places.mirrored(self._camera)[owner]
        skewed = ~are_similarities(places.modelviews)[owner]
        if skewed.any():
            folds = folds.copy()
            linear = places.modelviews[owner[skewed], :3, :3]
            folds[skewed] = self.edges.fold(first[skewed], second[skewed], linear)
            plainly = np.linalg.det(self._camera.projection) > 0.0
            flipped = np.where(skewed, plainly, flipped)
        return np.where(self.ccw[first] != flipped, folds, 2.0 * np.pi - folds)

    def moved(self, sides: Indices) -> Edges:
        """Some sides in eye space, each with its plane, not yet knowing each other."""
        ends, normals = self._ends(sides), self._normals(sides)
        planes = np.c_[normals, -np.einsum("li,li->l", normals, ends[:, 0])]
        creases = self._turned(sides, self.edges.creases[self.edges.polygon[sides]])
        nothing = np.empty(0, np.intp)
        each = np.arange(len(sides), dtype=np.int32)
        return Edges(
            ends.reshape(-1, 6), each, planes, creases, each.astype(np.intp),
            nothing, nothing, np.empty(0, np.bool_),
        )  # fmt: skip

    def records(self, found: _Found) -> Floats:
        """Records of lines, see `RECORD`."""
        count = sum(len(sides) for _, sides, _ in found)
        records = np.empty((count, RECORD), np.float32)
        if not count:
            return records
        sides = np.concatenate([sides for _, sides, _ in found])
        normals, beyond = self._normals(sides), np.zeros((count, 3))
        at = 0
        for kind, some, others in found:
            part = slice(at, at + len(some))
            records[part, 15] = kind
            if others is not None:
                # In an order that their place alone decides: which of the two polygons of an edge
                # came first makes no difference, to the last bit.
                own, other = normals[part], self._normals(others)
                later = own @ ASKEW < other @ ASKEW
                sides[part] = np.where(later, others, some)
                swapped = later[:, None]
                normals[part], beyond[part] = (
                    np.where(swapped, other, own), np.where(swapped, own, other)
                )  # fmt: skip
            at += len(some)
        ends, turned = self._ends(sides), ~self.ccw[sides]
        ends[turned] = ends[turned, ::-1]
        normals[turned] *= -1.0
        records[:, 0:6] = ends.reshape(-1, 6)
        records[:, 6:9] = ends[:, 1]
        records[:, 9:12] = normals
        records[:, 12:15] = beyond
        records[:, 16:20] = 0.0
        records[:, 20] = own_numbers(sides)
        return records

    def _ends(self, sides: Indices) -> Floats:
        """(N, 2, 3) both ends in eye space."""
        places, owner = self._places, self._owners(sides)
        ends = self.edges.sides[sides].reshape(-1, 2, 3).astype(np.float64)
        turn = places.modelviews[:, :3, :3].transpose(0, 2, 1)
        if len(turn) == 1:
            return np.asarray(ends @ turn[0] + places.modelviews[0, :3, 3], np.float32)
        return np.asarray(ends @ turn[owner] + places.modelviews[owner, None, :3, 3], np.float32)

    def _normals(self, sides: Indices) -> Doubles:
        """(N, 3) unit normals in eye space."""
        return self._turned(sides, self.edges.planes[self.edges.polygon[sides], :3])

    def _turned(self, sides: Indices, vectors: Doubles) -> Doubles:
        """(N, 3) normals of the polygons of sides, from object to eye space, unit."""
        normals = vectors[:, :, None]
        turn = cofactors(self._places.modelviews)
        moved = (turn[0] @ normals if len(turn) == 1 else turn[self._owners(sides)] @ normals)[
            ..., 0
        ]
        return unit(moved)

    def _owners(self, sides: Indices) -> NDArray[np.int32]:
        return self._places.polygon[self.edges.polygon[sides]]


def alone_of(sides: Indices, seen: Seen, choice: Choice) -> _Found:
    """Lines of sides that know no neighbour."""
    found: _Found = []
    ahead = sides[seen.front[sides]]
    if choice.silhouettes:
        found.append((FIN, sides, None))
    if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
        found.append((LONE_RIDGE, ahead, None))
    if choice.valley_angle is not None:
        found.append((LONE_VALLEY, ahead, None))
    return found


def together(edges: Edges, seen: Seen, choice: Choice) -> _Found:
    """Lines of edges with two and more sides."""
    found: _Found = []
    first, second = edges.pairs
    across = seen.left[first] != seen.left[second]
    if choice.silhouettes:
        one, other = first[~across], second[~across]
        # One ring an edge, from a back-facing polygon if it has one.
        from_behind = np.where(seen.front[one], other, one)
        folds = edges.folds[~across]
        sharp, hollow = folds <= SHARP, folds > np.pi
        for kind, which in ((RING, sharp), (CONTOUR, ~sharp & ~hollow), (HOLLOW, hollow)):
            found.append((kind, from_behind[which], None))
    if choice.ridge_angle is not None or choice.valley_angle is not None:
        one, other = first[across], second[across]
        folds = seen.folds(one, other, edges.folds[across])
        if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
            sharp = folds <= choice.ridge_angle + _ANGLE_GRAIN
            found.append((RIDGE, one[sharp], other[sharp]))
        if choice.valley_angle is not None:
            deep = folds > choice.valley_angle + _ANGLE_GRAIN
            found.append((VALLEY, one[deep], other[deep]))

    sides, edge = edges.crowds
    if len(sides):
        total = np.bincount(edge)
        lefts = np.bincount(edge, seen.left[sides])
        contour = ((lefts == 0) | (lefts == total))[edge]
        if choice.silhouettes:
            none_behind = (np.bincount(edge, ~seen.front[sides]) == 0)[edge]
            found.append((CONTOUR, sides[contour & (~seen.front[sides] | none_behind)], None))
        inner = ~contour & seen.front[sides]
        least, most = _crowded_folds(edges, seen, sides, edge)
        if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
            sharp = least[edge] <= choice.ridge_angle + _ANGLE_GRAIN
            found.append((LONE_RIDGE, sides[inner & sharp], None))
        if choice.valley_angle is not None:
            deep = most[edge] > choice.valley_angle + _ANGLE_GRAIN
            found.append((LONE_VALLEY, sides[inner & deep], None))
    return found


def _crowded_folds(
    edges: Edges, seen: Seen, sides: Indices, edge: Indices
) -> tuple[Doubles, Doubles]:
    """The least and the greatest fold between any two polygons of each edge with many, one on
    either side of it in the window. Polygons sent twice fold with none of their own."""
    counts = np.bincount(edge)
    least, most = np.full(len(counts), np.inf), np.full(len(counts), -np.inf)
    for step in range(1, min(int(counts.max()), _CROWD)):
        at = np.flatnonzero(edge[step:] == edge[:-step])
        first, second = sides[at], sides[at + step]
        across = seen.left[first] != seen.left[second]
        at, first, second = at[across], first[across], second[across]
        folds = seen.folds(first, second, edges.fold(first, second))
        np.minimum.at(least, edge[at], folds)
        np.maximum.at(most, edge[at], folds)
    large = counts > _CROWD
    least[large], most[large] = -np.inf, np.inf
    return least, most


def seams_of(lone: list[Edges]) -> Edges:
    """Lone sides of all parts, in one space, as edges with each other's sides."""
    sides = np.concatenate([part.sides for part in lone])
    planes = np.concatenate([part.planes for part in lone])
    creases = np.concatenate([part.creases for part in lone])
    each = np.arange(len(sides), dtype=np.int32)
    return Edges(sides, each, planes, creases, each.astype(np.intp), *neighbours(sides, None))


def are_similarities(modelviews: Doubles) -> Flags:
    """(M,) whether angles in object space are angles in eye space."""
    linear = modelviews[:, :3, :3]
    square = linear.transpose(0, 2, 1) @ linear
    scale = np.trace(square, axis1=1, axis2=2)[:, None, None] / 3.0
    off = np.abs(square - scale * np.eye(3)).max(axis=(1, 2))
    return np.asarray(off <= 1e-6 * scale[:, 0, 0])
