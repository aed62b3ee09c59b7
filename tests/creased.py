"""Where style crease's ink belongs: capsules around lines that are seen, in float64.

Creases and their visibility are those of `tests.score`, from exact ray tests. Smooth silhouettes
are zeros of n.c (`glshim.geometry.references.crease_quads.silhouettes`, which has tests of its
own); they are surely seen where something farther is drawn beyond them, unless they end in a cusp
nearby (D. DeCarlo et al., "Suggestive Contours for Conveying Shape", 2003: the radial curvature).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.geometry.crease.creases import Creases, creases
from glshim.geometry.recovery.mesh import mesh as recovered
from glshim.geometry.references.crease_quads import Silhouettes, silhouettes
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.passes.runner import seen_from
from tests import look
from tests.score import sight, truth

ANGLE = 40.0
"""Degrees of a crease."""
FLAP = 0.15
"""Object units by which polygons may lie before the smooth surface that is meant."""
CUSP = 0.3
"""Cosine between the line of sight and the gradient of n.c below which a cusp is near."""
NEAR = 8.0
"""Pixels from where a silhouette is hidden, or ends in a crease, within which it may be hidden."""
STEP = 0.5


def cone(n: int = 24) -> PolygonBatch:
    ring = [(0.8 * np.cos(a), 0.8 * np.sin(a), -0.9) for a in 2 * np.pi * np.arange(n) / n]
    return look.batch([*ring, (0, 0, 1)], [*[[i, (i + 1) % n, n] for i in range(n)],
                                           list(range(n))[::-1]])  # fmt: skip


def lathe(n: int = 28) -> PolygonBatch:
    """A pawn: a foot, a waist, a collar with a sharp rim, a round head."""
    turns = np.arange(12) / 12 * 2.5 + 0.35
    profile = [(0.0, -1.2), (0.75, -1.2), (0.75, -0.95)]
    profile += [(0.24 + 0.51 * (1 - t) ** 2.5, -0.95 + 1.05 * t) for t in np.arange(1, 11) / 10]
    profile += [(0.5, 0.2), (0.24, 0.3)]
    profile += [(0.4 * np.sin(np.pi - t), 0.65 + 0.4 * np.cos(np.pi - t)) for t in turns[2:]]
    profile += [(0.0, 1.05)]
    points = [(r * np.cos(a), r * np.sin(a), z)
              for r, z in profile for a in 2 * np.pi * np.arange(n) / n]  # fmt: skip
    rings = [[i * n + j, i * n + (j + 1) % n, (i + 1) * n + (j + 1) % n, (i + 1) * n + j]
             for i in range(len(profile) - 1) for j in range(n)]  # fmt: skip
    return look.batch(points, rings)


def ell() -> PolygonBatch:
    """An L-shaped solid, with an edge that is concave."""
    around = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
    points = [(x - 1, y - 1, z) for z in (-0.5, 0.5) for x, y in around]
    sides = [[i, (i + 1) % 6, 6 + (i + 1) % 6, 6 + i] for i in range(6)]
    return look.batch(points, [*sides, [0, 5, 4, 3], [3, 2, 1, 0],
                               [6, 7, 8, 9], [9, 10, 11, 6]])  # fmt: skip


MESHES = {"cube": look.cube, "cylinder": look.cylinder, "cone": cone, "lathe": lathe,
          "torus": look.torus, "bowl": look.bowl, "ell": ell}  # fmt: skip


@dataclass(frozen=True)
class Segments:
    """Lines on the screen."""

    ends: np.ndarray
    """(S, 2, 3) pixels and window depth."""
    polygons: np.ndarray
    """(S, 2) of creases; -1: none."""
    seen: list[np.ndarray]
    """Of each the sight (`tests.score.sight`) of places along it, evenly."""
    slopes: np.ndarray
    """(P, 2) window depth a pixel of each polygon."""
    fronts: np.ndarray
    """(S,) of creases: how many polygons beside each are seen, 1: a contour."""


def crease_lines(batch: PolygonBatch, camera: Camera) -> Segments:
    """Edges at which polygons turn by `ANGLE`, and open ones."""
    body = truth.body(batch)
    scene = sight.Scene(body, camera)
    normals = np.zeros((body.count, 3))
    a, b, c = (body.points[body.triangles[:, k]] for k in range(3))
    np.add.at(normals, body.owner, np.cross(b - a, c - a))
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    found = truth.lines(body, camera, 180.0 - ANGLE, 180.0 + ANGLE)
    kept = [found["ridges"], found["valleys"]]
    bent = normals[found["silhouettes"].polygons].prod(axis=1).sum(axis=1)
    sharp = (found["silhouettes"].polygons[:, 1] < 0) | (bent < np.cos(np.radians(ANGLE)))
    outer = found["silhouettes"]
    fronts = np.repeat((2, 1), (sum(len(one.ends) for one in kept), int(sharp.sum())))
    kept.append(truth.Lines(outer.ends[sharp], outer.polygons[sharp], outer.doubtful[sharp]))
    ends = np.concatenate([one.ends for one in kept])
    polygons = np.concatenate([one.polygons for one in kept])
    seen = []
    for pair, owners in zip(ends, polygons, strict=True):
        points = places_of(pair)
        along = np.repeat((pair[1] - pair[0])[None, :2], len(points), axis=0)
        along /= np.linalg.norm(along, axis=1)[:, None]
        seen.append(scene.sight(points, np.repeat(owners[None], len(points), 0), along, False))
    return Segments(ends, polygons, seen, scene.depth_slope, fronts)


def smooth_lines(batch: PolygonBatch, camera: Camera, depth: np.ndarray) -> Segments:
    """Zeros of n.c between creases; depth (H, W) in the window, as the app drew it."""
    eye = np.array(seen_from(camera, (0.0, 0.0, 1.0, 0.0))["eye"])
    found = creases(recovered(batch), angle=np.radians(ANGLE))
    lines = silhouettes(found, eye)
    near_cusp = _bulging(found, lines, eye) <= CUSP
    ends = truth.window_space(truth.eye_space(lines.ends, camera), camera)
    out = (truth.window_space(truth.eye_space(lines.ends + 1e-4 * lines.normals, camera), camera)
           - ends)[..., :2].mean(axis=1)  # fmt: skip
    out /= np.maximum(np.linalg.norm(out, axis=1), 1e-300)[:, None]
    # With one that may be hidden those that end where it ends may be, too.
    apart = np.linalg.norm(ends[:, None, :, None, :2] - ends[None, :, None, :, :2], axis=4)
    near_cusp = (near_cusp[None] & (apart.min(axis=(2, 3)) < 2.0)).any(axis=1)
    loose = np.stack([~lines.before.any(axis=1), ~lines.after.any(axis=1)], axis=1)
    seen = []
    for one, (pair, aside, doubtful) in enumerate(zip(ends, out, near_cusp, strict=True)):
        points = places_of(pair)
        flap = FLAP * _depth_of_a_unit(points, camera)
        nearest, beyond = (_at(depth, points[:, :2] + k * aside) for k in (-2.0, 2.0))
        state = np.full(len(points), sight.UNSURE)
        sure = (beyond > points[:, 2] + flap) & ~doubtful
        for end in pair[loose[one]]:  # at a crease, and maybe behind it
            sure &= np.linalg.norm(points[:, :2] - end[:2], axis=1) > NEAR
        state[sure] = sight.SURE
        front = np.maximum(nearest, np.maximum(_at(depth, points[:, :2]), beyond))
        state[front < points[:, 2] - flap] = sight.HIDDEN
        seen.append(state)
    places = [places_of(pair)[:, :2] for pair in ends]
    hidden = np.concatenate([np.empty((0, 2)), *(at[state == sight.HIDDEN]
                             for at, state in zip(places, seen, strict=True))])  # fmt: skip
    for at, state in zip(places, seen, strict=True):
        if len(hidden):
            gap = np.linalg.norm(at[:, None] - hidden[None], axis=2).min(axis=1)
            state[(state == sight.SURE) & (gap < NEAR)] = sight.UNSURE
    return Segments(ends, np.full((len(ends), 2), -1), seen, np.zeros((0, 2)),
                    np.zeros(len(ends)))  # fmt: skip


def _bulging(found: Creases, lines: Silhouettes, eye: np.ndarray) -> np.ndarray:
    """(S,) cosines between the gradient of n.c on each triangle and the way to the viewer."""
    corners = found.triangles[lines.triangles]
    points = found.mesh.positions[found.vertices][corners].astype(float)
    toward = eye[:3] - eye[3] * points
    facing = (found.normals[corners] * toward).sum(axis=2)
    u, v = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    area = np.cross(u, v)
    beside = np.cross(v, area), np.cross(area, u)
    gradient = sum(b * (facing[:, k + 1] - facing[:, 0])[:, None] for k, b in enumerate(beside))
    way = toward.mean(axis=1)
    way -= area * ((way * area).sum(axis=1) / (area**2).sum(axis=1))[:, None]
    sizes = np.linalg.norm(gradient, axis=1) * np.linalg.norm(way, axis=1)
    return (gradient * way).sum(axis=1) / np.maximum(sizes, 1e-300)


def places_of(ends: np.ndarray) -> np.ndarray:
    count = max(int(np.ceil(np.linalg.norm(ends[1, :2] - ends[0, :2]) / STEP)), 1)
    share = ((np.arange(count) + 0.5) / count)[:, None]
    return ends[0] * (1 - share) + ends[1] * share


def _at(depth: np.ndarray, places: np.ndarray) -> np.ndarray:
    x, y = np.floor(places).astype(int).T
    height, width = depth.shape
    return depth[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)].astype(float)


def _depth_of_a_unit(points: np.ndarray, camera: Camera) -> np.ndarray:
    """(N,) window depth that an object unit along the line of sight spans."""
    inverse = np.linalg.inv(camera.projection)
    x, y, width, height = camera.viewport
    ndc = (points - (x, y, 0)) / (width, height, 1) * 2 - 1
    eye = np.c_[ndc, np.ones(len(points))] @ inverse.T
    eye = eye[:, :3] / eye[:, 3:]
    return np.abs(truth.window_space(eye - np.eye(3)[2], camera) - truth.window_space(eye, camera)
                  )[:, 2]  # fmt: skip


@dataclass(frozen=True)
class Band:
    """What ink is bound to."""

    least: np.ndarray
    """(H, W) coverage that surely is there."""
    most: np.ndarray
    """(H, W) coverage of all that may be there, a pixel wider."""
    asked: float
    """Share of the pixels around lines that are surely seen of which `least` says something."""


def band(lines: list[tuple[Segments, float]], depth: np.ndarray) -> Band:
    """Of segments and their widths in pixels, over what the app drew (H, W).

    A segment must cover a pixel where its nearest point to that is surely seen, and nothing is
    drawn there before all of the planes that the segment's ink may lie on.
    """
    height, width = depth.shape
    least, most = np.zeros(depth.shape), np.zeros(depth.shape)
    near, asked = np.zeros(depth.shape, bool), np.zeros(depth.shape, bool)
    for some, wide in lines:
        half = wide / 2
        for ends, polygons, seen in zip(some.ends, some.polygons, some.seen, strict=True):
            low = np.floor(ends[:, :2].min(axis=0) - half - 3).astype(int)
            high = np.ceil(ends[:, :2].max(axis=0) + half + 3).astype(int)
            x0, y0 = np.clip(low, 0, (width, height))
            x1, y1 = np.clip(high, 0, (width, height))
            window = (slice(y0, y1), slice(x0, x1))
            grid = np.stack(np.meshgrid(np.arange(x0, x1), np.arange(y0, y1)), 2) + 0.5
            way = ends[1, :2] - ends[0, :2]
            t = np.clip((grid - ends[0, :2]) @ way / max(way @ way, 1e-12), 0.0, 1.0)
            off = grid - (ends[0, :2] + t[..., None] * way)
            d = np.linalg.norm(off, axis=2)
            state = seen[np.minimum((t * len(seen)).astype(int), len(seen) - 1)]
            covered = np.clip(half + 0.5 - d, 0.0, 1.0)
            sure = (state == sight.SURE) & (covered > 0)
            near[window] |= sure
            depth_here = ends[0, 2] + t * (ends[1, 2] - ends[0, 2])
            plane = depth_here
            for polygon in polygons[polygons >= 0]:
                plane = np.minimum(plane, depth_here + off @ some.slopes[polygon])
            if (polygons >= 0).any():
                sure &= depth[window] >= plane - 2e-5
            asked[window] |= sure
            np.maximum(least[window], np.where(sure, covered, 0.0), out=least[window])
            # What may be seen: round ends where it goes behind something.
            may = np.flatnonzero(seen != sight.HIDDEN)
            if len(may):
                runs = np.split(may, np.flatnonzero(np.diff(may) > 1) + 1)
                for run in runs:
                    span = np.clip((grid - ends[0, :2]) @ way / max(way @ way, 1e-12),
                                   run[0] / len(seen), (run[-1] + 1) / len(seen))  # fmt: skip
                    far = np.linalg.norm(grid - (ends[0, :2] + span[..., None] * way), axis=2)
                    np.maximum(most[window], np.clip(half + 1.5 - far, 0.0, 1.0),
                               out=most[window])  # fmt: skip
    return Band(least, most, asked.sum() / max(near.sum(), 1))
