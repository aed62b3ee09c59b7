"""Signatures of the draws, as data: what each argument means, by the spec's names."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from glshim.spec.constants import (
    GL_MAP1_GRID_DOMAIN,
    GL_MAP1_GRID_SEGMENTS,
    GL_MAP1_VERTEX_3,
    GL_MAP1_VERTEX_4,
    GL_MAP2_GRID_DOMAIN,
    GL_MAP2_GRID_SEGMENTS,
    GL_MAP2_VERTEX_3,
    GL_MAP2_VERTEX_4,
)


@dataclass(frozen=True, slots=True)
class Signature:
    """Parameters of one entry point in order; `multiple` when counts are arrays."""

    parameters: tuple[str, ...]
    multiple: bool = False


DRAWS: dict[str, Signature] = {
    "glDrawArrays": Signature(("mode", "first", "count")),
    "glDrawElements": Signature(("mode", "count", "type", "indices")),
    "glDrawRangeElements": Signature(("mode", "start", "end", "count", "type", "indices")),
    "glDrawElementsBaseVertex": Signature(("mode", "count", "type", "indices", "basevertex")),
    "glDrawRangeElementsBaseVertex": Signature(
        ("mode", "start", "end", "count", "type", "indices", "basevertex")
    ),
    "glMultiDrawArrays": Signature(("mode", "first", "count", "drawcount"), True),
    "glMultiDrawElements": Signature(("mode", "count", "type", "indices", "drawcount"), True),
    "glMultiDrawElementsBaseVertex": Signature(
        ("mode", "count", "type", "indices", "drawcount", "basevertex"), True
    ),
}
"""By name without the EXT suffix."""


def signature_of(name: str) -> Signature:
    """Of an ARRAY_DRAW entry point."""
    return DRAWS[name.removesuffix("EXT")]


class Rectangle(NamedTuple):
    """How a RECT entry point takes its two opposite corners."""

    letter: str
    """The type of its numbers: d, f, i or s."""
    vector: bool
    """Each corner lies behind a pointer."""


RECTANGLES = {
    f"glRect{letter}{v}": Rectangle(letter, bool(v)) for letter in "dfis" for v in ("", "v")
}


class EvaluatorMesh(NamedTuple):
    """What an EVALUATOR_MESH entry point evaluates."""

    dimensions: int
    """Of the grid."""
    maps: tuple[tuple[int, int], ...]
    """Targets of the maps that give vertices, each with its number of coordinates."""
    domain: int
    """The state that holds the grid's bounds."""
    segments: int
    """The state that holds its numbers of segments."""


EVALUATOR_MESHES = {
    "glEvalMesh1": EvaluatorMesh(
        1, ((GL_MAP1_VERTEX_3, 3), (GL_MAP1_VERTEX_4, 4)),
        GL_MAP1_GRID_DOMAIN, GL_MAP1_GRID_SEGMENTS,
    ),
    "glEvalMesh2": EvaluatorMesh(
        2, ((GL_MAP2_VERTEX_3, 3), (GL_MAP2_VERTEX_4, 4)),
        GL_MAP2_GRID_DOMAIN, GL_MAP2_GRID_SEGMENTS,
    ),
}  # fmt: skip
