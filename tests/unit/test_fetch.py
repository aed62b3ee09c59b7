"""Vertex fetch reads what the driver reads of arrays and indices, and not a byte more. No GL."""

from __future__ import annotations

import ctypes
from contextlib import suppress
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from glshim.driver import arguments
from glshim.model.batch import POSITIONS, Wanted
from glshim.sources.fixed import fetch
from glshim.sources.fixed.arrays import Array, Unfetchable
from glshim.sources.fixed.immediate import POLYGON_MODES, complete, polygon_corners
from glshim.spec.constants import (
    GL_ARRAY_BUFFER,
    GL_FLOAT,
    GL_POLYGON,
    GL_QUAD_STRIP,
    GL_QUADS,
    GL_TRIANGLES,
    GL_UNSIGNED_BYTE,
    GL_UNSIGNED_INT,
    GL_UNSIGNED_SHORT,
)
from glshim.spec.roles import Role
from glshim.system import memory

_TYPES = {GL_UNSIGNED_BYTE: "u1", GL_UNSIGNED_SHORT: "u2", GL_UNSIGNED_INT: "u4"}
_NORMALS = Array(3, GL_FLOAT, 0, 0, 1 << 40)


class Driver:
    """Memory that is all zeros but for indices; notes what is read of it."""

    def __init__(self, patch: pytest.MonkeyPatch, array: Array, indices: Any, at: int) -> None:
        self.vertices: list[tuple[int, int]] = []
        self.elements: list[tuple[int, int]] = []
        self._indices, self._at = np.asarray(indices).tobytes(), at
        patch.setattr(fetch, "vertex_array", lambda: array)
        patch.setattr(fetch, "normal_array", lambda: _NORMALS)
        patch.setattr(fetch, "restarts_primitives", lambda: False)
        patch.setattr(fetch, "integer", lambda name: 0)
        patch.setattr(fetch, "current_context", lambda: 1)
        patch.setattr(fetch, "_bytes", self._read)

    def _read(self, buffer: int, target: int, address: int, size: int) -> bytes:
        if size <= 0:
            return b""
        if target == GL_ARRAY_BUFFER:
            if address < _NORMALS.address:
                self.vertices.append((address, address + size))
            return bytes(size)
        self.elements.append((address, address + size))
        return self._indices[address - self._at : address - self._at + size]

    def reads_within(self, array: Array, numbers: Any, used: int, width: int) -> None:
        """Vertices of those numbers, and of so many indices of so many bytes, are all it reads."""
        if not len(numbers):
            assert self.vertices == []
        size = 4 * array.size
        stride = array.stride or size
        for start, end in self.vertices:
            assert start >= array.address + int(min(numbers)) * stride
            assert end <= array.address + int(max(numbers)) * stride + size
        for start, end in self.elements:
            assert self._at <= start and end <= self._at + used * width


arrays = st.builds(
    Array, st.integers(2, 4), st.just(GL_FLOAT), st.integers(0, 80), st.sampled_from((0, 7)),
    st.integers(1 << 20, 1 << 30),
)  # fmt: skip
elements = st.tuples(
    st.sampled_from(sorted(_TYPES)), st.lists(st.integers(0, 2**32 - 1), max_size=9)
)
modes = st.sampled_from(sorted(POLYGON_MODES))


def _fetched(name: str, args: tuple[Any, ...]) -> None:
    with suppress(Unfetchable):
        fetch.VertexFetch().batch(name, args, Wanted(normals=True))


@settings(deadline=None, max_examples=200)
@given(arrays, modes, st.integers(-5, 60), st.integers(-5, 60))
def test_arrays_are_read_from_the_first_to_the_last_vertex(
    array: Array, mode: int, first: int, count: int
) -> None:
    with pytest.MonkeyPatch.context() as patch:
        driver = Driver(patch, array, [], 0)
        _fetched("glDrawArrays", (mode, first, count))
        whole = complete(mode, count) if first >= 0 else 0
        driver.reads_within(array, range(first, first + whole), 0, 0)


@settings(deadline=None, max_examples=300)
@given(
    arrays, modes, elements, st.one_of(st.just(0), st.integers(-(2**31), 2**31 - 1)),
    st.integers(-2, 0),
)  # fmt: skip
def test_indices_are_read_of_whole_polygons_and_wrap(
    array: Array, mode: int, told: tuple[int, list[int]], base: int, fewer: int
) -> None:
    type_, numbers = told
    indices = np.array(numbers, "u8").astype(_TYPES[type_])
    count = len(indices) + fewer
    with pytest.MonkeyPatch.context() as patch:
        driver = Driver(patch, array, indices, 4096)
        _fetched("glDrawElementsBaseVertex", (mode, count, type_, 4096, base))
        used = complete(mode, count)
        numbers = [(int(i) + base) % 2**32 for i in indices[:used]]
        driver.reads_within(array, numbers, used, indices.itemsize)


@pytest.mark.parametrize("name, args", [
    ("glDrawArrays", (GL_TRIANGLES, 0, 2)),
    ("glDrawArrays", (GL_TRIANGLES, 0, -3)),
    ("glDrawArrays", (GL_TRIANGLES, -1, 3)),
    ("glDrawArrays", (77, 0, 3)),
    ("glDrawElements", (GL_TRIANGLES, 3, GL_FLOAT, 4096)),
    ("glDrawElements", (GL_TRIANGLES, -3, GL_UNSIGNED_INT, 4096)),
    ("glDrawRangeElements", (GL_TRIANGLES, 5, 2, 3, GL_UNSIGNED_INT, 4096)),
    ("glMultiDrawArrays", (GL_TRIANGLES, 64, 64, -1)),
    ("glMultiDrawArrays", (GL_TRIANGLES, [0, 0], [3, -3], 2)),
    ("glMultiDrawElements", (GL_TRIANGLES, 64, GL_UNSIGNED_INT, 64, 0)),
])  # fmt: skip
def test_of_draws_that_gl_refuses_nothing_is_read(name: str, args: tuple[Any, ...]) -> None:
    with pytest.MonkeyPatch.context() as patch:
        driver = Driver(patch, Array(3, GL_FLOAT, 0, 0, 4096), [], 4096)
        batch = fetch.VertexFetch().batch(name, args, POSITIONS)
        assert batch is None or not len(batch.corners)
        assert driver.vertices == driver.elements == []


def test_arguments_that_say_nothing_pass_the_draw_through() -> None:
    for args in (("4", 0, 3), (GL_TRIANGLES, 0), (GL_TRIANGLES, 0.5, 3)):
        with pytest.raises(Unfetchable):
            fetch.VertexFetch().batch("glDrawArrays", args, POSITIONS)


@pytest.mark.parametrize("mode", sorted(POLYGON_MODES))
@pytest.mark.parametrize("count", range(-1, 12))
def test_vertices_that_are_left_over_are_in_no_polygon(mode: int, count: int) -> None:
    whole = complete(mode, count)
    corners, _ = polygon_corners(mode, max(count, 0))
    assert corners.tolist() == polygon_corners(mode, whole)[0].tolist()
    assert set(corners.tolist()) == set(range(whole))


def test_complete_counts() -> None:
    assert [complete(GL_TRIANGLES, n) for n in (-3, 2, 3, 5)] == [0, 0, 3, 3]
    assert [complete(GL_QUADS, n) for n in (3, 4, 7)] == [0, 4, 4]
    assert [complete(GL_QUAD_STRIP, n) for n in (3, 4, 5)] == [0, 4, 4]
    assert [complete(GL_POLYGON, n) for n in (2, 5)] == [0, 5]


def test_memory_that_holds_nothing_is_not_read() -> None:
    here = ctypes.create_string_buffer(b"glshim")
    found = memory.read(ctypes.addressof(here), 6)
    assert found is not None and found.tobytes() == b"glshim"
    places = ((4096, 1), (0, 4), (-8, 4), (2**64 - 16, 8), (ctypes.addressof(here), 1 << 40))
    for address, size in places:
        assert memory.read(address, size) is None


class Wrapped:
    _as_parameter_ = 5


@pytest.mark.parametrize("value", [5, ctypes.c_int(5), ctypes.c_ubyte(5), np.int64(5),
                                   np.uint8(5), Wrapped(), 2**32 + 5])  # fmt: skip
def test_integers_in_every_form(value: Any) -> None:
    assert arguments.signed(value) == arguments.unsigned(value) == 5
    assert arguments.number((value,), 0) == 5


def test_integers_wrap_as_in_c() -> None:
    assert (arguments.signed(2**32 - 1), arguments.unsigned(-1)) == (-1, 2**32 - 1)
    assert arguments.name((-1,), 0) == 2**32 - 1
    assert arguments.number(("x",), 0) == arguments.number((), 3) == 0
    for value in (0.5, "4", None):
        with pytest.raises(TypeError):
            arguments.signed(value)


def test_addresses_in_every_form() -> None:
    held = (ctypes.c_uint * 3)(1, 2, 3)
    at = ctypes.addressof(held)
    forms = (at, held, ctypes.byref(held), ctypes.pointer(held), ctypes.c_void_p(at),
             np.frombuffer(held, np.uint32))  # fmt: skip
    assert {arguments.address_of(form) for form in forms} == {at}
    assert arguments.address_of(None) == 0
    for value in ([1, 2], "text"):
        with pytest.raises(TypeError):
            arguments.address_of(value)


def test_versions_of_deleted_buffers_are_not_kept() -> None:
    """Drivers may never give a name again: a program that makes buffers in each frame has many."""
    found = fetch.VertexFetch()
    for name in range(1, 200):
        before = found._version(name)
        found.buffer_written(Role.NAMED_BUFFER_WRITE, (name,))
        written = found._version(name)
        found.buffer_written(Role.BUFFERS_WRITE, (1, name))
        assert len({before, written, found._version(name)}) == 3
    assert not found._versions
