"""How a mesh bends at its vertices: principal curvatures, their derivatives, radial curvature.

Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes": within a
triangle, what the normals (then the curvatures) of its corners differ by determines the tensor in
the sense of least squares. A vertex takes the mean over its triangles, each turned into the
vertex's tangent plane and weighted by the part of its area that is nearest to the vertex.

A curvature is positive where the surface bends away from its normals: on a convex solid with
outward normals, 1 / r on a sphere. Triangles without area count for nothing. A vertex of no
triangle is flat.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from glshim.model.arrays import Doubles, Floats, Indices
from glshim.model.vectors import cross, dot, unit

_SLIVER = 1e-12
"""Squared area over the squared sum of squared sides, below which a triangle has no plane."""


class Curvature(NamedTuple):
    """Principal curvatures and directions of V vertices, k1 >= k2 as signed numbers."""

    k1: Floats
    """(V,) the greater, 1 / length."""
    k2: Floats
    """(V,) the lesser, 1 / length."""
    d1: Floats
    """(V, 3) unit direction of k1, perpendicular to the normal."""
    d2: Floats
    """(V, 3) ``normal x d1``."""


def principal_curvatures(
    positions: Floats, triangles: Indices, normals: Floats | None = None
) -> Curvature:
    """Principal curvatures and directions of each vertex (Rusinkiewicz 2004).

    positions (V, 3), triangles (T, 3) wound alike, normals (V, 3) of unit length, or None for
    `vertex_normals`.
    """
    faces = _Faces(positions, triangles)
    normal = _upright(vertex_normals(positions, triangles) if normals is None else normals)
    # A side (u, v) in the plane of the triangle and a difference of normals (p, q) belong together
    # under the sought tensor: (p, q) = ((a, b), (b, c)) (u, v).
    diagonal, right = np.zeros((3, len(faces))), np.zeros((3, len(faces)))
    off = np.zeros((2, len(faces)))
    for k in range(3):
        u, v = faces.sides[k]
        change = normal[faces.corners[:, k - 1]] - normal[faces.corners[:, k - 2]]
        p, q = dot(change, faces.t), dot(change, faces.b)
        diagonal += (u * u, u * u + v * v, v * v)
        off += u * v
        right += (p * u, p * v + q * u, q * v)
    a, b, c = _solve(diagonal, off, right)

    first, second = frames(normal)
    total = np.zeros((3, len(positions)))
    for k in range(3):
        (x, y), (z, w) = faces.turned(k, normal, first, second)
        parts = (
            a * x * x + 2 * b * x * y + c * y * y,
            a * x * z + b * (x * w + y * z) + c * y * w,
            a * z * z + 2 * b * z * w + c * w * w,
        )
        faces.gather(total, k, parts)
    a, b, c = total / faces.area(len(positions))
    mean, half = (a + c) / 2, (a - c) / 2
    spread, angle = np.hypot(half, b), np.arctan2(b, half) / 2
    d1 = np.cos(angle)[:, None] * first + np.sin(angle)[:, None] * second
    found = (mean + spread, mean - spread, d1, cross(normal, d1))
    return Curvature(*(x.astype(np.float32) for x in found))


def curvature_derivatives(positions: Floats, triangles: Indices, curvature: Curvature) -> Floats:
    """(V, 4) float32, how the tensor of curvature changes along the surface, 1 / length squared:
    C111, C112, C122, C222 of the symmetric tensor of rank 3 in the frame (d1, d2).

    Rusinkiewicz 2004, estimated like the curvatures, from what those differ by.
    """
    faces = _Faces(positions, triangles)
    first, second = curvature.d1.astype(np.float64), curvature.d2.astype(np.float64)
    normal = cross(first, second)
    k1, k2 = curvature.k1.astype(np.float64), curvature.k2.astype(np.float64)
    frame = [faces.turned(k, normal, first, second) for k in range(3)]
    tensor = []
    for k in range(3):
        (x, y), (z, w) = frame[k]
        m, n = k1[faces.corners[:, k]], k2[faces.corners[:, k]]
        tensor.append(
            np.stack((m * x * x + n * z * z, m * x * y + n * z * w, m * y * y + n * w * w))
        )
    diagonal, right = np.zeros((4, len(faces))), np.zeros((4, len(faces)))
    off = np.zeros((3, len(faces)))
    for k in range(3):
        u, v = faces.sides[k]
        p, q, r = tensor[k - 1] - tensor[k - 2]
        uu, uv, vv = u * u, u * v, v * v
        diagonal += (uu, vv + 2 * uu, 2 * vv + uu, vv)
        off += (uv, 2 * uv, uv)
        right += (p * u, p * v + 2 * q * u, 2 * q * v + r * u, r * v)
    a, b, c, d = _solve(diagonal, off, right)

    total = np.zeros((4, len(positions)))
    for k in range(3):
        (x, y), (z, w) = frame[k]
        parts = (
            a * x**3 + 3 * b * x * x * y + 3 * c * x * y * y + d * y**3,
            a * x * x * z
            + b * (x * x * w + 2 * x * y * z)
            + c * (y * y * z + 2 * x * y * w)
            + d * y * y * w,
            a * x * z * z
            + b * (z * z * y + 2 * x * z * w)
            + c * (w * w * x + 2 * y * z * w)
            + d * y * w * w,
            a * z**3 + 3 * b * z * z * w + 3 * c * z * w * w + d * w**3,
        )
        faces.gather(total, k, parts)
    return np.ascontiguousarray((total / faces.area(len(positions))).T, np.float32)


def radial_curvature(curvature: Curvature, positions: Floats, eye: Doubles) -> Floats:
    """(V,) curvature in the direction of the viewer, ``(d1.w)^2 k1 + (d2.w)^2 k2`` (McGuire and
    Hughes 2004, appendix A), w the unit projection of `towards` into the tangent plane.

    Zero where the viewer looks along the normal and there is no w.
    """
    k1, k2, d1, d2 = curvature
    sight = towards(positions, eye)
    u, v = _dot(d1, sight), _dot(d2, sight)
    u *= u
    v *= v
    return np.asarray((u * k1 + v * k2) / np.maximum(u + v, np.finfo(np.float32).tiny))


def radial_derivative(
    curvature: Curvature, derivatives: Floats, normals: Floats, positions: Floats, eye: Doubles
) -> Floats:
    """(V,) derivative of `radial_curvature` along w, 1 / length squared.

    ``C(w, w, w) - 2 t^2 cot(angle of n and e)``, where t is the radial torsion: w itself turns
    with the surface. On a zero of radial curvature, -t^2 is the Gaussian curvature (DeCarlo et
    al. 2004). derivatives as `curvature_derivatives` has them.
    """
    k1, k2, d1, d2 = curvature
    sight = towards(positions, eye)
    u, v = _dot(d1, sight), _dot(d2, sight)
    length = np.maximum(np.hypot(u, v), np.finfo(np.float32).tiny)
    cot = _dot(normals, sight) / length
    u /= length
    v /= length
    a, b, c, d = derivatives.T
    along = u * u * (u * a + 3 * v * b) + v * v * (3 * u * c + v * d)
    return np.asarray(along - 2 * ((k2 - k1) * u * v) ** 2 * cot)


def towards(positions: Floats, eye: Doubles) -> Floats:
    """(V, 3) from each position to the viewer, not of unit length but for a parallel view.

    eye (4,) in the space of positions, homogeneous: a point (of any w but 0), or the direction
    towards the viewer (w = 0). ``inv(modelview) @ Camera.viewpoint`` is one.
    """
    spot = np.asarray(eye, np.float64)
    length = float(np.linalg.norm(spot[:3]))
    if abs(spot[3]) <= 1e-12 * length or spot[3] == 0.0:  # what an inverse leaves of w = 0
        direction = (spot[:3] / max(length, 1e-300)).astype(np.float32)
        return np.broadcast_to(direction, np.shape(positions))
    return np.asarray((spot[:3] / spot[3]).astype(np.float32) - positions)


def vertex_normals(positions: Floats, triangles: Indices) -> Doubles:
    """(V, 3) unit normals, exact for vertices on a sphere (Max 1999, "Weights for computing vertex
    normals from facet normals"); zero for no triangle.

    Triangles below a hundredth of the greatest at a vertex have no say in it: such small ones are
    often folded over (the tip of GLUT's teapot is ringed by them).
    """
    faces = _Faces(positions, triangles)
    greatest, total = np.zeros(len(positions)), np.zeros((3, len(positions)))
    lengths = (faces.sides**2).sum(axis=1)
    for k in range(3):
        np.maximum.at(greatest, faces.corners[:, k], faces.size)
    for k in range(3):
        at = faces.corners[:, k]
        weight = faces.size / (lengths[k - 1] * lengths[k - 2])
        weight[faces.size < 0.01 * greatest[at]] = 0.0
        for axis in range(3):
            total[axis] += np.bincount(at, weight * faces.n[:, axis], len(positions))
    return unit(np.ascontiguousarray(total.T))


def frames(normals: Doubles) -> tuple[Doubles, Doubles]:
    """Two (V, 3), which with unit normals (V, 3) form right-handed orthonormal frames
    (Duff et al. 2017, "Building an orthonormal basis, revisited")."""
    x, y, z = normals.T
    sign = np.copysign(1.0, z)
    a = -1.0 / (sign + z)
    b = x * y * a
    return (
        np.stack((1.0 + sign * x * x * a, sign * b, -sign * x), axis=1),
        np.stack((b, sign + y * y * a, -y), axis=1),
    )


class _Faces:
    """Triangles that have an area, each with a frame in its own plane."""

    def __init__(self, positions: Floats, triangles: Indices) -> None:
        place = np.asarray(positions, np.float64)
        corners = np.asarray(triangles).reshape(-1, 3)
        with np.errstate(invalid="ignore", over="ignore"):
            one, two, three = (place[corners[:, k]] for k in range(3))
            sides = (three - two, one - three, two - one)
            normal = cross(sides[0], sides[1])
            square = sum(dot(side, side) for side in sides)
            keep = np.flatnonzero(dot(normal, normal) > _SLIVER * square * square)
        self.corners = corners[keep]
        """(F, 3) the vertices."""
        self.n = unit(normal[keep])
        self.t = unit(sides[0][keep])
        self.b = cross(self.n, self.t)
        """(F, 3) unit vectors: normal, along side 0, and the third."""
        self.sides = np.stack(
            [(dot(s, self.t), dot(s, self.b)) for s in (side[keep] for side in sides)]
        )
        """(3, 2, F) side k, opposite to corner k, in the frame (t, b)."""
        (x, y), (z, w) = self.sides[0], self.sides[1]
        self.size = (x * w - y * z) / 2
        """(F,) area."""
        self.share = self._mixed()
        """(3, F) the part of the area that is nearest to each corner."""

    def __len__(self) -> int:
        return len(self.corners)

    def _mixed(self) -> Doubles:
        """Voronoi areas of the corners; half and twice a quarter of an obtuse triangle (Meyer et
        al. 2003)."""
        # -2 / tan of the angle at corner k, times the area.
        lean = np.stack([(self.sides[k - 1] * self.sides[k - 2]).sum(axis=0) for k in range(3)])
        length = (self.sides**2).sum(axis=1)
        share = np.stack(
            [
                -(length[k - 1] * lean[k - 1] + length[k - 2] * lean[k - 2]) / (16 * self.size)
                for k in range(3)
            ]
        )
        obtuse = lean > 0.0
        share = np.where(obtuse.any(axis=0), self.size / np.where(obtuse, 2, 4), share)
        return np.asarray(share)

    def turned(
        self, k: int, normal: Doubles, first: Doubles, second: Doubles
    ) -> tuple[tuple[Doubles, Doubles], tuple[Doubles, Doubles]]:
        """Frames (V, 3) of the vertices at corner k, tilted into the planes of the triangles about
        what both planes have in common: the parts (F,) of each along t and b."""
        at = self.corners[:, k]
        upright = normal[at]
        # A vector x of the tangent plane becomes x - s (n.x), s = (m + n) / (1 + m.n) for
        # normals m of the vertex and n of the triangle. Of these, m alone has parts along t and b.
        scale = 1.0 / np.maximum(1.0 + dot(self.n, upright), 1e-6)
        lean = scale * dot(upright, self.t), scale * dot(upright, self.b)
        out = []
        for axis in (first[at], second[at]):
            away = dot(axis, self.n)
            out.append((dot(axis, self.t) - lean[0] * away, dot(axis, self.b) - lean[1] * away))
        return out[0], out[1]

    def gather(self, total: Doubles, k: int, parts: tuple[Doubles, ...]) -> None:
        """Add parts (F,) each, weighted, to the vertices (V,) at corner k."""
        for i, part in enumerate(parts):
            total[i] += np.bincount(self.corners[:, k], part * self.share[k], total.shape[1])

    def area(self, vertices: int) -> Doubles:
        """(V,) sums of the weights, never zero."""
        total = np.zeros(vertices)
        for k in range(3):
            total += np.bincount(self.corners[:, k], self.share[k], vertices)
        return np.where(total > 0.0, total, 1.0)


def _solve(diagonal: Doubles, off: Doubles, right: Doubles) -> Doubles:
    """(n, F) solutions of F symmetric, definite systems with one band beside the diagonal."""
    count = len(diagonal)
    for i in range(1, count):
        factor = off[i - 1] / diagonal[i - 1]
        diagonal[i] -= factor * off[i - 1]
        right[i] -= factor * right[i - 1]
    for i in reversed(range(count)):
        if i + 1 < count:
            right[i] -= off[i] * right[i + 1]
        right[i] /= diagonal[i]
    return right


def _upright(normals: Floats | Doubles) -> Doubles:
    """(V, 3) float64 unit normals, with some direction where there is none."""
    normal = unit(np.asarray(normals, np.float64))
    normal[~(dot(normal, normal) > 0.5)] = (0.0, 0.0, 1.0)
    return normal


def _dot(u: Floats, v: Floats) -> Floats:
    """(V,) products of rows, in float32."""
    return np.asarray(np.einsum("ij,ij->i", u, v))
