"""The camera of a batch: what the driver said about transforms when the batch began."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, replace

import numpy as np

from glshim.model.arrays import Doubles, Matrix
from glshim.model.fog import Fog
from glshim.model.lights import Lighting


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
    stencil: tuple[int, int, int] | None = None
    """glStencilFunc's function, reference and mask, or None when the stencil test is off."""
    lit: bool = False
    """GL_LIGHTING was on. This, `gleams` and `textured` are read for stylers that want lights, and
    are no part of `lens` and `key`."""
    gleams: bool = False
    """The front material had a specular colour."""
    textured: bool = False
    """GL_TEXTURE_2D was on in the active unit."""
    lighting: Lighting | None = None
    """The lights that were on, of what is lit; with `lit`."""
    fog: Fog | None = None
    """GL_FOG, where it was on; of stylers and keys as `lit`."""

    def affine(self) -> Camera:
        """An equal camera whose modelview is affine: an app that multiplies its perspective onto
        the modelview stack gets its object space for an eye space."""
        if self.modelview[3].tolist() == [0.0, 0.0, 0.0, 1.0]:
            return self
        clip = self.projection @ self.modelview
        a, b, c, d = ((np.asarray(self.clip_planes).reshape(-1, 4) @ self.modelview).T).tolist()
        planes = tuple(zip(a, b, c, d, strict=True))
        return replace(self, modelview=np.eye(4), projection=clip, clip_planes=planes)

    def under(self, modelview: Matrix) -> Camera:
        """The same with another modelview."""
        return replace(self, modelview=modelview)

    @property
    def lens(self) -> Hashable:
        """All but the modelview, equal for cameras that show one eye space alike."""
        return (
            self.projection.tobytes(), self.viewport, self.depth_range, self.front_ccw,
            self.scissor, self.clip_planes, self.stencil,
        )  # fmt: skip

    @property
    def key(self) -> Hashable:
        """Modelview and lens, equal for cameras that show one object space alike."""
        return self.modelview.tobytes(), self.lens

    @property
    def upright(self) -> bool:
        """Whether the modelview keeps depth apart: what is parallel to the object's x and y is
        parallel to the screen."""
        m = list(map(abs, self.modelview.ravel().tolist()))
        least = 1e-6 * max(m[0], m[1], m[4], m[5], m[10])
        return max(m[2], m[6], m[8], m[9]) <= least

    @property
    def mirrored(self) -> bool:
        """Whether modelview and projection together turn windings round (negative scale).

        True when the near side of a closed object that winds counter-clockwise seen from
        outside winds clockwise in the window. A projection alone counts too (a flipped y).
        With near ahead of far in depth, that is a positive determinant.
        """
        return bool(np.linalg.det(self.projection @ self.modelview) > 0.0)

    @property
    def centre(self) -> Doubles:
        """(4,) the eye in eye space, homogeneous and signed: for the plane ``(n, -n.p)`` of a
        polygon with winding normal n, ``plane . centre`` has the sign of its area in the window
        (positive: counter-clockwise), under any projection.

        The window area of a triangle is the determinant of its (x, y, w) clip rows, and so, by
        Cauchy-Binet, the product of its plane with the 3x3 minors of those rows.
        """
        return _minors(self.projection[[0, 1, 3]])

    @property
    def object_centre(self) -> Doubles:
        """(4,) `centre` for planes in object space, exact for a singular modelview too."""
        return _minors((self.projection @ self.modelview)[[0, 1, 3]])

    @property
    def viewpoint(self) -> Doubles:
        """(4,) where the viewer is in eye space: a point (w = 1), or, for a parallel projection,
        the unit direction towards the viewer (w = 0)."""
        centre = self.centre
        length = float(np.linalg.norm(centre[:3]))
        if abs(centre[3]) > 1e-12 * max(length, 1e-300) and self.projection[3, :3].any():
            return np.asarray(centre / centre[3])
        direction = centre / max(length, 1e-300)
        direction[3] = 0.0
        return np.asarray(direction if self.projection[2] @ direction < 0.0 else -direction)

    @property
    def normal_matrix(self) -> Doubles:
        """(3, 3) the cofactors of modelview's upper 3x3: takes area vectors (Newell normals)
        from object to eye space, exact under any scale, shear or mirroring."""
        return cofactors(self.modelview)

    @property
    def orthographic(self) -> bool:
        """Whether w does not depend on the eye-space position (parallel projection)."""
        return bool(np.all(self.projection[3, :3] == 0.0))


def cofactors(matrix: Doubles) -> Doubles:
    """(..., 3, 3) the cofactors of the upper 3x3 of matrices (..., 4, 4): what their action on
    vectors does to areas."""
    m = matrix[..., :3, :3]
    out = np.empty_like(m)
    for i in range(3):
        for j in range(3):
            a, b, c, d = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
            out[..., i, j] = m[..., a, c] * m[..., b, d] - m[..., a, d] * m[..., b, c]
    return out


def _minors(rows: Doubles) -> Doubles:
    """(4,) the signed 3x3 minors of a 3x4 matrix: its null vector."""
    (a, b, c, d), (e, f, g, h), (i, j, k, m) = rows.tolist()
    gm, fm, em = g * m - h * k, f * m - h * j, e * m - h * i
    jk, ik, ij = f * k - g * j, e * k - g * i, e * j - f * i
    return np.array(
        (
            b * gm - c * fm + d * jk,
            -(a * gm - c * em + d * ik),
            a * fm - b * em + d * ij,
            -(a * jk - b * ik + c * ij),
        )
    )
