"""The lines of Raskar 2001 as strokes in the window: the numpy reference of ``ink.vert.glsl``.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001. Section
2.1 enlarges a back-facing polygon with sides E and normal N by ``w z sin(a) (V.C)/(V.N)`` along
E x N; section 2.2 puts a quad on each side of a front-facing polygon, turned to the threshold
angle t, with the normal ``-N cos t + (E x N) sin t``, and gives it a width in the same way; section
2.3 does that for valleys and shows the quad where it lies just behind what is drawn.

The printed factor is the travel in the polygon's plane that moves the side by w on the screen when
the travel points away from the principal point. It is not exact elsewhere, and without bound for
planes seen edge-on. What the paper wants is kept, the planes and the width w, and the rest done on
the screen: a stroke is the projected side with what lies within w of it, and its depth is that of
the line's plane. In window coordinates depth is affine over a plane, so with the plane's clip-space
coordinates ``p = (N, -N.A) P^-1`` it changes by ``-(p_x, p_y)/p_z`` per unit. This is exact for any
projection, and nothing travels along the side.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.window import cut, window
from glshim.model.arrays import Doubles, Flags, Floats
from glshim.model.camera import Camera
from glshim.model.lines import (
    CONTOUR,
    FIN,
    GROUP,
    HOLLOW,
    LONE_RIDGE,
    LONE_VALLEY,
    OUTLINES,
    Line,
    group_of,
    kind_of,
)
from glshim.model.vectors import dot, unit

INWARD = 0.5
"""Pixels by which the middle of a ring's inner rim lies under its object: the object's own rim is
not smooth, and the whole pixel beside it has to be ink."""
EDGE_ON = 0.02
"""Cosine to the line of sight below which a quad is left out: it cannot be seen."""
JOINT = 0.02
"""Pixels by which strokes of a chain overlap against rounding."""
STEEPEST = 600.0
"""Pixels' worth of depth a pixel at which the slope of a plane is cut."""


@dataclass(frozen=True, slots=True, eq=False)
class Strokes:
    """Strokes in the window: pixels of the framebuffer, and window depth turned so that greater is
    farther away. Undefined where not drawn."""

    drawn: Flags
    """(L,)"""
    start: Doubles
    """(L, 3) the side's a: pixels and depth."""
    finish: Doubles
    """(L, 3) b."""
    onwards: Doubles
    """(L, 2) unit direction of the next side at an outer corner of an outline; else 0."""
    slopes: Doubles
    """(L, 4) depth a pixel on the line's plane and, if it has one, on the other polygon's."""
    extent: Doubles
    """(L, 3) pixels across, outwards (to the right of a to b), between which the ink lies; the kind
    and group of the line, as in its record."""
    repeats: Doubles
    """(L, 2) of a pattern at a and at b, see `glshim.model.lines.RECORD`."""
    grain: Doubles
    """(L, 2) depth of a pixel on a plane at 45 degrees to the line of sight; and the depth by which
    a line may lie behind what is drawn and count as seen."""


def strokes(
    records: Floats,
    camera: Camera,
    *,
    widths: Sequence[float],
    ridge_angle: float,
    valley_angle: float,
    hair: float,
    blur: float = 0.0,
) -> Strokes:
    """The strokes of line records (L, 21) in eye space, see `glshim.model.lines.RECORD`.

    widths of the groups (`glshim.model.lines.GROUPS`) in pixels, angles in radians,
    hair: a few steps of the depth buffer in window depth, positive. blur: pixels by which depths
    may not be those of pixel centres. The camera's depth function is taken as GL_LESS: depth range
    (0, 1) gives greater for farther.
    """
    rows = records.astype(np.float64)
    kind, group = kind_of(records), group_of(records)
    outline = np.isin(kind, OUTLINES)
    lone = (kind == LONE_RIDGE) | (kind == LONE_VALLEY)
    ends, whole_b, drawn = cut(rows[:, Line.A], rows[:, Line.B], camera)
    start, finish = (window(end, camera) for end in ends)
    along = (finish - start)[:, :2]
    drawn &= dot(along, along) >= 1e-6
    along = unit(along)

    sight = unit(camera.viewpoint[:3] - camera.viewpoint[3] * ends[0])
    side = unit(ends[1] - ends[0])
    own, other = rows[:, Line.NORMAL], rows[:, Line.OTHER_NORMAL]
    angle = np.where(kind == LONE_VALLEY, valley_angle, ridge_angle)
    plane = line_planes(kind, side, own, sight, angle)
    turned = dot(plane, sight)
    drawn &= ~(lone & (np.abs(turned) < EDGE_ON))
    drawn &= ~((kind == LONE_RIDGE) & (turned < 0.0) & (np.sin(angle) >= 0.0))
    drawn &= ~((kind == LONE_VALLEY) & (turned < 0.0) & (np.sin(angle) <= 0.0))

    deep = pixel_depth(ends[0], side, camera)
    slopes = np.concatenate(
        [_bounded(depth_slope(normal, ends[0], camera), deep) for normal in (plane, other)], axis=1
    )
    alone = ~other.any(axis=1)
    slopes[alone, 2:] = slopes[alone, :2]

    following = window(cut(rows[:, Line.ONWARD], rows[:, Line.B], camera)[0][0], camera)
    onwards = (following - finish)[:, :2]
    long = (dot(onwards, onwards) >= 1e-6) & whole_b & outline
    onwards = unit(onwards)
    turn = along[:, 0] * onwards[:, 1] - along[:, 1] * onwards[:, 0]
    outer = (turn > 0.0) | ((turn > -1e-3) & (dot(along, onwards) < 0.0))
    onwards = np.where((long & outer)[:, None], onwards, 0.0)

    width = np.asarray(widths, np.float64)[group]
    inwards = np.where(outline, INWARD, width / 2.0)
    steep = np.where(lone, np.sqrt(dot(slopes[:, :2], slopes[:, :2])), deep)
    length = np.hypot(*(finish - start)[:, :2].T)
    leaning = np.abs(finish[:, 2] - start[:, 2]) / np.maximum(length, 1e-30)
    slack = np.select(
        [kind == CONTOUR, kind == HOLLOW, (kind == FIN) | lone],
        [-0.25 * deep, -2.0 * deep, 0.0],
        np.minimum(leaning, deep),
    ) + hair + blur * steep  # fmt: skip
    return Strokes(
        drawn, start, finish, onwards, slopes, np.c_[-inwards, width - inwards, rows[:, Line.KIND]],
        rows[:, Line.REPEATS], np.c_[deep, slack],
    )  # fmt: skip


def quads(strokes: Strokes) -> Doubles:
    """(L, 4, 2) pixels of the framebuffer: strips around all that strokes may ink, a pixel beyond
    it, round at the ends of what is not an outline."""
    a, b = strokes.start[:, :2], strokes.finish[:, :2]
    along = unit(b - a)
    outwards = np.c_[along[:, 1], -along[:, 0]]
    corner = strokes.onwards.any(axis=1)
    reach = strokes.extent[:, 1] + 1.0
    flat = strokes.extent[:, 2] % GROUP <= FIN
    behind = np.where(flat, 1.0, reach)
    beyond = np.where(flat & ~corner, 1.0, reach)
    sharp = corner & (dot(along, strokes.onwards) < 0.0)
    inner = np.where(sharp, -reach, strokes.extent[:, 0] - 1.0)
    ends = (a - behind[:, None] * along, b + beyond[:, None] * along)
    rims = [offset[:, None] * outwards for offset in (inner, reach)]
    return np.stack([end + rim for end in ends for rim in rims], axis=1)


def line_planes(
    kind: NDArray[np.int_], along: Doubles, normal: Doubles, sight: Doubles, angle: Doubles
) -> Doubles:
    """(L, 3) unit normals of the planes that lines lie in, eye space.

    The polygon's own (section 2.1), but for lone ridges and valleys ``-N cos t + (E x N) sin t``
    with N towards the viewer (2.2, 2.3). along, normal (of the winding along a to b) and
    sight (from the side to the viewer): (L, 3), unit; angle: (L,) t in radians.
    """
    outward = unit(np.cross(along, normal))
    upright = np.cross(outward, along)
    towards = upright * np.where(dot(upright, sight) < 0.0, -1.0, 1.0)[:, None]
    quad = np.sin(angle)[:, None] * outward - np.cos(angle)[:, None] * towards
    kinds = kind[:, None]
    lone = (kinds == LONE_RIDGE) | (kinds == LONE_VALLEY)
    return np.where(lone, quad, upright)


def depth_slope(normal: Doubles, point: Doubles, camera: Camera) -> Doubles:
    """(L, 2) window depth per pixel over planes through eye-space points (L, 3)."""
    near, far = camera.depth_range
    plane = np.c_[normal, -dot(normal, point)] @ np.linalg.inv(camera.projection)
    z = np.where(np.abs(plane[:, 2:3]) < 1e-20, 1e-20, plane[:, 2:3])
    return np.asarray(-plane[:, :2] / z * (far - near) / np.array(camera.viewport[2:]))


def pixel_depth(point: Doubles, along: Doubles, camera: Camera) -> Doubles:
    """(L,) window depth between the near and the far end of a pixel's size along the line of sight:
    what a plane at 45 degrees to it gains in a pixel. Eye-space points and unit sides (L, 3)."""
    sight = unit(camera.viewpoint[3] * point - camera.viewpoint[:3])
    across = unit(np.cross(sight, along))
    turn, here = camera.projection[:, :3].T, np.c_[point, np.ones(len(point))] @ camera.projection.T
    w = here[:, 3:]
    deeper, aside = ((d @ turn) * w - here * (d @ turn)[:, 3:] for d in (sight, across))
    half = np.array(camera.viewport[2:]) / 2.0
    pixels = np.sqrt(dot(aside[:, :2] * half, aside[:, :2] * half))
    near, far = camera.depth_range
    return np.asarray(np.abs(deeper[:, 2] * (far - near)) / 2.0 / np.maximum(pixels, 1e-30))


def coverage(strokes: Strokes, row: int, pixels: Doubles) -> Doubles:
    """(...) ink in 0..1 that a stroke puts on pixels whose centres are given (..., 2), hidden or
    not: the box-filtered distance to its rim, `ink.frag.glsl`."""
    a, b = strokes.start[row, :2], strokes.finish[row, :2]
    length = float(np.hypot(*(b - a)))
    along = (b - a) / length
    inner, outer = strokes.extent[row, :2]
    t = (pixels - a) @ along
    s = (pixels - a) @ np.array((along[1], -along[0]))
    past = t - np.clip(t, 0.0, length)
    past[np.abs(past) < JOINT] = 0.0
    rim = np.clip(outer + 0.5 - np.hypot(past, s), 0.0, 1.0)
    if strokes.extent[row, 2] % GROUP > FIN:
        return np.asarray(rim)
    onwards = strokes.onwards[row]
    corner = (past > 0.0) & ((pixels - b) @ onwards < 0.0)
    band = np.clip(outer + 0.5 - s, 0.0, 1.0) * np.clip(s - inner + 0.5, 0.0, 1.0)
    return np.where(past == 0.0, band, np.where(corner, rim, 0.0))


def _bounded(slope: Doubles, deep: Doubles) -> Doubles:
    size = np.sqrt(dot(slope, slope))
    return np.asarray(slope * np.minimum(1.0, STEEPEST * deep / np.maximum(size, 1e-30))[:, None])
