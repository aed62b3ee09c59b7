"""Signatures of the array draws, as data: what each argument means, by the spec's names."""

from __future__ import annotations

from dataclasses import dataclass


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
