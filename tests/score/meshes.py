"""The meshes that are scored, as polygon batches in object space, about 1.5 units in radius."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from glshim.model.batch import PolygonBatch
from tests import look

Rings = list[list[int]]
Shell = tuple[np.ndarray, Rings]
"""Points (N, 3) and polygons wound counter-clockwise seen from outside."""


def gear(teeth=14, hub=0.38, root=0.92, tip=1.25, half=0.3) -> PolygonBatch:
    """A toothed wheel with a hub hole: quads only, walls square to flat caps."""
    turns = (np.arange(teeth)[:, None] + (0.0, 0.36, 0.48, 0.88)).ravel() * 2 * np.pi / teeth
    radii = np.tile((root, root, tip, tip), teeth)
    count = len(turns)
    circle = np.c_[np.cos(turns), np.sin(turns)]
    flat = [radii[:, None] * circle, hub * circle]
    points = np.concatenate([np.c_[xy, np.full(count, z)] for z in (-half, half) for xy in flat])
    quads: Rings = []
    for i in range(count):
        j = (i + 1) % count
        low, low_hole, high, high_hole = ((i + k * count, j + k * count) for k in range(4))
        quads.append([*low, high[1], high[0]])
        quads.append([low_hole[1], low_hole[0], high_hole[0], high_hole[1]])
        quads.append([*high, high_hole[1], high_hole[0]])
        quads.append([low[1], low[0], low_hole[0], low_hole[1]])
    return look.batch(points, quads)


def part() -> PolygonBatch:
    """A bracket with valleys, and shells that run through each other: a boss through its foot,
    a pin through its wall, a rib into both and a ring around the boss that bites into the foot."""
    shells = [
        _bracket(),
        _placed(_prism(28, 0.42, 0.55), (0.5, 0.03, -0.62), tilt=(0.06, 0.04)),
        _placed(_prism(20, 0.26, 0.5), (-0.86, 0.13, 0.55), tilt=(0.03, np.pi / 2 - 0.09)),
        _placed(_tube(32, 0.72, 0.58, 0.14), (0.5, 0.03, -0.6), tilt=(0.05, -0.07)),
        _placed(_wedge(), (-0.92, -0.87, -0.74), tilt=(0.0, 0.0)),
    ]
    return _together(shells)


def _bracket() -> Shell:
    """An L of two plates; its caps are split so that no corner lies within a side."""
    wide, low, thick, deep = 1.35, -0.9, 0.34, 1.0
    xs, zs = (-wide + 0.2, -wide + 0.2 + thick, wide), (low, low + thick, 1.25)
    profile = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), (0, 1)]
    caps = [(0, 1, 4, 7), (1, 2, 3, 4), (7, 4, 5, 6)]
    points = [(xs[i], y, zs[k]) for y in (-deep, deep) for i, k in profile]
    count = len(profile)
    walls = [[i, i + count, (i + 1) % count + count, (i + 1) % count] for i in range(count)]
    rings = [list(c) for c in caps] + [[i + count for i in c[::-1]] for c in caps] + walls
    return np.array(points), rings


def _prism(count: int, radius: float, half: float) -> Shell:
    whole = look.cylinder(count, radius, half)
    return whole.positions.astype(float), [list(p) for p in look.polygons_of(whole)]


def _tube(count: int, outer: float, inner: float, half: float) -> Shell:
    turns = 2 * np.pi * (np.arange(count) + 0.3) / count
    corners = [(outer, -half), (outer, half), (inner, half), (inner, -half)]
    points = np.array([(r * np.cos(a), r * np.sin(a), z) for r, z in corners for a in turns])
    rings = []
    for k in range(4):
        one, other = k * count, (k + 1) % 4 * count
        rings += [[one + i, one + (i + 1) % count, other + (i + 1) % count, other + i]
                  for i in range(count)]  # fmt: skip
    return points, rings


def _wedge() -> Shell:
    """A rib: a triangle in x and z, extruded along y; it reaches into foot and wall."""
    flat = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.35)]
    points = np.array([(x, y, z) for y in (0.0, 0.17) for x, z in flat])
    return points, [[0, 1, 2], [5, 4, 3], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]]


def _placed(shell: Shell, at, tilt) -> Shell:
    """Turned about x and then y by tilt (radians), and moved."""
    (a, b), (points, rings) = tilt, shell
    about_x = [[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]]
    about_y = [[np.cos(b), 0, np.sin(b)], [0, 1, 0], [-np.sin(b), 0, np.cos(b)]]
    return points @ (np.array(about_y) @ about_x).T + at, rings


def _together(shells: list[Shell]) -> PolygonBatch:
    offsets = np.cumsum([0] + [len(points) for points, _ in shells[:-1]])
    rings = [
        [int(i + k) for i in ring]
        for (_, rings), k in zip(shells, offsets, strict=True)
        for ring in rings
    ]
    return look.batch(np.concatenate([points for points, _ in shells]), rings)


def terrain(count=60, half=1.4) -> PolygonBatch:
    """An open height field of 2 x count x count triangles: hills, two sharp crests and a gorge."""
    axis = np.linspace(-half, half, count + 1)
    x, y = np.meshgrid(axis, axis, indexing="ij")
    noise = np.random.default_rng(5).normal(0, 0.004, x.shape)
    z = 0.16 * np.sin(2.3 * x + 0.4) * np.cos(1.9 * y) + 0.07 * np.sin(5 * x * y + 1) + noise
    z += 0.42 * np.clip(1 - np.abs(x - axis[18]) / 0.28, 0, None) * (0.7 + 0.3 * np.sin(3 * y))
    z += 0.34 * np.clip(1 - np.abs(x + y - axis[44]) / 0.3, 0, None) * (y > 0)
    z -= 0.4 * np.clip(1 - np.abs(y - axis[15]) / 0.22, 0, None)
    at = np.arange((count + 1) ** 2).reshape(count + 1, count + 1)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    split = ((np.add.outer(np.arange(count), np.arange(count)) % 2) == 0)[..., None]
    one = np.where(split, np.stack([a, b, c], -1), np.stack([a, b, d], -1))
    two = np.where(split, np.stack([a, c, d], -1), np.stack([b, c, d], -1))
    triangles = np.concatenate([one.reshape(-1, 3), two.reshape(-1, 3)])
    return look.batch(np.stack([x, y, z], -1).reshape(-1, 3), triangles)


def scan(rounds=5, noise=0.13) -> PolygonBatch:
    """A lumpy closed surface as a scanner gives it: 20480 triangles of all shapes, noisy.

    noise is the standard deviation along the normal, over the mean length of a side.
    """
    points, triangles = _icosphere(rounds)
    chance = np.random.default_rng(11)
    size = np.sqrt(4 * np.pi / (len(triangles) * np.sqrt(3) / 4))
    points = points + chance.normal(0, 0.17 * size, points.shape)
    points /= np.linalg.norm(points, axis=1)[:, None]
    triangles = _flipped(points, triangles, chance, len(triangles) // 5)
    x, y, z = points.T
    radius = 1 + 0.16 * np.sin(3.1 * x + 1) * np.cos(2.7 * y) + 0.13 * np.sin(4 * z + 2 * x)
    radius += 0.3 * np.exp(-14 * ((x - 0.8) ** 2 + y**2 + (z - 0.3) ** 2))  # a nose
    radius -= 0.22 * np.exp(-160 * (z + 0.25 + 0.2 * y) ** 2)  # a groove around
    radius += chance.normal(0, noise * size, len(points))
    return look.batch(1.1 * radius[:, None] * points, triangles)


def _icosphere(rounds: int) -> tuple[np.ndarray, np.ndarray]:
    """Unit points (N, 3), triangles (20 * 4^rounds, 3), counter-clockwise from outside."""
    g = (1 + 5**0.5) / 2
    points = np.array([(0, s, t * g) for s in (-1, 1) for t in (-1, 1)], float)
    points = np.concatenate([points, points[:, [2, 0, 1]], points[:, [1, 2, 0]]])
    near = np.isclose(np.linalg.norm(points[:, None] - points, axis=2), 2)
    trios = [(i, j, k) for i in range(12) for j in range(i) for k in range(j)
             if near[i, j] and near[j, k] and near[i, k]]  # fmt: skip
    turned = [t if np.linalg.det(points[list(t)]) > 0 else t[::-1] for t in trios]
    triangles = np.array(turned)
    for _ in range(rounds):
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        unique, middle = np.unique(sides, axis=0, return_inverse=True)
        ab, bc, ca = len(points) + middle.reshape(-1, 3).T
        points = np.concatenate([points, points[unique].mean(axis=1)])
        a, b, c = triangles.T
        quarters = [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = np.concatenate([np.stack(q, 1) for q in quarters])
    return points / np.linalg.norm(points, axis=1)[:, None], triangles


def _flipped(points, triangles, chance, count) -> np.ndarray:
    """Triangles on the unit sphere after up to count random flips of sides, each in two triangles
    that no other flip touches, where both new triangles still wind outwards."""
    triangles = triangles.copy()
    keys = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    order = np.lexsort(keys.T)
    touched = np.zeros(len(triangles), bool)
    for pair in chance.permutation(order.reshape(-1, 2)):
        (s, i), (t, j) = (divmod(int(p), 3) for p in pair)
        if touched[s] or touched[t]:
            continue
        a, b, c = np.roll(triangles[s], -i)
        d = triangles[t][(j + 2) % 3]
        new = [(c, a, d), (d, b, c)]
        if min(np.linalg.det(points[list(n)]) for n in new) < 1e-5 or count <= 0:
            continue
        triangles[s], triangles[t] = new
        touched[[s, t]] = True
        count -= 1
    return triangles


def from_file(path: Path) -> PolygonBatch:
    """Any file that trimesh reads, moved to the middle and scaled to a radius of 1.5."""
    import trimesh

    mesh = trimesh.load(path, force="mesh")
    points = np.asarray(mesh.vertices, float)
    points = points - (points.min(axis=0) + points.max(axis=0)) / 2
    return look.batch(points * (1.5 / np.linalg.norm(points, axis=1).max()), mesh.faces)


def teapot() -> PolygonBatch:
    """GLUT's teapot, its windings turned: GLUT sends clockwise polygons."""
    pot = look.teapot()
    return look.batch(pot.positions, [p[::-1] for p in look.polygons_of(pot)])


MESHES: dict[str, Callable[[], PolygonBatch]] = {
    "torus": look.torus,
    "teapot": teapot,
    "gear": gear,
    "part": part,
    "terrain": terrain,
    "scan": scan,
}
