"""Recorded primitives to polygons: the ten primitive modes, edge flags, true edges."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import POSITIONS, PolygonBatch, Wanted, join
from glshim.model.polygons import fan
from glshim.sources.fixed import normals
from glshim.spec.attributes import COLOR, EDGE_FLAG, KIND, NORMAL, SIZE, VERTEX, decode
from glshim.spec.constants import (
    GL_POLYGON,
    GL_QUAD_STRIP,
    GL_QUADS,
    GL_TRIANGLE_FAN,
    GL_TRIANGLE_STRIP,
    GL_TRIANGLES,
)

POLYGON_MODES = frozenset(
    (GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON)
)
"""glBegin modes that make polygons; points and lines carry no lines of ours."""

_FLAGGED = frozenset((GL_TRIANGLES, GL_QUADS, GL_POLYGON))
"""Modes whose edges glEdgeFlag hides; strips and fans ignore it."""


def vertices(stream: bytes) -> tuple[NDArray[np.float32], NDArray[np.bool_] | None]:
    """Positions (V, 3) float32, object space after division by w, and edge flags (V,) or None."""
    tags, values = decode(stream)
    kinds = KIND[tags]
    rows = np.flatnonzero(kinds == VERTEX)
    positions = values[rows, :3]
    homogeneous = SIZE[tags[rows]] == 4
    if homogeneous.any():
        positions = positions.copy()
        with np.errstate(divide="ignore", invalid="ignore"):
            positions[homogeneous] /= values[rows][homogeneous, 3:4]
    flag_rows = np.flatnonzero(kinds == EDGE_FLAG)
    if not len(flag_rows):
        return positions, None
    given = np.concatenate([[True], values[flag_rows, 0] != 0])
    return positions, given[np.searchsorted(flag_rows, rows)]


def shades(stream: bytes) -> NDArray[np.uint32]:
    """(V,) a number for the colour of each vertex, 0 before the first."""
    tags, values = decode(stream)
    kinds = KIND[tags]
    given = np.flatnonzero(kinds == COLOR)
    shades = values[given] + np.float32(0.0)
    shades[SIZE[tags[given]] == 3, 3] = 1.0
    mixed = np.zeros(len(given), np.uint32)
    for channel in np.ascontiguousarray(shades.T).view(np.uint32):
        mixed = (mixed ^ channel) * np.uint32(0x9E3779B1)
        mixed ^= mixed >> np.uint32(15)
    numbers = np.concatenate(([0], np.maximum(mixed, 1))).astype(np.uint32)
    return numbers[np.searchsorted(given, np.flatnonzero(kinds == VERTEX))]


def _regions(
    shades: NDArray[np.uint32], corners: NDArray[np.int32], starts: NDArray[np.int32]
) -> NDArray[np.uint32] | None:
    """(P,) colours of polygons, of vertices (V,); None where none has any."""
    if not shades.any() or len(starts) < 2:
        return None
    own = shades[corners]
    first = own[starts[:-1]]
    same = np.logical_and.reduceat(own == np.repeat(first, np.diff(starts)), starts[:-1])
    return np.where(same, first, 0).astype(np.uint32)


def complete(mode: int, count: int) -> int:
    """How many of ``count`` vertices are of whole polygons, in a mode that makes some; the rest is
    dropped."""
    if mode == GL_TRIANGLES:
        return max(count, 0) // 3 * 3
    if mode == GL_QUADS:
        return max(count, 0) // 4 * 4
    if mode == GL_QUAD_STRIP:
        return count // 2 * 2 if count >= 4 else 0
    return count if count >= 3 else 0


def polygon_corners(mode: int, count: int) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
    """Corners (C,) and starts (P + 1,) of the polygons that ``count`` vertices make in a mode.

    Left-over vertices are dropped as GL drops them; the winding is GL's (every other triangle of a
    strip is turned round).
    """
    index = np.arange(count, dtype=np.int32)
    if mode == GL_POLYGON:
        sides = max(count, 1)
        corners = index.reshape(1, -1) if count >= 3 else np.empty((0, 3), np.int32)
        sides = corners.shape[1]
    elif mode == GL_TRIANGLES:
        corners, sides = index[: count // 3 * 3].reshape(-1, 3), 3
    elif mode == GL_QUADS:
        corners, sides = index[: count // 4 * 4].reshape(-1, 4), 4
    elif mode == GL_TRIANGLE_STRIP:
        corners = np.stack([index[:-2], index[1:-1], index[2:]], 1) if count >= 3 else _none(3)
        corners[1::2] = corners[1::2, [1, 0, 2]]
        sides = 3
    elif mode == GL_TRIANGLE_FAN:
        corners, sides = fan(count).astype(np.int32), 3
    elif mode == GL_QUAD_STRIP:
        even = index[: count // 2 * 2].reshape(-1, 2)
        corners = (
            np.stack([even[:-1, 0], even[:-1, 1], even[1:, 1], even[1:, 0]], 1)
            if len(even) >= 2
            else _none(4)
        )
        sides = 4
    else:
        raise ValueError(f"mode {mode} makes no polygons")
    starts = np.arange(0, corners.size + 1, sides, dtype=np.int32)
    return np.ascontiguousarray(corners, np.int32).reshape(-1), starts


def _none(sides: int) -> NDArray[np.int32]:
    return np.empty((0, sides), np.int32)


def assemble(
    mode: int, stream: bytes, key: Hashable | None = None, *, wanted: Wanted = POSITIONS
) -> PolygonBatch:
    """Polygons of one recorded primitive."""
    positions, flags = vertices(stream)
    corners, starts = polygon_corners(mode, len(positions))
    if flags is None or mode not in _FLAGGED:
        boundary = np.ones(len(corners), np.bool_)
    else:
        boundary = flags[corners]
    return PolygonBatch(
        positions, corners, starts, boundary, key, *_extras(stream, corners, starts, wanted)
    )


def _extras(
    stream: bytes, corners: NDArray[np.int32], starts: NDArray[np.int32], wanted: Wanted
) -> tuple[NDArray[np.uint32] | None, NDArray[np.float32] | None]:
    """The regions and normals of polygons, as far as they are wanted."""
    regions = _regions(shades(stream), corners, starts) if wanted.colours else None
    given = normals.normals(stream) if wanted.normals else None
    return regions, given[corners] if given is not None and given.any() else None


def assemble_many(
    primitives: Sequence[tuple[int, bytes]], *, wanted: Wanted = POSITIONS
) -> PolygonBatch:
    """Polygons of several primitives in one space, as one batch.

    Runs of equal mode and length, the many small glBegin/glEnd pairs of real programs, are
    assembled at once.
    """
    groups: dict[tuple[int, int], list[bytes]] = {}
    for mode, stream in primitives:
        groups.setdefault((mode, len(stream)), []).append(stream)
    parts: list[PolygonBatch] = []
    for (mode, _), streams in groups.items():
        if len(streams) == 1 or mode not in _FLAGGED:
            parts.extend(assemble(mode, stream, wanted=wanted) for stream in streams)
            continue
        parts.append(_assemble_alike(mode, streams, wanted))
    return join(parts)


def _assemble_alike(mode: int, streams: list[bytes], wanted: Wanted) -> PolygonBatch:
    """Primitives of one mode and stream length; triangles, quads or one polygon each."""
    joined = b"".join(streams)
    kinds = KIND[decode(joined)[0]].reshape(len(streams), -1)
    counts = (kinds == VERTEX).sum(axis=1)
    count = int(counts[0])
    positions, flags = vertices(joined)
    sides = {GL_TRIANGLES: 3, GL_QUADS: 4}.get(mode, count)
    uneven = (counts != count).any() or count < 3 or flags is not None
    if uneven or (wanted.normals and not _all_begin_with(NORMAL, kinds)):
        return join([assemble(mode, stream, wanted=wanted) for stream in streams])
    each = count // sides * sides
    index = np.arange(len(positions), dtype=np.int32).reshape(-1, count)[:, :each]
    corners = np.ascontiguousarray(index).reshape(-1)
    starts = np.arange(0, len(corners) + 1, sides, dtype=np.int32)
    boundary = np.ones(len(corners), np.bool_)
    extras = _extras(joined, corners, starts, wanted)
    return PolygonBatch(positions, corners, starts, boundary, None, *extras)


def _all_begin_with(kind: int, kinds: NDArray[np.int8]) -> bool:
    """Whether streams of kinds (S, N) all say a kind before their first vertex, or none does at
    all: where one does not, it would go on with what the stream that is joined before it said."""
    said = kinds == kind
    first = (said | (kinds == VERTEX)).argmax(axis=1)
    return not said.any() or bool(said[np.arange(len(said)), first].all())


def transformed(batch: PolygonBatch, matrix: NDArray[np.float64]) -> PolygonBatch:
    """The batch moved by an affine (4, 4) matrix; a mirroring one turns the windings round."""
    positions = (batch.positions @ matrix[:3, :3].T + matrix[:3, 3]).astype(np.float32)
    given, linear = batch.normals, matrix[:3, :3]
    if given is not None:
        given = normals.transformed(given, linear)
    moved = replace(batch, positions=positions, normals=given, key=None)
    with np.errstate(invalid="ignore"):
        mirrored = np.linalg.det(linear) < 0
    return reversed_winding(moved) if mirrored else moved


def scaled(batch: PolygonBatch, factor: float, key: Hashable | None) -> PolygonBatch:
    """The batch, so many times larger; its normals stay, as a library sends them at any size."""
    positions = batch.positions * np.float32(factor)
    return replace(batch, positions=positions, key=key)


def reversed_winding(batch: PolygonBatch) -> PolygonBatch:
    """The same polygons seen from the other side: corners and sides in reverse order."""
    count = len(batch.corners)
    owner = np.repeat(np.arange(batch.polygon_count), np.diff(batch.starts))
    first, last = batch.starts[:-1][owner], batch.starts[1:][owner] - 1
    order = first + (last - np.arange(count))
    # Side c runs from corner c to the next one: reversed, it leaves from that next corner.
    side = np.where(order == first, last, order - 1)
    given = None if batch.normals is None else batch.normals[order]
    return replace(
        batch, corners=batch.corners[order], boundary=batch.boundary[side], normals=given
    )
