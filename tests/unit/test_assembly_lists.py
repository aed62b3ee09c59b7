"""Display lists as programs, and GL's matrix calls, without GL."""

from __future__ import annotations

import numpy as np
import pytest

from glshim.sources.fixed.immediate import assemble
from glshim.sources.fixed.lists import ListBook, ListPolygons, list_names
from glshim.sources.fixed.matrices import matrix_of
from glshim.sources.fixed.steps import Change, Closing, LooseVertices, Opening
from glshim.sources.source import Call, Primitive
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import GL_2_BYTES, GL_3_BYTES, GL_4_BYTES
from glshim.spec.matrices import MATRIX_CALLS
from glshim.spec.roles import Role

MODELVIEW, PROJECTION, DEPTH_TEST, FILL, LINE = 0x1700, 0x1701, 0x0B71, 0x1B02, 0x1B01
_ROW = BY_NAME["glVertex3f"]
SQUARE = Primitive(7, b"".join(
    _ROW.pack.pack(x, y, 0, _ROW.tag) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))
))  # fmt: skip
TRANSLATE, SCALE = Change("glTranslatef", (1, 0, 0)), Change("glScalef", (2, 2, 2))
PUSH, POP = Change("glPushMatrix", ()), Change("glPopMatrix", ())
IDENTITY = Change("glLoadIdentity", ())


def book(**lists: list) -> ListBook:
    """Lists by names l1, l2, ..."""
    made = ListBook()
    for name, items in lists.items():
        made.begin(int(name[1:]))
        assert made.open is not None
        made.open.items.extend(items)
        made.end()
    return made


def called(made: ListBook, name: int = 1, mode: int = MODELVIEW) -> ListPolygons:
    return made.polygons(name, mode, lambda shape: None, 7)


def corners(made: ListBook, name: int = 1, mode: int = MODELVIEW) -> list[tuple[float, float]]:
    """The first corner and the size of each square, in the caller's space."""
    found = called(made, name, mode).relative
    if found is None:
        return []
    p = found.positions[found.corners].reshape(-1, 4, 3)
    return [(float(q[0, 0]), float(q[1, 0] - q[0, 0])) for q in p]


def test_matrices_are_resolved_in_order() -> None:
    made = book(l1=[SQUARE, TRANSLATE, SQUARE, PUSH, SCALE, SQUARE, TRANSLATE, SQUARE, POP, SQUARE])
    assert corners(made) == [(0, 1), (1, 1), (1, 2), (3, 2), (1, 1)]


def test_other_matrices_are_not_the_modelview() -> None:
    made = book(l1=[Change("glMatrixMode", (PROJECTION,)), TRANSLATE, SQUARE,
                    Change("glMatrixMode", (MODELVIEW,)), SCALE, SQUARE])  # fmt: skip
    assert corners(made) == [(0, 1), (0, 2)]
    assert corners(book(l1=[TRANSLATE, SQUARE]), mode=PROJECTION) == [(0, 1)]


def test_nested_lists_resolve_when_called_and_keep_their_matrices() -> None:
    made = book(l1=[TRANSLATE, Call((2, 3)), SQUARE], l2=[SCALE, SQUARE], l3=[])
    assert corners(made) == [(1, 2), (1, 2)]
    made.begin(3)
    made.open.items.append(TRANSLATE)
    made.end()
    assert corners(made) == [(1, 2), (3, 2)]
    made.forget(2, 1)
    assert corners(made) == [(2, 1)]
    assert not made.knows(2)


def test_keys_hold_while_nothing_is_redefined() -> None:
    made = book(l1=[Call((2,))], l2=[SQUARE], l9=[SQUARE])
    first = called(made).relative
    assert first is not None
    assert first.key is not None
    made.forget(9, 5)
    assert called(made).relative is first
    made.begin(2)
    made.open.items.extend([SQUARE, SQUARE])
    assert called(made).relative is first  # not before glEndList
    made.end()
    again = called(made).relative
    assert again is not None
    assert again.polygon_count == 2
    assert again.key != first.key


def test_a_list_that_calls_itself_ends() -> None:
    made = book(l1=[SQUARE, Call((1,))], l2=[Call((3, 3))], l3=[])
    assert 1 < called(made).relative.polygon_count <= 70
    assert called(book(l1=[SQUARE, Call((1, 1))])).relative.polygon_count > 70
    deep = book(**{f"l{n}": [Call((n + 1, n + 1))] for n in range(1, 13)}, l13=[SQUARE])
    assert called(deep).relative.polygon_count == 2**12
    assert called(book(l1=[Call((5,))])).relative is None


def test_a_loaded_matrix_leaves_the_callers_space() -> None:
    found = called(book(l1=[SQUARE, PUSH, IDENTITY, TRANSLATE, SQUARE, POP, SQUARE]))
    assert found.relative.polygon_count == 2
    ((batch, matrix),) = found.absolute
    assert batch.positions[:, 0].max() == 1.0
    assert matrix[:3, 3].tolist() == [1, 0, 0]


@pytest.mark.parametrize(
    ("off", "on"),
    [
        (Change("glDisable", (DEPTH_TEST,)), Change("glEnable", (DEPTH_TEST,))),
        (Change("glDepthMask", (0,)), Change("glDepthMask", (1,))),
        (Change("glPolygonMode", (0x408, LINE)), Change("glPolygonMode", (0x408, FILL))),
    ],
    ids=["depth-test", "depth-mask", "polygon-mode"],
)
def test_switches_that_forbid_lines(off: Change, on: Change) -> None:
    push, pop = Change("glPushAttrib", (0xFFFFF,)), Change("glPopAttrib", ())
    made = book(
        l1=[off, SQUARE, on, SCALE, SQUARE, push, off, SQUARE, pop, SCALE, SQUARE, pop, SQUARE]
    )
    assert corners(made) == [(0, 2), (0, 4), (0, 4)]
    other = Change("glDisable", (0x0B50,))
    assert corners(book(l1=[other, SQUARE])) == [(0, 1)]


def test_batches_and_shapes_take_their_places() -> None:
    from glshim.spec.shapes import Shape

    batch = assemble(SQUARE.mode, SQUARE.stream)
    asked = []

    def shapes(shape):
        asked.append(shape)
        return batch if len(asked) == 1 else None

    made = book(l1=[TRANSLATE, batch, Shape("a", lambda: None), Shape("b", lambda: None)])
    assert made.polygons(1, MODELVIEW, shapes, 7).relative.polygon_count == 2
    assert [shape.key for shape in asked] == ["a", "b"]


def test_lists_that_begin_or_end_primitives_of_others() -> None:
    made = book(l1=[Opening(7, SQUARE.stream)], l2=[LooseVertices(SQUARE.stream), Closing()],
                l3=[Call((1, 2))], l4=[Call((2, 1))])  # fmt: skip
    assert [made.leaves_open(n) for n in (1, 2, 3, 4, 5)] == [True, False, False, True, False]
    assert called(made, 3).relative is None


def test_another_context_redefines_a_list() -> None:
    made = book(l1=[Call((8,))])
    called(made)
    made.redefined_elsewhere(8)
    made.redefined_elsewhere(1)
    assert called(made).relative is None


def _clip(matrix: np.ndarray, *point: float) -> list[float]:
    x, y, z, w = matrix @ (*point, 1.0)
    return [x / w, y / w, z / w]


def test_matrix_calls_are_gls() -> None:
    def of(name: str, *args) -> np.ndarray:
        assert MATRIX_CALLS[name].loads == name.startswith("glLoad")
        return matrix_of(MATRIX_CALLS[name], args)

    assert np.allclose(of("glTranslated", 1, 2, 3) @ (1, 1, 1, 1), (2, 3, 4, 1))
    assert np.allclose(of("glScalef", 2, 3, 4) @ (1, 1, 1, 1), (2, 3, 4, 1))
    assert np.allclose(of("glRotatef", 90, 0, 0, 5) @ (1, 0, 0, 1), (0, 1, 0, 1))
    assert np.allclose(of("glRotatef", 120, 1, 1, 1) @ (1, 0, 0, 1), (0, 1, 0, 1))
    assert np.allclose(_clip(of("glOrtho", -2, 4, -1, 3, 1, 9), 4, 3, -9), (1, 1, 1))
    assert np.allclose(_clip(of("glOrtho", -2, 4, -1, 3, 1, 9), -2, -1, -1), (-1, -1, -1))
    frustum = of("glFrustum", -2, 4, -1, 3, 2, 10)
    assert np.allclose(_clip(frustum, 4, 3, -2), (1, 1, -1))
    assert np.allclose(_clip(frustum, -2 * 5, -1 * 5, -10), (-1, -1, 1))
    columns = list(range(16))
    assert np.allclose(of("glLoadMatrixd", columns)[:, 3], (12, 13, 14, 15))
    assert np.allclose(of("glMultTransposeMatrixf", columns)[3], (12, 13, 14, 15))
    assert np.allclose(of("glLoadIdentity"), np.eye(4))


@pytest.mark.parametrize(
    ("type_", "spelled", "names"),
    [
        (GL_2_BYTES, b"\x01\x02\x00\x05", (0x102, 5)),
        (GL_3_BYTES, b"\x01\x02\x03\x00\x00\x07", (0x10203, 7)),
        (GL_4_BYTES, b"\x01\x02\x03\x04\xff\xff\xff\xff", (0x1020304, 0xFFFFFFFF)),
    ],
)
def test_names_of_lists_may_be_spelled_out(
    type_: int, spelled: bytes, names: tuple[int, ...]
) -> None:
    args = (2, type_, np.frombuffer(spelled, np.uint8))
    assert list_names(Role.LISTS_CALL, args, 0) == names
    assert list_names(Role.LISTS_CALL, args, 10) == tuple(n + 10 & 0xFFFFFFFF for n in names)
    assert list_names(Role.LISTS_CALL, (2, 0x1234, args[2]), 0) == ()
