"""How far along a pattern lines lie: written into their records."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from glshim.linework.coherence import Drawn, Past, follow, keep
from glshim.linework.hand import begun_anywhere, lifts
from glshim.linework.pairing import NamedObjects
from glshim.linework.walk import measure
from glshim.model.arrays import Floats, Rows
from glshim.model.camera import Camera
from glshim.model.lines import Line, group_of
from glshim.styling.wishes import Pattern


def lay_pattern(
    records: Floats,
    owner: Rows,
    objects: NamedObjects,
    camera: Camera,
    pattern: Pattern,
    *,
    past: Past | None = None,
) -> Past:
    """Write into records (L, 21) of lines of objects, by number (L,), how far along a pattern each
    lies, and where a hand lifts its pen: as in the past, what the frame before gave. What the next
    frame follows."""
    a, b = (records[:, end].astype(np.float64) for end in (Line.A, Line.B))
    group, edge = group_of(records), records[:, Line.NUMBER].astype(np.float64)
    walk = measure(records[:, Line.A], records[:, Line.B], group, camera, pattern)
    if pattern.corner is not None:
        rest = lifts(walk, pattern.corner, straight=pattern.straight)
        records[:, Line.REST] = np.stack(rest, axis=1)
        walk = begun_anywhere(walk)
    drawn = Drawn(walk, a, b, group, owner, edge, objects)
    if past is not None:
        drawn = replace(drawn, walk=follow(drawn, camera, past))
    turns = np.floor(drawn.walk.begin)
    records[:, Line.BEGIN] = drawn.walk.begin - turns
    records[:, Line.FINISH] = drawn.walk.finish - turns
    return keep(drawn, camera)
