"""Meshes that move are found again."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.recovery.meshes import Meshes
from glshim.model.batch import PolygonBatch
from tests.look import batch, bowl, cube, torus
from tests.unit.test_mesh import (
    consistent,
    exploded,
    soup,
    triangulated,
    with_positions,
)


def waved(b: PolygonBatch, time: float, key=None) -> PolygonBatch:
    x, y, z = b.positions.astype(np.float64).T
    bent = np.stack((x, y + 0.2 * np.sin(3 * x + time), z * (1.2 + np.sin(time))), axis=1)
    return with_positions(b, bent, key)


@pytest.mark.parametrize("make", [torus, bowl, cube])
def test_a_moved_mesh_is_found_again(make) -> None:
    b = soup(make())
    first = mesh(b)
    labels = first.components
    moved = first.moved(waved(b, 1.0).positions)
    assert moved is not None
    assert moved.triangles is first.triangles
    assert moved.components is labels
    consistent(moved)
    afresh = mesh(waved(b, 1.0))
    for name in ("positions", "edges", "faces", "opposite", "normals", "vertex_normals"):
        np.testing.assert_array_equal(getattr(moved, name), getattr(afresh, name))
    assert (moved.normals != first.normals).any()
    assert first.moved(b.positions) is first


def test_what_has_come_apart_or_together_is_not_the_same_mesh() -> None:
    b = soup(bowl())
    m = mesh(b)
    torn = b.positions.copy()
    torn[7] += np.float32(0.01)
    assert m.moved(torn) is None
    assert m.moved(b.positions[:-3]) is None
    # Two rim vertices meet: positions that were one still are, but the bowl may have closed.
    one, other = m.positions[m.rim[:2]]
    met = b.positions.copy()
    met[(met == one).all(axis=1)] = other
    assert m.moved(met) is None
    # Triangles apart are no torus that has as many.
    ring = soup(torus())
    apart = ring.positions + np.repeat(np.arange(ring.polygon_count), 3)[:, None] * np.float32(9)
    scattered = mesh(with_positions(ring, apart))
    assert scattered.report.components == ring.polygon_count
    assert scattered.moved(ring.positions) is None


def test_triangles_without_area_stay_and_come_back() -> None:
    b = soup(torus())
    m = mesh(b)
    flat = m.moved(b.positions * np.float32([1, 1, 0]))
    assert flat is not None
    gone = m.moved(np.where(b.positions == b.positions[0], np.float32("nan"), b.positions))
    assert gone is None
    collapsed = m.moved(b.positions * np.float32(0))
    assert collapsed is not None
    assert not collapsed.normals.any()
    assert not collapsed.vertex_normals.any()
    assert collapsed.moved(b.positions) is not None
    # What was left out for want of area must be looked at anew once it has one.
    line = batch([(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 1, 0)], [[0, 1, 2], [0, 1, 3]])
    m = mesh(line)
    assert len(m.triangles) == 1
    assert m.moved(line.positions + np.float32(1)) is not None
    assert m.moved([(0, 0, 0), (1, 0, 0), (2, 5, 0), (1, 1, 0)]) is None


def test_moved_within_the_tolerance() -> None:
    random = np.random.default_rng(4)
    b = soup(torus())
    m = mesh(with_positions(b, b.positions + random.random(b.positions.shape) * 1e-4), 1e-3)
    assert m.closed.all()
    again = m.moved(waved(b, 1.0).positions + random.random(b.positions.shape) * 1e-4)
    assert again is not None
    assert again.triangles is m.triangles
    assert m.moved(b.positions + random.random(b.positions.shape) * 1e-1) is None
    # Welded where they were equal, found where they are near.
    assert mesh(b, 1e-3).moved(b.positions + random.random(b.positions.shape) * 1e-4) is not None
    # A chain is one vertex, however far its ends; it may move as a whole.
    links = 0.9e-3 * np.arange(5)[:, None] * np.array([1.0, 0, 0])
    chain = batch([*links, (0, 1, 0), (0, 0, 1)], [[k, 5, 6] for k in range(5)])
    m = mesh(chain, 1e-3)
    assert len(m.positions) == 3
    assert m.moved(chain.positions[:, [1, 2, 0]]) is not None
    assert m.moved(chain.positions * np.float32(1.1)) is None


def test_nan_corners_do_not_hinder_finding() -> None:
    points = torus().positions.copy()
    points[5] = np.nan
    b = with_positions(torus(), points)
    m = mesh(b)
    assert m.report.boundary > 0
    assert m.moved(waved(b, 1.0).positions) is not None


def test_meshes_recover_once() -> None:
    meshes = Meshes()
    ring, ball = soup(torus(12, 6)), soup(bowl(12, 9))
    for frame in range(5):
        for b in (ring, ball):
            found = meshes.find(waved(b, 0.3 * frame))
            np.testing.assert_array_equal(found.positions, mesh(waved(b, 0.3 * frame)).positions)
            meshes.tick()
    assert meshes.recovered == 2
    assert meshes.find(waved(ring, 1.2)) is meshes.find(waved(ring, 1.2))


def test_meshes_of_one_structure_do_not_mix() -> None:
    meshes = Meshes()
    ring = soup(torus(12, 6))
    other = exploded(triangulated(torus(6, 12)))
    assert len(ring.positions) == len(other.positions)
    np.testing.assert_array_equal(ring.corners, other.corners)
    for _ in range(3):
        for b in (ring, other):
            np.testing.assert_array_equal(meshes.find(b).edges, mesh(b).edges)
    assert meshes.recovered == 2


def test_meshes_by_key() -> None:
    meshes = Meshes()
    b = exploded(torus(), key="list 1")
    found = meshes.find(b)
    assert meshes.find(b) is found
    # A list that was compiled again with other positions: the topology is found.
    moved = meshes.find(waved(b, 1.0, "list 2"))
    assert moved is not found
    assert moved.triangles is found.triangles
    assert meshes.find(waved(b, 1.0, "list 2")) is moved
    assert meshes.recovered == 1
    # Other flags are another structure.
    flags = b.boundary.copy()
    flags[3] = False
    meshes.find(PolygonBatch(b.positions, b.corners, b.starts, flags))
    assert meshes.recovered == 2


def test_meshes_stay_within_their_memory() -> None:
    most = 4 * mesh(soup(torus())).nbytes
    meshes = Meshes(most_bytes=most)
    for k in range(20):
        ring = torus(36, 18, small=0.3 + 0.01 * k)
        meshes.find(exploded(triangulated(ring), np.random.default_rng(k).permutation(1296), k))
    held = meshes._keyed._bytes + meshes._alike._bytes
    assert meshes.recovered == 20
    assert held <= most
