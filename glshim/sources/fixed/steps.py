"""What display lists hold, step by step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from glshim.model.batch import PolygonBatch
from glshim.sources.fixed import normals
from glshim.sources.fixed.immediate import POLYGON_MODES
from glshim.sources.fixed.pointers import numbers_at
from glshim.sources.source import Call, Primitive
from glshim.spec.matrices import MATRIX_CALLS
from glshim.spec.shapes import Shape
from glshim.system.interrupts import is_ours


@dataclass(frozen=True, slots=True)
class Change:
    """A matrix call or a switch, by its name and arguments."""

    name: str
    args: tuple[Any, ...]

    @classmethod
    def of(cls, name: str, args: tuple[Any, ...]) -> Change:
        """With matrices copied: the app may change its array. Of one that cannot be read nothing is
        left."""
        call = MATRIX_CALLS.get(name)
        if call is not None and call.element and len(args) == 1:
            try:
                args = (numbers_at(args[0], call.element, 16),)
            except TypeError as error:
                if not is_ours(error):
                    raise
                args = ()
        return cls(name, args)


@dataclass(frozen=True, slots=True)
class LooseVertices:
    """Said outside any glBegin of this list: attributes, which hold on, and vertices, which are
    legal when it is called inside one."""

    stream: bytes


@dataclass(frozen=True, slots=True)
class Opening:
    """A primitive that the list begins and leaves open."""

    mode: int
    stream: bytes


@dataclass(frozen=True, slots=True)
class Closing:
    """glEnd of a primitive that the list did not begin."""


@dataclass(frozen=True, slots=True)
class Marks:
    """Text or lines that are drawn without glBegin."""


Step = Primitive | Call | Change | Shape | LooseVertices | Opening | Closing | Marks | PolygonBatch
"""One thing that a list does."""

NOBODY_KNOWS = LooseVertices(normals.UNKNOWN)
"""What a list that was not seen being compiled may do."""


def is_drawn(item: Step) -> bool:
    """Whether a step of a list draws something."""
    return isinstance(item, (Primitive, PolygonBatch, Shape, Marks))


def is_no_polygon(item: Step) -> bool:
    """Whether a step of a list surely draws no polygons."""
    if isinstance(item, Primitive):
        return item.mode not in POLYGON_MODES
    if isinstance(item, PolygonBatch):
        return not len(item.corners)
    return isinstance(item, (Change, LooseVertices, Marks)) and item != NOBODY_KNOWS
