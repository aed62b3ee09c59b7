"""Meshes for the viewer, as points and polygons; plain numpy, no OpenGL."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


@dataclass(frozen=True, slots=True)
class Mesh:
    """Points (n, 3), polygons as index arrays (m, corners) and, perhaps, colours (n, 3) in 0..1."""

    points: Floats
    polygons: tuple[Ints, ...]
    colours: Floats | None = None

    def corners(self, crease: float = 35.0) -> "list[tuple[Floats, Floats, Ints]]":
        """For each kind of polygon: corner points, normals (m, corners, 3), and point numbers.

        A corner's normal is the mean over the polygons around its point that lie within `crease`
        degrees of its own.
        """
        _, spot = np.unique(np.round(self.points, 9), axis=0, return_inverse=True)
        flat = [polygon_normals(self.points[p]) for p in self.polygons]
        lengths = [np.repeat(n, p.shape[1], 0) for n, p in zip(flat, self.polygons, strict=True)]
        normals = smooth(spot.ravel()[np.concatenate([p.ravel() for p in self.polygons])],
                         np.concatenate(lengths), crease)
        parts = np.split(normals, np.cumsum([p.size for p in self.polygons])[:-1])
        return [(self.points[p], n.reshape(*p.shape, 3), p)
                for p, n in zip(self.polygons, parts, strict=True)]

    def fitted(self) -> "Mesh":
        """Centred, in a sphere of radius 1."""
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        centred = self.points - (low + high) / 2
        radius = np.linalg.norm(centred, axis=1).max()
        return Mesh(centred / max(radius, 1e-300), self.polygons, self.colours)


def polygon_normals(corners: Floats) -> Floats:
    """Normals (m, 3) of polygons (m, corners, 3), as long as twice their areas (Newell)."""
    return np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)


def unit(vectors: Floats) -> Floats:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def smooth(spot: Ints, weighted: Floats, crease: float) -> Floats:
    """Unit normals of corners: `spot` is the point of each, `weighted` its polygon's normal."""
    order = np.argsort(spot, kind="stable")
    starts = np.flatnonzero(np.diff(spot[order], prepend=-1))
    around = np.diff(starts, append=len(order))
    result = unit(weighted)
    for count in np.unique(around[around <= 512]):
        first = starts[around == count]
        for block in np.array_split(first, max(1, len(first) * count * count // 4_000_000)):
            corner = order[block[:, None] + np.arange(count)]
            own = result[corner]
            near = own @ own.transpose(0, 2, 1) >= np.cos(np.radians(crease))
            weighted_sum = near @ weighted[corner]
            result[corner] = np.where(np.linalg.norm(weighted_sum, axis=2, keepdims=True) > 0,
                                      unit(weighted_sum), own)
    return result


def grid(points: Floats, wrap_rows: bool = False, wrap_columns: bool = False) -> Mesh:
    """Quads between neighbours of a grid of points (rows, columns, 3)."""
    rows, columns = points.shape[:2]
    i = np.arange(rows if wrap_rows else rows - 1)[:, None]
    j = np.arange(columns if wrap_columns else columns - 1)
    here, right = i * columns + j, i * columns + (j + 1) % columns
    down = (i + 1) % rows * columns
    quads = np.stack([here, right, down + (j + 1) % columns, down + j], axis=2).reshape(-1, 4)
    return Mesh(points.reshape(-1, 3), (quads,))


def lathe(profile: Floats, sides: int) -> Mesh:
    """A profile (n, 2) of (radius, y), top down, turned about y; points on the axis cap it."""
    turn = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([np.cos(turn), np.zeros(sides), -np.sin(turn)], axis=1)
    points = profile[:, :1, None] * ring + profile[:, 1:, None] * np.array([0.0, 1.0, 0.0])
    mesh = grid(points, wrap_columns=True)
    quads = mesh.polygons[0][:, ::-1]
    rows = quads.reshape(len(profile) - 1, sides, 4)
    caps = []
    body = slice(0, len(rows))
    if profile[0, 0] == 0:
        caps.append(rows[0][:, [0, 1, 3]])
        body = slice(1, body.stop)
    if profile[-1, 0] == 0:
        caps.append(rows[-1][:, [1, 2, 3]])
        body = slice(body.start, len(rows) - 1)
    kinds = [rows[body].reshape(-1, 4)]
    if caps:
        kinds.append(np.concatenate(caps))
    return Mesh(mesh.points, tuple(kinds))


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """One mesh of several; polygons with the same number of corners lie together."""
    offsets = np.cumsum([0, *(len(m.points) for m in meshes)])
    kinds: dict[int, list[Ints]] = {}
    for mesh, offset in zip(meshes, offsets, strict=False):
        for polygons in mesh.polygons:
            kinds.setdefault(polygons.shape[1], []).append(polygons + offset)
    colours = None
    if any(m.colours is not None for m in meshes):
        colours = np.concatenate([np.full((len(m.points), 3), 0.7) if m.colours is None
                                  else m.colours for m in meshes])
    return Mesh(np.concatenate([m.points for m in meshes]),
                tuple(np.concatenate(kinds[k]) for k in sorted(kinds)), colours)


def bezier(control: Floats, steps: int) -> Floats:
    """Points on the cubic Bezier curve through the control points (4, ...)."""
    t = np.linspace(0.0, 1.0, steps + 1)
    basis = np.stack([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t**2 * (1 - t), t**3], axis=1)
    return np.tensordot(basis, control, 1)


def chain(control: Floats, steps: int) -> Floats:
    """Points along cubic Bezier pieces that share their end points: (3k + 1, ...) controls."""
    pieces = [bezier(control[i : i + 4], steps)[:-1] for i in range(0, len(control) - 1, 3)]
    return np.concatenate([*pieces, control[-1:]])


def torus() -> Mesh:
    u, v = np.meshgrid(2 * np.pi * np.arange(48) / 48, 2 * np.pi * np.arange(24) / 24,
                       indexing="ij")
    r = 1.0 + 0.38 * np.cos(v)
    points = np.stack([r * np.cos(u), 0.38 * np.sin(v), -r * np.sin(u)], axis=2)
    return grid(points[::-1], wrap_rows=True, wrap_columns=True)


def sphere() -> Mesh:
    angle = np.linspace(0.0, np.pi, 25)
    profile = np.stack([np.sin(angle), np.cos(angle)], axis=1)
    profile[[0, -1], 0] = 0.0
    return lathe(profile, 40)


def cube() -> Mesh:
    x, y, z = np.meshgrid([-1.0, 1.0], [-1.0, 1.0], [-1.0, 1.0], indexing="ij")
    points = np.stack([x, y, z], axis=3).reshape(-1, 3)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return Mesh(points, (np.array(quads),))


def bowl() -> Mesh:
    """Open, one sheet thick: its inside shows back faces."""
    angle = np.linspace(np.pi / 2, np.pi, 15)
    profile = np.stack([np.sin(angle), 0.8 * np.cos(angle)], axis=1)
    profile[-1, 0] = 0.0
    return lathe(profile, 40)


def gear() -> Mesh:
    """Twelve teeth, a stepped hub and a bore."""
    teeth, tall = 12, 0.24
    tooth = 2 * np.pi / teeth
    angles, radii = [], []
    for k in range(teeth):
        for at, radius in ((0.0, 0.78), (0.18, 0.78), (0.30, 1.0), (0.55, 1.0), (0.67, 0.78),
                           (0.84, 0.78)):
            angles.append((k + at) * tooth)
            radii.append(radius)
    turn = np.array(angles)
    ring = np.stack([np.cos(turn), np.zeros(len(turn)), -np.sin(turn)], axis=1)

    def loop(radius: float | Floats, y: float) -> Floats:
        return ring * np.reshape(radius, (-1, 1)) + np.array([0.0, y, 0.0])

    outline = np.array(radii)
    section = [(0.22, 0.36), (0.36, 0.36), (0.36, tall), (outline, tall), (outline, -tall),
               (0.36, -tall), (0.36, -0.36), (0.22, -0.36)]
    points = np.stack([loop(radius, y) for radius, y in section])
    return grid(points[:, ::-1], wrap_rows=True, wrap_columns=True)


def knot() -> Mesh:
    """A tube along a trefoil."""
    t = 2 * np.pi * np.arange(160) / 160
    axis = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.sin(3 * t), np.cos(t) - 2 * np.cos(2 * t)],
                    axis=1)
    ahead = unit(np.roll(axis, -1, 0) - np.roll(axis, 1, 0))
    side = unit(np.cross(ahead, [0.0, 1.0, 0.0]))
    up = np.cross(side, ahead)
    v = 2 * np.pi * np.arange(16) / 16
    tube = 0.42 * (np.cos(v)[:, None] * side[:, None] + np.sin(v)[:, None] * up[:, None])
    return grid((axis[:, None] + tube)[::-1], wrap_rows=True, wrap_columns=True)


def teapot() -> Mesh:
    """Newell's teapot: body and lid turned, handle and spout from its Bezier patches."""
    lid = [(0.0, 3.15), (0.8, 3.15), (0.0, 2.7), (0.2, 2.7), (0.4, 2.55), (1.3, 2.55), (1.3, 2.4)]
    body = [(1.4, 2.4), (1.3375, 2.53125), (1.4375, 2.53125), (1.5, 2.4), (1.75, 1.875),
            (2.0, 1.35), (2.0, 0.9), (2.0, 0.45), (1.5, 0.225), (1.5, 0.15), (1.5, 0.075),
            (1.425, 0.0), (0.0, 0.0)]
    handle = [(-1.6, 2.025, -1.5, 2.25, 0.3), (-2.3, 2.025, -2.5, 2.25, 0.3),
              (-2.7, 2.025, -3.0, 2.25, 0.3), (-2.7, 1.8, -3.0, 1.8, 0.3),
              (-2.7, 1.575, -3.0, 1.35, 0.3), (-2.5, 1.125, -2.65, 0.9375, 0.3),
              (-2.0, 0.9, -1.9, 0.6, 0.3)]
    spout = [(1.7, 1.425, 1.7, 0.6, 0.66), (2.6, 1.425, 3.1, 0.825, 0.66),
             (2.3, 2.1, 2.4, 2.025, 0.25), (2.7, 2.4, 3.3, 2.4, 0.25),
             (2.8, 2.475, 3.525, 2.49375, 0.25), (2.9, 2.475, 3.45, 2.5125, 0.15),
             (2.8, 2.4, 3.2, 2.4, 0.15)]

    def tube(rows: Sequence[Sequence[float]]) -> Mesh:
        """Rings whose near and far points and half width are given, swept along the rows."""
        x0, y0, x1, y1, w = chain(np.array(rows), 7).T
        side = bezier(np.array([0.0, 1.0, 1.0, 0.0]), 8)[:-1]
        across = bezier(np.array([0.0, 0.0, 1.0, 1.0]), 8)[:-1]
        ring_u, ring_w = np.concatenate([across, 1 - across]), np.concatenate([side, -side])
        points = np.stack([x0[:, None] + np.outer(x1 - x0, ring_u),
                           y0[:, None] + np.outer(y1 - y0, ring_u), np.outer(w, ring_w)], axis=2)
        return grid(points, wrap_columns=True)

    return joined([lathe(chain(np.array(lid), 6), 40), lathe(chain(np.array(body), 6), 40),
                   tube(handle), tube(spout)])


SHAPES: dict[str, Callable[[], Mesh]] = {
    shape.__name__: shape for shape in (gear, teapot, torus, knot, sphere, cube, bowl)
}
