"""What a program draws: how much of it carries lines, and why the rest does not."""

from __future__ import annotations

from collections import Counter
from enum import Enum

from glshim.model.batch import PolygonBatch
from glshim.sources.fixed.arrays import vertex_array
from glshim.sources.fixed.immediate import assemble
from glshim.sources.source import ArrayDraw, Call, Drawn, Polygons, Primitive

NO_DEPTH_TEST = "there is no depth test"
NO_DEPTH_WRITES = "depth is not written"
NOT_FILLED = "polygons are drawn as lines or points"
TEXT = "they are text: their texture has letters"
HUD = "a flat projection lies over a picture with depth"


class Path(Enum):
    """How polygons come to OpenGL; the values are for people."""

    IMMEDIATE = "glBegin and glEnd"
    ARRAYS = "client arrays"
    BUFFERS = "buffer objects"
    LISTS = "display lists"
    SHAPES = "shapes of C libraries"
    """And evaluated grids."""


class Census:
    """Counts of draws while a style is on."""

    def __init__(self) -> None:
        self.carried = 0
        """Draws whose polygons carry lines."""
        self.passed: Counter[str] = Counter()
        """Draws of polygons that carry none, by why."""
        self.latest = ""
        """Why the draw of polygons that came last carries none."""
        self.others = 0
        """Draws of lines, points and pixels."""
        self.refused: set[str] = set()
        """Why nothing can be styled in contexts of the program's, or at times; said when it was."""
        self.polygons: Counter[Path] | None = None
        """Polygons that carry lines, by path; None: nobody asks."""

    def count_polygons(self) -> None:
        """By path, from now on: a primitive is made polygons for that."""
        self.polygons = Counter()

    def draws(self) -> int:
        """All of them."""
        return self.carried + self.others + sum(self.passed.values())

    def passes(self, why: str) -> None:
        """A draw of polygons carries none."""
        self.passed[why] += 1
        self.latest = why

    def drew_no_polygons(self) -> None:
        """The draw that is over was taken for one of polygons."""
        if self.latest:
            self.passed -= Counter({self.latest: 1})
            self.latest = ""
        self.others += 1

    def carries(self, drawn: Drawn, polygons: Polygons) -> None:
        """Polygons of a draw carry lines. With its state current, where paths are asked for."""
        self.carried += 1
        if self.polygons is not None:
            batch = polygons if isinstance(polygons, PolygonBatch) else assemble(*polygons)
            self.polygons[path_of(drawn)] += batch.polygon_count


def path_of(drawn: Drawn) -> Path:
    """The path of what was just drawn."""
    if isinstance(drawn, Primitive):
        return Path.IMMEDIATE
    if isinstance(drawn, Call):
        return Path.LISTS
    if isinstance(drawn, ArrayDraw):
        return Path.BUFFERS if vertex_array().buffer else Path.ARRAYS
    return Path.SHAPES
