"""Halfedges against a look at every pair of triangles."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.recovery.halfedges import twins, with_adjacency
from glshim.geometry.recovery.mesh import mesh
from tests import look

MESHES = {
    "torus": look.torus(9, 6),
    "bowl": look.bowl(8, 4),
    "cube": look.cube(),
    "three on an edge": look.batch(
        [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, -1, 0)], [[0, 1, 2], [1, 0, 3], [0, 1, 4]]
    ),
    "wound wrongly": look.batch(
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 1)], [[0, 1, 2], [1, 2, 3], [0, 1, 3]]
    ),
    "nothing": look.batch([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [[0, 1, 2]]),
}


@pytest.mark.parametrize("name", MESHES)
def test_every_side_knows_the_vertex_across(name):
    found = mesh(MESHES[name])
    six = with_adjacency(found.triangles, twins(found))
    assert six.shape == (len(found.triangles), 6)
    assert np.array_equal(six[:, ::2], found.triangles)
    for t, corners in enumerate(found.triangles):
        for k in range(3):
            ends = {corners[k], corners[(k + 1) % 3]}
            others = [set(o) - ends for s, o in enumerate(found.triangles)
                      if s != t and ends <= set(o)]  # fmt: skip
            expected = others[0] if len(others) == 1 else {corners[k]}
            assert {six[t, 2 * k + 1]} == expected


@pytest.mark.parametrize("name", MESHES)
def test_a_twin_of_a_twin_is_the_halfedge(name):
    found = twins(mesh(MESHES[name]))
    paired = np.flatnonzero(found >= 0)
    assert np.array_equal(found[found[paired]], paired)
    if name in ("torus", "cube"):
        assert len(paired) == len(found)
