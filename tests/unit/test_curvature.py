"""Curvature of meshes whose surface is known."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from glshim.geometry.contour.curvature import (
    Curvature,
    curvature_derivatives,
    frames,
    principal_curvatures,
    radial_curvature,
    radial_derivative,
    towards,
    vertex_normals,
)
from tests.surfaces import TORUS, grid, icosphere, torus, torus_normals


def rows(u, v):
    return np.einsum("ij,ij->i", u, v)


def interior(m, n):
    """Vertices of an open grid that no border is near."""
    i, j = np.meshgrid(np.arange(m), np.arange(n), indexing="ij")
    return ((i > 1) & (i < m - 2) & (j > 1) & (j < n - 2)).ravel()


def halves(errors, at_least=3.0):
    """Whether each error is the one before over at_least (4 for second order)."""
    return all(b < a / at_least for a, b in itertools.pairwise(errors))


@pytest.mark.parametrize("radius", [1e-3, 0.7, 1e4])
def test_a_sphere_bends_by_one_over_its_radius_everywhere(radius):
    points, triangles = icosphere(3, radius)
    found = principal_curvatures(points, triangles)
    assert np.allclose(found.k1 * radius, 1.0, atol=2e-3)
    assert np.allclose(found.k2 * radius, 1.0, atol=2e-3)


def test_from_inside_a_sphere_is_concave():
    points, triangles = icosphere(2, 2.0)
    found = principal_curvatures(points, triangles[:, ::-1])
    assert np.allclose(found.k1, -0.5, atol=5e-3) and np.allclose(found.k2, -0.5, atol=5e-3)


def shoved(level):
    """A sphere with its vertices shoved about: triangles of all shapes, no two rings alike."""
    points, triangles = icosphere(level)
    points = points + np.random.default_rng(3).normal(size=points.shape) * 0.12 / 2**level
    return points / np.linalg.norm(points, axis=1)[:, None], triangles


@pytest.mark.parametrize("given", [False, True])
def test_a_sphere_is_exact_however_it_is_cut(given):
    points, triangles = shoved(3)
    found = principal_curvatures(points.astype(np.float32), triangles, points if given else None)
    assert max(abs(found.k1 - 1).max(), abs(found.k2 - 1).max()) < 1e-3


def test_an_ellipsoid_cut_irregularly_converges():
    axes = np.array([1.0, 0.7, 0.5])
    errors = []
    for level in (3, 4, 5):
        ball, triangles = shoved(level)
        points, normals = ball * axes, ball / axes
        size = np.linalg.norm(normals, axis=1)
        found = principal_curvatures(points.astype(np.float32), triangles, normals / size[:, None])
        gauss = 1 / (axes.prod() ** 2 * size**4)
        mean = ((axes**2).sum() - rows(points, points)) / (2 * axes.prod() ** 2 * size**3)
        spread = np.sqrt(np.maximum(mean**2 - gauss, 0.0))
        wrong = np.maximum(abs(found.k1 - mean - spread), abs(found.k2 - mean + spread))
        errors.append((wrong**2).mean() ** 0.5)
    assert errors[-1] < 0.02 and halves(errors, 1.8)


def test_directions_form_a_right_handed_frame_with_the_normal():
    points, triangles, _, _ = torus(24, 12)
    normals = torus_normals(24, 12)
    found = principal_curvatures(points, triangles, normals)
    assert (found.k1 >= found.k2).all()
    assert np.allclose(np.cross(found.d1, found.d2), normals, atol=1e-5)
    assert np.allclose(rows(found.d1, found.d1), 1.0, atol=1e-5)


def test_a_cylinder_bends_around_and_not_along():
    points, triangles = grid(
        lambda u, v: (0.5 * np.cos(2 * np.pi * u), 0.5 * np.sin(2 * np.pi * u), 2 * v),
        24,
        6,
        closed=(True, False),
    )
    for normals in (points * (2, 2, 0), None):
        found = principal_curvatures(points, triangles, normals)
        ends = (points[:, 2] == 0) | (points[:, 2] == 2)
        inside = ~ends if normals is None else np.ones(len(points), bool)
        assert abs(found.k1 - 2.0)[inside].max() < 1e-4
        assert abs(found.k2)[inside].max() < 1e-4
        assert np.allclose(abs(found.d2[inside, 2]), 1.0, atol=1e-4)


def test_a_torus_has_its_curvatures_and_directions():
    big, small = TORUS
    outer, inner, turned = [], [], []
    for n in (16, 32, 64):
        points, triangles, a, b = torus(2 * n, n)
        found = principal_curvatures(points, triangles)
        outer.append(abs(found.k1 - 1 / small).max())
        inner.append(abs(found.k2 - np.cos(b) / (big + small * np.cos(b))).max())
        round_tube = np.stack(
            (-np.cos(a) * np.sin(b), -np.sin(a) * np.sin(b), np.cos(b)), axis=1
        )  # fmt: skip
        turned.append(1 - abs(rows(found.d1, round_tube)).min())
    assert outer[-1] < 0.01 and inner[-1] < 0.02 and turned[-1] < 1e-5
    assert halves(outer) and halves(inner) and halves(turned)


def test_a_saddle_has_one_of_each():
    errors = []
    for n in (17, 33, 65):
        points, triangles = grid(
            lambda u, v: (2 * u - 1, 2 * v - 1, ((2 * u - 1) ** 2 - (2 * v - 1) ** 2) / 2),
            n - 1, n - 1, closed=(False, False),
        )  # fmt: skip
        x, y, _ = points.T.astype(float)
        found = principal_curvatures(points, triangles, unit_rows(-x, y, np.ones_like(x)))
        # Monge patch z = (x^2 - y^2) / 2; bending up is concave under an upward normal.
        g = 1 + x * x + y * y
        gauss = -1 / g**2
        mean = -((1 + y * y) - (1 + x * x)) / (2 * g**1.5)
        spread = np.sqrt(mean**2 - gauss)
        inside = interior(n, n)
        errors.append(
            max(
                abs(found.k1 - mean - spread)[inside].max(),
                abs(found.k2 - mean + spread)[inside].max(),
            )
        )
        middle = np.argmin(x * x + y * y)
        assert abs(found.d1[middle, 1]) > 0.999 and abs(found.d2[middle, 0]) > 0.999
    assert errors[-1] < 5e-3 and halves(errors, 2.5)


def unit_rows(x, y, z):
    v = np.stack((x, y, z), axis=1)
    return v / np.linalg.norm(v, axis=1)[:, None]


def test_derivatives_on_a_torus():
    big, small = TORUS
    errors = []
    for n in (16, 32, 64):
        points, triangles, a, b = torus(2 * n, n)
        found = principal_curvatures(points, triangles)
        tensor = curvature_derivatives(points, triangles, found)
        round_tube = np.stack(
            (-np.cos(a) * np.sin(b), -np.sin(a) * np.sin(b), np.cos(b)), axis=1
        )  # fmt: skip
        sign = np.sign(rows(found.d1, round_tube))
        # k2 changes around the tube, by b / small; nothing else changes along d1 or d2.
        change = -big * np.sin(b) / (big + small * np.cos(b)) ** 2 / small
        assert abs(change).max() > 2.0
        expected = np.zeros((len(points), 4))
        expected[:, 2] = sign * change
        errors.append(abs(tensor - expected).max())
    assert errors[-1] < 0.08 and halves(errors)


@pytest.mark.parametrize("eye", [(3.0, 1.0, 2.5, 1.0), (0.3, -0.5, 0.8, 0.0)])
def test_radial_curvature_and_its_derivative_are_those_of_the_torus(eye):
    big, small = TORUS
    points, triangles, a, b = torus(160, 80)
    found = principal_curvatures(points, triangles)
    normals = vertex_normals(points, triangles)
    eye = np.array(eye)

    def exact(a, b):
        n = np.stack((np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)), axis=1)
        tube = np.stack((-np.cos(a) * np.sin(b), -np.sin(a) * np.sin(b), np.cos(b)), axis=1)
        ring = np.stack((-np.sin(a), np.cos(a), 0 * a), axis=1)
        r = big + small * np.cos(b)
        p = np.stack((r * np.cos(a), r * np.sin(a), small * np.sin(b)), axis=1)
        e = eye[:3] - eye[3] * p
        w = e - n * rows(n, e)[:, None]
        length = np.linalg.norm(w, axis=1)
        x, y = rows(tube, w) / length, rows(ring, w) / length
        return x * x / small + y * y * np.cos(b) / r, x / small, y / r, length

    radial, db, da, length = exact(a, b)
    seen = length > 0.5
    assert abs(radial_curvature(found, points, eye) - radial)[seen].max() < 0.02
    h = 1e-5
    slope = (exact(a + h * da, b + h * db)[0] - exact(a - h * da, b - h * db)[0]) / (2 * h)
    got = radial_derivative(
        found, curvature_derivatives(points, triangles, found), normals, points, eye
    )
    assert np.ptp(slope[seen]) > 5.0
    assert abs(got - slope)[seen].max() < 0.02 * np.ptp(slope[seen])


def test_looking_along_the_normal_there_is_no_radial_curvature():
    points = np.zeros((1, 3), np.float32)
    flat = (np.array([k], np.float32) for k in (3.0, 2.0))
    found = Curvature(*flat, np.float32([[1, 0, 0]]), np.float32([[0, 1, 0]]))
    assert radial_curvature(found, points, np.array([0, 0, 5.0, 1])) == [0.0]
    up = np.float32([[0, 0, 1]])
    slope = radial_derivative(
        found, np.ones((1, 4), np.float32), up, points, np.array([0, 0, 1, 0])
    )
    assert np.isfinite(slope).all()


def test_an_eye_is_homogeneous():
    points = np.float32([[1, 2, 3], [0, 0, 0]])
    at = towards(points, np.array([2.0, 2.0, 5.0, 1.0]))
    assert np.allclose(at, [[1, 0, 2], [2, 2, 5]])
    assert np.allclose(towards(points, np.array([-4.0, -4.0, -10.0, -2.0])), at)
    for w in (0.0, 1e-17, -1e-40):
        assert np.allclose(towards(points, np.array([0.0, 0.0, -7.0, w])), [[0, 0, -1]] * 2)


def test_frames_are_orthonormal_and_right_handed():
    normals = np.random.default_rng(1).normal(size=(500, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    normals[:4] = [(0, 0, 1), (0, 0, -1), (0, 1, -0.0), (1, 0, 0)]
    first, second = frames(normals)
    assert np.allclose(np.cross(first, second), normals)
    assert np.allclose(rows(first, first), 1)


def test_what_has_no_area_or_no_triangle_is_flat_and_spoils_nothing():
    points, triangles = icosphere(2, 1.0)
    whole = principal_curvatures(points, triangles)
    count = len(points)
    odd = np.float32([[5, 5, 5], [np.nan, 0, 0], [0, 0, 0], [1, 0, 0], [2, 0, 0]])
    bad = [[0, 0, 1], [3, 3, 3], [count + 2, count + 3, count + 4], [0, 1, count + 1]]
    found = principal_curvatures(
        np.concatenate((points, odd)), np.concatenate((triangles, np.int32(bad)))
    )
    tensor = curvature_derivatives(
        np.concatenate((points, odd)), np.concatenate((triangles, np.int32(bad))), found
    )
    assert np.isfinite(tensor).all() and (tensor[count:] == 0).all()
    for part, expected in zip(found, whole, strict=True):
        assert np.isfinite(part).all()
        assert np.array_equal(part[:count], expected)
    assert (found.k1[count:] == 0).all() and (found.k2[count:] == 0).all()


def test_normals_of_zero_and_normals_against_the_winding_stay_finite():
    points, triangles = icosphere(2, 1.0)
    normals = vertex_normals(points, triangles)
    for broken in (
        normals * 0,
        -normals,
        np.where(np.arange(len(normals))[:, None] % 3, 0, normals),
    ):
        found = principal_curvatures(points, triangles, broken.astype(np.float32))
        assert all(np.isfinite(part).all() for part in found)


def test_tiny_triangles_folded_over_do_not_turn_normals():
    points, triangles, _, _ = torus(24, 12)
    # A fan about the middle of a triangle, whose middle lies outside it by a hair.
    corners = points[triangles[0]]
    hair = corners[0] + 0.01 * (corners[0] - corners[1:].mean(axis=0))
    i, j, k = triangles[0]
    fan = np.int32([[i, j, len(points)], [j, k, len(points)], [k, i, len(points)]])
    folded = np.concatenate((triangles[1:], fan))
    normals = vertex_normals(np.concatenate((points, [hair])).astype(np.float32), folded)
    assert (rows(normals[:-1], torus_normals(24, 12)) > 0.98).all()


def test_no_triangles():
    empty = np.empty((0, 3))
    for points in (np.empty((0, 3), np.float32), np.zeros((4, 3), np.float32)):
        found = principal_curvatures(points, empty.astype(np.int32))
        assert found.k1.shape == (len(points),) and found.d2.shape == (len(points), 3)
        assert (found.k1 == 0).all()
