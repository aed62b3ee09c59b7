"""Thick lines of McGuire & Hughes 2004 on the screen: quads, half quads, caps and their textures.

The numpy reference of ``stylers/edge_mesh/paper.glsl``. The screen is in pixels from the middle of
the viewport, y upwards. Where the paper has a stroke two units thick, `reach` is the pixels from
the edge to the side of its stroke. Sources: section 3.3 (equations 2 to 5), section 4, figure 9.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from glshim.model.arrays import Doubles, Flags
from glshim.model.vectors import dot

Parameters = Literal["object", "screen"]
INSIDE = 1.0 - 1e-5
"""Depth over w up to which edges are kept: a little within the near and the far plane."""


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Edges on the screen, cut at the near and the far plane."""

    start: Doubles
    """(E, 2) s0"""
    finish: Doubles
    """(E, 2) s1"""
    start_normal: Doubles
    """(E, 2) m0, a unit vector; zero where the normal at v0 points along the line of sight."""
    finish_normal: Doubles
    """(E, 2) m1"""
    depths: Doubles
    """(E, 2) of both ends, -1 at the near plane."""
    shown: Flags
    """(E,) some of it lies between the planes."""

    @property
    def perpendicular(self) -> Doubles:
        """(E, 2) p, a unit vector, a quarter turn counter-clockwise from the edge."""
        along = self.finish - self.start
        return _unit(np.stack((-along[:, 1], along[:, 0]), axis=1))

    @property
    def sides(self) -> tuple[Doubles, Doubles]:
        """(E,) sign(m0 . p) and sign(m1 . p): on which side of the edge its outside is."""
        p = self.perpendicular
        return _sign(dot(self.start_normal, p)), _sign(dot(self.finish_normal, p))


def segments(
    v0: Doubles, v1: Doubles, n0: Doubles, n1: Doubles, matrix: Doubles, *,
    half: tuple[float, float],
) -> Segments:  # fmt: skip
    """Edges from v0 to v1 (E, 3) with vertex normals n0 and n1 (E, 3), under a model view
    projection matrix (4, 4) and half the size of the viewport in pixels.

    A line that is projected keeps its direction however long it is: m, which the paper takes from
    v and v + n, is taken from v and a point beside it, so that v + n may lie behind the viewer.
    """
    scale = np.asarray(half, np.float64)
    flow0, flow1 = (n @ matrix[:, :3].T for n in (n0, n1))
    a, b = (v @ matrix[:, :3].T + matrix[:, 3] for v in (v0, v1))
    shown = np.ones(len(a), np.bool_)
    with np.errstate(all="ignore"):
        for way in (1.0, -1.0):
            at_a, at_b = (INSIDE * c[:, 3] + way * c[:, 2] for c in (a, b))
            shown &= (at_a > 0.0) | (at_b > 0.0)
            cut = (at_a / (at_a - at_b))[:, None]
            met = a + cut * (b - a)
            a, b = (np.where((at <= 0.0)[:, None], met, c) for at, c in ((at_a, a), (at_b, b)))
        shown &= (a[:, 3] > 0.0) & (b[:, 3] > 0.0)
        start, finish = (c[:, :2] / c[:, 3:] * scale for c in (a, b))
        start_normal, finish_normal = (
            _unit((flow[:, :2] * c[:, 3:] - c[:, :2] * flow[:, 3:]) * scale)
            for flow, c in ((flow0, a), (flow1, b))
        )
        depths = np.stack((a[:, 2] / a[:, 3], b[:, 2] / b[:, 3]), axis=1)
        return Segments(start, finish, start_normal, finish_normal, depths, shown)


def outwards(lines: Segments, within: Doubles, some: Flags) -> Segments:
    """Normals of some edges (E,) turned away from places within their surface (E, 2): where a
    surface has two sides, the normals of contours may point to either."""
    p = lines.perpendicular
    inner = dot(within - lines.start, p)
    start, finish = (
        np.where((some & (dot(m, p) * inner > 0.0))[:, None], -m, m)
        for m in (lines.start_normal, lines.finish_normal)
    )
    return replace(lines, start_normal=start, finish_normal=finish)


def quads(lines: Segments, reach: Doubles) -> Doubles:
    """(E, 4, 2) equation 2. reach (E,) pixels."""
    p = lines.perpendicular * reach[:, None]
    return np.stack((lines.start - p, lines.finish - p, lines.finish + p, lines.start + p), axis=1)


def half_quads(lines: Segments, reach: Doubles) -> Doubles:
    """(E, 4, 2) equation 3: the outer half alone."""
    out = lines.perpendicular * (reach * lines.sides[0])[:, None]
    return np.stack((lines.start, lines.finish, lines.finish + out, lines.start + out), axis=1)


def caps(lines: Segments, reach: Doubles) -> tuple[Doubles, Doubles]:
    """(E, 3, 2) start and finish caps, equations 4 and 5.

    The corner j is i or 2 - i, so that a cap winds counter-clockwise where it fills a gap: where m
    leans beyond its end of the edge. As printed the rule (i where m and p agree) is that of the
    start; the finish is its mirror image. Caps that wind clockwise lie over their own quad.
    """
    start, finish = _corners(lines, reach)
    sides = lines.sides
    return (
        np.where((sides[0] > 0.0)[:, None, None], start, start[:, ::-1]),
        np.where((sides[1] < 0.0)[:, None, None], finish, finish[:, ::-1]),
    )


def _corners(lines: Segments, reach: Doubles) -> tuple[Doubles, Doubles]:
    """(E, 3, 2) corners of the caps by j: the edge's end, its quad's outer corner, the tip."""
    p, (one, other), far = lines.perpendicular, lines.sides, reach[:, None]
    start, finish = lines.start, lines.finish
    return (
        np.stack((start, start + p * one[:, None] * far, start + lines.start_normal * far), axis=1),
        np.stack(
            (finish, finish + p * other[:, None] * far, finish + lines.finish_normal * far), axis=1
        ),
    )


def fills(caps: Doubles) -> Flags:
    """(E,) which of caps (E, 3, 2) face the viewer."""
    a, b = caps[:, 1] - caps[:, 0], caps[:, 2] - caps[:, 0]
    return np.asarray(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0] > 0.0)


def along(
    lines: Segments, r: Doubles, lengths: Doubles, origin: Doubles, parameters: Parameters
) -> Doubles:
    """(E, 2) u0 and u1, section 4. r (E,) the edges' own numbers; lengths (E,) pixels after which a
    texture repeats; origin (2,) c, where the origin of object space is on the screen.

    w is printed as the line's width times sign(m0 . p), "to maintain the aspect ratio". Pixels of
    the screen do that with the sign over the texture's length in pixels: the width times the ratio.
    """
    w = lines.sides[0] / lengths
    way = lines.finish - lines.start
    if parameters == "object":
        return np.stack((r, r + w * np.hypot(*way.T)), axis=1)
    axis = (np.abs(way[:, 1]) > np.abs(way[:, 0])).astype(int)[:, None]
    ends = np.stack((lines.start - origin, lines.finish - origin), axis=1)
    return np.asarray(w[:, None] * np.take_along_axis(ends, axis[:, None], axis=2)[..., 0])


def outer_along(lines: Segments, reach: Doubles, u: Doubles, capped: bool) -> Doubles:
    """(E, 2) what u is at the outer corners of half quads at s0 and s1, figure 9: by length from u0
    at the tip of the start cap to u1 at that of the finish cap. A cap not drawn has no length."""
    a, c = np.zeros((2, len(u)))
    if capped:
        a, c = (
            np.where(fills(cap), np.hypot(*(corners[:, 2] - corners[:, 1]).T), 0.0)
            for cap, corners in zip(caps(lines, reach), _corners(lines, reach), strict=True)
        )
    b = np.hypot(*(lines.finish - lines.start).T)
    whole = np.maximum(a + b + c, 1e-30)
    step = u[:, 1] - u[:, 0]
    return np.stack((u[:, 0] + step * a / whole, u[:, 0] + step * (a + b) / whole), axis=1)


def random_of(count: int) -> Doubles:
    """(count,) the number r of each edge, in 0..1."""
    with np.errstate(over="ignore"):
        h = np.arange(count, dtype=np.uint32) * np.uint32(747796405) + np.uint32(2891336453)
        h = ((h >> ((h >> np.uint32(28)) + np.uint32(4))) ^ h) * np.uint32(277803737)
        return np.asarray(((h >> np.uint32(22)) ^ h) % 65536 / 65536.0)


def _unit(vectors: Doubles) -> Doubles:
    length = np.hypot(*vectors.T)[:, None]
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(length > 0.0, vectors / length, 0.0)


def _sign(values: Doubles) -> Doubles:
    return np.where(values < 0.0, -1.0, 1.0)
