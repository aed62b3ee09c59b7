"""The lines of Raskar 2001 as clip-space vertices: the numpy reference of ``raskar.vert.glsl``.

R. Raskar, "Hardware Support for Non-photorealistic Rendering", Graphics Hardware 2001. Section
2.1 enlarges a back-facing polygon with sides E and normal N by ``w z sin(a) (V.C)/(V.N)`` along
E x N; section 2.2 puts a quad on each side of a front-facing polygon, turned to the threshold
angle t, with the normal ``-N cos t + (E x N) sin t``, and gives it a width in the same way.

The printed factor is the travel in the polygon's plane that moves the side by w on the screen when
the travel points away from the principal point. It is not exact elsewhere, and without bound for
planes seen edge-on. What the paper wants is kept, the planes and the width w, and the rest done
on the screen: with n a unit vector across the projected side, the new vertices lie at exactly w
along n, and their depth is the plane's at that place. In normalised device coordinates depth is
affine over a plane, so with the plane's clip-space coordinates ``p = (N, -N.A) P^-1`` the depth
changes by ``-(p_x, p_y)/p_z`` per unit. This is exact for any projection, and nothing travels along
the side.

Silhouettes never come nearer than their side (the paper's plane would, through whatever is in
front). The paper's enlarged polygon has 2n sides: the corner between two offset sides belongs to
it, and is rounded here.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera
from glshim.geometry.lines import FIN, LONE_RIDGE, RIDGE, RING

Doubles = NDArray[np.float64]
Flags = NDArray[np.bool_]

INSET = 1.0 / 128.0
"""Pixels by which a ring reaches under its object, so that no crack shows."""
SNAP = 1.0 / 256.0
"""Pixels added to the width against what rasterisation rounds away."""
EDGE_ON = 0.02
"""Cosine to the line of sight below which a ridge quad is left out: it cannot be seen."""
FIN_TILT = 0.17
"""Cosine between a fin and the line of sight."""
LONGEST_TIP = 3.0
"""Widths to which the tip of a corner may reach before rounding."""
STEEP = 0.2
"""Cosine to the line of sight of the flattest plane that a ring follows towards the viewer."""
LIFT = 0.5
"""Pixels' worth of depth by which a line wins over what lies in its own plane."""
LEAN = 1.0
"""Pixels by which a line whose spine is seen comes nearer in each pixel."""


def strips(
    records: NDArray[np.float32],
    camera: Camera,
    *,
    silhouette_width: float,
    ridge_width: float,
    ridge_angle: float,
    hair: float,
    spines: bool = True,
) -> tuple[Doubles, Flags]:
    """Clip-space vertices (L, 6, 4) of the strips of line records, and which are drawn (L,).

    records: (L, 15) as `glshim.geometry.lines.choose` gives them. Widths in pixels (that of a
    ridge is one quad's, half of the visible line), ridge_angle in radians, hair in normalised
    device depth, positive away from the viewer. spines: whether fragments of rings and fins look
    up, in the pixel beside the side, whether they are seen. The six vertices: a out, a, b out,
    b, tip of the corner, next side's b out. A strip that is not drawn has undefined vertices.
    """
    rows = records.astype(np.float64)
    kind, winding = rows[:, 13].astype(int), rows[:, 14:15]
    ridge = (kind == RIDGE) | (kind == LONE_RIDGE)
    width = np.where(ridge, ridge_width, silhouette_width)[:, None] + SNAP
    half = np.array(camera.viewport[2:]) / 2.0

    eye = [rows[:, at : at + 3] @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
           for at in (0, 3, 6)]  # fmt: skip
    far = [np.c_[p, np.ones(len(p))] @ camera.projection.T for p in eye]
    near_a, near_b = _before_near(far[0]), _before_near(far[1])
    clip = [_clipped(far[0], far[1]), _clipped(far[1], far[0]), _clipped(far[2], far[1])]
    pixel = [_pixels(c, half) for c in clip]
    along = pixel[1] - pixel[0]
    drawn = ~(near_a & near_b) & (clip[0][:, 3] > 0) & (clip[1][:, 3] > 0)
    drawn &= _dot(along, along) >= 1e-6
    along = _unit(along)

    normal = _unit(rows[:, 9:12] @ camera.normal_matrix.T)
    planes, turned = [], []
    for start, end in ((0, 1), (1, 2)):
        sight = _unit(camera.viewpoint[:3] - camera.viewpoint[3] * eye[start])
        direction = _unit(eye[end] - eye[start])
        planes.append(line_planes(kind, direction, normal, sight, ridge_angle))
        turned.append(_dot(planes[-1], sight))
    drawn &= ~(ridge & (np.abs(turned[0]) < EDGE_ON))
    if np.sin(ridge_angle) >= 0.0:
        drawn &= ~(ridge & (turned[0] < 0.0))  # hidden behind its own polygon
    side = winding * np.where(ridge, np.sign(turned[0]), 1.0)[:, None]
    out_1 = side * _right(along)
    slope_1 = depth_slope(planes[0], eye[0], camera, half)
    slope_2 = depth_slope(planes[1], eye[1], camera, half)

    # The corner: to the next side's offset, where the polygon turns outwards.
    along_2 = pixel[2] - pixel[1]
    straight = (clip[2][:, 3] <= 0.0) | (_dot(along_2, along_2) < 1e-6)
    along_2 = _unit(np.where(straight[:, None], along, along_2))
    out_2 = side * _right(along_2)
    reflex = side[:, 0] * (along[:, 0] * along_2[:, 1] - along[:, 1] * along_2[:, 0]) <= 0.0
    lost = ridge & (turned[1] * turned[0] < EDGE_ON * np.abs(turned[0]))
    out_2 = np.where((reflex & ~ridge)[:, None], along, out_2)  # an end round half the way
    out_2 = np.where((ridge & (reflex | lost))[:, None], out_1, out_2)
    slope_2 = np.where((lost | (kind == RING))[:, None], slope_1, slope_2)
    middle = 0.5 * (out_1 + out_2)
    halved = np.sqrt(_dot(middle, middle))[:, None]
    safe = np.maximum(halved, 1e-3)
    tip = np.minimum(1.0 / safe, LONGEST_TIP) * middle / safe
    tip = np.where(halved > 1e-3, tip, LONGEST_TIP * along)

    inset = np.where(kind == RING, INSET, 0.0)[:, None] * out_1
    outer = width * out_1
    turns = np.where(near_b[:, None], 0.0, width)  # no corner where the near plane cuts
    mean = 0.5 * (slope_1 + slope_2)
    vertices = np.empty((len(rows), 6, 4))
    for corner, (base, offset, slope) in enumerate((
        (clip[0], outer, slope_1), (clip[0], -inset, slope_1),
        (clip[1], outer, slope_1), (clip[1], -inset, slope_1),
        (clip[1], turns * tip, mean), (clip[1], turns * out_2, slope_2),
    )):  # fmt: skip
        deeper = _biased(
            kind, _dot(slope, offset), _dot(offset, out_1) * (corner < 4), slope_1, turned[0], hair,
            spines,
        )
        vertices[:, corner, :2] = base[:, :2] + offset / half * base[:, 3:]
        w = base[:, 3]
        vertices[:, corner, 2] = np.clip(base[:, 2] + deeper * w, -w, w)
        vertices[:, corner, 3] = base[:, 3]
    return vertices, drawn


def line_planes(
    kind: NDArray[np.int_], along: Doubles, normal: Doubles, sight: Doubles, ridge_angle: float
) -> Doubles:
    """(L, 3) unit normals of the planes that lines lie in, eye space.

    RING: the polygon's own (section 2.1). RIDGE and LONE_RIDGE: ``-N cos t + (E x N) sin t``
    with N towards the viewer (section 2.2). FIN: tilted back from the viewer about the side.
    along, normal (of the winding) and sight (from the side to the viewer): (L, 3), unit.
    """
    outward = _unit(np.cross(along, normal))
    upright = np.cross(outward, along)
    level = _unit(np.cross(along, sight))
    level *= np.where(_dot(level, outward) < 0.0, -1.0, 1.0)[:, None]
    seen = _unit(sight - _dot(sight, along)[:, None] * along)
    fin = FIN_TILT * seen + sqrt(1.0 - FIN_TILT**2) * level
    towards = upright * np.where(_dot(upright, sight) < 0.0, -1.0, 1.0)[:, None]
    quad = np.sin(ridge_angle) * outward - np.cos(ridge_angle) * towards
    kinds = kind[:, None]
    return np.where(kinds == RING, upright, np.where(kinds == FIN, fin, quad))


def depth_slope(normal: Doubles, point: Doubles, camera: Camera, half: Doubles) -> Doubles:
    """(L, 2) normalised device depth per pixel over planes through eye-space points (L, 3)."""
    plane = np.c_[normal, -_dot(normal, point)] @ np.linalg.inv(camera.projection)
    z = np.where(np.abs(plane[:, 2:3]) < 1e-20, 1e-20, plane[:, 2:3])
    return np.asarray(-plane[:, :2] / (z * half))


def _biased(  # noqa: PLR0917
    kind: NDArray[np.int_],
    depth: Doubles,
    outwards: Doubles,
    slope: Doubles,
    turned: Doubles,
    hair: float,
    spines: bool,
) -> Doubles:
    """Depth against a side's own: depth is that of the line's plane, outwards the way in pixels.

    A line whose visibility is known, from its neighbours or from its spine, wins over what lies
    in its plane (the floor under a box, the line an app draws on the same edge); where depth has
    to decide, it loses. The distance is a part of a pixel's worth of depth on the line's plane.
    """
    away, grain = (1.0 if hair >= 0.0 else -1.0), abs(hair)
    deeper = away * depth
    steep = np.sqrt(_dot(slope, slope))
    lift = LIFT * steep * np.minimum(1.0, np.abs(turned) / STEEP)
    found = np.maximum(deeper, 0.0) + 2.0 * grain
    if spines:
        level = np.maximum(np.sqrt(np.maximum(1.0 - turned**2, 0.0)), 0.05)
        pixel_deep = steep * np.abs(turned) / level
        nearer = -LEAN * pixel_deep * outwards
        follows = (kind == RING) & (np.abs(turned) > STEEP)
        found = np.where(nearer < 0.0, nearer + 2.0 * grain, found)
        found = np.where(follows, deeper - lift - grain, found)
    found = np.where(kind == LONE_RIDGE, deeper + grain, found)
    return away * np.where(kind == RIDGE, np.minimum(deeper, 0.0) - lift - grain, found)


def _before_near(clip: Doubles) -> Flags:
    return np.asarray(clip[:, 2] < -clip[:, 3])


def _clipped(p: Doubles, q: Doubles) -> Doubles:
    """p (L, 4), moved towards q onto the near plane where it lies before it and q does not."""
    dp, dq = p[:, 2] + p[:, 3], q[:, 2] + q[:, 3]
    cuts = (dp < 0.0) & (dq > 0.0)
    share = np.where(cuts, dp / np.where(cuts, dp - dq, 1.0), 0.0)[:, None]
    return np.asarray(p + share * (q - p))


def _pixels(clip: Doubles, half: Doubles) -> Doubles:
    w = np.where(clip[:, 3:] == 0.0, 1e-30, clip[:, 3:])
    return np.asarray(clip[:, :2] / w * half)


def _right(along: Doubles) -> Doubles:
    return np.stack([along[:, 1], -along[:, 0]], axis=1)


def _dot(u: Doubles, v: Doubles) -> Doubles:
    return np.asarray(np.einsum("ij,ij->i", u, v))


def _unit(vectors: Doubles) -> Doubles:
    length = np.sqrt(_dot(vectors, vectors))[:, None]
    return np.asarray(vectors / np.maximum(length, 1e-300))
