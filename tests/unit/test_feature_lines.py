"""Which edges the CPU calls features, against the oracle of equation 1; and their objects."""

from __future__ import annotations

import dataclasses
import gc
import weakref
from dataclasses import replace

import numpy as np
import pytest

from glshim.geometry.meshshaders.edge_mesh import (
    BOUNDARY,
    CONTOUR,
    MARKED,
    RIDGE,
    VALLEY,
    edge_mesh,
    features,
)
from glshim.geometry.recovery.mesh import mesh
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.linework.objects import Objects
from glshim.model.camera import Camera
from glshim.model.dihedral import GRAIN, crease_limits
from glshim.model.lines import BOUNDARY as BOUNDARY_GROUP
from glshim.model.lines import FIN, GROUP, RECORD, Line, group_of
from glshim.styling.wishes import Features
from tests import look
from tests.counted import work
from tests.score import meshes as scored

BAND = 1e-9
"""Part of the lengths that go into a test, under which float64 may decide one way or the other."""
ANGLES = (np.radians(120.0), np.radians(240.0))
FOLDS = Features(contours=True, ridge_angle=ANGLES[0], valley_angle=ANGLES[1])
ALL = replace(FOLDS, marked=True, boundary=True)
SIZE = (0, 0, 400, 400)


class Models(dict):
    """Meshes by name, made when they are first asked for: GLUT draws its teapot on a screen."""

    def __missing__(self, name):
        made = look.MESHES | scored.MESHES
        return self.setdefault(name, mesh(made[name]()))


@pytest.fixture(scope="module")
def models():
    return Models()


def cameras(count=24, front_ccw=True):
    """In perspective and in parallel, in turns."""
    for k, d in enumerate(look.directions(count)):
        lens = look.perspective() if k % 2 else look.orthographic()
        yield Camera(look.look_at(5 * d), lens, SIZE, front_ccw=front_ccw)


def oracle(whole, camera, angles=ANGLES):
    """(E,) bits of the edges of a mesh by `features`, told in eye space, and (E,) whether an
    edge lies in the band of rounding."""
    made = edge_mesh(whole)
    linear = camera.modelview[:3, :3]
    points = whole.positions @ linear.T + camera.modelview[:3, 3]
    eye = camera.centre * np.sign(camera.centre @ camera.viewpoint)
    facing = np.sign(camera.centre @ camera.viewpoint) * (1.0 if camera.front_ccw else -1.0)
    external = crease_limits(*angles)
    found = np.zeros(len(whole.edges), np.uint8)
    found[made.rows] = features(made.indices, points, eye, external, facing=facing)

    v0, v1, v2, v3 = (np.where(i < 0, ~i, i) for i in made.indices.T)
    p0, p1, p2, p3 = (points[v].astype(np.float64) for v in (v0, v1, v2, v3))
    towards = eye[:3] - eye[3] * p0
    band = np.zeros(len(v0), bool)
    units = []
    for one, other in ((p1 - p0, p2 - p0), (p3 - p0, p1 - p0)):
        out = np.cross(one, other)
        reach = np.linalg.norm(one, axis=1) * np.linalg.norm(other, axis=1)
        reach = reach * (np.linalg.norm(towards, axis=1) + np.linalg.norm(p0, axis=1))
        # A reflection turns A into B: both are told in the same space, with rounding of their own.
        band |= np.abs((out * towards).sum(axis=1)) <= BAND * reach
        units.append(out / np.maximum(np.linalg.norm(out, axis=1), 1e-300)[:, None])
    product = (units[0] * units[1]).sum(axis=1)
    for angle in external:
        band |= np.abs(product + np.cos(angle)) <= BAND
    if external[0] > np.pi:  # flat edges, of which equation 1 has no ridges
        band |= product >= np.cos(GRAIN) - BAND
    unsure = np.zeros(len(whole.edges), bool)
    unsure[made.rows] = band & (v3 != v0) & (v3 != v1)
    return found, unsure


def bits(lines, camera, wanted=ALL):
    """(E,) the bits that `EdgeLines` decides."""
    decided = lines.decided(camera.modelview, camera, wanted)
    found = np.zeros(len(lines.topology.edges), np.uint8)
    kinds = (CONTOUR, RIDGE, VALLEY, MARKED, BOUNDARY)
    names = ("contours", "ridges", "valleys", "marked", "boundary")
    for bit, name in zip(kinds, names, strict=True):
        rows = getattr(decided, name)
        assert len(np.unique(rows)) == len(rows)
        found[rows] |= bit
    return found


def agree(whole, camera, lines=None, angles=ANGLES):
    """Asserts that they do; how many edges of each kind there are."""
    lines = lines or EdgeLines(whole)
    wanted = replace(ALL, ridge_angle=angles[0], valley_angle=angles[1])
    found, (true, unsure) = bits(lines, camera, wanted), oracle(whole, camera, angles)
    # A crease that is no contour may be one in the band, and the other way round.
    wrong = (found != (true & ~np.where(true & CONTOUR, RIDGE | VALLEY, 0))) & ~unsure
    assert not wrong.any(), (found[wrong], true[wrong])
    return np.array([(found & bit > 0).sum() for bit in (CONTOUR, RIDGE, VALLEY, BOUNDARY)])


@pytest.mark.parametrize("name", ["torus", "sphere", "bowl", "cube", "cylinder", "gear", "part",
                                  "terrain", pytest.param("teapot", marks=pytest.mark.gl)])
def test_edges_are_those_of_the_oracle_from_everywhere(models, name):
    whole, lines = models[name], EdgeLines(models[name])
    total, unsure = np.zeros(4, int), 0
    for front_ccw in (True, False):
        for camera in cameras(front_ccw=front_ccw):
            total += agree(whole, camera, lines)
            unsure += oracle(whole, camera)[1].sum()
    assert total[0] > 48
    assert unsure <= 2e-3 * 48 * len(whole.edges)  # nothing hides in the band
    assert (total[1] > 0) == (name in ("cube", "cylinder", "gear", "part", "terrain", "teapot"))
    assert (total[3] > 0) == (name in ("bowl", "terrain", "teapot"))
    if name in ("gear", "part", "terrain"):
        assert total[2] > 0


MODELVIEWS = {
    "mirrored": np.diag((-1.0, 1, 1, 1)),
    "scaled": np.diag((0.5, 2.0, 1.3, 1)),
    "mirrored and scaled": np.diag((0.5, 2.0, -1.3, 1)),
    "sheared": np.array([[1, 0.7, 0, 0], [0, 1, -0.4, 0], [0.2, 0, 1, 0], [0, 0, 0, 1.0]]),
    "small": np.diag((1e-3, 1e-3, 1e-3, 1)),
}


@pytest.mark.parametrize("front_ccw", [True, False])
@pytest.mark.parametrize("name", list(MODELVIEWS))
def test_modelviews_of_all_kinds(models, name, front_ccw):
    for model in ("gear", "bowl", "cylinder", "terrain"):
        whole, lines = models[model], EdgeLines(models[model])
        for camera in cameras(6, front_ccw):
            agree(whole, camera.under(camera.modelview @ MODELVIEWS[name]), lines)


def test_angles_are_kept_while_a_scaled_object_turns_and_not_when_it_changes(models):
    lines = EdgeLines(models["gear"])
    scaled = np.diag((1.0, 1.0, 3.0, 1.0))
    first = lines.folds(scaled[:3, :3])
    for camera in cameras(4):
        view = camera.modelview @ scaled
        agree(models["gear"], camera.under(view), lines)
        assert lines.folds(view[:3, :3]) is first
    mirrored = scaled @ np.diag((-1.0, 1, 1, 1))
    assert not first.holds(mirrored[:3, :3])
    assert lines.folds(2.0 * scaled[:3, :3]) is not first


def shadow(light=(1.0, 2.0, 5.0), floor=-1.5):
    """An app's planar shadow: the object flattened along a light onto z = floor. Affine."""
    flat = np.eye(4)
    flat[:3, 2] = -np.array(light) / light[2]
    flat[:3, 3] = np.array(light) / light[2] * floor
    flat[2] = (0, 0, 0, floor)
    return flat


def test_a_flattened_object_has_the_outline_of_its_shadow_and_no_creases(models):
    for camera in cameras(4):
        under = camera.under(camera.modelview @ shadow())
        for name in ("cube", "torus"):
            decided = EdgeLines(models[name]).decided(under.modelview, under, ALL)
            assert len(decided.contours) and not len(decided.ridges) + len(decided.valleys)
            light = Camera(look.look_at((1.0, 2.0, 5.0)), look.orthographic(), SIZE)
            lit = EdgeLines(models[name]).decided(light.modelview, light, ALL)
            assert set(decided.contours) == set(lit.contours)


@pytest.mark.parametrize("rank", [0, 1])
def test_what_has_no_area_on_the_screen_has_no_edges(models, rank):
    camera = next(cameras(1))
    flat = camera.modelview @ np.diag((1.0, *([0.0, 0.0]), 1)) if rank else np.diag((0.0, 0, 0, 1))
    for wanted in (ALL, replace(FOLDS, smooth=True, suggestive=True)):
        records, _ = feature_lines([(EdgeLines(models["gear"]), flat)], camera, wanted)
        assert np.isfinite(records).all()
        assert not (group_of(records) == 0).any()


def turned(b, which):
    return look.batch(b.positions, [p[::-1] if which(i) else p
                                    for i, p in enumerate(look.polygons_of(b))])  # fmt: skip


def test_windings():
    """Inside out: folds of closed meshes swap with what glFrontFace says; mixed: no matter."""
    for make in (scored.gear, look.cylinder):
        plain, inverse = mesh(make()), mesh(turned(make(), lambda i: True))
        mixed = mesh(turned(make(), lambda i: i % 3 == 0))
        for one, other in zip(cameras(6), cameras(6, front_ccw=False), strict=True):
            counts = agree(plain, one)
            assert (agree(inverse, other) == counts).all()
            assert (agree(mixed, one) == counts).all()
            swapped = agree(inverse, one)
            assert swapped[0] == counts[0]
            assert (swapped[1:3] == agree(plain, other)[1:3]).all()


def test_open_folds_are_what_they_are_from_the_side_that_is_seen():
    """A card folded at 90 degrees is a ridge from outside and a valley from inside."""
    card = look.batch([(0, 0, 0), (0, 2, 0), (1, 2, -1), (1, 0, -1), (-1, 2, -1), (-1, 0, -1)],
                      [[0, 3, 2, 1], [0, 1, 4, 5]])  # fmt: skip
    for b in (card, turned(card, lambda i: True), turned(card, lambda i: i == 0)):
        for front_ccw in (True, False):
            for z, kind in ((5, RIDGE), (-5, VALLEY)):
                view = look.look_at((0.2, 1.1, z), up=(0, 1, 0))
                camera = Camera(view, look.perspective(), SIZE, front_ccw=front_ccw)
                found = bits(EdgeLines(mesh(b)), camera)
                assert found.max() >= BOUNDARY and (found & kind).sum() == kind
                assert not (found & ((RIDGE | VALLEY) ^ kind)).any()
                agree(mesh(b), camera)


def test_a_moebius_strip_agrees():
    """No winding suits it."""
    turns = np.arange(24) * 2 * np.pi / 24
    radius = np.array((-0.4, 0.4))[:, None] * np.cos(turns / 2) + 1
    height = np.array((-0.4, 0.4))[:, None] * np.sin(turns / 2)
    points = np.stack([radius * np.cos(turns), radius * np.sin(turns), height], -1).reshape(-1, 3)
    quads = [[i, i + 1, i + 25, i + 24] for i in range(23)] + [[23, 24, 0, 47]]
    # In triangles: bent quads fold by the normals of the wholes, which the oracle does not know.
    halves = [[q[0], *q[k : k + 2]] for q in quads for k in (1, 2)]
    whole = mesh(look.batch(points, halves))
    assert whole.twisted.any()
    for camera in cameras(8):
        agree(whole, camera, angles=(np.radians(175), np.radians(185)))


def test_any_angles(models):
    for angles in ((0.0, 2 * np.pi), (np.pi, np.pi), (np.radians(175), np.radians(181))):
        for camera in cameras(4):
            for name in ("torus", "terrain"):
                agree(models[name], camera, angles=angles)
    wanted = Features(contours=True, ridge_angle=0.0, valley_angle=2 * np.pi)
    nothing = EdgeLines(models["gear"]).decided(np.eye(4), next(cameras(1)), wanted)
    assert not len(nothing.ridges) and not len(nothing.valleys)


def test_marked_edges_are_marked_and_nothing_else(models):
    gear = models["gear"]
    colours = np.random.default_rng(4).integers(0, 3, int(gear.polygon.max()) + 1)
    coloured = dataclasses.replace(gear, regions=colours[gear.polygon].astype(np.uint32))
    assert 50 < coloured.marked.sum() < len(coloured.edges) / 2
    for camera in cameras(3):
        agree(coloured, camera)
    assert bits(EdgeLines(coloured), camera).max() == MARKED


def test_sides_inside_of_polygons_are_contours_only_where_these_are_bent():
    """A saddle of four corners may turn away along its diagonal; a flat one may not."""
    for height, bent in ((0.5, True), (1e-5, False)):
        quad = look.batch([(-1, -1, height), (1, -1, -height), (1, 1, height), (-1, 1, -height)],
                          [[0, 1, 2, 3]])  # fmt: skip
        whole = mesh(quad)
        eyes = [(x, y, 0.0) for x in (-5, -2, 2, 5.5) for y in (-5.2, -1.7, 1.1, 4)]
        found = [
            agree(whole, Camera(look.look_at(eye), look.perspective(), SIZE))[0] for eye in eyes
        ]
        assert (max(found) > 0) == bent


def test_records_are_finite_whatever_comes(models):
    camera = next(cameras(1))
    wanted = replace(FOLDS, boundary=True, smooth=True, suggestive=True)
    points = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], np.float32)
    solids = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    for value in (np.nan, np.inf, 3e38, 1e20, 1e-30, 0.0):
        broken = points.copy()
        broken[3, 2] = value
        for scale in (1.0, 1e30, 0.0):
            view = camera.modelview @ np.diag((scale, scale, scale, 1.0))
            records, _ = feature_lines([(EdgeLines(mesh(look.batch(broken, solids))), view)],
                                       camera, wanted)  # fmt: skip
            assert records.shape[1] == RECORD and np.isfinite(records).all()
    for b in (look.batch(np.zeros((0, 3)), [[]]), look.batch(points, [[0, 1]]),
              look.batch(points * 0, solids)):  # fmt: skip
        records, _ = feature_lines([(EdgeLines(mesh(b)), camera.modelview)], camera, wanted)
        assert records.shape == (0, RECORD)
    assert feature_lines([], camera, wanted)[0].shape == (0, RECORD)


def test_records_have_the_own_polygon_at_the_left(models):
    """The outline's back-facing triangle lies left of it in the window, and its normal faces away
    where glFrontFace is as the mesh winds."""
    from glshim.geometry.window import window

    for camera in cameras(6):
        records, _ = feature_lines([(EdgeLines(models["torus"]), camera.modelview)], camera,
                                   Features(contours=True))  # fmt: skip
        a, b = (window(records[:, end].astype(float), camera)[:, :2] for end in (Line.A, Line.B))
        onward = np.linalg.norm(records[:, Line.ONWARD] - records[:, Line.B], axis=1) > 1e-6
        assert onward.mean() > 0.98  # the torus has closed outlines
        inside = np.cross(records[:, Line.B] - records[:, Line.A], records[:, Line.NORMAL])
        middle = (records[:, Line.A] + records[:, Line.B]) / 2
        step = window((middle - 1e-3 * inside).astype(float), camera)[:, :2] - (a + b) / 2
        ahead = b - a
        assert (ahead[:, 0] * step[:, 1] > ahead[:, 1] * step[:, 0]).mean() > 0.99


def halves(b, keys=(None, None)):
    """A batch as two, cut anywhere."""
    polygons = look.polygons_of(b)
    for k, key in enumerate(keys):
        yield look.batch(b.positions, polygons[k::2], key=key)


@pytest.mark.parametrize("keys", [(None, None), ("one", "two"), ("one", None)])
def test_batches_under_one_matrix_are_one_mesh(keys):
    camera = next(cameras(1))
    objects = Objects(1 << 28)
    items = [(part, camera.modelview) for part in halves(look.torus(), keys)]
    for _ in range(3):
        ((lines, _),) = objects.placed(items, 0.0)
        assert not lines.decided(camera.modelview, camera, ALL).boundary.size
        objects.tick()
    whole, _ = feature_lines([(EdgeLines(mesh(look.torus())), camera.modelview)], camera, ALL)
    cut, _ = feature_lines([(lines, camera.modelview)], camera, ALL)
    assert len(whole) == len(cut)
    assert {r[Line.ENDS].tobytes() for r in whole} == {r[Line.ENDS].tobytes() for r in cut}
    other = [items[0], (items[1][0], camera.modelview + 1e-12)]
    assert len(objects.placed(other, 0.0)) == 2


def test_a_tolerance_welds_a_cracked_seam():
    camera = next(cameras(1))
    one, other = halves(look.torus())
    moved = look.batch(other.positions + np.float32(1e-4), look.polygons_of(other))
    items = [(part, camera.modelview) for part in (one, moved)]
    counts = []
    for tolerance in (0.0, 1e-3):
        ((lines, _),) = Objects(1 << 28).placed(items, tolerance)
        counts.append(len(lines.decided(camera.modelview, camera, ALL).boundary))
    assert counts[0] > 100 and counts[1] == 0


def test_a_mesh_that_moves_is_recovered_once_and_leaves_nothing_behind():
    objects, first, seen = Objects(1 << 28), look.torus(), []
    camera = next(cameras(1))
    names = set()
    for frame in range(20):
        moved = look.batch(first.positions * np.float32(1 + 0.02 * frame), look.polygons_of(first))
        ((lines, _),) = objects.placed([(moved, camera.modelview)], 0.0)
        agree(mesh(moved), camera, lines)
        names.add(lines.topology.name)
        seen.append(weakref.ref(lines))
        objects.tick()
    assert sum(meshes.recovered for meshes in objects._meshes.values()) == 1
    assert len(names) == 1
    del lines
    gc.collect()
    assert sum(ref() is not None for ref in seen) <= 2


def test_a_smooth_mesh_that_moves_keeps_its_pieces(models):
    lines = EdgeLines(models["cylinder"])
    moved = EdgeLines(models["cylinder"].moved(models["cylinder"].positions * np.float32(2)),
                      topology=lines.topology)  # fmt: skip
    assert moved.pieces.triangles is lines.pieces.triangles
    assert np.allclose(moved.pieces.positions, 2 * lines.pieces.positions)


def test_what_a_display_list_of_100000_polygons_takes_grows_by_their_number_alone():
    """The decision alone, of a known mesh: 16 times as many polygons, hardly a call more."""
    wanted = Features(contours=True, ridge_angle=ANGLES[0], valley_angle=ANGLES[1], boundary=True)
    *_, camera = cameras(8)

    def taken(rings, sides):
        lines = EdgeLines(mesh(look.torus(rings, sides)))
        return work(lambda: lines.records(camera.modelview, camera, wanted))

    few, many = taken(100, 62), taken(400, 250)
    assert many.calls <= 1.2 * few.calls < 1000, (few, many)
    assert many.bytes <= 20 * few.bytes, (few, many)
    assert many.bytes <= 30 * 100_000, (few, many)


def test_shapes_cut_into_objects_have_the_edges_that_they_have_as_one():
    """A box without a lid and the lid, each under a modelview of its own: no boundary is left."""
    cube = look.cube()
    whole, parts = [cube.corners[i : i + 4] for i in range(0, 24, 4)], []
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 400))
    for some, shift in ((whole[:1], (0.5, 0.0, -0.25)), (whole[1:], (-2.0, 1.0, 0.0))):
        made = look.batch(cube.positions - np.float32(shift), some)
        place = np.eye(4)
        place[:3, 3] = shift
        parts.append((EdgeLines(mesh(made)), camera.modelview @ place))
    wanted = replace(FOLDS, boundary=True)
    cut, _ = feature_lines(parts, camera, wanted)
    one, _ = feature_lines([(EdgeLines(mesh(cube)), camera.modelview)], camera, wanted)
    assert len(cut) == len(one)
    # Folds that face away are taken as they are seen: no ridge of a solid that is in pieces.
    pieces, whole = cut[:, Line.KIND], one[:, Line.KIND]
    assert sorted(pieces[pieces <= FIN]) == sorted(whole[whole <= FIN])
    assert pieces.max() < GROUP
    middles = [np.sort((r[:, Line.A] + r[:, Line.B]).round(3), axis=0) for r in (cut, one)]
    assert np.allclose(*middles, atol=2e-3)
    alone, _ = feature_lines(parts[:1], camera, wanted)
    assert (alone[:, Line.KIND] == FIN + GROUP * (BOUNDARY_GROUP - 3)).sum() == 4
