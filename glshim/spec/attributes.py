"""Signatures of the recorded vertex attributes, as data.

A recorded call is 20 bytes: four float32 values (unused ones zero) and an int32 tag. The tag is the
row's index here; GL keeps vertices and attributes as floats too, so nothing is lost. Values come
first so that a record can be handed to a ``…fv`` entry point as it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from struct import Struct
from typing import NamedTuple

import numpy as np

VERTEX, NORMAL, COLOR, TEXCOORD, EDGE_FLAG = range(5)
"""Kinds of recorded calls."""

RECORD_BYTES = 20
TAG_OFFSET = 16


@dataclass(frozen=True, slots=True)
class Attribute:
    """One recorded entry point (its scalar form; the vector form records the same)."""

    name: str
    """C name without a trailing v."""
    kind: int
    size: int
    """Number of arguments."""
    type: str
    """f or d (floats), i or s (integers made floats), u (unsigned bytes made 0..1), b (a byte)."""
    tag: int
    pack: Struct
    """Packs (values ..., tag) to one record."""


def _rows() -> tuple[Attribute, ...]:
    table: list[tuple[str, int, tuple[int, ...], tuple[str, ...]]] = [
        ("glVertex", VERTEX, (2, 3, 4), ("f", "d", "i", "s")),
        ("glNormal", NORMAL, (3,), ("f", "d")),
        ("glColor", COLOR, (3, 4), ("f", "d", "ub")),
        ("glTexCoord", TEXCOORD, (1, 2, 3, 4), ("f", "d", "i", "s")),
    ]
    rows: list[Attribute] = []

    def add(name: str, kind: int, size: int, type_: str) -> None:
        pad = f"{16 - 4 * size}x" if size < 4 else ""
        rows.append(Attribute(name, kind, size, type_[0], len(rows), Struct(f"={size}f{pad}i")))

    for stem, kind, sizes, types in table:
        for size in sizes:
            for type_ in types:
                add(f"{stem}{size}{type_}", kind, size, type_)
    add("glEdgeFlag", EDGE_FLAG, 1, "b")
    return tuple(rows)


ATTRIBUTES = _rows()
BY_NAME = {row.name: row for row in ATTRIBUTES}

KIND = np.array([row.kind for row in ATTRIBUTES], np.int8)
"""(tags,) kind of each tag."""
SIZE = np.array([row.size for row in ATTRIBUTES], np.int8)
"""(tags,) argument count of each tag."""
class Replay(NamedTuple):
    """How a record is said to the bare driver."""

    name: str
    takes: str
    """record: a ``fv`` entry point, straight from the record; opaque: the same, with an alpha of 1
    after three values; number: the first value as an integer."""


def _replay(row: Attribute) -> Replay:
    if row.kind == EDGE_FLAG:
        return Replay("glEdgeFlag", "number")
    if row.kind == COLOR and row.type != "f":
        # Mesa's glColor3d and 3ub are its glColor4f, which its glColor3f is not.
        return Replay("glColor4fv", "opaque" if row.size == 3 else "record")
    return Replay(f"{row.name.rstrip('dfisub')}fv", "record")


REPLAY = tuple(map(_replay, ATTRIBUTES))
"""For each tag the bare entry point that says the same."""


class NormalCall(NamedTuple):
    """A NORMAL entry point whose argument is a normal and nothing else."""

    letters: str
    """The type of its numbers: b, s, i, or ui for one packed number."""
    packed: bool
    """A type, and three numbers in one; else three numbers."""
    vector: bool
    """The numbers lie behind a pointer."""


NORMALS = {
    **{f"glNormal3{b}{v}": NormalCall(b, False, bool(v)) for b in "bsi" for v in ("", "v")},
    **{f"glNormalP3ui{v}": NormalCall("ui", True, bool(v)) for v in ("", "v")},
}


def decode(stream: bytes) -> tuple[np.ndarray, np.ndarray]:
    """Tags (N,) int32 and values (N, 4) float32 of a recorded stream, as views."""
    records = np.frombuffer(stream, np.float32).reshape(-1, 5)
    return records.view(np.int32)[:, 4], records[:, :4]
