"""Creases: against definitions taken literally, halfedge by halfedge."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.crease.creases import INVALID, Creases, creases, decoded
from glshim.geometry.crease.quads import silhouettes
from glshim.geometry.crease.smoothing_groups import by_traversal, within_adjacency
from glshim.geometry.recovery.mesh import Mesh, mesh
from tests import look, surfaces

CUTS = st.integers(0, 2**32 - 1)


def sent_by(m: Mesh, cut: float, seed: int) -> np.ndarray:
    """(T, 3, 3) normals of an app that duplicates vertices at a share of the edges: smoothing
    groups of triangles, each with a normal of its own at each vertex."""
    random = np.random.default_rng(seed)
    group = np.arange(len(m.triangles))
    a, b = m.faces[(m.faces[:, 1] >= 0) & (random.random(len(m.faces)) >= cut)].T
    for _ in range(len(m.triangles)):
        least = np.minimum(group[a], group[b])
        before = group.copy()
        np.minimum.at(group, a, least)
        np.minimum.at(group, b, least)
        if np.array_equal(before, group):
            break
    own = random.normal(size=(group.max(initial=0) + 1, 3))
    return (m.vertex_normals[m.triangles] + own[group][:, None]).astype(np.float32)


def fans_of(m: Mesh, sides: np.ndarray) -> list[set[int]]:
    """Corners around each vertex that hang together over sides that are no creases."""
    parent = list(range(3 * len(m.triangles)))

    def root(c: int) -> int:
        while parent[c] != c:
            c = parent[c]
        return c

    where = {}
    for t, tri in enumerate(m.triangles):
        for k in range(3):
            where.setdefault(frozenset((tri[k], tri[(k + 1) % 3])), []).append((t, k))
    for halves in where.values():
        if len(halves) != 2 or any(sides[h] for h in halves):
            continue
        (t, k), (s, _) = halves
        for v in (m.triangles[t, k], m.triangles[t, (k + 1) % 3]):
            one, other = (3 * f + list(m.triangles[f]).index(v) for f in (t, s))
            parent[root(one)] = root(other)
    groups: dict[int, set[int]] = {}
    for c in range(len(parent)):
        groups.setdefault(root(c), set()).add(c)
    return list(groups.values())


def literally(m: Mesh, n: np.ndarray) -> np.ndarray:
    """(T, 3) section 3 word by word: the triangles do not share two vertex records."""
    found = np.zeros(m.triangles.shape, bool)
    n = n / np.maximum(np.linalg.norm(n, axis=2, keepdims=True), 1e-30)
    for e, (a, b) in enumerate(m.faces):
        ends = m.edges[e]
        if b < 0:
            k = _side(m.triangles[a], ends)
            found[a, k] = m.true[e]
            continue
        records = [[n[t, list(m.triangles[t]).index(v)] for v in ends] for t in (a, b)]
        differ = any(
            np.linalg.norm(p - q) > 1e-3 and p.any() and q.any()
            for p, q in zip(*records, strict=True)
        )
        if m.true[e] and (differ or m.twisted[e]):
            for t in (a, b):
                found[t, _side(m.triangles[t], ends)] = True
    return found


def _side(tri: np.ndarray, ends: np.ndarray) -> int:
    return next(k for k in range(3) if {tri[k], tri[(k + 1) % 3]} == set(ends))


def dart() -> tuple[Mesh, np.ndarray]:
    """A flat disc with one crease from its middle to its rim: the middle is the tip of a dart."""
    ring = [(np.cos(a), np.sin(a), 0) for a in np.arange(6) * np.pi / 3]
    m = mesh(look.batch([(0, 0, 0), *ring], [[0, 1 + k, 1 + (k + 1) % 6] for k in range(6)]))
    sent = np.tile(np.array((0.0, 0.0, 1.0)), (6, 3, 1))
    for t, tri in enumerate(m.triangles):
        if set(tri) == {0, 1, 2}:
            sent[t, list(tri).index(1)] = (1, 0, 1)
    return m, sent.astype(np.float32)


def hourglass() -> Mesh:
    """Two closed cones that meet at their tips."""
    ring = [(np.cos(a), np.sin(a)) for a in np.arange(7) * 2 * np.pi / 7]
    points = [(0, 0, 0), *[(x, y, 1) for x, y in ring], *[(x, y, -1) for x, y in ring]]
    points += [(0, 0, 1), (0, 0, -1)]
    faces = []
    for k in range(7):
        j = (k + 1) % 7
        faces += [[0, 1 + k, 1 + j], [15, 1 + j, 1 + k], [0, 8 + j, 8 + k], [16, 8 + k, 8 + j]]
    return mesh(look.batch(points, faces))


MESHES = {
    "torus": mesh(look.torus(9, 6)),
    "bowl": mesh(look.bowl(8, 4)),
    "cube": mesh(look.cube()),
    "cylinder": mesh(look.cylinder()),
    "hourglass": hourglass(),
    "blob": mesh(look.batch(*surfaces.icosphere(1))),
    "dart": dart()[0],
    "three on an edge": mesh(look.batch(
        [(0, 0, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (-1, -1, 0)], [[0, 1, 2], [1, 0, 3], [0, 1, 4]]
    )),
    "moebius": mesh(look.batch(
        [(0, 0, 0), (1, 0, 0), (0, 1, 1), (1, 1, 0), (0, 2, 0.5)],
        [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]],
    )),
    "bent quads": mesh(look.batch(
        [(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0), (2, 0, 0), (2, 1, 3)],
        [[0, 1, 2, 3], [1, 4, 5, 2]],
    )),
    "nothing": mesh(look.batch([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [[0, 1, 2]])),
}  # fmt: skip


@st.composite
def soups(draw: st.DrawFn) -> Mesh:
    """Any triangles of few vertices: open, non-manifold, twisted, several fans at a vertex."""
    count = draw(st.integers(3, 9))
    corner = st.integers(0, count - 1)
    faces = draw(st.lists(st.tuples(corner, corner, corner), min_size=1, max_size=24))
    points = np.random.default_rng(draw(st.integers(0, 99))).normal(size=(count, 3))
    return mesh(look.batch(points, faces))


def check(m: Mesh, sent: np.ndarray) -> Creases:
    """All that must hold of creases, by the paper's rule."""
    found = creases(m, sent, rule="normals", least=0.0)
    assert np.array_equal(found.sides, literally(m, sent))
    fans = fans_of(m, found.sides)
    assert {frozenset(f) for f in fans} == {
        frozenset(np.flatnonzero(found.triangles.ravel() == v)) for v in np.unique(found.triangles)
    }
    assert np.array_equal(found.vertices[found.triangles], m.triangles)
    assert np.array_equal(found.vertices[: len(m.positions)], np.arange(len(m.positions)))
    flags = found.sides.ravel()
    joined = found.halfedges.twins.copy()
    joined[flags] = -1
    one, other, _, _ = found.halfedges
    joined[one[m.twisted]] = joined[other[m.twisted]] = -1
    count = len(found.vertices)
    traversed = by_traversal(found.triangles, found.sides, joined, count)
    adjacent = within_adjacency(found.triangles, found.sides, count)
    assert np.array_equal(traversed.incoming, adjacent.incoming)
    assert np.array_equal(traversed.outgoing, adjacent.outgoing)
    halves = np.flatnonzero(flags)
    # At most one in and one out at each: so every crease halfedge is written somewhere.
    assert np.array_equal(np.sort(adjacent.outgoing[adjacent.outgoing >= 0]), halves)
    assert np.array_equal(np.sort(adjacent.incoming[adjacent.incoming >= 0]), halves)
    return found


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("cut", [0.0, 0.1, 0.4, 1.0])
def test_known_meshes(name: str, cut: float) -> None:
    for seed in range(3):
        check(MESHES[name], sent_by(MESHES[name], cut, seed))


@settings(deadline=None, max_examples=150)
@given(soups(), st.sampled_from([0.0, 0.2, 0.5, 1.0]), CUTS)
def test_any_soup(m: Mesh, cut: float, seed: int) -> None:
    check(m, sent_by(m, cut, seed))


def test_the_halves_of_edges_are_those_of_halfedges() -> None:
    from glshim.geometry.recovery.halfedges import twins

    for m in MESHES.values():
        assert np.array_equal(creases(m).halfedges.twins, twins(m))


def test_the_tip_of_a_dart_is_followed_by_its_own_other_half() -> None:
    m, sent = dart()
    found = check(m, sent)
    inner = found.sides & ~found.open
    assert inner.sum() == 2
    incoming, outgoing = found.strips
    tip = int(found.triangles[m.triangles == 0][0])
    assert (found.triangles[m.triangles == 0] == tip).all()
    assert found.halfedges.twins[incoming[tip]] == outgoing[tip]
    e_out = m.positions[1] - m.positions[0]
    assert np.allclose(found.differences[tip], (*(2 * e_out), 0.0), atol=1e-6)


def test_closed_fans_that_share_a_vertex_are_two_vertices() -> None:
    m = MESHES["hourglass"]
    found = creases(m, rule="angle", angle=np.pi)
    assert not found.sides.any()
    assert len(found.vertices) == len(m.positions) + 1
    tips = np.flatnonzero(found.vertices == 0)
    assert len(tips) == 2
    assert not found.normals[tips].any()  # sharp ones, as that of a cone


def cone(n: int, half_angle: float) -> Mesh:
    """With its tip at vertex n."""
    ring = [(np.cos(a), np.sin(a), 0.0) for a in np.arange(n) * 2 * np.pi / n]
    tip = (0.0, 0.0, 1.0 / np.tan(half_angle))
    sides = [[k, (k + 1) % n, n] for k in range(n)]
    return mesh(look.batch([*ring, tip], [*sides, list(range(n))[::-1]]))


def test_the_tip_of_a_cone_has_no_normal_unless_it_is_blunt_or_the_app_says_so() -> None:
    sharp, blunt = cone(24, np.radians(40.0)), cone(24, np.radians(70.0))
    tip = 24
    assert not creases(sharp, rule="angle", angle=1.0).normals[tip].any()
    assert np.allclose(creases(blunt, rule="angle", angle=1.0).normals[tip], (0, 0, 1), atol=1e-6)
    at_tip = sharp.triangles == tip
    sent = np.repeat(sharp.normals[:, None], 3, axis=1).astype(np.float32)
    assert not creases(sharp, sent, rule="angle", angle=1.0).normals[tip].any()
    sent[at_tip] = (0.0, 0.0, 1.0)
    rounded = creases(sharp, sent, rule="angle", angle=1.0)
    assert np.allclose(rounded.normals[tip], (0, 0, 1), atol=1e-6)


def test_silhouettes_of_a_cone_run_from_its_rim_to_its_tip() -> None:
    m = cone(24, np.radians(30.0))
    found = creases(m, rule="angle", angle=1.0)
    lines = silhouettes(found, np.array((1.0, 0.3, 0.2, 0.0)))
    size = np.linalg.norm(lines.ends[:, 1] - lines.ends[:, 0], axis=1)
    ends = lines.ends[size > 1e-9]
    assert len(ends) == 2
    tip = m.positions[24]
    assert np.allclose(np.sort(np.linalg.norm(ends - tip, axis=2), axis=1)[:, 0], 0.0, atol=1e-9)
    assert np.allclose(np.sort(ends[:, :, 2], axis=1)[:, 0], 0.0, atol=1e-9)


def test_a_vertex_of_a_thousand_triangles() -> None:
    n = 1000
    ring = [(np.cos(a), np.sin(a), 0) for a in np.arange(n) * 2 * np.pi / n]
    faces = [[n, k, (k + 1) % n] for k in range(n)] + [[n + 1, (k + 1) % n, k] for k in range(n)]
    m = mesh(look.batch([*ring, (0, 0, 1), (0, 0, -1)], faces))
    found = creases(m, rule="angle", angle=1.0)
    assert found.sides.sum() == 2 * n  # the rim
    assert len(found.vertices) == n + 2 + n
    assert not creases(m, rule="angle", angle=2.0).sides.any()


@pytest.mark.parametrize("name", MESHES)
def test_differences_reflect_one_direction_on_the_other(name: str) -> None:
    m = MESHES[name]
    found = check(m, sent_by(m, 0.4, 1))
    held = found.differences.astype(np.float64)
    incoming, outgoing = found.strips
    for v in range(len(held)):
        delta, verifier = held[v, :3], held[v, 3]
        if incoming[v] < 0 and outgoing[v] < 0:
            assert verifier == INVALID
            assert not delta.any()
            continue
        if incoming[v] < 0 or outgoing[v] < 0:
            assert not held[v].any()
            continue
        corners = m.triangles.ravel()
        after = np.arange(len(corners)).reshape(-1, 3)[:, (1, 2, 0)].ravel()
        e_in, e_out = (
            (m.positions[corners[after[h]]] - m.positions[corners[h]]).astype(np.float64)
            for h in (incoming[v], outgoing[v])
        )
        e_in, e_out = (e / np.linalg.norm(e) for e in (e_in, e_out))
        assert np.allclose(e_out - delta, e_in, atol=1e-6)
        if np.linalg.norm(delta) > 1e-3:
            bisector = delta / np.linalg.norm(delta)
            assert np.allclose(e_in - 2 * (e_in @ bisector) * bisector, e_out, atol=1e-6)
        assert verifier == pytest.approx(np.cross(e_in, e_out)[0], abs=1e-6)


def test_rules_and_angles() -> None:
    m = mesh(look.cylinder(32))
    smooth = np.array(m.vertex_normals[m.triangles], np.float32)
    assert not creases(m, smooth, rule="normals").sides.any()
    rims = creases(m, smooth, rule="angle", angle=np.radians(60)).sides
    assert rims.sum() == 2 * 2 * 32
    assert np.array_equal(creases(m, smooth).sides, rims)
    flat = np.repeat(m.normals[:, None], 3, axis=1).astype(np.float32)
    assert np.array_equal(creases(m, flat).sides, rims)  # 11 degrees are too little
    wires = creases(m, flat, least=0.0).sides
    assert wires.sum() == 2 * 3 * 32
    assert np.array_equal(creases(m, 7.0 * flat, least=0.0).sides, wires)
    assert np.array_equal(creases(m, flat, least=0.0, angle=3.0, rule="normals").sides, wires)
    unknown = flat.copy()
    unknown[::2] = 0.0
    assert creases(m, unknown, least=0.0, rule="normals").sides.sum() < wires.sum()
    assert not creases(m, 0 * flat, least=0.0, rule="normals").sides.any()
    assert not creases(m, np.nan * flat, least=0.0, rule="normals").sides.any()


def test_sides_inside_a_bent_polygon_are_no_creases() -> None:
    m = MESHES["bent quads"]
    inside = ~m.true
    assert inside.sum() == 2
    found = creases(m, np.random.default_rng(0).normal(size=(4, 3, 3)).astype(np.float32),
                    least=0.0, angle=0.0)  # fmt: skip
    ends = {frozenset(e) for e in m.edges[inside]}
    for t, tri in enumerate(m.triangles):
        for k in range(3):
            inner = frozenset((tri[k], tri[(k + 1) % 3])) in ends
            assert found.sides[t, k] == (not inner)


def test_normals_are_the_apps_on_the_side_of_the_winding() -> None:
    points, triangles = surfaces.icosphere(2)
    m = mesh(look.batch(points, triangles))
    exact = m.positions / np.linalg.norm(m.positions, axis=1, keepdims=True)
    for way in (1.0, -3.0):
        found = creases(m, (way * exact[m.triangles]).astype(np.float32))
        assert np.allclose(found.normals, exact, atol=1e-6)
    assert np.abs(creases(m).normals - exact).max() < 0.03
    # A component that winds the other way has them the other way, whatever the app sent.
    back = mesh(look.batch(points, triangles[:, ::-1]))
    found = creases(back, exact[back.triangles].astype(np.float32))
    assert np.allclose(found.normals, -exact, atol=1e-6)
    # Half of them unknown: the others say it.
    some = exact[m.triangles].astype(np.float32)
    some[::2] = 0.0
    found = creases(m, some)
    known = np.isin(np.arange(len(found.vertices)), found.triangles[1::2])
    assert np.allclose(found.normals[known], exact[known], atol=1e-6)
    assert (np.einsum("ij,ij->i", found.normals, exact) > 0.99).all()


def test_normals_do_not_blend_over_creases() -> None:
    m = MESHES["cube"]
    found = creases(m)
    flat = np.repeat(m.normals[:, None], 3, axis=1)
    assert len(found.vertices) == 24
    assert np.allclose(found.normals[found.triangles], flat, atol=1e-6)
    assert np.array_equal(found.adjacency[:, ::2], found.triangles)


def _swollen(m: Mesh, by: float) -> Mesh:
    moved = m.moved((m.positions * (1.0, 1.0 + by, 1.0 - by / 2))[m.weld].astype(np.float32))
    assert moved is not None
    return moved


@pytest.mark.parametrize("rule", ["normals", "angle", "either"])
@pytest.mark.parametrize("name", MESHES)
def test_moved_is_like_fresh(name: str, rule: str) -> None:
    m = MESHES[name]
    sent = sent_by(m, 0.3, 5)
    was = creases(m, sent, rule=rule)
    assert was.adjacency.shape == (len(m.triangles), 6)
    other = _swollen(m, 0.5)
    found, fresh = was.moved(other, sent), creases(other, sent, rule=rule)
    for part in ("sides", "open", "triangles", "vertices", "adjacency", "differences", "normals"):
        assert np.array_equal(getattr(found, part), getattr(fresh, part)), part
    if rule == "normals" and was.criterion.least == 0.0:
        assert found.triangles is was.triangles
    assert was.moved(other).normals.shape == (len(was.moved(other).vertices), 3)


def book(degrees: float) -> np.ndarray:
    """Two pages that turn by so much at their back, along the y axis."""
    turn = np.radians(degrees)
    far = (np.cos(turn), np.sin(turn))
    return np.array([(-1, 0, 0), (-1, 1, 0), (0, 0, 0), (0, 1, 0),
                     (far[0], 0, far[1]), (far[0], 1, far[1])], np.float32)  # fmt: skip


def test_creases_by_angle_come_and_go_at_the_angle_and_those_by_normals_stay() -> None:
    first = mesh(look.batch(book(0.0), [[0, 2, 3, 1], [2, 4, 5, 3]]))
    parted = np.repeat(first.normals[:, None], 3, axis=1).astype(np.float32)
    parted[2:] += (0.5, 0.0, 0.0)  # the second page has normals of its own
    held = {
        "angle": creases(first, angle=np.radians(40.0)),
        "normals": creases(first, parted, rule="normals", least=0.0),
    }
    for degrees in (10.0, 39.9, 40.1, 80.0, 40.1, 39.9, 0.0, 60.0):
        m = first.moved(book(degrees)[first.weld])
        assert m is not None
        held = {rule: one.moved(m, parted if rule == "normals" else None)
                for rule, one in held.items()}  # fmt: skip
        inner = {rule: int((one.sides & ~one.open).sum()) for rule, one in held.items()}
        assert inner == {"angle": 2 if degrees > 40.0 else 0, "normals": 2}
        fresh = creases(m, angle=np.radians(40.0))
        assert np.array_equal(held["angle"].sides, fresh.sides)
        assert np.allclose(held["angle"].differences[held["angle"].triangles],
                           fresh.differences[fresh.triangles])  # fmt: skip


def test_moved_keeps_what_can_be_kept() -> None:
    m = MESHES["torus"]
    was = creases(m)
    found = was.moved(_swollen(m, 1e-3))
    assert found.triangles is was.triangles
    with pytest.raises(ValueError, match="connectivity"):
        was.moved(MESHES["cube"])


@pytest.mark.parametrize("name", MESHES)
@pytest.mark.parametrize("cut", [0.05, 0.3, 1.0])
def test_the_differences_of_crooked_creases_decode(name: str, cut: float) -> None:
    m = MESHES[name]
    for seed in range(4):
        found = creases(m, sent_by(m, cut, seed), rule="normals", least=0.0)
        assert np.array_equal(decoded(found, m.positions), found.sides)


def beam(count: int, bend: float) -> Mesh:
    """A square beam along a slanted axis in count pieces, that bends by an angle at each."""
    square = np.array([(0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1)], float)
    points = []
    for k in range(count + 1):
        c, s = np.cos(bend * k), np.sin(bend * k)
        turn = np.array([(c, -s, 0), (s, c, 0), (0, 0, 1)])
        where = np.array([(np.cos(bend * j), np.sin(bend * j), 0.0) for j in range(k)])
        points.extend(square @ turn.T + 2 * where.reshape(-1, 3).sum(axis=0))
    faces = []
    for k in range(count):
        for i in range(4):
            j = (i + 1) % 4
            a, b, c, d = 4 * k + i, 4 * k + j, 4 * k + 4 + j, 4 * k + 4 + i
            faces += [[a, c, b], [a, d, c]]
    slanted = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    return mesh(look.batch(np.array(points) @ slanted.T, faces))


def test_differences_cannot_tell_what_lies_between_straight_creases() -> None:
    """Where a crease goes straight on its difference is zero, and every direction fits: the
    verifier is the x of the cross product alone. So the rungs of a beam are taken for creases,
    by the whole cross product too, and `sides` is what draws them right."""
    count = 12
    m = beam(count, 0.0)
    found = creases(m, rule="angle", angle=1.0)
    assert found.sides.sum() == 4 * 2 * count + 2 * 4  # four edges with two halves, and the ends
    flags = decoded(found, m.positions)
    assert not (found.sides & ~flags).any()
    wrong = (flags & ~found.sides).sum()
    # Rungs and diagonals (four each, two halves) between the vertices that are no corners.
    assert wrong == 4 * 2 * (count - 1) + 4 * 2 * (count - 2)
    bent = beam(count, 0.1)
    found = creases(bent, rule="angle", angle=1.0)
    assert np.array_equal(decoded(found, bent.positions), found.sides)


def zigzag(count: int) -> Mesh:
    """A band of triangles whose two rims run zigzag in x: forth and back by 0.6 a side."""
    c, s = 0.6, 0.8
    below = [(c * (k % 2), k * s, 0.0) for k in range(count)]
    above = [(c * (1 - k % 2), (k + 0.5) * s, s * np.sqrt(0.75)) for k in range(count)]
    faces = [[k, k + 1, count + k] for k in range(count - 1)]
    faces += [[k + 1, count + k + 1, count + k] for k in range(count - 1)]
    return mesh(look.batch(below + above, faces))


def test_one_element_of_the_cross_product_is_too_little() -> None:
    """Differences along the x axis: every direction as steep as the crease's has the verifier 0,
    and the whole cross product would tell them apart."""
    m = zigzag(8)
    found = creases(m, rule="angle", angle=np.pi)  # the rims alone
    flags = decoded(found, m.positions)
    wrong = flags & ~found.sides
    assert not (found.sides & ~flags).any()
    assert wrong.sum() == 2 * 6  # every other rung, both halves, but for the corners' two
    for t, k in np.argwhere(wrong):
        a, b = found.triangles[t, k], found.triangles[t, (k + 1) % 3]
        e = np.diff(m.positions[found.vertices[[a, b]]].astype(float), axis=0)[0]
        e /= np.linalg.norm(e)
        corners = m.triangles.ravel()
        h = found.strips.outgoing[a]
        true = m.positions[corners[h - h % 3 + (h + 1) % 3]] - m.positions[corners[h]]
        true = true / np.linalg.norm(true)
        delta = found.differences[a, :3].astype(float)
        assert np.linalg.norm(delta) > 0.1
        assert np.linalg.norm(np.cross(e, delta) - np.cross(true, delta)) > 0.1


def test_one_normal_for_a_whole_surface_that_turns_was_never_sent():
    """What OpenGL has where a program says nothing, (0, 0, 1), says nothing."""
    found = mesh(look.sphere(12, 8))
    default = np.broadcast_to(np.float32((0, 0, 1)), (len(found.triangles), 3, 3))
    unsaid, none = (creases(found, sent) for sent in (default, None))
    assert np.array_equal(unsaid.normals, none.normals)
    flat = mesh(look.batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2, 3]]))
    sent = np.broadcast_to(np.float32((0.6, 0, 0.8)), (2, 3, 3))
    assert creases(flat, sent).normals == pytest.approx(np.tile((0.6, 0, 0.8), (4, 1)))
