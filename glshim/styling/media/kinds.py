"""Widths and colours of lines, kind by kind."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from glshim.errors import StyleError, nearest
from glshim.model.lines import BOUNDARY, GROUPS, MARKED, SUGGESTIVE
from glshim.styling.colours import parse_colour
from glshim.styling.values import Colour

GROUP_OF = {
    "silhouettes": 0, "contours": 0, "ridges": 1, "valleys": 2, "intersections": 3,
    "marked": MARKED, "boundary": BOUNDARY, "suggestive": SUGGESTIVE,
}  # fmt: skip
"""The group of lines (`glshim.model.lines.GROUPS`) of what `Choice` and `Features` call them."""

_Value = TypeVar("_Value")


def group_of_kind(kind: str) -> int:
    """Raises `StyleError` where nothing is called so."""
    if kind not in GROUP_OF:
        near = nearest(kind, GROUP_OF) or tuple(GROUP_OF)
        raise StyleError(f"no lines are called {kind!r}: did you mean {' or '.join(near)}?")
    return GROUP_OF[kind]


def of_each(every: _Value, some: Mapping[str, _Value]) -> tuple[_Value, ...]:
    """(`GROUPS`,) one value for every group, but for those of some kinds."""
    found = [every] * GROUPS
    for kind, value in some.items():
        found[group_of_kind(kind)] = value
    return tuple(found)


def colours_of_each(
    every: Colour | str, some: Mapping[str, Colour | str]
) -> tuple[Colour, ...]:
    """The same for colours, which may be texts."""
    return tuple(
        parse_colour(one) if isinstance(one, str) else one for one in of_each(every, some)
    )
