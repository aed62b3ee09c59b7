"""What volumes are closed by: every side of every triangle is in one row."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from glshim.geometry.meshshaders.edge_mesh import edge_mesh, inner_sides
from glshim.geometry.recovery.mesh import mesh
from tests import look

FIN = look.batch(  # three triangles at one edge
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, -1, 0)], [[0, 1, 2], [0, 1, 3], [0, 1, 4]]
)


@pytest.mark.parametrize("batch", [*(make() for make in look.MESHES.values()), FIN])
def test_every_side_is_in_one_row(batch):
    found = mesh(batch)
    edges = edge_mesh(found)
    rest = inner_sides(found, edges)
    assert len(rest) + len(edges.indices) == len(found.edges)
    rows = np.concatenate((edges.indices, rest))
    rows = np.where(rows < 0, ~rows, rows)
    sides = Counter()
    for v0, v1, v2, v3 in rows.tolist():
        sides[frozenset((v0, v1)), v2] += 1
        if v3 != v0:
            sides[frozenset((v0, v1)), v3] += 1
    wanted = Counter()
    for a, b, c in found.triangles.tolist():
        wanted.update([(frozenset((a, b)), c), (frozenset((b, c)), a), (frozenset((c, a)), b)])
    assert sides == wanted


def test_the_diagonals_of_flat_quads_are_the_rest():
    found = mesh(look.cube())
    assert len(inner_sides(found, edge_mesh(found))) == 6
