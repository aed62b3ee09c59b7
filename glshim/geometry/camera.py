"""The camera of a batch: what the driver said about transforms when the batch began."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Camera:
    """Transforms and viewport under which polygons are drawn. Plain values, read from the driver.

    Matrices act on column vectors, ``clip = projection @ modelview @ object``.
    Two cameras are compared by identity; the pipeline interns them.
    """

    modelview: Matrix
    """(4, 4) float64, object space to eye space."""
    projection: Matrix
    """(4, 4) float64, eye space to clip space."""
    viewport: tuple[int, int, int, int]
    """x, y, width, height in pixels, origin at the lower left."""
    depth_range: tuple[float, float] = (0.0, 1.0)
    """Window depth of the near and the far plane (glDepthRange)."""
    front_ccw: bool = True
    """glFrontFace: front faces wind counter-clockwise in window space."""
    scissor: tuple[int, int, int, int] | None = None
    """Scissor box in pixels, or None when the scissor test is off."""
    clip_planes: tuple[tuple[float, float, float, float], ...] = ()
    """Enabled user clip planes, in eye space."""

    @property
    def mirrored(self) -> bool:
        """Whether modelview and projection together turn windings round (negative scale)."""
        m = self.projection @ self.modelview
        # In homogeneous coordinates the screen-space winding of a facet in front of the eye
        # is that of det[x y w], whose sign over the whole space is the sign of the 4x4
        # determinant up to the sign that the usual z row contributes (z_ndc grows away from
        # the eye while eye z points at it).
        return bool(np.linalg.det(m) > 0.0)

    @property
    def orthographic(self) -> bool:
        """Whether w does not depend on the eye-space position (parallel projection)."""
        return bool(np.all(self.projection[3, :3] == 0.0))
