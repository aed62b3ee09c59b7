"""Edges, lines and cameras, without GL."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from glshim.geometry.edges.edges import dihedral, edges, edges_of_each
from glshim.geometry.edges.gather import Placement, merged
from glshim.linework.polygon_lines import polygon_lines
from glshim.model.batch import PolygonBatch, join
from glshim.model.camera import Camera, cofactors
from glshim.model.lines import (
    CONTOUR,
    FIN,
    HOLLOW,
    LONE_RIDGE,
    LONE_VALLEY,
    RECORD,
    RIDGE,
    RING,
    VALLEY,
    Line,
)
from glshim.styling.wishes import Choice
from tests import look

BOTH = Choice(silhouettes=True, ridge_angle=np.radians(120.0))
VIEW = (0, 0, 400, 400)


def camera(modelview=None, projection=None, **more):
    modelview = look.look_at((3, 2, 2.5)) if modelview is None else modelview
    return Camera(modelview, look.perspective() if projection is None else projection, VIEW, **more)


def moved(batch, modelview):
    positions = batch.positions @ modelview[:3, :3].T + modelview[:3, 3]
    return PolygonBatch(positions.astype(np.float32), batch.corners, batch.starts, batch.boundary)


def choose(found, seen, choice, places=None):
    """Lines of one part, under the camera's own modelview or in places."""
    places = places or Placement.one(seen.modelview, len(found.planes))
    return polygon_lines([(found, places)], seen, choice)


def kinds(records):
    """How many rings (of any kind), ridges, lone ridges and fins."""
    count = {k: int((np.floor(records[:, Line.KIND]) == k).sum()) for k in range(9)}
    rings = count[RING] + count[CONTOUR] + count[HOLLOW]
    return {RING: rings, RIDGE: count[RIDGE], LONE_RIDGE: count[LONE_RIDGE], FIN: count[FIN]}


def ends_of(records, modelview):
    """(L, 6) both ends of each line, from eye space back into object space."""
    eye = records[:, Line.ENDS].reshape(-1, 3).astype(float)
    back = np.linalg.inv(modelview)
    return (eye @ back[:3, :3].T + back[:3, 3]).reshape(-1, 6)


# edges


def test_a_cube_has_twelve_edges_of_two_sides():
    found = edges(look.cube())
    assert len(found) == 24
    assert len(found.pairs[0]) == 12 and not len(found.singles) and not len(found.crowds[0])
    assert np.allclose(found.folds, np.pi / 2)
    assert (found.forward[found.pairs[0]] != found.forward[found.pairs[1]]).all()
    for side, plane in zip(found.sides, found.planes[found.polygon], strict=True):
        a, b = side.reshape(2, 3)
        assert abs(plane[:3] @ (b - a)) < 1e-6
        assert abs(plane[:3] @ a + plane[3]) < 1e-6
        assert -plane[3] > 0  # the cube is about the origin and wound outwards


def test_inside_out_folds_are_the_complement():
    mesh = look.cube()
    turned = look.batch(mesh.positions, [p[::-1] for p in look.polygons_of(mesh)])
    assert np.allclose(edges(turned).folds, 3 * np.pi / 2)


def test_boundary_false_sides_give_nothing_and_split_nothing():
    whole = look.batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2, 3]])
    split = look.batch(whole.positions, [[0, 1, 2], [0, 2, 3]])
    split.boundary[[2, 3]] = False
    assert len(edges(whole)) == len(edges(split)) == 4
    assert len(edges(split).singles) == 4


BAD = {
    "nan": [(0, 0, 0), (1, 0, 0), (np.nan, 1, 0)],
    "inf": [(0, 0, 0), (np.inf, 0, 0), (0, 1, 0)],
    "line": [(0, 0, 0), (1, 1, 1), (2, 2, 2)],
    "point": [(1, 2, 3)] * 3,
    "two corners": [(0, 0, 0), (1, 0, 0), (0, 0, 0)],
    "sliver": [(5, 5, 5), (6, 5, 5), (5.5, 5.0000005, 5)],
    "huge": [(1e38, 0, 0), (-1e38, 0, 0), (0, np.inf, 1e38)],
}


@pytest.mark.parametrize("name", BAD)
def test_polygons_without_a_plane_are_dropped_and_harm_no_other(name):
    good = look.cube()
    points = np.concatenate([good.positions, np.array(BAD[name], np.float32)])
    polygons = [*look.polygons_of(good)[:3], [8, 9, 10], *look.polygons_of(good)[3:]]
    with np.errstate(all="raise"):
        found = edges(look.batch(points, polygons))
    assert np.isfinite(found.sides).all() and np.isfinite(found.planes).all()
    assert len(found) == 24 and len(found.pairs[0]) == 12


def test_poles_of_a_sphere_close():
    found = edges(look.sphere())
    assert not len(found.singles) and not len(found.crowds[0])
    a, b = found.sides.reshape(-1, 2, 3).transpose(1, 0, 2)
    assert (np.abs(a - b).max(axis=1) > 0).all()


def test_a_seam_computed_twice_is_found_again():
    rng = np.random.default_rng(3)
    mesh = look.torus()
    soup = mesh.positions[mesh.corners]
    soup = soup + rng.uniform(-2e-7, 2e-7, soup.shape)
    found = edges(look.batch(soup, np.arange(len(soup)).reshape(-1, 4)))
    assert len(found.singles) <= 0.01 * len(found)


def test_concave_polygons_have_newells_normal():
    star = [(np.cos(a) * r, np.sin(a) * r, 0.0)
            for a, r in zip(np.arange(10) * np.pi / 5, [1, 0.3] * 5, strict=True)]  # fmt: skip
    found = edges(look.batch(star, [list(range(10))]))
    assert np.allclose(found.planes[0], (0, 0, 1, 0), atol=1e-6)


def test_bent_polygons_are_the_triangles_that_are_drawn():
    corners = [(0, 0, 0.1), (1, 0, -0.1), (1, 1, 0.1), (0, 1, -0.1)]
    found = edges(look.batch(corners, [[0, 1, 2, 3]]))
    assert len(found.planes) == 2 and len(found.sides) == 6
    assert len(found.pairs[0]) == 1 and len(found.singles) == 4
    diagonal = found.sides[found.pairs[0][0]].reshape(2, 3)
    assert sorted(np.round(diagonal[:, 0])) == [0, 1] and np.allclose(diagonal[:, 2], 0.1)
    flat = edges(look.batch(np.array(corners) * (1, 1, 1e-3), [[0, 1, 2, 3]]))
    assert len(flat.planes) == 1
    five = [(np.cos(a), np.sin(a), 0.2 * (k % 2)) for k, a in enumerate(np.arange(5) * 1.2566)]
    hidden = look.batch(five, [[0, 1, 2, 3, 4]])
    hidden.boundary[:] = (True, False, True, True, False)
    found = edges(hidden)
    assert len(found.planes) == 3 and len(found.pairs[0]) == 2 and len(found.singles) == 3


def test_joined_batches_are_one_object():
    mesh = look.cube()
    parts = [look.batch(mesh.positions, [p]) for p in look.polygons_of(mesh)]
    assert len(edges(join(parts)).pairs[0]) == 12
    assert join(parts[:1]) is parts[0]


def test_no_polygons():
    empty = PolygonBatch(np.empty((0, 3), np.float32), np.empty(0, np.int32),
                         np.zeros(1, np.int32), np.empty(0, bool))  # fmt: skip
    assert len(edges(empty)) == 0
    assert choose(edges(empty), camera(), BOTH).shape == (0, RECORD)


@given(st.floats(1.0, 359.0))
def test_dihedral_is_the_turn_between_the_polygons(degrees):
    turn = np.radians(degrees)
    along = np.array([[0.0, 0.0, 2.0]])
    # The first polygon leaves the side towards -x with normal +y; the other is turned by the angle
    # about the side, through the space behind.
    first = np.array([[0.0, 1.0, 0.0]])
    second = np.array([[np.sin(turn), -np.cos(turn), 0.0]])
    assert np.degrees(dihedral(-along, first, second)[0]) == pytest.approx(degrees, abs=1e-6)


# lines


@pytest.mark.parametrize("projection", [look.perspective(), look.orthographic()])
def test_a_cube_shows_six_silhouettes_and_three_ridges(projection):
    assert kinds(choose(edges(look.cube()), camera(None, projection), BOTH)) == {
        RING: 6, RIDGE: 3, LONE_RIDGE: 0, FIN: 0}  # fmt: skip


@pytest.mark.parametrize("angle, count", [(89.0, 0), (90.0, 3), (91.0, 3), (0.0, 0), (360.0, 6)])
def test_ridges_fold_at_most_by_the_threshold(angle, count):
    """At 360 degrees every edge with polygons on both sides of it counts, seen or not."""
    found = kinds(choose(edges(look.cube()), camera(), Choice(ridge_angle=np.radians(angle))))
    assert found[RING] == found[FIN] == 0
    assert found[RIDGE] == count


def test_a_hexagonal_prism_has_its_sides_inked_at_the_default_threshold():
    found = kinds(choose(edges(look.cylinder(6)), camera(), Choice(ridge_angle=np.radians(120.0))))
    assert found[RIDGE] == 2 + 3  # two uprights and half of the rim are between seen faces


def test_angles_are_measured_in_eye_space():
    """A box squeezed into a shear has ridges by its angles as seen, not as stored."""
    squash = np.array([[1, 0.9, 0, 0], [0, 0.4, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    tilted = camera(look.look_at((3, 2, 2.5)) @ squash)
    shaped = moved(look.cube(), squash)
    for angle in (40.0, 70.0, 100.0, 150.0):
        choice = Choice(ridge_angle=np.radians(angle))
        assert kinds(choose(edges(look.cube()), tilted, choice)) == kinds(
            choose(edges(shaped), camera(), choice)
        )


@pytest.mark.parametrize("front_ccw", [True, False])
@pytest.mark.parametrize("mirror", [(1, 1, 1), (-1, 1, 1), (1, -1, -1), (-1, -1, -1), (2, -0.5, 1)])
def test_silhouettes_do_not_depend_on_the_winding(front_ccw, mirror):
    scale = np.diag([*mirror, 1.0])
    plain = choose(edges(moved(look.torus(), scale)), camera(), Choice(silhouettes=True))
    turned = camera(look.look_at((3, 2, 2.5)) @ scale, front_ccw=front_ccw)
    found = choose(edges(look.torus()), turned, Choice(silhouettes=True))
    assert len(found) == len(plain)
    plain, found = ends_of(plain, camera().modelview), ends_of(found, turned.modelview)
    ends, wanted = found[:, Line.A] * mirror, np.concatenate([plain[:, Line.A], plain[:, Line.B]])
    assert (np.abs(ends[:, None] - wanted).max(axis=2).min(axis=1) < 1e-5).all()


def test_an_open_side_is_outlined_whatever_its_facing():
    square = look.batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2, 3]])
    above, below = camera(), camera(look.look_at((3, 2, -2.5)))
    assert kinds(choose(edges(square), above, BOTH)) == {RING: 0, RIDGE: 0, LONE_RIDGE: 4, FIN: 4}
    assert kinds(choose(edges(square), below, BOTH)) == {RING: 0, RIDGE: 0, LONE_RIDGE: 0, FIN: 4}


def test_a_doubled_surface_has_the_silhouettes_of_one():
    mesh = look.torus()
    polygons = look.polygons_of(mesh)
    doubled = look.batch(mesh.positions, [*polygons, *(p[::-1] for p in polygons)])
    one = choose(edges(mesh), camera(), Choice(silhouettes=True))
    two = choose(edges(doubled), camera(), Choice(silhouettes=True))

    def places(records):
        rounded = np.round(records.astype(float), 5)
        return {frozenset(map(tuple, (r[Line.A], r[Line.B]))) for r in rounded}

    assert places(one) == places(two)


# cameras


@given(st.integers(0, 10_000))
def test_centre_tells_the_winding_in_the_window(seed):
    rng = np.random.default_rng(seed)
    flipped = np.diag([-1.0, 1, 1, 1]) @ look.perspective()
    aside = look.perspective() @ look.look_at((1, 2, 3))
    projection = (look.perspective(), look.orthographic(), flipped, aside)[seed % 4]
    modelview = rng.normal(size=(4, 4))
    modelview[3] = (0, 0, 0, 1)
    modelview[:3, 3] = (0.1, -0.2, -9.0)
    seen = Camera(modelview, projection, VIEW)
    triangle = rng.normal(size=(3, 3))
    normal = np.cross(triangle[1] - triangle[0], triangle[2] - triangle[0])
    clip = np.c_[triangle, np.ones(3)] @ (projection @ modelview).T
    assume((clip[:, 3] > 0).all())
    x, y = (clip[:, :2] / clip[:, 3:]).T
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0])
    found = np.append(normal, -normal @ triangle[0]) @ seen.object_centre
    assume(abs(area) > 1e-9)
    assert np.sign(found) == np.sign(area)


def test_mirrored():
    assert not camera().mirrored
    assert not camera(None, look.orthographic()).mirrored
    assert camera(look.look_at((3, 2, 2)) @ np.diag([1, -1, 1, 1.0])).mirrored
    assert camera(None, np.diag([1, -1, 1, 1.0]) @ look.perspective()).mirrored
    both = camera(look.look_at((3, 2, 2)) @ np.diag([1, -1, 1, 1.0]),
                  np.diag([-1.0, 1, 1, 1]) @ look.orthographic())  # fmt: skip
    assert not both.mirrored


def test_viewpoint_is_the_eye_or_the_way_to_it():
    assert np.allclose(camera().viewpoint, (0, 0, 0, 1))
    assert np.allclose(camera(None, look.orthographic()).viewpoint, (0, 0, 1, 0))
    aside = look.perspective() @ look.look_at((1, 2, 3))
    assert np.allclose(camera(np.eye(4), aside).viewpoint, (1, 2, 3, 1))


def test_cofactors_take_areas_along():
    rng = np.random.default_rng(1)
    m = rng.normal(size=(5, 4, 4))
    u, v = rng.normal(size=(2, 3))
    wanted = [np.cross(k[:3, :3] @ u, k[:3, :3] @ v) for k in m]
    assert np.allclose(cofactors(m) @ np.cross(u, v), wanted)


def test_a_projection_on_the_modelview_stack_is_made_affine():
    odd = Camera(look.perspective() @ look.look_at((3, 2, 2)), np.eye(4), VIEW,
                 clip_planes=((1, 2, 3, 4),))  # fmt: skip
    plain = odd.affine()
    assert (plain.modelview == np.eye(4)).all()
    point = np.array((0.3, -0.2, 0.5, 1.0))
    assert np.allclose(plain.projection @ point, odd.projection @ odd.modelview @ point)
    assert plain.clip_planes[0] @ point == pytest.approx((1, 2, 3, 4) @ (odd.modelview @ point))
    assert camera().affine().modelview is not None


# gathering


@pytest.mark.parametrize("projection", [look.perspective(), look.orthographic()])
def test_batches_in_their_places_have_the_lines_of_moved_batches(projection):
    """Turned, mirrored, squeezed and flattened; chosen in object space, moved afterwards."""
    rng = np.random.default_rng(2)
    modelviews = np.tile(np.eye(4), (7, 1, 1))
    modelviews[:, :3] = rng.normal(size=(7, 3, 4))
    modelviews[:, 2, 3] -= 9.0
    modelviews[3] = look.look_at((3, 2, 2.5))
    modelviews[4] = modelviews[3] @ np.diag([-1.0, 1, 1, 1])
    modelviews[5] = modelviews[3] @ np.diag([2.0, 2, 2, 1])
    modelviews[6, :3, :3] = np.diag([1.0, 1, 0])
    meshes = [(look.cube(), look.torus(), look.bowl())[k % 3] for k in range(7)]
    whole, owner = merged([edges(mesh) for mesh in meshes])
    eye = camera(np.eye(4), projection)
    choice = Choice(silhouettes=True, ridge_angle=np.radians(100.0))
    found = choose(whole, eye, choice, Placement(owner, modelviews))
    for k in range(6):
        alone = choose(edges(meshes[k]), camera(modelviews[k], projection), choice)
        one, index = merged([edges(meshes[k])])
        here = choose(one, eye, choice, Placement(index, modelviews[k : k + 1]))
        assert np.allclose(here, alone, atol=1e-4)
    assert len(found) >= sum(
        len(choose(edges(meshes[k]), camera(modelviews[k], projection), choice)) for k in range(6)
    )


def test_objects_apart_are_no_neighbours_even_where_they_touch():
    """Two cubes side by side, each drawn on its own: every one keeps its own edges."""
    aside = np.eye(4)
    aside[0, 3] = 1.8
    pair = [look.cube(), moved(look.cube(), aside)]
    found, owner = edges_of_each(pair)
    assert len(found.pairs[0]) == 24 and not len(found.crowds[0])
    assert (np.bincount(owner) == 6).all()
    one, other = (found.polygon[side] for side in found.pairs)
    assert (owner[one] == owner[other]).all()
    assert len(edges(join(pair)).crowds[0]) == 16  # in one object they meet


@pytest.mark.parametrize("angle, count", [(240.0, 1), (269.0, 1), (271.0, 0), (180.0, 1)])
def test_valleys_fold_by_more_than_the_threshold(angle, count):
    """The hollow of an L: 270 degrees."""
    wall = look.batch([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (2, 0, 2), (0, 0, 2)],
                      [[0, 1, 2, 3], [1, 0, 5, 4]])  # fmt: skip
    choice = Choice(valley_angle=np.radians(angle))
    found = choose(edges(wall), camera(look.look_at((1, 3, 2.5))), choice)
    assert (np.floor(found[:, Line.KIND]) == VALLEY).sum() == count
    assert (found[:, Line.KIND] == LONE_VALLEY).sum() == 6
    behind = choose(edges(wall), camera(look.look_at((1, -3, -2.5))), choice)
    assert (np.floor(behind[:, Line.KIND]) == VALLEY).sum() == 0  # a ridge from there
    assert kinds(choose(edges(wall), camera(look.look_at((1, -3, -2.5))), BOTH))[RIDGE] == 1


@pytest.mark.parametrize("name", ["cube", "torus", "cylinder", "bowl"])
def test_cutting_a_mesh_into_objects_changes_no_line(name):
    """One batch, or its polygons dealt to objects with cameras and object spaces of their own."""
    mesh, rng = look.MESHES[name](), np.random.default_rng(7)
    choice = Choice(silhouettes=True, ridge_angle=np.radians(130.0), valley_angle=np.radians(190.0))
    seen = camera()

    def places(records):
        """Unordered ends in the eye's space, and the kind."""
        rounded = np.round(records[:, Line.ENDS].astype(float), 4) + 0.0
        return sorted((*sorted((tuple(r[:3]), tuple(r[3:]))), k)
                      for r, k in zip(rounded, records[:, Line.KIND], strict=True))  # fmt: skip

    whole = choose(edges(mesh), seen, choice)
    polygons = look.polygons_of(mesh)
    dealt = rng.integers(0, 5, len(polygons))
    parts = []
    for number in range(5):
        space = np.eye(4)
        space[:3, :3] *= rng.uniform(0.5, 2)
        space[:3, 3] = rng.normal(size=3)
        some = [p for p, owner in zip(polygons, dealt, strict=True) if owner == number]
        if some:
            part = edges(moved(look.batch(mesh.positions, some), np.linalg.inv(space)))
            parts.append((part, Placement.one(seen.modelview @ space, len(part.planes))))
    cut = polygon_lines(parts, seen, choice)
    assert len(cut) == len(whole)
    one, other = places(whole), places(cut)
    difference = [abs(np.subtract(a[0] + a[1], b[0] + b[1])).max()
                  for a, b in zip(one, other, strict=True)]  # fmt: skip
    assert [a[2] for a in one] == [b[2] for b in other]
    assert max(difference) < 1e-3


def test_outlines_know_where_they_go_on():
    found = choose(edges(look.torus()), camera(), Choice(silhouettes=True))
    goes_on = (found[:, 6:9] != found[:, 3:6]).any(axis=1)
    assert goes_on.mean() > 0.98
    begins = {tuple(np.round(r, 5)) for r in found[:, Line.A].astype(float)}
    assert all(tuple(np.round(r, 5)) in begins for r in found[:, Line.B].astype(float))


def test_without_connectivity_every_side_stands_alone():
    choice = replace(BOTH, valley_angle=np.radians(240.0), connectivity=False)
    found = choose(edges(look.cube()), camera(), choice)
    assert (found[:, Line.KIND] == FIN).sum() == 24
    assert (found[:, Line.KIND] == LONE_RIDGE).sum() == 12
    assert (found[:, Line.KIND] == LONE_VALLEY).sum() == 12


def test_polygons_sent_twice_make_no_crease():
    """A strip whose end overlaps its beginning (GLUT's gears): a seam of three, all in a plane."""
    points = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0),
              (1, 1, 1), (1, 0, 1)]  # fmt: skip
    flat = [[0, 1, 4, 3], [1, 2, 5, 4], [1, 2, 5, 4]]
    choice = Choice(ridge_angle=np.radians(120.0), valley_angle=np.radians(240.0))
    seen = camera(look.look_at((1, 0.5, 5)))
    found = choose(edges(look.batch(points, flat)), seen, choice)
    ends = found[:, Line.ENDS].reshape(-1, 2, 3) @ np.linalg.inv(seen.modelview)[:3, :3].T
    ends += np.linalg.inv(seen.modelview)[:3, 3]
    assert not np.isclose(ends[:, :, 0], 1.0, atol=1e-5).all(axis=1).any()
    wall = choose(edges(look.batch(points, [*flat, [4, 6, 7, 1]])), seen, choice)
    assert (wall[:, Line.KIND] == LONE_VALLEY).sum() > (found[:, Line.KIND] == LONE_VALLEY).sum()
