"""Connectivity recovered from streams: against meshes whose connectivity is known."""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.recovery.components import components
from glshim.geometry.recovery.mesh import Mesh, mesh
from glshim.model.batch import PolygonBatch, join
from tests.look import batch, bowl, cube, cylinder, polygons_of, sphere, torus


def exploded(b: PolygonBatch, order=None, key=None) -> PolygonBatch:
    """The same polygons with a position for each corner, as glBegin/glEnd sends them."""
    polygons = polygons_of(b)
    if order is not None:
        polygons = [polygons[k] for k in order]
    corners = np.concatenate(polygons)
    ends = np.cumsum([len(p) for p in polygons])[:-1]
    return batch(b.positions[corners], np.split(np.arange(len(corners)), ends), key)


def triangulated(b: PolygonBatch) -> PolygonBatch:
    """Triangles, with those of fewer than three different points left out."""
    fans = [
        [p[0], p[k], p[k + 1]]
        for p in polygons_of(b)
        for k in range(1, len(p) - 1)
        if len(np.unique(b.positions[[p[0], p[k], p[k + 1]]], axis=0)) == 3
    ]
    return batch(b.positions, fans)


def soup(b: PolygonBatch, seed=0) -> PolygonBatch:
    """Triangles without indices in random order."""
    b = triangulated(b)
    return exploded(b, np.random.default_rng(seed).permutation(b.polygon_count))


def with_positions(b: PolygonBatch, positions, key=None) -> PolygonBatch:
    return PolygonBatch(np.asarray(positions, np.float32), b.corners, b.starts, b.boundary, key)


def euler(m: Mesh) -> int:
    return m.report.vertices - m.report.edges + m.report.triangles


def consistent(m: Mesh) -> None:
    """What holds for every mesh, whatever it was made of."""
    a, b = m.faces.T
    paired = b >= 0
    rows = np.arange(len(m.edges))
    winds = [{tuple(t[[k, (k + 1) % 3]]) for k in range(3)} for t in m.triangles]
    for row, (v0, v1), (v2, v3) in zip(rows, m.edges, m.opposite, strict=True):
        assert (v0, v1) in winds[a[row]]
        assert set(m.triangles[a[row]]) == {v0, v1, v2}
        if paired[row]:
            assert set(m.triangles[b[row]]) == {v0, v1, v3}
            assert ((v0, v1) in winds[b[row]]) == m.twisted[row]
            assert m.manifold[row]
        else:
            assert v3 == v0
            assert not m.twisted[row]
    sides = 2 * paired.sum() + (~paired).sum()
    assert sides == 3 * len(m.triangles)


def test_cube_of_separate_pieces() -> None:
    b = cube()
    pieces = [batch(b.positions[p], [[0, 1, 2, 3]]) for p in polygons_of(b)]
    m = mesh(join(pieces))
    consistent(m)
    assert m.positions.shape == (8, 3)
    assert len(m.triangles) == 12
    assert len(m.edges) == 18
    assert m.true.sum() == 12  # not the six diagonals
    assert m.closed.all()
    assert m.manifold.all()
    assert not m.turned.any()
    assert sorted(m.polygon) == sorted([*range(6), *range(6)])
    outward = m.positions[m.triangles].mean(axis=1)
    assert (np.einsum("ij,ij->i", m.normals, outward) > 0).all()
    np.testing.assert_allclose(np.abs(m.normals).max(axis=1), 1.0)
    # Weighted by angles, the normal of a cube's corner is the diagonal, however faces are cut.
    np.testing.assert_allclose(m.vertex_normals, m.positions / (0.9 * np.sqrt(3)), atol=1e-6)


def test_torus_soup() -> None:
    m = mesh(soup(torus()))
    consistent(m)
    assert euler(m) == 0
    assert m.closed.all()
    assert m.components.max() == 0
    assert len(m.positions) == 36 * 18


def test_two_objects_are_two_components() -> None:
    apart = with_positions(cube(), cube().positions + np.float32(5))
    m = mesh(join([torus(), apart, bowl()]))
    assert m.report.components == 3
    assert m.report.closed == 2
    closed = np.repeat([True, True, False], [36 * 18, 6, 24 * 9])[m.polygon]
    np.testing.assert_array_equal(m.closed, closed)
    assert "3 components (2 closed)" in str(m.report)


def test_open_bowl() -> None:
    m = mesh(soup(bowl()))
    consistent(m)
    assert euler(m) == 1
    assert m.report.boundary == 24
    assert not m.closed.any()
    rim = m.edges[m.faces[:, 1] < 0]
    heights = m.positions[rim][..., 2]
    np.testing.assert_allclose(heights, m.positions[:, 2].max(), atol=1e-6)
    assert set(m.rim) == set(rim.ravel())


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("share", [0.1, 0.45, 0.8])
def test_mixed_windings_follow_the_majority(seed: int, share: float) -> None:
    b = soup(sphere(), seed)
    flipped = np.random.default_rng(seed).random(b.polygon_count) < share
    corners = b.corners.reshape(-1, 3).copy()
    corners[flipped] = corners[flipped][:, ::-1]
    m = mesh(batch(b.positions, corners))
    consistent(m)
    minority = flipped if flipped.mean() < 0.5 else ~flipped
    np.testing.assert_array_equal(m.turned, minority)
    assert not m.twisted.any()
    assert m.report.turned == minority.sum()
    outward = m.positions[m.triangles].mean(axis=1)
    facing = np.einsum("ij,ij->i", m.normals, outward) > 0
    assert facing.all() if flipped.mean() < 0.5 else not facing.any()


def moebius(n=30) -> PolygonBatch:
    a = 2 * np.pi * np.arange(n) / n
    low, high = ([[(1 + w * np.cos(t / 2)) * np.cos(t), (1 + w * np.cos(t / 2)) * np.sin(t),
                   w * np.sin(t / 2)] for t in a] for w in (-0.3, 0.3))  # fmt: skip
    quads = [[i, i + 1, n + i + 1, n + i] for i in range(n - 1)]
    return batch([*low, *high], [*quads, [n - 1, n, 0, 2 * n - 1]])


def test_moebius_strip_keeps_one_twist() -> None:
    m = mesh(soup(moebius()))
    consistent(m)
    assert m.report.twisted == 1
    assert m.report.boundary == 60
    assert euler(m) == 0
    assert not m.turned.any()  # no turning leaves fewer


def test_three_quads_on_an_edge() -> None:
    points = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (1, 0, 1), (0, 1, 0), (0, 1, 1), (-1, -1, 0),
              (-1, -1, 1)]  # fmt: skip
    m = mesh(exploded(batch(points, [[0, 1, 3, 2], [0, 1, 5, 4], [0, 1, 7, 6]])))
    consistent(m)
    crowded = ~m.manifold
    assert crowded.sum() == 3
    assert len({tuple(sorted(e)) for e in m.edges[crowded]}) == 1
    assert set(m.polygon[m.faces[crowded, 0]]) == {0, 1, 2}
    assert (m.faces[crowded, 1] == -1).all()
    assert m.true[crowded].all()
    assert m.report.non_manifold == 1
    assert m.report.components == 3
    assert not m.closed.any()


def test_a_crowded_edge_is_true_if_any_side_is() -> None:
    points = [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, -1, 0)]
    b = batch(points, [[0, 1, 2], [0, 1, 3], [0, 1, 4]])
    flags = np.zeros(9, bool)
    flags[3] = True
    m = mesh(PolygonBatch(b.positions, b.corners, b.starts, flags))
    np.testing.assert_array_equal(m.true, ~m.manifold)


def test_a_pair_is_true_if_either_side_is() -> None:
    b = batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2], [2, 0, 3]])
    for at in (2, 3):
        flags = np.zeros(6, bool)
        flags[at] = True
        m = mesh(PolygonBatch(b.positions, b.corners, b.starts, flags))
        np.testing.assert_array_equal(m.true, m.faces[:, 1] >= 0)


def test_polygons_of_all_sizes() -> None:
    m = mesh(exploded(cylinder(12)))
    consistent(m)
    assert euler(m) == 2
    assert m.closed.all()
    assert m.true.sum() == 36
    assert (np.bincount(m.polygon) == [*[2] * 12, 10, 10]).all()


def test_repeated_corners_lose_no_side() -> None:
    # A lone quad whose first corner came twice is a triangle with three true sides.
    points = [(0, 0, 0), (0, 0, 0), (1, 0, 0), (0, 1, 0)]
    for turn in range(4):
        m = mesh(batch(points, [np.roll(np.arange(4), turn)]))
        assert len(m.triangles) == 1
        assert m.true.all()
        assert m.report.boundary == 3
    m = mesh(sphere())  # quads at the poles
    assert euler(m) == 2
    assert m.closed.all()


def test_a_surface_sent_twice_counts_once() -> None:
    for b in (torus(), bowl(), batch([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]])):
        once, twice = mesh(b), mesh(join([b, b]))
        assert twice.report == once.report
        assert (twice.polygon < b.polygon_count).all()


def test_degenerates_and_nan_are_dropped() -> None:
    b = triangulated(torus())
    bad = batch([(np.nan, 0, 0), (0.5, np.inf, 0.5), (1, 0, 1), (0, 1, 0), (2, 0, 2), (3, 0, 3)],
                [[0, 2, 3], [1, 2, 3], [2, 4, 5], [2, 2, 3], [0, 0, 0], [1, 1, 4]])  # fmt: skip
    m = mesh(join([bad, exploded(b)]))
    assert m.polygon.min() == 6
    assert m.report == mesh(b).report
    assert len(m.weld) == 6 + 3 * b.polygon_count
    assert np.isfinite(m.normals).all()
    assert np.isfinite(m.vertex_normals).all()


def test_nothing() -> None:
    for b in (
        PolygonBatch(np.empty((0, 3), np.float32), np.empty(0, np.int32), np.zeros(1, np.int32),
                     np.empty(0, bool)),
        batch([(np.nan, 0, 0)] * 3, [[0, 1, 2]]),
        batch([(0, 0, 0)] * 4, [[0, 1, 2, 3]]),
        batch([(0, 0, 0), (1, 1, 1)], [[0, 1]]),
    ):  # fmt: skip
        for tolerance in (0.0, 0.1):
            m = mesh(b, tolerance)
            assert len(m.triangles) == len(m.edges) == len(m.normals) == len(m.closed) == 0
            assert m.report.components == 0
            assert len(m.vertex_normals) == len(m.positions)



@given(data=st.data())
@settings(max_examples=200, deadline=None)
def test_components_have_the_parity_of_their_links(data: st.DataObject) -> None:
    count = data.draw(st.integers(1, 30))
    node = st.integers(0, count - 1)
    links = data.draw(st.lists(st.tuples(node, node), max_size=60))
    colour = np.array(data.draw(st.lists(st.booleans(), min_size=count, max_size=count)))
    one, other = np.array(links, np.int32).reshape(-1, 2).T
    found = components(count, one, other, colour[one] ^ colour[other])
    reach = np.eye(count, dtype=bool)
    reach[one, other] = reach[other, one] = True
    for k in range(count):
        reach |= reach[:, k : k + 1] & reach[k]
    np.testing.assert_array_equal(found.label[:, None] == found.label[None], reach)
    np.testing.assert_array_equal(found.first[found.label], reach.argmax(axis=1))
    np.testing.assert_array_equal(found.odd, colour ^ colour[found.first[found.label]])


def _expected(triangles: list[tuple[int, ...]]) -> dict[frozenset[int], list[int]]:
    """The triangles of each edge, by the plainest of means."""
    found = defaultdict(list)
    for t, corners in enumerate(triangles):
        for k in range(3):
            found[frozenset((corners[k], corners[(k + 1) % 3]))].append(t)
    return found


def _winds(t: tuple[int, ...], edge: frozenset[int]) -> tuple[int, ...]:
    return next((t[k], t[(k + 1) % 3]) for k in range(3) if {t[k], t[(k + 1) % 3]} == edge)


@given(data=st.data())
@settings(max_examples=300, deadline=None)
def test_soup_gives_back_the_indexed_mesh(data: st.DataObject) -> None:
    count = data.draw(st.integers(3, 9))
    triple = st.permutations(range(count)).map(lambda p: tuple(p[:3]))
    triangles = data.draw(st.lists(triple, min_size=1, max_size=16, unique_by=frozenset))
    # No three points are near a line: nothing is a junction of sides.
    points = np.array([(np.cos(2.4 * i), np.sin(2.4 * i), i % 3) for i in range(count)], np.float32)
    m = mesh(exploded(batch(points, triangles)))
    consistent(m)
    vertex = {tuple(p): i for i, p in enumerate(points)}
    number = [vertex[tuple(p)] for p in m.positions]
    assert sorted(number) == sorted({v for t in triangles for v in t})
    np.testing.assert_array_equal(m.polygon, np.arange(len(triangles)))

    rows = defaultdict(list)
    for ends, faces in zip(m.edges, m.faces, strict=True):
        rows[frozenset(number[v] for v in ends)].append(faces.tolist())
    links = []
    expected = _expected(triangles)
    assert set(rows) == set(expected)
    for edge, sharing in expected.items():
        if len(sharing) == 2:
            assert rows[edge] == [sharing]
            against = _winds(triangles[sharing[0]], edge) == _winds(triangles[sharing[1]], edge)
            links.append((*sharing, against))
        else:
            assert sorted(rows[edge]) == [[t, -1] for t in sharing]

    # Windings: walk from triangle to triangle, and compare with what was turned.
    ways = defaultdict(list)
    for a, b, against in links:
        ways[a].append((b, against))
        ways[b].append((a, against))
    label, odd = {}, {}
    for seed in range(len(triangles)):
        if seed in label:
            continue
        label[seed], odd[seed], todo = seed, False, [seed]
        while todo:
            a = todo.pop()
            for b, against in ways[a]:
                if b not in label:
                    label[b], odd[b] = seed, odd[a] ^ against
                    todo.append(b)
        members = [t for t in label if label[t] == seed]
        inner = [link for link in links if label.get(link[0]) == seed]
        still = [link for link in inner if link[2] ^ odd[link[0]] ^ odd[link[1]]]
        left = sum(link[2] ^ m.turned[link[0]] ^ m.turned[link[1]] for link in inner)
        if still:  # not orientable
            assert 0 < left <= sum(link[2] for link in inner)
        else:
            minority = 2 * sum(odd[t] for t in members) > len(members)
            assert all(m.turned[t] == odd[t] ^ minority for t in members)
            assert left == 0
    for t, corners in enumerate(triangles):
        own = [number[v] for v in m.triangles[t]]
        at = own.index(corners[0])
        assert tuple(own[at:] + own[:at])[:: -1 if m.turned[t] else 1] in {
            corners, corners[1:] + corners[:1], corners[2:] + corners[:2]
        }  # fmt: skip
        assert m.components[t] == sorted(set(label.values())).index(label[t])


def _quad(*corners):
    return batch(corners, [[0, 1, 2, 3]])


def test_a_side_along_two_others_has_both_for_neighbours() -> None:
    """Whatever the sides' order and however many junctions lie on one."""
    steps = np.linspace(0.0, 1.0, 8)
    parts = [_quad((0, 0, 0), (1, 0, 0), (1, -1, 0), (0, -1, 0))]
    parts += [_quad((a, 0, 0), (a, 1, 0), (b, 1, 0), (b, 0, 0)) for a, b in pairwise(steps)]
    m = mesh(join(parts))
    consistent(m)
    assert m.report.boundary == 2 + 7 + 1 + 2
    assert m.report.components == 1
    assert euler(m) == 1
    assert m.true[m.faces[:, 1] < 0].all()
    assert m.joints is not None
    lifted = m.moved(join(parts).positions + np.float32(0.3))
    assert lifted is not None
    assert lifted.triangles is m.triangles
    bent = join(parts).positions.copy()
    bent[bent[:, 0] == 0.0, 2] += 0.5
    bent[0, 2] -= 0.2
    assert m.moved(bent) is None  # what lay on a side no longer does


@pytest.mark.parametrize("gap", [0.02, 0.004])
def test_gaps_between_tiles_stay_open(gap: float) -> None:
    tiles = []
    for row in range(3):
        for column in range(4):
            x, y = column + 0.5 * (row % 2), float(row)
            tiles.append(
                _quad((x, y, 0), (x + 1 - gap, y, 0), (x + 1 - gap, y + 1 - gap, 0),
                      (x, y + 1 - gap, 0)))  # fmt: skip
    m = mesh(join(tiles))
    assert m.joints is None
    assert m.report.boundary == 4 * len(tiles)


def test_a_slit_between_two_curves_stays_open() -> None:
    """Lips: both ends in common, as many corners on either side, bent away from each other."""
    x = np.linspace(-1.0, 1.0, 7)
    open_ = 0.04 * (1.0 - x**2)
    upper = [_quad((a, p, 0), (b, q, 0), (b, 1, 0), (a, 1, 0))
             for (a, p), (b, q) in pairwise(zip(x, open_, strict=True))]  # fmt: skip
    lower = [_quad((a, -1, 0), (b, -1, 0), (b, -q, 0), (a, -p, 0))
             for (a, p), (b, q) in pairwise(zip(x, open_, strict=True))]  # fmt: skip
    m = mesh(join(upper + lower))
    assert m.joints is None
    assert m.report.boundary == 2 * 6 + 2 * 6 + 4


def test_rounding_parts_no_seam() -> None:
    b = exploded(batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2], [0, 2, 3]]))
    noise = np.random.default_rng(3).uniform(-1.0, 1.0, b.positions.shape) * 2e-6
    m = mesh(with_positions(b, b.positions + noise))
    consistent(m)
    assert m.report.boundary == 4


def test_what_ends_on_a_side_may_be_wound_as_it_likes() -> None:
    """Two small quads along the side of a large one, wound against it: no fault of the program's,
    as it is where sides are whole."""
    points = [(0, 0), (2, 0), (2, 1), (0, 1), (0, -1), (1, -1), (2, -1), (1, 0)]
    points = [(*point, 0) for point in points]
    cut = mesh(batch(points, [[0, 1, 2, 3], [0, 7, 5, 4], [7, 1, 6, 5]]))
    assert cut.joints is not None
    assert not cut.mixed
    assert mesh(batch(points, [[0, 1, 2, 3], [0, 1, 6, 4]])).mixed
