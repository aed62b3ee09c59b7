"""PolygonBatch: what sources give and stylers get, and what it may be asked to add."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.model.arrays import Flags, Floats, Indices
from glshim.model.camera import Camera


@dataclass(frozen=True, slots=True)
class Wanted:
    """What polygons shall come with beside their positions: each costs time and memory."""

    colours: bool = False
    """`PolygonBatch.regions`."""
    normals: bool = False
    """`PolygonBatch.normals`."""
    lights: bool = False
    """`Camera.lit` of the cameras that they are drawn with, and the lights of a layer."""


POSITIONS = Wanted()
"""Nothing beside them."""
WHOLE = Wanted(colours=True, normals=True)
"""All there is: what a display list is recorded with, for any style may be on when it is called."""


@dataclass(frozen=True, slots=True, eq=False)
class PolygonBatch:
    """Polygons in one object space, with their true edges. Immutable by agreement.

    Polygon ``p`` has the corners ``corners[starts[p]:starts[p + 1]]`` (3 or more, wound as the
    app sent them); ``boundary[c]`` says whether the side from corner ``c`` to the next corner
    of the same polygon is a true edge (False for a triangulation diagonal or an app's edge flag).
    Degenerate polygons (zero area, repeated or non-finite corners) may occur: code that derives
    geometry drops them.
    """

    positions: Floats
    """(V, 3) object space, after division by w."""
    corners: Indices
    """(C,) indices into positions."""
    starts: Indices
    """(P + 1,) first corner of each polygon; the last entry is C."""
    boundary: Flags
    """(C,) the side that leaves this corner is a true edge."""
    key: Hashable | None = None
    """Equal keys mean equal content (a display list, an unchanged buffer), so derived values may be
    cached. None: do not cache."""

    regions: NDArray[np.uint32] | None = None
    """(P,) a number for the colour that all corners of a polygon were given, 0 where they differ or
    nothing is known; None: not asked for (`glshim.styling.protocol.Styler.wants_colours`)."""

    normals: Floats | None = None
    """(C, 3) object space: the normal that the app gave at each corner, as sent (not normalised),
    zero where none is known; None: none is, or not asked for
    (`glshim.styling.protocol.Styler.wants_normals`)."""

    @property
    def polygon_count(self) -> int:
        """Number of polygons."""
        return len(self.starts) - 1


Item = tuple[PolygonBatch, Camera]
"""A batch and the camera that it was drawn with."""


def regions_of(parts: Sequence[PolygonBatch]) -> NDArray[np.uint32] | None:
    """(P,) the regions of several batches as one, None where none is known."""
    if all(p.regions is None for p in parts):
        return None
    return np.concatenate(
        [np.zeros(p.polygon_count, np.uint32) if p.regions is None else p.regions for p in parts]
    )


def normals_of(parts: Sequence[PolygonBatch]) -> Floats | None:
    """(C, 3) the normals of several batches as one, None where none is known."""
    if all(p.normals is None for p in parts):
        return None
    return np.concatenate(
        [np.zeros((len(p.corners), 3), np.float32) if p.normals is None else p.normals
         for p in parts]
    )  # fmt: skip


def join(parts: Sequence[PolygonBatch], key: Hashable | None = None) -> PolygonBatch:
    """Batches in one object space as one."""
    if len(parts) == 1 and key is None:
        return parts[0]
    if not parts:
        return PolygonBatch(
            np.empty((0, 3), np.float32), np.empty(0, np.int32), np.zeros(1, np.int32),
            np.empty(0, np.bool_), key,
        )  # fmt: skip
    vertices = np.cumsum([0] + [len(b.positions) for b in parts[:-1]])
    counts = [len(b.corners) for b in parts]
    first = np.cumsum([0, *counts])
    polygons = [b.polygon_count for b in parts]
    corners = np.concatenate([b.corners for b in parts]) + np.repeat(vertices, counts)
    starts = np.concatenate([b.starts[:-1] for b in parts]) + np.repeat(first[:-1], polygons)
    return PolygonBatch(
        np.concatenate([b.positions for b in parts]),
        corners.astype(np.int32),
        np.append(starts, first[-1]).astype(np.int32),
        np.concatenate([b.boundary for b in parts]),
        key,
        regions_of(parts),
        normals_of(parts),
    )
