"""Zero sets on meshes, smooth contours and suggestive contours."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.contour.contours import (
    Segments,
    facing,
    smooth_contours,
    suggestive_contours,
    zero_segments,
)
from glshim.geometry.contour.curvature import (
    curvature_derivatives,
    principal_curvatures,
    radial_curvature,
    vertex_normals,
)
from glshim.model.camera import Camera
from tests import look
from tests.counted import work
from tests.surfaces import TORUS, blob, grid, icosphere, torus, torus_normals

EYES = [(2.0, 3.0, 4.0, 1.0), (0.3, -0.5, 0.8, 0.0), (-4.0, -6.0, -8.0, -2.0)]


def rows(u, v):
    return np.einsum("ij,ij->i", u, v)


def linked(found: Segments) -> bool:
    """Whether every end is the start of exactly one segment and every start an end, to the bit."""
    start, end = np.argsort(found.side[:, 0]), np.argsort(found.side[:, 1])
    sides = found.side[start, 0]
    return (
        len(np.unique(sides)) == len(sides)
        and np.array_equal(sides, found.side[end, 1])
        and np.array_equal(found.ends[start, 0], found.ends[end, 1])
    )


def one(values, points=((0, 0, 0), (1, 0, 0), (0, 1, 0))):
    return zero_segments(np.float32(points), np.int32([[0, 1, 2]]), np.float32(values))


def shape(points, triangles):
    """What contours need of a mesh."""
    normals = vertex_normals(points, triangles).astype(np.float32)
    curvature = principal_curvatures(points, triangles, normals)
    return points, triangles, normals, curvature


@pytest.mark.parametrize("values", [(1, -1, -3), (-1, 1, 3), (-3, 1, -1), (1, 3, -1), (0, 0, -1)])
def test_a_segment_lies_where_the_linear_number_is_zero_with_positive_at_the_left(values):
    found = one(values)
    assert len(found) == 1 and found.triangle.tolist() == [0]
    a, b, c = values
    x, y = found.ends[0, :, 0], found.ends[0, :, 1]
    assert np.allclose(a + (b - a) * x + (c - a) * y, 0, atol=1e-6)
    along = found.ends[0, 1] - found.ends[0, 0]
    assert (b - a) * -along[1] + (c - a) * along[0] > 0  # the gradient points to the left
    corners = np.float32([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
    assert np.allclose(found.weights[0] @ corners, found.ends[0])
    assert np.allclose(found.interpolate(np.int32([[0, 1, 2]]), np.float32(values)), 0, atol=1e-6)


@pytest.mark.parametrize("values", [(1, 2, 3), (-1, -2, -3), (0, 0, 0), (0, 0, 1), (0, 1, 2)])
def test_without_a_negative_and_a_positive_corner_there_is_none(values):
    assert len(one(values)) == 0


def test_zero_is_positive():
    point = one((0, -1, -1))
    assert len(point) == 1 and (point.ends == 0).all()
    through = one((0, -1, 1))
    assert np.allclose(sorted(map(tuple, through.ends[0])), [(0, 0, 0), (0.5, 0.5, 0)])


def test_what_is_not_finite_gives_nothing():
    assert len(one((np.nan, 1, -1))) == 0
    assert len(one((np.inf, 1, -1))) == 0
    assert len(one((1, 1, -1), ((0, 0, 0), (1, 0, 0), (np.nan, 0, 0)))) == 0
    huge = one((3e38, -3e38, -3e38))
    assert np.allclose(huge.ends[0, :, :2].sum(axis=1), 0.5)
    tiny = one((1e-45, -1e-45, -1e-45))
    assert np.allclose(tiny.ends[0, :, :2].sum(axis=1), 0.5)


def test_a_corner_twice_breaks_no_chain():
    points, triangles, _, _ = torus(12, 8)
    values = points[:, 0] - np.float32(0.13)
    whole = zero_segments(points, triangles, values)
    crossed = triangles[whole.triangle[0]]
    folded = np.concatenate((triangles, [crossed[[0, 0, 1]], crossed[[2, 0, 2]]])).astype(np.int32)
    assert np.array_equal(zero_segments(points, folded, values).ends, whole.ends)


def test_triangles_on_a_line_have_finite_segments():
    found = one((1, -1, -1), ((0, 0, 0), (1, 0, 0), (2, 0, 0)))
    assert np.allclose(sorted(found.ends[0, :, 0]), [0.5, 1.0])


levels = st.integers(0, 2)
numbers = st.sampled_from([-2.0, -1.0, -0.25, -0.0, 0.0, 0.5, 1.0, 3.0])


@settings(max_examples=60, deadline=None)
@given(st.sampled_from(["sphere", "torus"]), st.data())
def test_on_a_closed_mesh_every_end_is_shared_by_exactly_two(kind, data):
    points, triangles = icosphere(1) if kind == "sphere" else torus(6, 5)[:2]
    count = len(points)
    values = np.float32(data.draw(st.lists(numbers, min_size=count, max_size=count)))
    found = zero_segments(points, triangles, values)
    mixed = (values >= 0)[triangles]
    assert len(found) == (mixed.any(axis=1) & ~mixed.all(axis=1)).sum()
    assert (np.unique(found.side, return_counts=True)[1] == 2).all()
    assert linked(found)
    assert np.isfinite(found.ends).all()


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_chains_are_what_links_up(seed):
    rng = np.random.default_rng(seed)
    points, triangles = icosphere(2)
    found = zero_segments(points, triangles, rng.normal(size=len(points)).astype(np.float32))
    found = found.take(rng.permutation(len(found))[: rng.integers(1, len(found) + 1)])
    chain = found.chains()
    # By hand: flood from each segment over equal sides.
    expected = np.full(len(found), -1)
    for start in range(len(found)):
        todo = [start] if expected[start] < 0 else []
        while todo:
            at = todo.pop()
            expected[at] = start
            near = np.isin(found.side, found.side[at]).any(axis=1) & (expected < 0)
            todo.extend(np.flatnonzero(near))
    assert len(set(zip(chain, expected, strict=True))) == len(set(chain)) == len(set(expected))


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("radius", [1e-3, 1.0, 50.0])
def test_the_smooth_contour_of_a_sphere_is_a_circle(eye, radius):
    points, triangles = icosphere(4, radius)
    eye = np.array(eye) * (radius, radius, radius, 1)
    found = smooth_contours(points, triangles, points / np.float32(radius), eye)
    assert linked(found) and len(set(found.chains())) == 1
    spot = eye[:3] / (eye[3] or 1)
    away = np.linalg.norm(spot)
    # Tangents from the eye touch in the plane p . eye = r^2; from far away, p . eye = 0.
    height = found.ends @ (spot / away)
    expected = radius**2 / away if eye[3] else 0.0
    assert abs(height - expected).max() < 1e-5 * radius
    distance = np.linalg.norm(found.ends, axis=2)
    assert distance.max() <= radius * 1.0001 and distance.min() > radius * 0.995
    # The near side at the left, seen from outside.
    middle, along = found.ends.mean(axis=1), found.ends[:, 1] - found.ends[:, 0]
    left = np.cross(middle, along)
    assert (left @ spot > 0).all()


@pytest.mark.parametrize("projection", [look.perspective(), look.orthographic()])
def test_the_eye_of_a_camera(projection):
    modelview = look.look_at((2, 3, 4)) @ np.diag((2.0, 2.0, 2.0, 1.0))
    camera = Camera(modelview, projection, (0, 0, 100, 100))
    points, triangles = icosphere(3)
    by_hand = np.array((2.0, 3.0, 4.0, 0.0 if camera.orthographic else 2.0))
    expected = smooth_contours(points, triangles, points, by_hand)
    for eye in (np.linalg.inv(modelview) @ camera.viewpoint, camera.object_centre):
        found = smooth_contours(points, triangles, points, eye)
        assert np.array_equal(found.triangle, expected.triangle)
        assert np.allclose(found.ends, expected.ends, atol=1e-5)


def test_the_smooth_contour_converges():
    eye, errors = np.array((0.0, -3.0, 1.6, 1.0)), []
    for n in (20, 40, 80):
        points, triangles, _, _ = torus(2 * n, n)
        found = smooth_contours(points, triangles, torus_normals(2 * n, n), eye)
        _, normal, _, e = radial_of_torus(found.ends.reshape(-1, 3).astype(float), eye)
        errors.append(abs(rows(normal, e)).max())
    assert errors[1] < errors[0] / 3 and errors[2] < errors[1] / 3 and errors[2] < 0.01


def test_a_torus_from_above_has_two_contours():
    points, triangles, _, _ = torus(60, 30)
    found = smooth_contours(points, triangles, torus_normals(60, 30), np.array([0.1, 0.05, 1, 0]))
    assert linked(found) and len(set(found.chains())) == 2


def radial_of_torus(points, eye):
    """Exact radial curvature for points near the torus."""
    big, small = TORUS
    a = np.arctan2(points[:, 1], points[:, 0])
    out = np.hypot(points[:, 0], points[:, 1]) - big
    b = np.arctan2(points[:, 2], out)
    n = np.stack((np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)), axis=1)
    tube = np.stack((-np.cos(a) * np.sin(b), -np.sin(a) * np.sin(b), np.cos(b)), axis=1)
    ring = np.stack((-np.sin(a), np.cos(a), 0 * a), axis=1)
    e = eye[:3] - eye[3] * points
    w = e - n * rows(n, e)[:, None]
    w /= np.linalg.norm(w, axis=1)[:, None]
    radial = rows(tube, w) ** 2 / small
    return radial + rows(ring, w) ** 2 * np.cos(b) / (big + small * np.cos(b)), n, w, e


@pytest.mark.parametrize("eye", [(0.0, -3.0, 1.6, 1.0), (0.2, -0.9, 0.45, 0.0)])
@pytest.mark.parametrize("tensor", [False, True])
def test_suggestive_contours_of_a_torus_are_zeros_of_its_radial_curvature(eye, tensor):
    eye, errors = np.array(eye), []
    for n in (40, 80):
        points, triangles, normals, curvature = shape(*torus(2 * n, n)[:2])
        derivatives = curvature_derivatives(points, triangles, curvature) if tensor else None
        found = suggestive_contours(
            points, triangles, normals, curvature, eye, derivatives=derivatives
        )
        assert len(found) > n / 4
        middle = found.ends.mean(axis=1).astype(float)
        radial, normal, w, e = radial_of_torus(middle, eye)
        assert (rows(normal, e) > -0.01).all()
        step = 1e-3
        rise = (
            radial_of_torus(middle + step * w, eye)[0] - radial_of_torus(middle - step * w, eye)[0]
        )
        assert (rise / (2 * step) > -0.5).all() and (rise > 0).mean() > 0.9
        errors.append(abs(radial).max())
    assert errors[1] < errors[0] / 2 and errors[1] < 0.05


def test_no_zero_that_counts_is_missing():
    eye = np.array((0.0, -3.0, 1.6, 1.0))
    points, triangles, normals, curvature = shape(*torus(120, 60)[:2])
    radial = radial_of_torus(points.astype(float), eye)[0].astype(np.float32)
    whole = zero_segments(points, triangles, radial)
    middle = whole.ends.mean(axis=1).astype(float)
    _, normal, w, e = radial_of_torus(middle, eye)
    step = 1e-3
    rise = radial_of_torus(middle + step * w, eye)[0] - radial_of_torus(middle - step * w, eye)[0]
    cosine = rows(normal, e) / np.linalg.norm(e, axis=1)
    sure = (rise / (2 * step) > 1.5) & (cosine > 0.05) & (cosine < np.cos(np.radians(25)))
    assert sure.sum() > 20
    found = suggestive_contours(points, triangles, normals, curvature, eye)
    got = found.ends.mean(axis=1)
    nearest = np.linalg.norm(middle[sure][:, None] - got[None], axis=2).min(axis=1)
    assert nearest.max() < 0.03


@pytest.mark.parametrize("convex", ["sphere", "cylinder"])
def test_what_is_convex_suggests_nothing(convex):
    if convex == "sphere":
        points, triangles = icosphere(4)
    else:
        points, triangles = grid(
            lambda u, v: (np.cos(2 * np.pi * u), np.sin(2 * np.pi * u), 3 * v),
            48, 12, (True, False),
        )  # fmt: skip
    for eye in EYES:
        assert len(suggestive_contours(*shape(points, triangles), np.array(eye))) == 0


BLOB_EYES = [(4.0, 1.2, 2.0, 1.0), (-1.0, 2.0, 3.0, 1.0), (0.5, -0.6, 0.6, 0.0)]


@pytest.mark.parametrize("eye", BLOB_EYES)
def test_options_of_suggestive_contours(eye):
    mesh, eye = shape(*blob(4)), np.array(eye)
    points, triangles, normals, _ = mesh

    def found(**options):
        return suggestive_contours(*mesh, eye, **options)

    def of(segments):
        return set(zip(segments.triangle.tolist(), map(bytes, segments.ends), strict=True))

    plain, single, every = found(), found(hysteresis=1.0), found(slope=0.0)
    assert of(single) < of(plain) or of(single) == of(plain)
    assert of(plain) <= of(every)
    # What hysteresis adds hangs on something that was there: chains are the same in number.
    assert len(set(plain.chains())) <= len(set(single.chains()))
    assert set(plain.chains()[np.isin(plain.triangle, single.triangle)]) == set(plain.chains())
    strict = found(slope=8.0, hysteresis=1.0), found(slope=8.0, hysteresis=0.1)
    assert of(strict[0]) < of(strict[1]) < of(every)
    # All face the viewer, and none nearer to head-on than theta.
    front = np.einsum(
        "sk,sk->s",
        every.weights.mean(axis=1),
        facing(points, normals, eye)[triangles[every.triangle]],
    )
    assert (front > 0).all()
    wide = found(theta=np.radians(60))
    assert 0 < len(wide) < len(found(theta=0.0))
    middle = wide.ends.mean(axis=1)
    sight = eye[:3] - eye[3] * middle
    normal = wide.interpolate(triangles, normals).mean(axis=1)
    cosine = rows(normal, sight) / np.linalg.norm(sight, axis=1) / np.linalg.norm(normal, axis=1)
    assert (cosine < np.cos(np.radians(57))).all()


def test_hysteresis_bridges_and_its_lack_breaks():
    mesh, eye = shape(*blob(5)), np.array(BLOB_EYES[0])
    joined = suggestive_contours(*mesh, eye, slope=6.0, hysteresis=0.1)
    broken = suggestive_contours(*mesh, eye, slope=6.0, hysteresis=1.0)
    assert len(joined) > len(broken)
    assert len(set(joined.chains())) <= len(set(broken.chains()))


@pytest.mark.parametrize("scale", [1e-4, 300.0])
def test_the_scale_of_the_object_does_not_matter(scale):
    points, triangles = blob(4)
    eye = np.array(BLOB_EYES[0])
    one = suggestive_contours(*shape(points, triangles), eye)
    scaled = shape((points * scale).astype(np.float32), triangles)
    other = suggestive_contours(*scaled, eye * (scale, scale, scale, 1))
    assert len(one) > 50
    assert len(np.setxor1d(one.triangle, other.triangle)) <= 0.03 * len(one)


def test_suggestive_contours_run_into_contours():
    points, triangles, normals, curvature = shape(*blob(5))
    eye = np.array(BLOB_EYES[0])
    found = suggestive_contours(points, triangles, normals, curvature, eye)
    contour = smooth_contours(points, triangles, normals, eye)
    cut = found.side == -1
    assert cut.any()
    for triangle, end in zip(found.triangle[cut.any(axis=1)], found.ends[cut], strict=True):
        a, b = contour.ends[contour.triangle == triangle][0].astype(float)
        share = np.clip((end - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        assert np.linalg.norm(a + share * (b - a) - end) < 1e-5


@pytest.mark.parametrize("eye", BLOB_EYES)
def test_the_paper_rejects_valleys_and_leaves_more_holes(eye):
    points, triangles, normals, curvature = mesh = shape(*blob(5))
    eye = np.array(eye)
    ours = suggestive_contours(*mesh, eye, slope=0.0, theta=0.0)
    paper = suggestive_contours(*mesh, eye, paper=True)
    assert len(set(paper.chains())) > 1.5 * len(set(ours.chains()))
    # Neither draws the valleys, which the other zeros are.
    zeros = zero_segments(points, triangles, radial_curvature(curvature, points, eye))
    front = facing(points, normals, eye)[triangles[zeros.triangle]] > 0
    assert 0 < len(paper) < front.all(axis=1).sum()
    assert np.isin(paper.triangle, ours.triangle).mean() > 0.9


def test_odd_meshes_give_finite_contours():
    points, triangles = blob(3)
    count = len(points)
    odd = np.float32([[9, 9, 9], [np.nan, 0, 0], [0, 0, 0], [1, 0, 0], [2, 0, 0]])
    bad = [[0, 0, 1], [3, 3, 3], [count + 2, count + 3, count + 4], [0, 1, count + 1]]
    mesh = shape(np.concatenate((points, odd)), np.concatenate((triangles, np.int32(bad))))
    derivatives = curvature_derivatives(mesh[0], mesh[1], mesh[3])
    for eye in (*BLOB_EYES, (0, 0, 0, 1), (*points[5], 1), (0, 0, 0, 0)):
        at = np.array(eye, float)
        for options in ({}, {"derivatives": derivatives}, {"paper": True}):
            found = suggestive_contours(*mesh, at, **options)
            assert np.isfinite(found.ends).all() and np.isfinite(found.weights).all()
        assert np.isfinite(smooth_contours(*mesh[:3], at).ends).all()


def test_no_triangles():
    points, none = np.zeros((3, 3), np.float32), np.empty((0, 3), np.int32)
    mesh = shape(points, none)
    eye = np.array(EYES[0])
    for found in (
        suggestive_contours(*mesh, eye),
        suggestive_contours(*mesh, eye, paper=True),
        smooth_contours(points, none, points, eye),
    ):
        assert found.ends.shape == (0, 2, 3) and found.chains().shape == (0,)


def test_what_a_hundred_thousand_triangles_take_grows_by_their_number_alone():
    """16 times as many triangles: hardly a call more, and memory by their number."""
    eye = np.array((0.0, -3.0, 1.6, 1.0))

    def taken(rings, sides):
        mesh = shape(*torus(rings, sides)[:2])
        derivatives = curvature_derivatives(mesh[0], mesh[1], mesh[3])
        smooth = work(lambda: smooth_contours(*mesh[:3], eye))
        return smooth, work(lambda: suggestive_contours(*mesh, eye, derivatives=derivatives))

    for few, many, share in zip(taken(80, 40), taken(320, 160), (16, 40), strict=True):
        assert many.calls <= 1.2 * few.calls < 1000, (few, many)
        assert many.bytes <= 20 * few.bytes, (few, many)
        assert many.bytes <= share * 102_400, (few, many)
