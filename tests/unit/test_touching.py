"""Edges that solids have in common."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from glshim.geometry.recovery.mesh import mesh
from glshim.linework.feature_lines import EdgeLines
from glshim.linework.touching import touching
from tests.look import cube, cylinder, look_at

VIEW = look_at(np.array((3.0, 2.2, 4.0)))


def lines(made=None):
    return EdgeLines(mesh(made or cube(0.5)))


def at(x, y, z, *scale) -> np.ndarray:
    placed = np.eye(4)
    placed[:3, 3] = x, y, z
    placed[[0, 1, 2], [0, 1, 2]] = scale or (1.0, 1.0, 1.0)
    return VIEW @ placed


def counts(*objects) -> list[tuple[int, int]]:
    return [(int(one.shared.sum()), int(one.inside.sum())) for one in touching(objects)]


def test_what_stands_apart_touches_nothing() -> None:
    one = lines()
    assert counts((one, at(0, 0, 0)), (one, at(1.5, 0, 0))) == [(0, 0), (0, 0)]


@pytest.mark.parametrize("mirrored", [1.0, -1.0])
def test_the_common_face_of_two_cubes_has_no_edges(mirrored: float) -> None:
    one = lines()
    two = counts((one, at(0, 0, 0)), (one, at(1, 0, 0, mirrored, 1.0, 1.0)))
    assert two == [(4, 4), (4, 4)]


def test_of_eight_cubes_the_edges_of_the_large_one_stay() -> None:
    one = lines()
    found = counts(*((one, at(*corner)) for corner in product((0.0, 1.0), repeat=3)))
    assert found == [(9, 9)] * 8  # three of each are the large one's

def test_an_l_keeps_its_inner_corner() -> None:
    one = lines()
    found = counts(*((one, at(*place)) for place in ((0, 0, 0), (1, 0, 0), (0, 1, 0))))
    assert found[0] == (7, 6)  # the one in the corner


def test_cubes_that_meet_in_an_edge_keep_it() -> None:
    one = lines()
    assert counts((one, at(0, 0, 0)), (one, at(1, 1, 0))) == [(1, 0), (1, 0)]


def test_the_same_cube_twice_keeps_its_edges() -> None:
    one = lines()
    assert counts((one, at(0, 0, 0)), (one, at(0, 0, 0))) == [(12, 0), (12, 0)]


def test_a_long_side_is_inside_where_all_its_parts_are() -> None:
    one, long = lines(), (1.0, 2.0, 1.0)
    whole = counts((one, at(0, 0, 0)), (one, at(0, 1, 0)), (one, at(1, 0.5, 0, *long)))
    assert whole[2] == (4, 4)
    part = counts((one, at(0, 0, 0)), (one, at(1, 0.5, 0, *long)))
    assert part[1][1] < 4


def test_a_drum_on_a_drum_is_one() -> None:
    drum = lines(cylinder(24, 0.7, 1.0))
    found = counts((drum, VIEW), (drum, at(0, 0, 2)))
    assert found == [(24, 24), (24, 24)]
