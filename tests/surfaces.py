"""Welded meshes of surfaces with known curvature, (V, 3) float32 and (T, 3) int32."""

from __future__ import annotations

import numpy as np

TORUS = (1.0, 0.4)
"""Radii of ring and tube."""


def grid(point, m, n, closed):
    """m x n quads, halved, over point(u, v) with u, v in 0..1; outward as du x dv is."""
    rows, columns = (k if round_ else k + 1 for k, round_ in zip((m, n), closed, strict=True))
    i, j = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    u, v = np.broadcast_arrays(i / m, j / n)
    points = np.stack(np.broadcast_arrays(*point(u, v)), axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")

    def at(i, j):
        return (i % rows * columns + j % columns).ravel()

    a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    triangles = np.concatenate((np.stack((a, b, c), 1), np.stack((a, c, d), 1)))
    return points.astype(np.float32), triangles.astype(np.int32)


def torus(m, n):
    """Points, triangles, and the angles (V,) of each vertex around ring and tube."""
    big, small = TORUS

    def at(u, v):
        a, b = 2 * np.pi * u, 2 * np.pi * v
        r = big + small * np.cos(b)
        return r * np.cos(a), r * np.sin(a), small * np.sin(b)

    points, triangles = grid(at, m, n, (True, True))
    a, b = np.meshgrid(2 * np.pi * np.arange(m) / m, 2 * np.pi * np.arange(n) / n, indexing="ij")
    return points, triangles, a.ravel(), b.ravel()


def torus_normals(m, n):
    """(V, 3) float32 exact normals of the vertices of `torus`."""
    _, _, a, b = torus(m, n)
    normals = (np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b))
    return np.stack(normals, axis=1).astype(np.float32)


def icosphere(level, radius=1.0):
    """An icosahedron, each triangle cut into 4 level times."""
    g = (1 + 5**0.5) / 2
    ring = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0)]
    points = np.array([np.roll(p, k) for k in (0, 1, 2) for p in ring], float)
    points /= np.linalg.norm(points[0])
    near = points @ points.T > 0.4
    triangles = np.array(
        [
            (i, j, k)
            for i in range(12)
            for j in range(i)
            for k in range(j)
            if near[i, j] and near[j, k] and near[i, k]
        ]
    )
    corners = points[triangles]
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    triangles[volume < 0] = triangles[volume < 0][:, ::-1]
    for _ in range(level):
        sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        sides, which = np.unique(sides, axis=0, return_inverse=True)
        middle = points[sides].sum(axis=1)
        middle /= np.linalg.norm(middle, axis=1)[:, None]
        p, q, r = (which.reshape(-1, 3) + len(points)).T
        a, b, c = triangles.T
        points = np.concatenate((points, middle))
        parts = ((a, p, r), (p, b, q), (r, q, c), (p, q, r))
        triangles = np.concatenate([np.stack(part, axis=1) for part in parts])
    return (points * radius).astype(np.float32), triangles.astype(np.int32)


def blob(level):
    """A sphere with bumps and hollows."""
    points, triangles = icosphere(level)
    x, y, z = points.T.astype(float)
    radius = 1 + 0.18 * np.sin(3.1 * x + 1) * np.sin(4.2 * y + 0.3)
    radius += 0.12 * np.sin(5 * z + 2 * x) + 0.1 * np.cos(6 * y - 2 * z)
    return (points * radius[:, None]).astype(np.float32), triangles
