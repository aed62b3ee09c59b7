"""The record of a line: what every output reads, in eye space."""

from __future__ import annotations

import numpy as np

from glshim.model.arrays import Floats, Rows

RECORD = 21
"""Floats of one record; `Line` names them."""


class Line:
    """Columns of records (L, `RECORD`), as ``records[:, Line.A]``. Eye space."""

    A = slice(0, 3)
    """Where the line begins; the own polygon lies left of A to B in the window."""
    B = slice(3, 6)
    """Where it ends."""
    ENDS = slice(0, 6)
    """Both."""
    ONWARD = slice(6, 9)
    """Where an outline goes on from B, or B."""
    NORMAL = slice(9, 12)
    """Unit normal of the own polygon."""
    OTHER_NORMAL = slice(12, 15)
    """Unit normal of the polygon across the edge; zero where none is known."""
    KIND = 15
    """Kind of line, plus `GROUP` times (group - 3) for groups from 4 on."""
    BEGIN = 16
    """Repeats of a pattern at A."""
    FINISH = 17
    """Repeats of it at B: the same as `BEGIN` where there is no pattern."""
    REPEATS = slice(16, 18)
    """Both."""
    BEFORE = 18
    """Pixels of its stroke before A (`Pattern.corner`)."""
    AFTER = 19
    """Pixels of its stroke after B."""
    REST = slice(18, 20)
    """Both."""
    NUMBER = 20
    """In 0..1, kept by an edge from frame to frame; 0 for lines that are none."""


RING, CONTOUR, HOLLOW, FIN, RIDGE, LONE_RIDGE, VALLEY, LONE_VALLEY, INTERSECTION = range(9)
OUTLINES = (RING, CONTOUR, HOLLOW, FIN)
"""Kinds of line.

RING: the enlargement of a polygon beyond a side (Raskar 2001, section 2.1) at a sharp edge. At the
foot of a box it lies on the floor.
CONTOUR: the same where the surface turns away smoothly.
HOLLOW: the same where the fold is hollow on the winding side: hidden in a solid, seen in an open
surface or where the windings are inside out, so only well before what lies behind it.
FIN: the outline of an open side, but not where what is drawn beside it meets it: a neighbour may be
there after all (a seam, a T-junction).
RIDGE, VALLEY: an edge whose two polygons are known to fold below or above the threshold.
LONE_RIDGE (2.2), LONE_VALLEY (2.3): the quad at the threshold angle, where no neighbour is known:
depth decides.
INTERSECTION: where two polygons pass through each other (2.4)."""

GROUPS = 8
"""Groups of lines that have a width and a colour of their own: 0 silhouettes, 1 ridges, 2 valleys,
3 intersections; and 4 marked edges, 5 boundary edges, 6 suggestive contours, whose records hold
their kind plus `GROUP` times (group - 3)."""
GROUP = 16
MARKED, BOUNDARY, SUGGESTIVE = 4, 5, 6
SHARED = 8 * GROUP
"""What is added to kinds of lines that lie on others (`glshim.linework.side_by_side`)."""
CROWDED = 2 * SHARED
"""What is added to kinds of lines among many (`glshim.linework.crowded`)."""

ENDLESS = 1e6
"""Pixels to the end of a stroke that has none: a loop without a corner."""


def kind_of(records: Floats) -> Rows:
    """(L,) kinds of line of records (L, 21)."""
    return np.asarray(records[:, Line.KIND].astype(np.intp) % GROUP)


def group_of(records: Floats) -> Rows:
    """(L,) groups of records (L, 21), see `GROUPS`."""
    kind, extra = kind_of(records), records[:, Line.KIND].astype(np.intp) % SHARED // GROUP
    return np.where(extra > 0, extra + 3, np.maximum(kind - FIN + 1, 0) // 2)


def in_group(kind: int, group: int) -> int:
    """The number in column `Line.KIND` of a kind of line that is of a group from 4 on."""
    return kind + GROUP * (group - 3)


def no_lines() -> Floats:
    """(0, 21)."""
    return np.empty((0, RECORD), np.float32)
