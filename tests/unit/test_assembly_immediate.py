"""Recorded primitives to polygons, without GL."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.model.batch import PolygonBatch, join
from glshim.sources.fixed.immediate import (
    assemble,
    assemble_many,
    polygon_corners,
    reversed_winding,
    transformed,
    vertices,
)
from glshim.spec.attributes import ATTRIBUTES, BY_NAME, KIND, RECORD_BYTES, SIZE, VERTEX, decode


def said(*calls: tuple) -> bytes:
    """The stream of calls given as (name, values...)."""
    rows = [(BY_NAME[name], values) for name, *values in calls]
    return b"".join(row.pack.pack(*values, row.tag) for row, values in rows)


def points(count: int, start: int = 0) -> bytes:
    """Vertices on a spiral, so that every two differ."""
    return said(*(("glVertex3f", np.cos(i), np.sin(i), i) for i in range(start, start + count)))


def polygons(batch: PolygonBatch) -> list[list[int]]:
    """Corner indices of each polygon."""
    ends = zip(batch.starts[:-1], batch.starts[1:], strict=True)
    return [batch.corners[a:b].tolist() for a, b in ends]


def sides(batch: PolygonBatch) -> set[tuple[tuple, tuple]]:
    """True edges with their direction, by position."""
    found = set()
    for a, b in zip(batch.starts[:-1], batch.starts[1:], strict=True):
        for c in range(a, b):
            if batch.boundary[c]:
                ends = batch.corners[c], batch.corners[c + 1 if c + 1 < b else a]
                found.add(tuple(tuple(batch.positions[e].tolist()) for e in ends))
    return found


@pytest.mark.parametrize("row", ATTRIBUTES, ids=lambda row: row.name)
def test_decode_gives_back_what_was_packed(row) -> None:
    values = [0.25, 0.5, 0.75, 1.0][: row.size]
    stream = row.pack.pack(*values, row.tag) * 3
    assert len(stream) == 3 * RECORD_BYTES
    tags, decoded = decode(stream)
    assert tags.tolist() == [row.tag] * 3
    assert decoded.tolist() == [values + [0.0] * (4 - row.size)] * 3
    assert (KIND[row.tag], SIZE[row.tag]) == (row.kind, row.size)


EXPECTED = {
    (4, 7): [[0, 1, 2], [3, 4, 5]],
    (4, 2): [],
    (5, 5): [[0, 1, 2], [2, 1, 3], [2, 3, 4]],
    (5, 2): [],
    (6, 5): [[0, 1, 2], [0, 2, 3], [0, 3, 4]],
    (6, 2): [],
    (7, 11): [[0, 1, 2, 3], [4, 5, 6, 7]],
    (7, 3): [],
    (8, 7): [[0, 1, 3, 2], [2, 3, 5, 4]],
    (8, 3): [],
    (9, 6): [[0, 1, 2, 3, 4, 5]],
    (9, 2): [],
    (9, 0): [],
}


@pytest.mark.parametrize(("mode", "count"), EXPECTED)
def test_polygons_of_each_mode(mode: int, count: int) -> None:
    batch = assemble(mode, points(count))
    assert polygons(batch) == EXPECTED[mode, count]
    assert batch.polygon_count == len(EXPECTED[mode, count])
    assert batch.boundary.all()
    assert batch.starts[-1] == len(batch.corners) == len(batch.boundary)


@pytest.mark.parametrize("mode", range(4))
def test_points_and_lines_make_no_polygons(mode: int) -> None:
    with pytest.raises(ValueError, match="no polygons"):
        polygon_corners(mode, 6)


@pytest.mark.parametrize("mode", [5, 6, 8])
def test_strips_and_fans_keep_the_winding(mode: int) -> None:
    """Neighbours in a strip run along their common side in opposite directions."""
    batch = assemble(mode, points(10))
    directed = [
        (p[i], p[(i + 1) % len(p)]) for p in polygons(batch) for i in range(len(p))
    ]
    assert len(directed) == len(set(directed))


def test_w_divides_and_missing_components_are_zero() -> None:
    stream = said(("glVertex4f", 2, 4, 6, 2), ("glVertex2i", 3, 4), ("glVertex3d", 1, 2, 3),
                  ("glVertex4f", 1, 1, 1, 0))  # fmt: skip
    positions, flags = vertices(stream)
    assert flags is None
    assert positions[:3].tolist() == [[1, 2, 3], [3, 4, 0], [1, 2, 3]]
    assert not np.isfinite(positions[3]).any()


def test_an_edge_flag_holds_for_the_sides_of_the_vertices_after_it() -> None:
    corners = [("glVertex2f", x, y) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    stream = said(corners[0], ("glEdgeFlag", 0), corners[1], corners[2], ("glEdgeFlag", 2),
                  corners[3])  # fmt: skip
    for mode in (7, 9):
        assert assemble(mode, stream).boundary.tolist() == [True, False, False, True]
    for mode in (5, 6, 8):  # GL ignores the flag there
        assert assemble(mode, stream).boundary.all()


_PIECE = st.tuples(
    st.sampled_from((4, 5, 6, 7, 8, 9)),
    st.lists(st.sampled_from(("v", "v", "v", "c", "n", "e")), max_size=9),
)


@settings(max_examples=150, derandomize=True, deadline=None)
@given(st.lists(_PIECE, max_size=8), st.integers(1, 4))
def test_many_at_once_are_what_each_is_alone(
    pieces: list[tuple[int, list[str]]], copies: int
) -> None:
    serial = iter(range(10_000))
    calls = {
        "v": lambda: ("glVertex3f", next(serial), next(serial), 1),
        "c": lambda: ("glColor3f", 1, 0, 0),
        "n": lambda: ("glNormal3f", 0, 0, 1),
        "e": lambda: ("glEdgeFlag", next(serial) % 2),
    }
    primitives = [
        (mode, said(*(calls[kind]() for kind in kinds))) for mode, kinds in pieces * copies
    ]
    together = assemble_many(primitives)
    alone = [assemble(mode, stream) for mode, stream in primitives]
    assert together.polygon_count == sum(batch.polygon_count for batch in alone)
    assert sides(together) == set().union(*map(sides, alone))


def test_join() -> None:
    a, b, empty = assemble(7, points(8)), assemble(9, points(5, 20)), assemble(4, b"")
    joined = join([a, empty, b], key="k")
    assert joined.key == "k"
    assert polygons(joined) == [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11, 12]]
    assert sides(joined) == sides(a) | sides(b)
    assert join([a]) is a
    assert join([a], "k").key == "k"
    assert join([]).polygon_count == 0
    assert joined.corners.dtype == joined.starts.dtype == np.int32


def _normals(batch: PolygonBatch) -> np.ndarray:
    p = batch.positions[batch.corners].astype(float)
    first = batch.starts[:-1]
    return np.cross(p[first + 1] - p[first], p[first + 2] - p[first])


def test_reversed_winding_keeps_each_side_and_its_flag() -> None:
    stream = said(("glVertex2f", 0, 0), ("glEdgeFlag", 0), ("glVertex2f", 1, 0),
                  ("glEdgeFlag", 1), ("glVertex2f", 1, 1), ("glVertex2f", 0, 1))  # fmt: skip
    batch = join([assemble(7, stream), assemble(4, points(6)), assemble(9, points(5))])
    turned = reversed_winding(batch)
    assert {(b, a) for a, b in sides(batch)} == sides(turned)
    flat = slice(3)  # the last polygon is not planar: its corners disagree
    assert np.allclose(_normals(turned)[flat], -_normals(batch)[flat], atol=1e-5)
    assert sides(reversed_winding(turned)) == sides(batch)


@pytest.mark.parametrize("scale", [(2, 3, 4), (-1, 1, 1), (-1, -1, 1), (-1, -2, -3)])
def test_transformed_keeps_the_sense_of_the_faces(scale: tuple[float, float, float]) -> None:
    matrix = np.diag([*scale, 1.0])
    matrix[:3, 3] = 5, 6, 7
    batch = assemble(7, points(8))
    moved = transformed(batch, matrix)
    expected = batch.positions * scale + (5, 6, 7)
    assert np.allclose(moved.positions, expected, atol=1e-5)
    assert moved.key is None
    # A face that looks at a point still looks at where that point goes.
    eye = np.array([3.0, -2.0, 30.0])
    before = ((eye - batch.positions[batch.corners[batch.starts[:-1]]]) * _normals(batch)).sum(1)
    there = eye * scale + (5, 6, 7)
    after = ((there - moved.positions[moved.corners[moved.starts[:-1]]]) * _normals(moved)).sum(1)
    assert (np.sign(before) == np.sign(after)).all()


def test_vertex_kinds_are_found() -> None:
    names = {row.name for row in ATTRIBUTES if row.kind == VERTEX}
    assert names == {f"glVertex{n}{t}" for n in (2, 3, 4) for t in "dfis"}
