"""Which way is out of triangles that nobody has welded."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.recovery.outward import outward_sign


def box(size=1.0):
    """(12, 3, 3) wound about what is out."""
    found = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            u, v, n = np.roll(np.eye(3), axis, axis=0)
            corners = [side * n + a * u + b * v for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            if np.dot(np.cross(corners[1] - corners[0], corners[2] - corners[0]), side * n) < 0.0:
                corners.reverse()
            found += [corners[:3], [corners[0], corners[2], corners[3]]]
    return size * np.array(found)


def floor(size=30.0):
    """(2, 3, 3) far below, seen from above."""
    square = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    a, b, c, d = (np.array((x * size, y * size, -5.0)) for x, y in square)
    return np.array([(a, b, c), (a, c, d)])


@pytest.mark.parametrize("turned", [1, -1])
def test_of_a_body_on_a_floor_the_body_says(turned):
    body = box()[:, ::turned]
    assert outward_sign(body) == turned
    assert outward_sign(np.concatenate((body, floor()))) == turned
    assert outward_sign(np.concatenate((floor(), body, box(0.3)[:, ::turned] + 4.0))) == turned


def test_a_sheet_has_no_outside():
    assert outward_sign(floor()) == 0.0
    assert outward_sign(np.empty((0, 3, 3))) == 0.0
    assert outward_sign(np.full((2, 3, 3), np.nan)) == 0.0


def test_patches_that_miss_each_other_enclose_something_together():
    apart = box() * (1.0 + 1e-4 * np.arange(12)[:, None, None])
    assert outward_sign(apart) == 1.0
    assert outward_sign(apart[:, ::-1]) == -1.0
