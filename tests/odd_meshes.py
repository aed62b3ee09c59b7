"""Small meshes in which everything occurs that creases have to get along with."""

from __future__ import annotations

import numpy as np

from glshim.geometry.recovery.mesh import Mesh, mesh
from tests import look, surfaces


def sent_by(m: Mesh, cut: float, seed: int) -> np.ndarray:
    """(T, 3, 3) normals of an app that duplicates vertices at a share of the edges: smoothing
    groups of triangles, each with a normal of its own at each vertex."""
    random = np.random.default_rng(seed)
    group = np.arange(len(m.triangles))
    a, b = m.faces[(m.faces[:, 1] >= 0) & (random.random(len(m.faces)) >= cut)].T
    for _ in range(len(m.triangles)):
        least = np.minimum(group[a], group[b])
        before = group.copy()
        np.minimum.at(group, a, least)
        np.minimum.at(group, b, least)
        if np.array_equal(before, group):
            break
    own = random.normal(size=(group.max(initial=0) + 1, 3))
    return (m.vertex_normals[m.triangles] + own[group][:, None]).astype(np.float32)


def dart() -> tuple[Mesh, np.ndarray]:
    """A flat disc with one crease from its middle to its rim: the middle is the tip of a dart."""
    ring = [(np.cos(a), np.sin(a), 0) for a in np.arange(6) * np.pi / 3]
    m = mesh(look.batch([(0, 0, 0), *ring], [[0, 1 + k, 1 + (k + 1) % 6] for k in range(6)]))
    sent = np.tile(np.array((0.0, 0.0, 1.0)), (6, 3, 1))
    for t, tri in enumerate(m.triangles):
        if set(tri) == {0, 1, 2}:
            sent[t, list(tri).index(1)] = (1, 0, 1)
    return m, sent.astype(np.float32)


def hourglass() -> Mesh:
    """Two closed cones that meet at their tips."""
    ring = [(np.cos(a), np.sin(a)) for a in np.arange(7) * 2 * np.pi / 7]
    points = [(0, 0, 0), *[(x, y, 1) for x, y in ring], *[(x, y, -1) for x, y in ring]]
    points += [(0, 0, 1), (0, 0, -1)]
    faces = []
    for k in range(7):
        j = (k + 1) % 7
        faces += [[0, 1 + k, 1 + j], [15, 1 + j, 1 + k], [0, 8 + j, 8 + k], [16, 8 + k, 8 + j]]
    return mesh(look.batch(points, faces))


MESHES = {
    "torus": mesh(look.torus(9, 6)),
    "bowl": mesh(look.bowl(8, 4)),
    "cube": mesh(look.cube()),
    "cylinder": mesh(look.cylinder()),
    "hourglass": hourglass(),
    "blob": mesh(look.batch(*surfaces.icosphere(1))),
    "dart": dart()[0],
    "three on an edge": mesh(look.batch(
        [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, -1, 0)], [[0, 1, 2], [1, 0, 3], [0, 1, 4]]
    )),
    "moebius": mesh(look.batch(
        [(0, 0, 0), (1, 0, 0), (0, 1, 1), (1, 1, 0), (0, 2, 0.5)],
        [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]],
    )),
    "bent quads": mesh(look.batch(
        [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0), (2, 0, 0), (2, 1, 3)],
        [[0, 1, 2, 3], [1, 4, 5, 2]],
    )),
    "nothing": mesh(look.batch([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [[0, 1, 2]])),
}  # fmt: skip


def beam(count: int, bend: float) -> Mesh:
    """A square beam along a slanted axis in count pieces, that bends by an angle at each."""
    square = np.array([(0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1)], float)
    points = []
    for k in range(count + 1):
        c, s = np.cos(bend * k), np.sin(bend * k)
        turn = np.array([(c, -s, 0), (s, c, 0), (0, 0, 1)])
        where = np.array([(np.cos(bend * j), np.sin(bend * j), 0.0) for j in range(k)])
        points.extend(square @ turn.T + 2 * where.reshape(-1, 3).sum(axis=0))
    faces = []
    for k in range(count):
        for i in range(4):
            j = (i + 1) % 4
            a, b, c, d = 4 * k + i, 4 * k + j, 4 * k + 4 + j, 4 * k + 4 + i
            faces += [[a, c, b], [a, d, c]]
    slanted = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    return mesh(look.batch(np.array(points) @ slanted.T, faces))


def zigzag(count: int) -> Mesh:
    """A band of triangles whose two rims run zigzag in x: forth and back by 0.6 a side."""
    c, s = 0.6, 0.8
    below = [(c * (k % 2), k * s, 0.0) for k in range(count)]
    above = [(c * (1 - k % 2), (k + 0.5) * s, s * np.sqrt(0.75)) for k in range(count)]
    faces = [[k, k + 1, count + k] for k in range(count - 1)]
    faces += [[k + 1, count + k + 1, count + k] for k in range(count - 1)]
    return mesh(look.batch(below + above, faces))
