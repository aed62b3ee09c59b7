"""Which places along lines are seen: exact ray tests against all triangles, in float64.

A place is hidden when a triangle that is not of its own polygons covers it nearer to the viewer.
The same is asked a pixel away in eight directions, where the place's own polygons are continued,
each to its own side of the line (on the other side: at the place's own depth). To call a place
hidden they are taken to come nearer by at most 3 pixels' worth of depth: a steep polygon does not
reach through whatever hides its edge. Then a place is

* SURE where it is seen, and a pixel around it nothing stands in front by more than 3 pixels'
  worth of depth: no occluder ends within a pixel;
* HIDDEN where it is hidden, and so is everything a pixel around it;
* UNSURE where it is seen, but within a pixel of an occlusion boundary, or no nearer than depth
  resolves, or on a doubtful line;
* BESIDE where it is hidden, but within a pixel of an occlusion boundary.

Ink may lie on places that are UNSURE or BESIDE, or not.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from glshim.model.camera import Camera
from tests.score.truth import Body, Lines, eye_space, window_space

HIDDEN, BESIDE, UNSURE, SURE = range(4)
NOISE = 4 * 2.0**-24
"""Window depth that a 24-bit buffer and single precision do not resolve."""
_MARGIN = 3.0
"""Pixels' worth of depth by which an occluder nearby stands in front."""
_TURNS = np.arange(8) * np.pi / 4 + 0.2
_AROUND = np.concatenate([[(0.0, 0.0)], np.stack([np.cos(_TURNS), np.sin(_TURNS)], axis=1)])
_TILE = 8
_PART = 1 << 21


@dataclass(frozen=True)
class Places:
    """Places along lines."""

    points: np.ndarray
    """(N, 3) pixels and window depth."""
    sight: np.ndarray
    """(N,) HIDDEN, BESIDE, UNSURE or SURE."""
    length: np.ndarray
    """(N,) pixels of line that each stands for."""


class Scene:
    """The triangles of a mesh under a camera, in tiles of the window."""

    def __init__(self, mesh: Body, camera: Camera) -> None:
        self.eye = eye_space(mesh.points, camera)
        corners = window_space(self.eye, camera)[mesh.triangles]
        self.size = camera.viewport[2:]
        self.camera = camera
        self.count = mesh.count
        self.depth_slope = np.zeros((mesh.count, 2))
        a, u, v = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
        area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
        flat = np.abs(area) > 1e-10
        safe = np.where(flat, area, 1.0)[:, None]
        beside_u = np.stack([v[:, 1], -v[:, 0]], axis=1) / safe
        beside_v = np.stack([-u[:, 1], u[:, 0]], axis=1) / safe
        slope = beside_u * u[:, 2:] + beside_v * v[:, 2:]
        by_size = np.argsort(np.abs(area), kind="stable")  # the largest of a polygon stays
        self.depth_slope[mesh.owner[by_size]] = slope[by_size]
        self.covers = np.bincount(mesh.owner, flat, minlength=mesh.count) > 0
        self.middle = np.zeros((mesh.count, 2))
        np.add.at(self.middle, mesh.owner, corners[:, :, :2].mean(axis=1))
        self.middle /= np.maximum(np.bincount(mesh.owner, minlength=mesh.count), 1)[:, None]
        self._tables = (a[flat], beside_u[flat], beside_v[flat], slope[flat])
        self._owner = mesh.owner[flat]
        low, high = corners[flat].min(axis=1), corners[flat].max(axis=1)
        self._low, self._high = low[:, :2] - 1.01, high[:, :2] + 1.01
        self._nearest = low[:, 2]
        self._fill_tiles()

    def _fill_tiles(self) -> None:
        columns, rows = (-(-n // _TILE) for n in self.size)
        limit = (columns - 1, rows - 1)
        first = np.clip(np.floor(self._low / _TILE), 0, limit).astype(np.int64)
        last = np.clip(np.floor(self._high / _TILE), 0, limit).astype(np.int64)
        span = last - first + 1
        counts = span.prod(axis=1)
        which = np.repeat(np.arange(len(counts)), counts)
        within = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
        x = first[which, 0] + within % span[which, 0]
        y = first[which, 1] + within // span[which, 0]
        tile = y * columns + x
        order = np.argsort(tile, kind="stable")
        self._columns = columns
        self._listed = which[order]
        self._starts = np.searchsorted(tile[order], np.arange(columns * rows + 1))

    def pixel_deep(self, points) -> np.ndarray:
        """(N,) window depth that a pixel's width spans along the line of sight at points."""
        camera = self.camera
        inverse = np.linalg.inv(camera.projection)
        x, y, width, height = camera.viewport
        near, far = camera.depth_range
        ndc = (points - (x, y, near)) / (width, height, far - near) * 2 - 1
        eye = np.c_[ndc, np.ones(len(points))] @ inverse.T
        eye = eye[:, :3] / eye[:, 3:]
        step = np.array((2 / width, 0, 0))
        beside = np.c_[ndc + step, np.ones(len(points))] @ inverse.T
        footprint = np.linalg.norm(beside[:, :3] / beside[:, 3:] - eye, axis=1)
        sight = (0, 0, 1) if not camera.projection[3, :3].any() else -eye
        sight = sight / np.linalg.norm(np.atleast_2d(sight), axis=1)[:, None]
        moved = window_space(eye + footprint[:, None] * sight, camera)
        return np.abs(moved[:, 2] - points[:, 2])

    def sight(self, points, polygons, along, through) -> np.ndarray:
        """(N,) what is seen of points (N, 3) inside the window, on lines with directions along
        (N, 2) between polygons (N, 2); through: the polygons lie on both sides of the line."""
        around = self._own_depth(points, polygons, along, through)
        margin = _MARGIN * self.pixel_deep(points)
        at_most = np.maximum(around, points[:, 2:] - margin[:, None])
        covered = np.zeros((len(points), len(_AROUND)), bool)
        crowded = np.zeros(len(points), bool)
        tied = np.zeros(len(points), bool)
        for place, triangle in self._candidates(points, polygons):
            a, beside_u, beside_v, slope = (table[triangle] for table in self._tables)
            step = points[place, :2] - a[:, :2]
            u, v = (step * beside_u).sum(axis=1), (step * beside_v).sum(axis=1)
            z = a[:, 2] + (step * slope).sum(axis=1)
            for k, offset in enumerate(_AROUND):
                u_k, v_k = u + beside_u @ offset, v + beside_v @ offset
                inside = np.minimum(np.minimum(u_k, v_k), 1 - u_k - v_k) >= -1e-9
                z_k = z + slope @ offset
                behind = around[place, k] - z_k
                covered[place[inside & (at_most[place, k] - z_k > NOISE)], k] = True
                if k:
                    crowded[place[inside & (behind > margin[place] + NOISE)]] = True
                else:
                    tied[place[inside & (np.abs(behind) <= NOISE)]] = True
        hidden = covered[:, 0]
        sight = np.where(tied | crowded, UNSURE, SURE)
        sight[hidden] = BESIDE
        sight[covered.all(axis=1)] = HIDDEN
        return sight

    def _own_depth(self, points, polygons, along, through):
        """(N, 9) the depth at which each place's own surface lies around it."""
        depth = np.repeat(points[:, 2:], len(_AROUND), axis=1)
        out = np.stack([along[:, 1], -along[:, 0]], axis=1)
        for column in polygons.T:
            there = (column >= 0) & self.covers[column]
            side = np.sign(((self.middle[column] - points[:, :2]) * out).sum(axis=1))
            on_side = ((out @ _AROUND.T) * side[:, None] > 0) | through
            own = points[:, 2:] + self.depth_slope[column] @ _AROUND.T
            depth = np.where(there[:, None] & on_side, np.minimum(depth, own), depth)
        return depth

    def _candidates(self, points, polygons):
        """Places and triangles whose boxes meet, nearer than the place, part by part."""
        cell = np.floor(points[:, :2] / _TILE).astype(np.int64)
        tile = cell[:, 1] * self._columns + cell[:, 0]
        counts = self._starts[tile + 1] - self._starts[tile]
        parts = np.cumsum(counts) // _PART
        cuts = np.flatnonzero(np.diff(parts, prepend=-1, append=-1)) if len(points) else []
        for begin, end in itertools.pairwise(cuts):
            some = counts[begin:end]
            place = np.repeat(np.arange(begin, end), some)
            within = np.arange(len(place)) - np.repeat(np.cumsum(some) - some, some)
            triangle = self._listed[self._starts[tile[place]] + within]
            keep = self._nearest[triangle] <= points[place, 2] + NOISE
            place, triangle = place[keep], triangle[keep]
            at = points[place, :2]
            keep = ((at >= self._low[triangle]) & (at <= self._high[triangle])).all(axis=1)
            keep &= (polygons[place] != self._owner[triangle][:, None]).all(axis=1)
            yield place[keep], triangle[keep]


def places(scene: Scene, lines: Lines, step=0.5) -> Places:
    """Places along the lines about every step pixels inside the window, and what is seen."""
    ends = lines.ends
    length = np.linalg.norm(ends[:, 1, :2] - ends[:, 0, :2], axis=1)
    counts = np.maximum(np.ceil(length / step).astype(np.int64), 1)
    counts[~np.isfinite(length) | (length < 1e-6)] = 0
    which = np.repeat(np.arange(len(ends)), counts)
    within = np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = ((within + 0.5) / counts[which])[:, None]
    points = ends[which, 0] * (1 - share) + ends[which, 1] * share
    keep = ((points[:, :2] >= 0) & (points[:, :2] < scene.size)).all(axis=1)
    points, which = points[keep], which[keep]
    along = (ends[which, 1, :2] - ends[which, 0, :2]) / length[which][:, None]
    sight = scene.sight(points, lines.polygons[which], along, lines.through)
    sight[(sight == SURE) & lines.doubtful[which]] = UNSURE
    return Places(points, sight, (length / np.maximum(counts, 1))[which])
