"""Creases: against definitions taken literally, halfedge by halfedge."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.crease.creases import INVALID, Creases, creases
from glshim.geometry.crease.smoothing_groups import by_traversal, within_adjacency
from glshim.geometry.recovery.mesh import Mesh, mesh
from glshim.geometry.references.crease_quads import silhouettes
from tests import look, surfaces
from tests.odd_meshes import MESHES, dart, sent_by

CUTS = st.integers(0, 2**32 - 1)


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


def test_one_normal_for_a_whole_surface_that_turns_was_never_sent():
    """What OpenGL has where a program says nothing, (0, 0, 1), says nothing."""
    found = mesh(look.sphere(12, 8))
    default = np.broadcast_to(np.float32((0, 0, 1)), (len(found.triangles), 3, 3))
    unsaid, none = (creases(found, sent) for sent in (default, None))
    assert np.array_equal(unsaid.normals, none.normals)
    flat = mesh(look.batch([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [[0, 1, 2, 3]]))
    sent = np.broadcast_to(np.float32((0.6, 0, 0.8)), (2, 3, 3))
    assert creases(flat, sent).normals == pytest.approx(np.tile((0.6, 0, 0.8), (4, 1)))
