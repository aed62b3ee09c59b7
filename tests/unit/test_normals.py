"""Normals as the app sent them, from the stream to the corners of a mesh's triangles."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.geometry.recovery.mesh import Mesh, mesh
from glshim.geometry.recovery.meshes import Meshes
from glshim.model.batch import PolygonBatch, Wanted, join
from glshim.sources.fixed import immediate, normals
from glshim.sources.fixed.immediate import (
    POLYGON_MODES,
    reversed_winding,
    scaled,
    transformed,
)
from glshim.sources.fixed.lists import ListBook
from glshim.sources.fixed.steps import Change, LooseVertices
from glshim.sources.following.layers import ContentCache
from glshim.sources.source import Call, Primitive
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import GL_POLYGON as POLYGON
from glshim.spec.constants import GL_QUADS as QUADS
from glshim.spec.constants import GL_TRIANGLE_STRIP as TRIANGLE_STRIP
from glshim.spec.constants import GL_TRIANGLES as TRIANGLES
from tests import look
from tests.look import batch

NORMALS = Wanted(normals=True)
assemble = partial(immediate.assemble, wanted=NORMALS)
assemble_many = partial(immediate.assemble_many, wanted=NORMALS)
UP, SIDE, UNKNOWN = (0.0, 2.0, 0.0), (1.0, 0.0, 0.5), (0.0, 0.0, 0.0)
Normal = tuple[float, ...]


def said(name: str, *values: float) -> bytes:
    row = BY_NAME[name]
    return row.pack.pack(*values, row.tag)


def vertices(count: int, start: int = 0) -> bytes:
    return b"".join(said("glVertex2f", start + k, 0) for k in range(count))


def given_to(found: PolygonBatch) -> dict[int, Normal]:
    """The normal of every vertex by its x, which is a number."""
    points = found.positions[found.corners][:, 0].astype(int).tolist()
    given = np.zeros((len(points), 3)) if found.normals is None else found.normals
    assert given.shape == (len(found.corners), 3)
    return dict(zip(points, map(tuple, given.tolist()), strict=True))


# -- streams ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["glNormal3f", "glNormal3d"])
def test_a_normal_holds_from_where_it_is_said(name):
    stream = vertices(1) + said(name, *UP) + vertices(2, 1) + said(name, *SIDE) + vertices(1, 3)
    assert given_to(assemble(QUADS, stream)) == {0: UNKNOWN, 1: UP, 2: UP, 3: SIDE}
    assert assemble(QUADS, stream).normals.dtype == np.float32


def test_corners_of_strips_have_the_normals_of_their_vertices():
    parts = [said("glNormal3f", k + 1, 0, 0) + vertices(1, k) for k in range(6)]
    found = assemble(TRIANGLE_STRIP, b"".join(parts))
    assert (found.normals[:, 0] == found.corners + 1).all() and len(found.corners) == 12


def test_without_a_normal_there_are_none():
    assert assemble(QUADS, vertices(4)).normals is None
    assert assemble(QUADS, said("glNormal3f", *UNKNOWN) + vertices(4)).normals is None
    assert assemble_many([(QUADS, vertices(4)), (QUADS, vertices(4))]).normals is None


def test_nobody_pays_who_did_not_ask(monkeypatch):
    def never(*args):
        raise AssertionError("looked at normals")

    streams = [(mode, said("glNormal3f", *UP) + vertices(6)) for mode in (7, 7, 4, 5, 9)]
    for name in ("normals", "after", "throughout", "transformed"):
        monkeypatch.setattr(normals, name, never)
    assert immediate.assemble_many(streams).normals is None
    book = ListBook()
    book.begin(1)
    book.open.items.extend(Primitive(*stream) for stream in streams)
    book.open.items += [Change("glTranslatef", (1, 0, 0)), LooseVertices(said("glNormal3f", *UP))]
    book.end()
    found = book.polygons(1, 0x1700, lambda shape: None, 1).relative
    assert found.normals is None
    assert mesh(found).corners is None and mesh(found).corner_normals is None


RECORDS = st.sampled_from([
    said("glNormal3f", *UP), said("glNormal3d", *SIDE), said("glColor3f", 1, 0, 0), None, None,
])  # fmt: skip
"""None: a vertex."""
BODIES = st.lists(RECORDS, max_size=12)


class Reference:
    """GL's current normal, followed record by record."""

    def __init__(self) -> None:
        self.normal: Normal = UNKNOWN
        self.count = 0
        self.given: dict[int, Normal] = {}

    def stream(self, body: list[bytes | None]) -> bytes:
        parts = []
        for record in body:
            if record is None:
                self.given[self.count] = self.normal
                parts.append(vertices(1, self.count))
                self.count += 1
            else:
                parts.append(record)
                values = tuple(np.frombuffer(record, np.float32, 3).tolist())
                self.normal = values if values in (UP, SIDE) else self.normal
        return b"".join(parts)


@given(st.lists(st.tuples(st.sampled_from(sorted(POLYGON_MODES)), BODIES), max_size=8))
@settings(deadline=None)
def test_primitives_assembled_together_keep_to_themselves(bodies):
    primitives, reference = [], Reference()
    for mode, body in bodies:
        reference.normal = UNKNOWN
        primitives.append((mode, reference.stream(body)))
    found = given_to(assemble_many(primitives))
    assert found == {vertex: reference.given[vertex] for vertex in found}


STEPS = st.lists(
    st.one_of(
        st.tuples(st.just("begin"), st.sampled_from([TRIANGLES, QUADS, POLYGON]), BODIES),
        st.tuples(st.just("say"), st.sampled_from([UP, SIDE])),
        st.tuples(st.just("push"), st.booleans()),
        st.tuples(st.just("pop")),
        st.tuples(st.just("call")),
        st.tuples(st.just("lost")),
    ),
    max_size=12,
)


@given(STEPS, STEPS)
@settings(deadline=None)
def test_lists_follow_the_normal_as_the_driver_does(inner, outer):
    """List 2 calls list 1, whose vertices are numbered as they are in the list."""
    book, reference = ListBook(NORMALS), Reference()
    later: list[dict[int, Normal]] = []

    def follow(steps, depth: int) -> Iterator[object]:
        stack: list[Normal | None] = []
        for what, *how in steps:
            if what == "begin":
                yield Primitive(how[0], reference.stream(how[1]))
            elif what == "say":
                reference.normal = how[0]
                yield LooseVertices(said("glNormal3f", *how[0]))
            elif what == "push":
                stack.append(reference.normal if how[0] else None)
                yield Change("glPushAttrib", (1 if how[0] else 2,))
            elif what == "pop" and stack:
                kept = stack.pop()
                reference.normal = reference.normal if kept is None else kept
                yield Change("glPopAttrib", ())
            elif what == "call" and depth:
                before, reference.given = reference.given, {}
                reference.count += 1000
                keep = reference.count
                list(follow(inner, 0))
                later.append({k - keep: v for k, v in reference.given.items()})
                reference.given, reference.count = before, keep
                yield Call((1,))
            elif what == "lost":
                reference.normal = UNKNOWN
                yield Call((99,))
        for kept in reversed(stack):  # as many pops as pushes
            reference.normal = reference.normal if kept is None else kept
            yield Change("glPopAttrib", ())

    book.begin(1)
    book.open.items.extend(follow(inner, 0))
    book.end()
    own = len(reference.given)
    reference.normal, reference.given, reference.count = UNKNOWN, {}, 1000 * (own + 1)
    book.begin(2)
    book.open.items.extend(follow(outer, 1))
    book.end()
    found = book.polygons(2, 0x1700, lambda shape: None, 1).relative
    if found is None:
        return
    at = found.positions[found.corners][:, 0].astype(int)
    got = np.zeros((len(at), 3)) if found.normals is None else found.normals
    outside = at >= 1000
    for vertex, normal in zip(at[outside], got[outside], strict=True):
        assert tuple(normal.tolist()) == reference.given[vertex]
    # Called several times: each call's vertices come as often as there were calls.
    for vertex in set(at[~outside].tolist()):
        seen = sorted(map(tuple, got[at == vertex].tolist()))
        times = len(seen) // len(later)
        assert seen == sorted([call[vertex] for call in later] * times)


# -- batches ---------------------------------------------------------------------------------------


def numbered(b: PolygonBatch) -> PolygonBatch:
    """Every corner with a normal that tells its polygon, its vertex and itself."""
    polygon = np.repeat(np.arange(b.polygon_count), np.diff(b.starts))
    vertex = mesh(replace(b, normals=None)).weld[b.corners]
    own = np.stack([polygon, vertex, np.arange(len(b.corners))], axis=1) + 1
    return replace(b, normals=own.astype(np.float32))


def test_normals_go_along_with_their_corners():
    one, plain = numbered(look.cube()), look.torus(5, 4)
    for both in (join([one, plain]), join([one, plain], "key")):
        assert (both.normals[:24] == one.normals).all() and not both.normals[24:].any()
    assert join([plain, plain]).normals is None
    assert scaled(one, 3.0, "key").normals is one.normals
    turned = reversed_winding(one)
    assert (turned.normals[:, 1] == turned.corners + 1).all()
    assert (turned.normals[:, 2] != one.normals[:, 2]).any()


@given(st.integers(0, 10**6), st.booleans())
@settings(deadline=None, max_examples=60)
def test_transformed_normals_stand_on_their_transformed_polygons(seed, mirrored):
    random = np.random.default_rng(seed)
    one, other = (np.linalg.qr(random.normal(size=(3, 3)))[0] for _ in range(2))
    linear = one @ np.diag(random.uniform(0.3, 3.0, 3)) @ other
    if (np.linalg.det(linear) < 0) != mirrored:
        linear[:, 0] *= -1
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = linear, random.normal(size=3)
    cube = look.cube()
    faces = cube.positions[cube.corners].reshape(6, 4, 3)
    upright = np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 1])
    cube = replace(cube, normals=np.repeat(upright, 4, axis=0).astype(np.float32))
    found = transformed(cube, matrix)
    points = found.positions[found.corners].reshape(6, 4, 3).astype(float)
    standing = np.cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 1])
    given = found.normals.reshape(6, 4, 3)
    assert (given == given[:, :1]).all()
    along = (standing * given[:, 0]).sum(axis=1)
    lengths = np.linalg.norm(standing, axis=1) * np.linalg.norm(given[:, 0], axis=1)
    assert np.allclose(along, lengths, rtol=1e-4)  # parallel, and on the same side


def test_the_layers_cache_tells_normals_apart():
    cache = ContentCache(NORMALS)
    one, other = numbered(look.cube()), look.cube()
    keys = {cache.of_batch(b).key for b in (one, one, other, other)} - {None}
    assert len(keys) == 2
    keyed = cache.of_batch(one)
    assert (keyed.normals == one.normals).all()


@pytest.mark.parametrize(
    ("values", "wanted"),
    [
        (np.int8([127, -128, 0]), (1.0, -1.0, 1 / 255)),
        (np.int16([32767, -32768, 1]), (1.0, -1.0, 3 / 65535)),
        (np.int32([2**31 - 1, -(2**31), 0]), (1.0, -1.0, 1 / (2**32 - 1))),
        (np.float64([2.0, -1e300, 0.25]), (2.0, -np.inf, 0.25)),
    ],
)
def test_integers_are_mapped_onto_one(values, wanted):
    assert np.allclose(normals.mapped(values), wanted, rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize(
    ("name", "args", "wanted"),
    [
        ("glNormal3b", (127, -128, 300), (1.0, -1.0, 89 / 255)),  # 300 wraps to 44
        ("glNormalP3ui", (0x8D9F, 512 | 511 << 10), (-1.0, 1.0, 0.0)),
        ("glNormalP3ui", (0x8368, 1023 << 20), (0.0, 0.0, 1.0)),
        ("glNormalP3ui", (0x1406, 7), UNKNOWN),
        ("glNormal3s", tuple(map(ctypes.c_short, (32767, -1, 0))), (1.0, -1 / 65535, 1 / 65535)),
        ("glNormal3bv", ((ctypes.c_byte * 3)(127, -128, 0),), (1.0, -1.0, 1 / 255)),
        ("glNormal3bv", (object(),), UNKNOWN),
        ("glNormal3hNV", (1, 2, 3), UNKNOWN),
        ("glColor4fNormal3fVertex3fSUN", (), UNKNOWN),
        ("glArrayElement", (3,), UNKNOWN),
    ],
)
def test_calls_that_are_not_recorded_as_they_are(name, args, wanted):
    record = normals.said(name, args)
    assert np.allclose(np.frombuffer(record, np.float32, 3), wanted)
    assert normals.after(record, b"before") == record


def test_other_calls_say_no_normal():
    assert normals.said("glMaterialf", (1, 2, 3)) == b""


# -- meshes ----------------------------------------------------------------------------------------


def holds(m: Mesh, b: PolygonBatch) -> None:
    """Every corner of every triangle has a normal of its own polygon, at its own vertex."""
    assert m.corner_normals.shape == (len(m.triangles), 3, 3)
    assert m.corner_normals.dtype == np.float32
    own = m.corner_normals.astype(int) - 1
    assert (own[:, :, 0] == m.polygon[:, None]).all()
    assert (own[:, :, 1] == m.triangles).all()
    assert (own[:, :, 2] == m.corners).all()
    assert (m.corner_normals == b.normals[m.corners]).all()


def shuffled(b: PolygonBatch, seed: int) -> PolygonBatch:
    """The polygons in random order, every other one turned round, without shared positions."""
    random = np.random.default_rng(seed)
    order = random.permutation(b.polygon_count)
    rows = [b.corners[b.starts[p] : b.starts[p + 1]] for p in order]
    rows = [row[::-1] if random.random() < 0.5 else row for row in rows]
    points = b.positions[np.concatenate(rows)]
    ends = np.cumsum([len(row) for row in rows])[:-1]
    return batch(points, np.split(np.arange(len(points)), ends))


@pytest.mark.parametrize("make", [look.cube, look.torus, look.sphere, look.cylinder, look.bowl])
def test_corners_of_triangles_have_the_normals_that_were_sent_there(make):
    b = numbered(make())
    holds(mesh(b), b)
    b = numbered(shuffled(make(), 3))
    m = mesh(b)
    assert m.turned.any()
    holds(m, b)


@given(data=st.data())
@settings(deadline=None, max_examples=200)
def test_corners_keep_their_normals_in_any_soup(data):
    """Polygons that repeat corners, have none, fall together or come twice."""
    count = data.draw(st.integers(3, 8))
    corner = st.integers(0, count - 1)
    polygons = data.draw(st.lists(st.lists(corner, min_size=1, max_size=6), min_size=1, max_size=8))
    polygons += data.draw(st.lists(st.sampled_from(polygons), max_size=3))
    # No three points are near a line: nothing is a junction of sides, where corners are cut in two.
    points = np.array([(np.cos(2.4 * i), np.sin(2.4 * i), i % 3) for i in range(count)], np.float32)
    points[-1] = points[0]  # welded
    b = numbered(batch(points, polygons))
    holds(mesh(b), b)


def test_a_moved_mesh_has_the_new_normals():
    b = numbered(shuffled(look.torus(8, 6), 1))
    meshes = Meshes()
    first = meshes.find(b)
    assert meshes.find(b) is first
    lit = replace(b, normals=b.normals * np.float32(2))
    again = meshes.find(lit)
    assert again.triangles is first.triangles
    assert (again.corner_normals == 2 * first.corner_normals).all()
    bent = replace(lit, positions=b.positions * np.float32([1, 2, 3]))
    moved = meshes.find(bent)
    assert meshes.recovered == 1
    assert moved.triangles is first.triangles
    assert (moved.corner_normals == again.corner_normals).all()
    assert (moved.positions != first.positions).any()
    holds(meshes.find(b), b)


def test_other_normals_leave_what_positions_give():
    b = numbered(look.torus(8, 6))
    first = mesh(b)
    derived = first.normals, first.vertex_normals, first.components
    again = first.moved(b.positions, b.normals + np.float32(1))
    assert again is not first
    assert all(
        one is other
        for one, other in zip(
            derived, (again.normals, again.vertex_normals, again.components), strict=True
        )
    )
    other = first.moved(b.positions * np.float32(2), b.normals)
    assert other.components is derived[2] and other.normals is not derived[0]


def test_with_and_without_normals_are_different_meshes():
    plain = look.torus(8, 6)
    b = numbered(plain)
    assert mesh(plain).moved(plain.positions, b.normals) is None
    assert mesh(b).moved(plain.positions) is None
    meshes = Meshes()
    assert meshes.find(plain).corner_normals is None
    assert meshes.find(b).corner_normals is not None
    assert meshes.find(plain).corner_normals is None
    assert meshes.recovered == 2


def test_normals_change_nothing_else_of_a_mesh():
    plain = shuffled(look.bowl(), 5)
    one, other = mesh(plain), mesh(numbered(plain))
    for name in ("positions", "triangles", "polygon", "edges", "faces", "true", "turned"):
        assert (getattr(one, name) == getattr(other, name)).all()
    assert other.nbytes > one.nbytes
