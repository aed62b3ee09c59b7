"""How long the sides of a mesh can be on the screen."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, inf

import numpy as np

from glshim.model.arrays import Floats, Indices
from glshim.model.camera import Camera


@dataclass(frozen=True, slots=True)
class Extent:
    """A ball around a mesh and its longest side, in object units."""

    centre: tuple[float, float, float]
    radius: float
    longest: float

    @classmethod
    def of(cls, positions: Floats, sides: Indices) -> Extent:
        """Of positions (V, 3), with the vertices (E, 2) of the sides."""
        if not len(sides):
            return cls((0.0, 0.0, 0.0), 0.0, 0.0)
        a, b = (positions[sides[:, k]].astype(np.float64) for k in (0, 1))
        centre = (np.minimum(a, b).min(axis=0) + np.maximum(a, b).max(axis=0)) / 2
        radius = max(float(np.linalg.norm(end - centre, axis=1).max()) for end in (a, b))
        longest = float(np.linalg.norm(b - a, axis=1).max())
        x, y, z = centre.tolist()
        return cls((x, y, z), radius, longest)

    def pixels(self, camera: Camera) -> float:
        """A bound of the length of a side on the screen; infinite where the mesh reaches the
        viewer.

        With rows x, y and w of the matrix from object to clip space and least w in the ball, x / w
        changes by at most (|x| + |w| max |x / w|) / least w a unit, and so does y / w.
        """
        rows = (camera.projection @ camera.modelview)[[0, 1, 3]].tolist()
        a, b, c = self.centre
        at = [row[0] * a + row[1] * b + row[2] * c + row[3] for row in rows]
        norm = [hypot(*row[:3]) for row in rows]
        w = at[2] - norm[2] * self.radius
        if not w > 0.0:
            return inf
        lengths = [
            half * (norm[k] + norm[2] * (abs(at[k]) + norm[k] * self.radius) / w) / w
            for k, half in enumerate((camera.viewport[2] / 2, camera.viewport[3] / 2))
        ]
        return self.longest * hypot(*lengths)
