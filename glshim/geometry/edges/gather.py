"""Many small batches as one: what a thousand objects cost is one draw."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from glshim.geometry.edges.edges import Edges
from glshim.model.arrays import Doubles, Flags, Indices
from glshim.model.camera import Camera, cofactors


@dataclass(frozen=True, slots=True, eq=False)
class Placement:
    """Where the parts of an `Edges` stand: each has its own object space."""

    polygon: Indices
    """(P,) which modelview belongs to the polygon of a row in planes."""
    modelviews: Doubles
    """(M, 4, 4) affine, object space to eye space."""

    @classmethod
    def one(cls, modelview: Doubles, polygons: int) -> Placement:
        """All polygons under one modelview (4, 4)."""
        return cls(np.zeros(polygons, np.int32), modelview[None])

    def centres(self, camera: Camera) -> Doubles:
        """(M, 4) the camera's `Camera.object_centre` under each modelview.

        The minors of ``A M`` are ``adj(M)`` times the minors of A (Cauchy-Binet).
        """
        eye = camera.centre
        adjugate = cofactors(self.modelviews).transpose(0, 2, 1)
        determinant = np.einsum("mi,mi->m", self.modelviews[:, 0, :3], adjugate[:, :, 0])
        spot = eye[:3] - self.modelviews[:, :3, 3] * eye[3]
        along = np.einsum("mij,mj->mi", adjugate, spot)
        return np.concatenate([along, determinant[:, None] * eye[3]], axis=1)

    def mirrored(self, camera: Camera) -> Flags:
        """(M,) `Camera.mirrored` under each modelview."""
        turn = np.linalg.det(self.modelviews[:, :3, :3])
        return np.asarray(float(np.linalg.det(camera.projection)) * turn > 0.0)


def merged(parts: Sequence[Edges]) -> tuple[Edges, Indices]:
    """Several `Edges` as one, each with its own neighbours, and the part of every polygon (P,)."""
    counts = [len(part.planes) for part in parts]
    index = np.repeat(np.arange(len(parts), dtype=np.int32), counts)
    if len(parts) == 1:
        return parts[0], index
    sides = np.cumsum([0] + [len(part) for part in parts[:-1]])
    planes = np.cumsum([0, *counts[:-1]])
    whole = Edges(
        np.concatenate([part.sides for part in parts]),
        np.concatenate(
            [part.polygon + np.int32(at) for part, at in zip(parts, planes, strict=True)]
        ),
        np.concatenate([part.planes for part in parts]),
        np.concatenate([part.creases for part in parts]),
        np.concatenate([part.parents + at for part, at in zip(parts, planes, strict=True)]),
        np.concatenate([part.order + at for part, at in zip(parts, sides, strict=True)]),
        np.concatenate([part.first + at for part, at in zip(parts, sides, strict=True)]),
        np.concatenate([part.forward for part in parts]),
    )
    return whole, index
