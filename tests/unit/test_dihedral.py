"""One rule says which folds are ridges and which valleys, however a fold is sent."""

from __future__ import annotations

from math import cos, degrees

import numpy as np
import pytest
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.raskar import Raskar
from glshim_stylers.shared.hand import Hand
from glshim_stylers.shared.hand import features as features_of_hand
from glshim_stylers.shared.options import folds
from glshim_stylers.technical import Technical

from glshim.geometry.edges.edges import edges
from glshim.geometry.edges.gather import Placement
from glshim.geometry.meshshaders.edge_mesh import RIDGE as RIDGE_BIT
from glshim.geometry.meshshaders.edge_mesh import VALLEY as VALLEY_BIT
from glshim.geometry.meshshaders.edge_mesh import edge_mesh, features
from glshim.geometry.meshshaders.sieve import EdgeSieve
from glshim.geometry.recovery.mesh import mesh
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.linework.polygon_lines import polygon_lines
from glshim.model.camera import Camera
from glshim.model.dihedral import GRAIN, crease_limits, is_ridge, is_valley
from glshim.model.lines import RIDGE, VALLEY, kind_of
from glshim.styling.media.hand import hand
from glshim.styling.values import Layer
from glshim.styling.wishes import Choice
from tests import look

SIZE = (0, 0, 400, 400)
THRESHOLDS = {"ridge": (120.0, 90.0, 150.0), "valley": (240.0, 270.0, 210.0)}
OFFSETS = (-0.2, -0.1, -0.07, -0.05, -0.03, 0.0, 0.03, 0.05, 0.07, 0.1, 0.2)
"""Degrees from the threshold: within the grain, which is 0.057, and without."""
CASES = [(kind, angle) for kind, angles in THRESHOLDS.items() for angle in angles]
TURNS = (np.eye(4), look.look_at((2.0, 1.0, 1.5)))
"""Two object spaces of a rigid object."""


def fold(angle):
    """Two quads that share a side along y, with the material below them; degrees between them. Ends
    of the shared side and the outer sides' ends, each quad's own corners."""
    half = np.radians(angle) / 2
    left, right = (side * np.sin(half) for side in (-1.0, 1.0))
    low = -np.cos(half)
    ridge = [(0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    return (
        [ridge[0], ridge[1], (left, 1.0, low), (left, 0.0, low)],
        [ridge[1], ridge[0], (right, 0.0, low), (right, 1.0, low)],
    )


def as_one(angle):
    one, other = fold(angle)
    return look.batch([*one, *other], [[0, 1, 2, 3], [4, 5, 6, 7]])


def as_two(angle):
    """Two batches, each with the matrix that puts its own space where the fold is."""
    for quad, place in zip(fold(angle), TURNS, strict=True):
        back = np.linalg.inv(place)
        points = np.array(quad) @ back[:3, :3].T + back[:3, 3]
        yield look.batch(points, [[0, 1, 2, 3]]), place


def view():
    """From above: a fold of any angle between 60 and 300 degrees shows both its fronts."""
    return Camera(look.look_at((0.05, 0.5, 6.0), up=(0, 1, 0)), look.orthographic(), SIZE)


def options(kind, threshold):
    return {
        "ridges": kind == "ridge",
        "valleys": kind == "valley",
        f"{kind}_angle": threshold,
    }


def drawn(records, kind):
    """Whether a line of the kind is among records whose neighbours are known."""
    return bool((kind_of(records) == {"ridge": RIDGE, "valley": VALLEY}[kind]).any())


def by_polygons(kind, threshold, angle):
    """What raskar asks for: of one batch, and of two objects."""
    camera, batch = view(), as_one(angle)
    draws = list(Raskar(silhouettes=False, **options(kind, threshold)).draws(
        Layer(((batch, camera),))))  # fmt: skip
    choice = draws[0].wanted
    yield one_part(batch, camera.modelview, camera, choice)
    parts = []
    for part, place in as_two(angle):
        found = edges(part)
        parts.append((found, Placement.one(camera.modelview @ place, len(found.planes))))
    yield polygon_lines(parts, camera, choice)


def one_part(batch, modelview, camera, choice):
    found = edges(batch)
    return polygon_lines([(found, Placement.one(modelview, len(found.planes)))], camera, choice)


def by_meshes(kind, threshold, angle):
    """What edge_mesh asks for: of one mesh, and of two objects."""
    camera, batch = view(), as_one(angle)
    off = {"contours": False, "boundary": False}
    draws = list(EdgeMesh(**off, **options(kind, threshold)).draws(Layer(((batch, camera),))))
    wanted = draws[0].wanted
    yield feature_lines([(EdgeLines(mesh(batch)), camera.modelview)], camera, wanted)[0]
    objects = [
        (EdgeLines(mesh(part)), camera.modelview @ place) for part, place in as_two(angle)
    ]
    yield feature_lines(objects, camera, wanted)[0]


def by_the_gpu(kind, threshold, angle):
    """What the passes of edge_mesh ask of a mesh shader and of the sieve before it."""
    camera, whole = view(), mesh(as_one(angle))
    style = EdgeMesh(
        strokes="quads", contours=False, boundary=False, **options(kind, threshold)
    )
    passes = style.draws(Layer(((as_one(angle), camera),)))
    asked = next(one for one in passes if "turns" in one.uniforms)
    assert asked.uniforms["turns"] == pytest.approx([cos(limit) for limit in asked.sieve.angles])
    found = edge_mesh(whole)
    eye = np.linalg.inv(camera.modelview) @ camera.viewpoint
    bits = features(found.indices, whole.positions, eye, asked.sieve.angles)
    bit = RIDGE_BIT if kind == "ridge" else VALLEY_BIT
    decided = np.flatnonzero(bits & bit)
    kept = EdgeSieve(whole, found).candidates(eye, bit, asked.sieve.angles)
    assert set(decided) <= set(kept)
    return bool(len(decided))


@pytest.mark.parametrize(("kind", "threshold"), CASES)
@pytest.mark.parametrize("offset", OFFSETS)
def test_a_fold_is_decided_alike_by_all_who_ask(kind, threshold, offset):
    angle = threshold + offset
    equal = abs(offset) < degrees(GRAIN)
    expected = {"ridge": offset < 0 or equal, "valley": offset > 0 and not equal}[kind]
    raskar = [drawn(records, kind) for records in by_polygons(kind, threshold, angle)]
    meshes = [drawn(records, kind) for records in by_meshes(kind, threshold, angle)]
    answers = (*raskar, *meshes, by_the_gpu(kind, threshold, angle))
    assert answers == (expected,) * 5


def test_the_rule():
    near = np.radians([119.9, 119.95, 120.0, 120.05, 120.1])
    assert is_ridge(near, np.radians(120.0)).tolist() == [True, True, True, True, False]
    assert is_valley(near, np.radians(120.0)).tolist() == [False, False, False, False, True]
    ridge, valley = crease_limits(np.radians(120.0), np.radians(240.0))
    assert (ridge, valley) == pytest.approx(np.radians(120.0) + np.array([GRAIN, -GRAIN]))
    assert crease_limits(0.0, 2 * np.pi)[1] == 0.0


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_crease_angle_includes_its_folds_to_either_side(offset):
    by_hand = features_of_hand(Hand(40.0, hand()))
    (fine, *_) = Technical(crease_angle=40.0, paper="app").draws(Layer(()))
    cad = fine.wanted
    drawn_from = np.radians(40.0 + offset)
    expected = offset > 0 or abs(offset) < degrees(GRAIN)
    for ridge, valley in (
        (by_hand.ridge_angle, by_hand.valley_angle),
        (cad.ridge_angle, cad.valley_angle),
    ):
        assert is_ridge(np.pi - drawn_from, ridge) == is_valley(np.pi + drawn_from, valley)
        assert is_ridge(np.pi - drawn_from, ridge) == expected


def test_what_lies_in_a_plane_is_no_valley_at_a_crease_angle_of_nothing():
    ridge, valley = np.radians(folds(0.0))
    flat = np.pi + np.array([-0.5, 0.0, 0.5]) * GRAIN
    assert is_ridge(flat, ridge).all() and not is_valley(flat, valley).any()


def test_an_angle_of_nothing_asks_for_no_ridge():
    camera = view()
    found = one_part(as_one(60.0), camera.modelview, camera, Choice(ridge_angle=0.0))
    assert not len(found)
