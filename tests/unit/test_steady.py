"""Creases of meshes that bend, and suggestive contours of bodies that turn, do not flicker."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.contour.contours import SLOPE, suggestive_contours
from glshim.geometry.contour.curvature import principal_curvatures, vertex_normals
from glshim.linework.objects import Objects
from glshim.linework.steady import View
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.styling.wishes import Features
from tests import look, surfaces

CAMERA = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 200, 200))


def roof(fold: float) -> PolygonBatch:
    """Two squares along the y axis that fold by so many degrees."""
    a = np.radians(fold / 2)
    x, z = np.cos(a), -np.sin(a)
    points = [(0, 0, 0), (0, 1, 0), (x, 0, z), (x, 1, z), (-x, 0, z), (-x, 1, z)]
    return look.batch(points, [(0, 2, 3, 1), (0, 1, 5, 4)])


def creases(folds, objects=None, angle=30.0) -> list[int]:
    """How many creases there are, frame by frame."""
    objects = objects or Objects(1 << 24)
    wanted = Features(ridge_angle=np.radians(180.0 - angle))
    counts = []
    for fold in folds:
        placed = objects.placed([(roof(fold), CAMERA.modelview)], 0.0)
        lines, modelview = placed[0]
        counts.append(len(lines.decided(modelview, CAMERA, wanted).ridges))
        objects.tick()
    return counts


def test_a_crease_that_wavers_about_its_angle_stays_as_it_was():
    wavers = [30.5, 29.5, 30.4, 29.2, 30.6]
    assert creases(wavers) == [1] * 5
    assert creases([29.5, *wavers]) == [0] * 6
    assert creases([30.5, 27.0, 29.5, 31.0]) == [1, 0, 0, 0]
    assert creases([29.5, 33.0, 29.5]) == [0, 1, 1]


@pytest.mark.parametrize("fold", [29.9, 30.1])
def test_what_is_seen_first_is_decided_by_the_angle_itself(fold):
    assert creases([fold]) == [int(fold > 30.0)]
    assert creases([fold] * 3) == [int(fold > 30.0)] * 3


def test_it_goes_with_the_mesh():
    assert creases([30.5, 29.5]) == [1, 1]
    assert creases([29.5]) == [0]


def test_suggestive_contours_stay_down_to_a_part_of_their_limit_and_come_above_it():
    points, triangles = surfaces.blob(4)
    normals = vertex_normals(points, triangles)
    bends = principal_curvatures(points, triangles, normals)
    eye = np.array((3.0, 2.0, 2.5, 1.0))

    def drawn(share: float, before=None) -> set[int]:
        found = suggestive_contours(
            points, triangles, normals, bends, eye, slope=share * SLOPE, before=before
        )
        return set(found.triangle.tolist())

    def near(found: set[int]) -> np.ndarray:
        flags = np.zeros(len(points), bool)
        flags[triangles[sorted(found)]] = True
        return flags

    usual, steeper = drawn(50.0), drawn(65.0)
    assert len(usual) > len(steeper) + 10
    assert drawn(50.0, near(usual)) >= usual
    assert drawn(65.0, near(usual)) >= usual  # what was drawn stays
    assert len(drawn(50.0, near(set()))) < len(usual)  # what was not comes later


def test_a_view_from_elsewhere_is_a_first_one():
    view, near = View(), np.ones(3, bool)
    view.keep(np.array((0.0, 0.0, 5.0, 1.0)), near)
    assert view.before(np.array((0.3, 0.0, 5.0, 1.0))) is near
    assert view.before(np.array((3.0, 0.0, 5.0, 1.0))) is None
    assert view.before(np.array((0.0, 0.0, 1.0, 0.0))) is None
