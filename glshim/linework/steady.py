"""Lines that stay while what decides about them wavers: a crease by an angle that a moving mesh
bends to and fro, a suggestive contour by a slope that the view changes.

J. Canny, "A Computational Approach to Edge Detection", PAMI 1986 (hysteresis), here over time: what
was drawn stays until it is clearly below its threshold, what was not comes when it is clearly
above. What is seen for the first time is decided by the threshold itself.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable

import numpy as np

from glshim.model.arrays import Doubles, Flags, Rows

MARGIN = np.radians(2.0)
"""By which an angle is clearly beyond a threshold."""
_NEAR = np.cos(np.radians(12.0))
"""Cosine of the angle between views of which one follows the other."""


class Creases:
    """Which edges of a mesh, and of all that it moves to, were creases last."""

    def __init__(self) -> None:
        self._drawn: dict[Hashable, tuple[Rows, Flags]] = {}

    def decided(
        self, name: Hashable, rows: Rows, at: Callable[[float], Flags], *, moved: bool
    ) -> Flags:
        """(N,) which edges (N,), in ascending order, are creases. at: which are where the threshold
        lies so many radians farther from flat; moved: the mesh has been drawn elsewhere before."""
        before = self._drawn.get(name)
        if before is None or not moved:
            found = at(0.0)
        else:
            drawn = before[0][before[1]]
            place = np.minimum(np.searchsorted(drawn, rows), max(len(drawn) - 1, 0))
            was = drawn[place] == rows if len(drawn) else np.zeros(len(rows), np.bool_)
            found = at(MARGIN) | (was & at(-MARGIN))
        self._drawn[name] = rows, found
        return found


class View:
    """Where lines of a surface were, as seen from somewhere."""

    def __init__(self) -> None:
        self._eye: Doubles | None = None
        self._near: Flags | None = None

    def before(self, eye: Doubles) -> Flags | None:
        """(V,) vertices of triangles that had lines, if they were seen from near an eye: (4,)
        homogeneous, object space."""
        if self._eye is None or (self._eye[3] == 0.0) != (eye[3] == 0.0):
            return None
        product = float(self._eye[:3] @ eye[:3])
        sizes = float(np.linalg.norm(self._eye[:3]) * np.linalg.norm(eye[:3]))
        return self._near if product > _NEAR * sizes else None

    def keep(self, eye: Doubles, near: Flags) -> None:
        """What `before` gives to the next view."""
        self._eye, self._near = eye, near
