"""Which sides of which polygons become lines under a camera, and what kind of line."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from glshim.geometry.edges.edges import Edges, joined
from glshim.geometry.edges.gather import Placement
from glshim.linework.hand import own_numbers
from glshim.linework.joins import link
from glshim.linework.side_by_side import mark_shared
from glshim.model.arrays import Doubles, Flags, Floats, Indices, Rows
from glshim.model.camera import Camera, cofactors
from glshim.model.dihedral import is_ridge, is_valley
from glshim.model.lines import (
    CONTOUR,
    FIN,
    HOLLOW,
    LONE_RIDGE,
    LONE_VALLEY,
    RECORD,
    RIDGE,
    RING,
    VALLEY,
    Line,
    kind_of,
    no_lines,
)
from glshim.model.vectors import unit
from glshim.styling.wishes import Choice

SHARP = np.radians(150.0)
"""Greatest dihedral angle at which a contour is a sharp edge."""

_CROWD = 12
"""Most polygons on an edge whose folds are all looked at; of more, depth decides."""

ASKEW = np.array((0.571, 0.733, 0.369))
"""A direction that no app has in mind."""

_Chosen = list[tuple[int, Rows, Rows | None]]
"""Lines of a kind: their sides, and the other polygon's sides on the same edges."""


def polygon_lines(
    parts: Sequence[tuple[Edges, Placement]], camera: Camera, choice: Choice
) -> Floats:
    """(L, 21) float32 records of the lines, eye space; see `RECORD`. All but intersections, without
    a pattern.

    The camera's own modelview counts for nothing. Per side, as in the paper: a ring where its
    polygon is back-facing, a quad where it is front-facing. Where another side lies on its edge,
    what that polygon hides anyway is left out: a ring stays only where all polygons of the edge
    lie on one side of it in the window (the occluding contour, whatever the windings), a ridge or
    a valley only where they lie on both. Sides that find no neighbour in their own part look for
    one in the others, in eye space: how an app cuts its polygons into objects does not matter.
    """
    return lines_of_objects(parts, camera, choice)[0]


def lines_of_objects(
    parts: Sequence[tuple[Edges, Placement]], camera: Camera, choice: Choice
) -> tuple[Floats, Rows]:
    """The same, and (L,) the object of each line: the number of its modelview, of all parts' one
    after the other."""
    several = choice.connectivity and sum(len(places.modelviews) for _, places in parts) > 1
    records, owners = [no_lines()], [np.empty(0, np.intp)]
    lone: list[Edges] = []
    whose: list[Rows] = []
    first = 0

    def add(seen: Seen, chosen: _Chosen, owner_of_polygons: Rows) -> None:
        found, sides = seen.records_of_sides(chosen)
        records.append(found)
        owners.append(owner_of_polygons[seen.edges.polygon[sides]])

    for edges, places in parts:
        seen = Seen(edges, places, camera)
        owner = places.polygon.astype(np.intp) + first
        first += len(places.modelviews)
        if not choice.connectivity:
            everything = np.arange(len(edges), dtype=np.intp)
            add(seen, single_side_lines(everything, seen, choice), owner)
            continue
        chosen = shared_edge_lines(edges, seen, choice)
        if several:
            lone.append(seen.moved(edges.singles))
            whose.append(owner[edges.polygon[edges.singles]])
        else:
            chosen += single_side_lines(edges.singles, seen, choice)
        add(seen, chosen, owner)
    if lone and sum(map(len, lone)):
        seams = seams_of(lone)
        seen = Seen(seams, Placement.one(np.eye(4), len(seams.planes)), camera)
        chosen = shared_edge_lines(seams, seen, choice)
        chosen += single_side_lines(seams.singles, seen, choice)
        add(seen, chosen, np.concatenate(whose))  # each side is a polygon of its own there
    whole = np.concatenate(records)
    run_on(whole)
    if choice.connectivity:
        mark_shared(whole)
    return whole, np.concatenate(owners)


def run_on(records: Floats) -> None:
    """Write into records of outlines where each goes on from its end b."""
    outlines = np.flatnonzero(kind_of(records) <= FIN)
    if len(outlines):
        following = link(records[outlines, Line.A], records[outlines, Line.B])
        goes_on = following >= 0
        records[outlines[goes_on], Line.ONWARD] = records[outlines[following[goes_on]], Line.B]


class Seen:
    """The sides of one `Edges` as a camera sees them."""

    def __init__(self, edges: Edges, places: Placement, camera: Camera) -> None:
        self.edges, self._places, self._camera = edges, places, camera
        centres = places.centres(camera)[places.polygon]
        ccw = np.einsum("pi,pi->p", edges.planes, centres) > 0.0
        self.ccw: Flags = ccw[edges.polygon]
        """(E,) whether the side's polygon winds counter-clockwise in the window."""
        self.front: Flags = self.ccw == camera.front_ccw
        self.left: Flags = self.ccw == edges.forward
        """(E,) on which side of its edge, as it runs, the polygon lies in the window."""

    def folds(self, first: Rows, second: Rows, folds: Doubles) -> Doubles:
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

    def moved(self, sides: Rows) -> Edges:
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

    def records(self, chosen: _Chosen) -> Floats:
        """Records of lines, see `RECORD`."""
        return self.records_of_sides(chosen)[0]

    def records_of_sides(self, chosen: _Chosen) -> tuple[Floats, Rows]:
        """(L, 21) records of lines, see `RECORD`, and (L,) the side that each is of."""
        count = sum(len(sides) for _, sides, _ in chosen)
        records = np.empty((count, RECORD), np.float32)
        if not count:
            return records, np.empty(0, np.intp)
        sides = np.concatenate([sides for _, sides, _ in chosen])
        normals, beyond = self._normals(sides), np.zeros((count, 3))
        at = 0
        for kind, some, others in chosen:
            part = slice(at, at + len(some))
            records[part, Line.KIND] = kind
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
        records[:, Line.ENDS] = ends.reshape(-1, 6)
        records[:, Line.ONWARD] = ends[:, 1]
        records[:, Line.NORMAL] = normals
        records[:, Line.OTHER_NORMAL] = beyond
        records[:, Line.REPEATS] = records[:, Line.REST] = 0.0
        records[:, Line.NUMBER] = own_numbers(sides)
        return records, sides

    def _ends(self, sides: Rows) -> Floats:
        """(N, 2, 3) both ends in eye space."""
        places, owner = self._places, self._owners(sides)
        ends = self.edges.sides[sides].reshape(-1, 2, 3).astype(np.float64)
        turn = places.modelviews[:, :3, :3].transpose(0, 2, 1)
        if len(turn) == 1:
            return np.asarray(ends @ turn[0] + places.modelviews[0, :3, 3], np.float32)
        return np.asarray(ends @ turn[owner] + places.modelviews[owner, None, :3, 3], np.float32)

    def _normals(self, sides: Rows) -> Doubles:
        """(N, 3) unit normals in eye space."""
        return self._turned(sides, self.edges.planes[self.edges.polygon[sides], :3])

    def _turned(self, sides: Rows, vectors: Doubles) -> Doubles:
        """(N, 3) normals of the polygons of sides, from object to eye space, unit."""
        normals = vectors[:, :, None]
        turn = cofactors(self._places.modelviews)
        moved = (turn[0] @ normals if len(turn) == 1 else turn[self._owners(sides)] @ normals)[
            ..., 0
        ]
        return unit(moved)

    def _owners(self, sides: Rows) -> Indices:
        return self._places.polygon[self.edges.polygon[sides]]


def single_side_lines(sides: Rows, seen: Seen, choice: Choice) -> _Chosen:
    """Lines of sides that know no neighbour."""
    chosen: _Chosen = []
    ahead = sides[seen.front[sides]]
    if choice.silhouettes:
        chosen.append((FIN, sides, None))
    if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
        chosen.append((LONE_RIDGE, ahead, None))
    if choice.valley_angle is not None:
        chosen.append((LONE_VALLEY, ahead, None))
    return chosen


def shared_edge_lines(edges: Edges, seen: Seen, choice: Choice) -> _Chosen:
    """Lines of edges with two and more sides."""
    chosen: _Chosen = []
    first, second = edges.pairs
    across = seen.left[first] != seen.left[second]
    if choice.silhouettes:
        one, other = first[~across], second[~across]
        # One ring an edge, from a back-facing polygon if it has one.
        from_behind = np.where(seen.front[one], other, one)
        folds = edges.folds[~across]
        sharp, hollow = folds <= SHARP, folds > np.pi
        for kind, which in ((RING, sharp), (CONTOUR, ~sharp & ~hollow), (HOLLOW, hollow)):
            chosen.append((kind, from_behind[which], None))
    if choice.ridge_angle is not None or choice.valley_angle is not None:
        one, other = first[across], second[across]
        folds = seen.folds(one, other, edges.folds[across])
        if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
            sharp = is_ridge(folds, choice.ridge_angle)
            chosen.append((RIDGE, one[sharp], other[sharp]))
        if choice.valley_angle is not None:
            deep = is_valley(folds, choice.valley_angle)
            chosen.append((VALLEY, one[deep], other[deep]))

    sides, edge = edges.crowds
    if len(sides):
        total = np.bincount(edge)
        lefts = np.bincount(edge, seen.left[sides])
        contour = ((lefts == 0) | (lefts == total))[edge]
        if choice.silhouettes:
            none_behind = (np.bincount(edge, ~seen.front[sides]) == 0)[edge]
            chosen.append((CONTOUR, sides[contour & (~seen.front[sides] | none_behind)], None))
        inner = ~contour & seen.front[sides]
        least, most = _crowded_folds(edges, seen, sides, edge)
        if choice.ridge_angle is not None and choice.ridge_angle > 0.0:
            sharp = is_ridge(least[edge], choice.ridge_angle)
            chosen.append((LONE_RIDGE, sides[inner & sharp], None))
        if choice.valley_angle is not None:
            deep = is_valley(most[edge], choice.valley_angle)
            chosen.append((LONE_VALLEY, sides[inner & deep], None))
    return chosen


def _crowded_folds(
    edges: Edges, seen: Seen, sides: Rows, edge: Rows
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
    sides, polygon, order, first, forward = joined(sides, each, None)
    return Edges(sides, polygon, planes, creases, each.astype(np.intp), order, first, forward)


def are_similarities(modelviews: Doubles) -> Flags:
    """(M,) whether angles in object space are angles in eye space."""
    linear = modelviews[:, :3, :3]
    square = linear.transpose(0, 2, 1) @ linear
    scale = np.trace(square, axis1=1, axis2=2)[:, None, None] / 3.0
    off = np.abs(square - scale * np.eye(3)).max(axis=(1, 2))
    return np.asarray(off <= 1e-6 * scale[:, 0, 0])
