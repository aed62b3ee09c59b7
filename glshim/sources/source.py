"""Where polygons and cameras come from: what the app drew, and who can say which polygons it was.

The fixed-function pipeline (``fixed``) is the first source, draws under the app's own programs
(``programs``) are the second. The follower asks them in order.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.sources.state import DrawState
from glshim.spec.shapes import Shape


class Primitive(NamedTuple):
    """What was said between glBegin and glEnd."""

    mode: int
    stream: bytes
    """Records (`glshim.spec.attributes`)."""


class ArrayDraw(NamedTuple):
    """A draw from arrays or buffers, by its name and arguments."""

    name: str
    args: tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Call:
    """Display lists that were called."""

    names: tuple[int, ...]


Drawn = Primitive | ArrayDraw | Shape | Call
"""What the app drew in one draw."""
Polygons = PolygonBatch | Primitive
"""A primitive is made a batch when its layer ends, together with its neighbours."""


class Source(Protocol):
    """One way from a draw to the polygons that it drew."""

    def obstacle(self, state: DrawState) -> str | None:
        """Why the polygons of draws in a state cannot be had, empty if they can; None for draws
        that are another source's."""

    def polygons(self, drawn: Drawn, state: DrawState) -> Iterable[tuple[Polygons, Camera]]:
        """What was drawn in a state without an obstacle, and the cameras that saw it: positions
        in object space. Asked right after the draw; outside glBegin/glEnd."""
