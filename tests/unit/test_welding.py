"""Which positions are one vertex."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.recovery import welding
from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.mesh import mesh, weld
from tests.look import torus
from tests.unit.test_mesh import (
    consistent,
    euler,
    soup,
    with_positions,
)


def test_weld_exactly() -> None:
    points = np.array([(0.0, 1, 2), (-0.0, 1, 2), (1, 1, 2), (np.nan, 0, 0), (np.nan, 0, 0),
                       (0, 1, 2), (np.inf, 0, 0), (np.inf, 0, 0), (1, 1, 2)],
                      np.float32)  # fmt: skip
    first, vertex = weld(points)
    np.testing.assert_array_equal(first, [0, 2, 3, 4, 6, 7])
    np.testing.assert_array_equal(vertex, [0, 0, 1, 2, 3, 0, 4, 5, 1])


def test_weld_survives_clashing_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    points = np.random.default_rng(0).integers(-3, 3, (500, 3)).astype(np.float32)
    expected = weld(points)
    monkeypatch.setattr(welding, "mixed", lambda columns: next(iter(columns)).astype(np.uint64))
    for a, b in zip(weld(points), expected, strict=True):
        np.testing.assert_array_equal(a, b)
    assert len(expected[0]) == len(np.unique(points, axis=0))


@pytest.mark.parametrize("scale", [1e-3, 1.0, 1e6])
@pytest.mark.parametrize("spread", [2.0, 12.0])
def test_weld_within_tolerance_is_single_linkage(scale: float, spread: float) -> None:
    # spread, in tolerances: 12 gives some chains, 2 a crowd.
    random = np.random.default_rng(int(spread))
    points = (random.random((300, 3)) * spread * scale).astype(np.float32)
    points[::7] = points[3]
    exact = points.astype(np.float64)
    near = np.linalg.norm(exact[:, None] - exact[None], axis=2) <= scale
    one, other = np.nonzero(near)
    expected = components(300, one.astype(np.int32), other.astype(np.int32))
    first, vertex = weld(points, scale)
    np.testing.assert_array_equal(vertex, expected.label)
    np.testing.assert_array_equal(first, expected.first)


def test_weld_finds_pairs_across_all_cell_boundaries() -> None:
    directions = np.random.default_rng(1).normal(size=(2000, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    start = np.arange(2000)[:, None] * np.array([5.0, 0, 0]) + directions[::-1]
    for way, count in ((0.99, 2000), (1.01, 4000)):
        points = np.concatenate((start, start + way * directions)).astype(np.float32)
        first, vertex = weld(points, 1.0)
        np.testing.assert_array_equal(first, np.arange(count))
        np.testing.assert_array_equal(vertex, np.arange(4000) % count)


def test_tolerance_closes_a_seam() -> None:
    b = soup(torus())
    noise = np.random.default_rng(3).normal(size=b.positions.shape) * 1e-4
    rough = with_positions(b, b.positions + noise)
    assert mesh(rough).report.boundary > 100
    m = mesh(rough, 1e-3)
    consistent(m)
    assert euler(m) == 0
    assert m.closed.all()
