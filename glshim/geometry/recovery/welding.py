"""Welding: which positions of a stream are one vertex."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.recovery.components import components
from glshim.model.arrays import Doubles, Floats, Indices, Keys, Rows

_Number = TypeVar("_Number", bound="np.integer[Any]")

_SPREAD = np.uint64(0x9E3779B97F4A7C15)
"""An odd number that spreads keys over 64 bits."""
_CROWD = 64
"""Distinct points in a cell past which all of them count as one: the tolerance is far coarser
than the mesh, and comparing each with each would take forever."""
_LEAST = 1e-45
"""Different float32 numbers are never closer."""
_SLACK = 1.0 + 1e-6
"""Cells are this much wider than they need to be, against rounding."""


def weld(positions: Floats, tolerance: float = 0.0) -> tuple[Indices, Indices]:
    """(V,) the positions that stand for a vertex each, ascending, and (N,) the vertex of each.

    positions (N, 3). Those of equal coordinates are one (-0.0 is 0.0), and those no further apart
    than tolerance, an absolute length in object units; so are the ends of a chain of such.
    A vertex is represented by its first position. Infinite and NaN positions stay alone.
    """
    points = np.ascontiguousarray(positions, np.float32).reshape(-1, 3) + np.float32(0.0)
    leader = np.arange(len(points), dtype=np.int32)
    finite = np.isfinite(points).all(axis=1) if not np.isfinite(points).all() else None
    if finite is None:
        leader = _leaders(points, tolerance)
    else:
        sound = np.flatnonzero(finite).astype(np.int32)
        leader[sound] = sound[_leaders(points[sound], tolerance)]
    return _numbered(leader)


def _numbered(leader: Indices) -> tuple[Indices, Indices]:
    """Vertices numbered by the positions that lead them, from the leader of each position."""
    leads = leader == np.arange(len(leader), dtype=np.int32)
    number = np.cumsum(leads, dtype=np.int32) - np.int32(1)
    return np.flatnonzero(leads).astype(np.int32), number[leader]


def _leaders(points: Floats, tolerance: float) -> Indices:
    """(N,) the first of the finite points (N, 3) that each is one with."""
    if not len(points):
        return np.empty(0, np.int32)
    leader = _equals(points)
    if not tolerance > _LEAST:
        return leader
    first, vertex = _numbered(leader)
    near = _near(points[first].astype(np.float64), tolerance)
    if not near:
        return leader
    one, other = (np.concatenate(ends) for ends in zip(*near, strict=True))
    found = components(len(first), one, other)
    return np.asarray(first[found.first[found.label[vertex]]])


def _equals(points: Floats) -> Indices:
    """(N,) the first point (N, 3) with the same bits."""
    bits = points.view(np.int32)
    key = mixed(bits.T)
    held = 64 - len(key).bit_length()
    leader = _first_of_runs(*sorted_with(key >> np.uint64(64 - held), held))
    if held < 64 and not np.array_equal(bits.take(leader, axis=0), bits):
        # Different points met in what is left of their keys.
        leader = _first_of_runs(*sorted_with(key, 64))
    if not np.array_equal(bits.take(leader, axis=0), bits):
        # Different points met in one key: by all their 96 bits then.
        order = np.lexsort(bits.T)
        rows = bits[order]
        news = np.concatenate(([True], (rows[1:] != rows[:-1]).any(axis=1)))
        leader = _first_of_runs(order, np.cumsum(news).astype(np.uint64))
    return leader


def sorted_with(key: Keys, bits: int) -> tuple[Rows, Keys]:
    """(N,) the order that sorts keys (N,) of so many bits, and the sorted keys."""
    room = len(key).bit_length()
    if bits + room > 64:
        order = np.argsort(key)
        return order, key[order]
    # Numbers are sorted several times sooner than their order is found: each takes its own along.
    packed = key << np.uint64(room)
    packed |= np.arange(len(key), dtype=np.uint64)
    packed.sort()
    return (packed & np.uint64((1 << room) - 1)).astype(np.intp), packed >> np.uint64(room)


def mixed(columns: Iterable[NDArray[np.generic]]) -> Keys:
    """(N,) a key of 64 bits for each row of integer columns, each (N,)."""
    key: Keys | None = None
    for column in columns:
        wide = column.astype(np.uint64)
        key = wide if key is None else np.bitwise_xor(key, wide, out=key)
        key *= _SPREAD
        key ^= key >> np.uint64(32)
    assert key is not None
    return key


def distinct(values: NDArray[_Number]) -> NDArray[_Number]:
    """(K,) each value once, sorted. np.unique hashes, which takes six times as long."""
    ordered = np.sort(values)
    fresh = np.ones(len(ordered), np.bool_)
    np.not_equal(ordered[1:], ordered[:-1], out=fresh[1:])
    return ordered[fresh]


def _starts(ordered: Keys) -> Rows:
    """Where the runs of equals begin in sorted keys."""
    return np.flatnonzero(np.concatenate(([True], ordered[1:] != ordered[:-1])))


def _first_of_runs(order: Rows, ordered: Keys) -> Indices:
    """(N,) the least of the items that have the same key as each: order sorts the keys."""
    starts = _starts(ordered)
    least = np.minimum.reduceat(order, starts)
    leader = np.empty(len(order), np.int32)
    leader[order] = np.repeat(least.astype(np.int32), np.diff(starts, append=len(order)))
    return leader


def _near(points: Doubles, tolerance: float) -> list[tuple[Indices, Indices]]:
    """Pairs of points (N, 3) no further apart than tolerance, each at least once."""
    # In cells twice as wide as the tolerance, points that close share one if not a boundary
    # parts them; that boundary is the middle of a cell in the grid shifted by half a cell.
    # So one of the eight grids, shifted or not along each axis, has both in one cell.
    scaled = points / (2.0 * tolerance * _SLACK)
    found: list[tuple[Indices, Indices]] = []
    for shift in product((0.0, 0.5), repeat=3):
        cells = np.floor(scaled + shift)
        key = mixed(cells.view(np.int64).T)
        order = np.argsort(key)
        found += _within_cells(points, tolerance, order.astype(np.int32), key[order])
    return found


def _within_cells(
    points: Doubles, tolerance: float, order: Indices, ordered: Keys
) -> Iterator[tuple[Indices, Indices]]:
    """The near ones of the pairs that share a cell: order sorts the points by their cells."""
    starts = _starts(ordered)
    sizes = np.diff(starts, append=len(order))
    crowds = sizes > _CROWD
    if crowds.any():
        inside = np.repeat(crowds, sizes)
        heads = np.repeat(order[starts], sizes)
        yield heads[inside], order[inside]
    rest = np.repeat(~crowds & (sizes > 1), sizes)
    order, ordered = order[rest], ordered[rest]
    for step in range(1, _CROWD):
        at = np.flatnonzero(ordered[:-step] == ordered[step:])
        if not len(at):
            break
        one, other = order[at], order[at + step]
        apart = points[one] - points[other]
        near = np.einsum("ij,ij->i", apart, apart) <= tolerance * tolerance
        yield one[near], other[near]
