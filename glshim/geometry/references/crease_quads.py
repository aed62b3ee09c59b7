"""Quads of creases and of smooth silhouettes on the screen, as a geometry shader makes them.

The numpy reference of B. Hajagos, L. Szecsi, B. Csebfalvi, SCCG 2012, sections 4.2 and 4.3. The
screen is in pixels from the middle of the viewport, y upwards. The paper's inset is right up to
first order; here it is derived on the screen, where it is exact in perspective too.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.geometry.crease.creases import Creases
from glshim.geometry.crease.smoothing_groups import following
from glshim.geometry.references.thick_lines import INSIDE
from glshim.model.arrays import Doubles, Flags, Indices
from glshim.model.vectors import cross, dot, unit

MITER = 4.0
"""Widths that a join reaches outwards at most; sharper ones end square."""
_EDGE_ON = 0.02
"""Cosine between normal and line of sight below which a triangle's plane is no help."""
_NEARER = 4.0
"""How much nearer or farther than its vertex an inset may lie, by w."""


@dataclass(frozen=True, slots=True, eq=False)
class Quads:
    """What a shader emits."""

    clip: Doubles
    """(Q, 4, 4) corners in clip space. Creases: a, b, then the insets at b and at a. Silhouettes:
    start, finish, finish, start, the first two on the right side."""
    bisectors: Doubles
    """(Q, 2, 2) on the screen, from both ends: how an inset moves for each pixel of width. The
    paper's d, as long as its denominator makes it."""
    insets: Doubles
    """(Q, 2, 3) object space: the paper's r in the triangle's plane at both ends, unit vectors.
    Zero for silhouettes, and where the plane is seen edge-on."""
    reach: Doubles
    """(Q, 2) pixels of width: of a crease's inset, twice; of a silhouette on its right and its
    left. Less than asked for where the ends' bisectors cross before."""
    shown: Flags
    """(Q,) some of it lies behind the near plane."""


@dataclass(frozen=True, slots=True, eq=False)
class Silhouettes:
    """Where n.c is zero on triangles, object space (section 4.3)."""

    triangles: Indices
    """(S,) the triangle of each segment."""
    ends: Doubles
    """(S, 2, 3) start and finish: seen from outside front-facing surface is on the left."""
    normals: Doubles
    """(S, 2, 3) interpolated normals there, not of unit length."""
    before: Doubles
    """(S, 3) from the start of the segment that finishes at the start to there; zero: none."""
    after: Doubles
    """(S, 3) from the finish to where the segment that starts there ends; zero: none."""


def crease_quads(
    creases: Creases, matrix: Doubles, width: float, *, half: tuple[float, float]
) -> tuple[Indices, Quads]:
    """(Q,) the crease halfedges and their quads, width pixels wide, on their triangles' side.

    matrix (4, 4): object to clip space; half the size of the viewport in pixels. The directions of
    the segments before and after are those that the crease differences give.
    """
    halves = np.flatnonzero(creases.sides).astype(np.int32)
    after = following(len(creases.triangles))
    corners, records = creases.mesh.triangles.ravel(), creases.triangles.ravel()
    a, b, c = (
        creases.mesh.positions[corners[h]].astype(np.float64)
        for h in (halves, after[halves], after[after[halves]])
    )
    e = unit(b - a)
    before = e - creases.differences[records[halves], :3]
    beyond = e + creases.differences[records[after[halves]], :3]
    return halves, _inset(_Screen(matrix, half), (a, b, c), before, beyond, width)


def silhouettes(creases: Creases, eye: Doubles) -> Silhouettes:
    """The smooth silhouettes of a mesh for an eye (4,), homogeneous: a direction towards the
    viewer where w = 0. Neighbours are known across sides that are no creases."""
    points = creases.mesh.positions[creases.vertices].astype(np.float64)
    normals = creases.normals.astype(np.float64)
    alpha = dot(normals, eye[:3] - eye[3] * points)
    front = alpha > 0.0
    flags = front[creases.triangles]
    count = flags.sum(axis=1)
    which = np.flatnonzero((count == 1) | (count == 2)).astype(np.int32)
    odd_front = count[which] == 1
    odd = (flags[which] == odd_front[:, None]).argmax(axis=1)
    last = (odd + 2) % 3
    # The side after a front-facing odd corner is where the segment starts; it finishes before it.
    start, finish = np.where(odd_front, odd, last), np.where(odd_front, last, odd)
    six = creases.adjacency[which]
    rows = np.arange(len(which))
    ends, sent, ways = [], [], []
    for side in (start, finish):
        v, w, m = (six[rows, at % 6] for at in (2 * side, 2 * side + 2, 2 * side + 1))
        y = _zero(points, alpha, v, w)
        other = _zero(points, alpha, m, np.where(front[m] == front[v], w, v))
        ends.append(y)
        sent.append(_zero(normals, alpha, v, w))
        ways.append(np.where(_joined(creases, 3 * which + side)[:, None], y - other, 0.0))
    return Silhouettes(which, np.stack(ends, axis=1), np.stack(sent, axis=1), ways[0], -ways[1])


def silhouette_quads(
    lines: Silhouettes,
    matrix: Doubles,
    inside: float,
    outside: float,
    *,
    half: tuple[float, float],
) -> Quads:
    """The quads of silhouettes, so many pixels wide on the side of the surface and on that to
    which its normals point. Ends are cut on the bisector with the neighbouring segment."""
    screen = _Screen(matrix, half)
    a, b, cut_a, cut_b, shown = screen.behind_near(*(lines.ends[:, k] for k in (0, 1)))
    out_a, out_b = (lines.normals[:, k] for k in (0, 1))
    at_a, at_b = screen.of(a), screen.of(b)
    way = _place(at_b) - _place(at_a)
    e = unit(way)
    m = _left(e)
    u_a = _miter(_left(unit(screen.flow(at_a, lines.before))), m, e, cut_a, inwards=False)
    u_b = _miter(_left(unit(screen.flow(at_b, lines.after))), m, e, cut_b, inwards=False)
    outwards = unit(screen.flow(at_a, out_a)) + unit(screen.flow(at_b, out_b))
    left_out = dot(outwards, m) > 0.0
    closing = dot(u_a - u_b, e)
    length = np.sqrt(dot(way, way))
    right = _unfolded(np.where(left_out, inside, outside), length, -closing)
    left = _unfolded(np.where(left_out, outside, inside), length, closing)
    corners = [
        _shifted(at, side[:, None] * u)
        for at, u, side in (
            (at_a, u_a, -right),
            (at_b, u_b, -right),
            (at_b, u_b, left),
            (at_a, u_a, left),
        )
    ]
    return Quads(
        clip=np.stack(corners, axis=1) / screen.pixels,
        bisectors=np.stack((u_a, u_b), axis=1),
        insets=np.zeros((len(a), 2, 3)),
        reach=np.stack((right, left), axis=1),
        shown=shown,
    )


class _Screen:
    """Clip space with x and y in pixels times w."""

    def __init__(self, matrix: Doubles, half: tuple[float, float]) -> None:
        self.pixels = np.array((*half, 1.0, 1.0))
        self.matrix = np.asarray(matrix, np.float64) * self.pixels[:, None]

    def of(self, points: Doubles) -> Doubles:
        """(N, 4) of points (N, 3) in object space."""
        return np.asarray(points @ self.matrix[:, :3].T + self.matrix[:, 3])

    def flow(self, at: Doubles, way: Doubles) -> Doubles:
        """(N, 2) where on the screen a point at (N, 4) goes that moves by way (N, 3) in object
        space: the derivative of x / w, times w squared."""
        step = way @ self.matrix[:, :3].T
        return np.asarray(step[:, :2] * at[:, 3:] - at[:, :2] * step[:, 3:])

    def behind_near(self, a: Doubles, b: Doubles) -> tuple[Doubles, Doubles, Flags, Flags, Flags]:
        """Segments (N, 3) cut at the near plane, whether a and b were cut off, and whether any
        of it is left."""
        near_a, near_b = (INSIDE * p[:, 3] + p[:, 2] for p in (self.of(a), self.of(b)))
        cut_a, cut_b = near_a <= 0.0, near_b <= 0.0
        with np.errstate(invalid="ignore", divide="ignore"):
            met = a + (near_a / (near_a - near_b))[:, None] * (b - a)
        shown = ~(cut_a & cut_b)
        a = np.where((cut_a & shown)[:, None], met, a)
        b = np.where((cut_b & shown)[:, None], met, b)
        shown &= (self.of(a)[:, 3] > 0.0) & (self.of(b)[:, 3] > 0.0)
        return a, b, cut_a, cut_b, shown


def _inset(
    screen: _Screen,
    triangle: tuple[Doubles, Doubles, Doubles],
    before: Doubles,
    beyond: Doubles,
    width: float,
) -> Quads:
    """Section 4.2 for sides a to b of triangles a, b, c, object space (Q, 3) each, with the
    directions of the creases before and after."""
    a, b, c = triangle
    a, b, cut_a, cut_b, shown = screen.behind_near(a, b)
    at_a, at_b = screen.of(a), screen.of(b)
    way = _place(at_b) - _place(at_a)
    e = unit(way)
    # The triangle lies to the left, or to the right where it is seen from behind.
    facing = np.where(_turn(e, screen.flow(at_a, c - a)) < 0.0, -1.0, 1.0)
    m, m_before, m_beyond = (
        facing[:, None] * _left(d)
        for d in (e, unit(screen.flow(at_a, before)), unit(screen.flow(at_b, beyond)))
    )
    u_a = _miter(m_before, m, e, cut_a)
    u_b = _miter(m_beyond, m, -e, cut_b)
    reach = _unfolded(np.full(len(a), width), np.sqrt(dot(way, way)), dot(u_a - u_b, e))
    x_a, r_a = _in_plane(screen, a, (b - a, c - a), reach, u_a)
    x_b, r_b = _in_plane(screen, b, (b - a, c - a), reach, u_b)
    return Quads(
        clip=np.stack((at_a, at_b, x_b, x_a), axis=1) / screen.pixels,
        bisectors=np.stack((u_a, u_b), axis=1),
        insets=np.stack((r_a, r_b), axis=1),
        reach=np.stack((reach, reach), axis=1),
        shown=shown,
    )


def _miter(
    neighbour: Doubles, own: Doubles, e: Doubles, cut: Flags, inwards: bool = True
) -> Doubles:
    """(N, 2) the vector to where two lines meet, one pixel beside two segments with these unit
    normals (N, 2). e (N, 2) leads away from the join along the own segment.

    It bisects the angle, and is 1 long across both segments. Ends that were cut off or have no
    neighbour are square, and so are joins that reach out too far; into a sharp corner a join may
    reach as far as it likes (inwards), since the other end's bisector bounds it.
    """
    with np.errstate(invalid="ignore", divide="ignore"):
        u = (neighbour + own) / (1.0 + dot(neighbour, own))[:, None]
        length = np.sqrt(dot(u, u))
        far = length > MITER
        if inwards:
            far &= (dot(u, e) <= 0.0) | ~(length < 1e6)
        square = far | ~np.isfinite(length) | cut | ~neighbour.any(axis=1)
    return np.where(square[:, None], own, u)


def _unfolded(width: Doubles, length: Doubles, closing: Doubles) -> Doubles:
    """(N,) widths no wider than where the ends' bisectors cross: closing (N,) is by how much
    for each pixel of width a segment (N,) pixels long grows shorter."""
    with np.errstate(divide="ignore", invalid="ignore"):
        most = np.where(closing > 0.0, length / closing, np.inf)
    return np.minimum(width, most)


def _in_plane(
    screen: _Screen, origin: Doubles, plane: tuple[Doubles, Doubles], reach: Doubles, u: Doubles
) -> tuple[Doubles, Doubles]:
    """(N, 4) the points of planes that lie reach (N,) times u (N, 2) pixels beside origins
    (N, 3) on the screen, and (N, 3) the unit vectors in the planes that lead there.

    The paper's r = n x (c x d) is the vector of the plane that the screen shows along d. In the
    plane's own vectors it needs neither n nor c: their flows are solved for u. Then x = a + s r
    moves by s u / (w (w + s w_r)) pixels, which is reach u for s = reach w^2 / (1 - reach w w_r).
    """
    at = screen.of(origin)
    first, second = plane
    f, g = screen.flow(at, first), screen.flow(at, second)
    area, w = _turn(f, g), at[:, 3]
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        r = (_turn(u, g) / area)[:, None] * first + (_turn(f, u) / area)[:, None] * second
        w_r = r @ screen.matrix[3, :3]
        ratio = 1.0 / (1.0 - reach * w * w_r)  # w of the inset over w of the origin
        x = screen.of(origin + (reach * w * w * ratio)[:, None] * r)
        normal = cross(first, second)
        scale = (screen.matrix[:2, :3] ** 2).sum() / 2.0
        cosine = np.abs(area) / (np.sqrt(dot(normal, normal)) * scale * w * w)
        held = (cosine > _EDGE_ON) & (ratio > 1.0 / _NEARER) & (ratio < _NEARER)
        held &= (np.abs(x[:, 2]) <= x[:, 3]) & np.isfinite(x).all(axis=1)
    # A plane seen edge-on is at no certain depth there: it is replaced by one that faces the eye.
    flat = _shifted(at, reach[:, None] * u)
    return np.where(held[:, None], x, flat), np.where(held[:, None], unit(r), 0.0)


def _zero(values: Doubles, alpha: Doubles, a: Indices, b: Indices) -> Doubles:
    """(N, 3) values (V, 3) where alpha (V,) is zero between a and b (N,): y_ab. To the bit the same
    from b to a."""
    at_a, at_b = alpha[a], alpha[b]
    apart = at_a - at_b
    mixed = at_a[:, None] * values[b] - at_b[:, None] * values[a]
    return np.asarray(mixed / np.where(apart == 0.0, 1.0, apart)[:, None])


def _joined(creases: Creases, halves: Indices) -> Flags:
    """(N,) whether the surface goes on smoothly across halfedges."""
    records, twin = creases.triangles.ravel(), creases.halfedges.twins[halves]
    after = following(len(creases.triangles))
    same = (records[after[twin]] == records[halves]) & (records[twin] == records[after[halves]])
    return np.asarray((twin >= 0) & same & ~creases.sides.ravel()[halves])


def _place(at: Doubles) -> Doubles:
    """(N, 2) pixels."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(at[:, :2] / at[:, 3:])


def _shifted(at: Doubles, by: Doubles) -> Doubles:
    """(N, 4) moved by pixels (N, 2) in parallel to the screen."""
    out = at.copy()
    out[:, :2] += by * at[:, 3:]
    return out


def _left(direction: Doubles) -> Doubles:
    """(N, 2) a quarter turn counter-clockwise."""
    return np.stack((-direction[:, 1], direction[:, 0]), axis=1)


def _turn(u: Doubles, v: Doubles) -> Doubles:
    """(N,) the cross product of rows (N, 2)."""
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
