"""How vertices of a mesh are moved: key frames and bones (McGuire & Hughes 2004, section 3.6).

The numpy reference of ``glshim/outputs/gl/shaders/mesh.glsl``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from glshim.model.arrays import Doubles, Floats, Indices
from glshim.model.camera import cofactors
from glshim.model.vectors import unit

MOST_BONES = 64


@dataclass(frozen=True, slots=True, eq=False)
class Keyframes:
    """Between two frames of positions and normals, all (V, 3) object space: from at share 0, to at
    share 1. (The paper prints v + a (v - v'); between v and v' it is v + a (v' - v).)"""

    positions: tuple[Floats, Floats]
    normals: tuple[Floats, Floats]
    share: float

    def move(self) -> tuple[Doubles, Doubles]:
        """(V, 3) positions and unit normals."""
        (a, b), (n, m) = self.positions, self.normals
        return (
            a + self.share * (b.astype(np.float64) - a),
            unit(n + self.share * (m.astype(np.float64) - n)),
        )


@dataclass(frozen=True, slots=True, eq=False)
class Skin:
    """Up to four bones a vertex, blended linearly."""

    positions: Floats
    """(V, 3) in the pose of rest, object space."""
    normals: Floats
    """(V, 3)"""
    matrices: Floats
    """(B, 4, 4) affine, from the pose of rest to where the bone is; at most `MOST_BONES`."""
    bones: Indices
    """(V, 4) rows of matrices."""
    weights: Floats
    """(V, 4), sums of one."""

    def move(self) -> tuple[Doubles, Doubles]:
        """(V, 3) positions and unit normals."""
        blended = np.einsum("vb,vbij->vij", self.weights, self.matrices[self.bones], dtype=float)
        moved = np.einsum("vij,vj->vi", blended[:, :3, :3], self.positions) + blended[:, :3, 3]
        turned = np.einsum("vij,vj->vi", cofactors(blended), self.normals)
        return moved, unit(turned)


Pose = Keyframes | Skin
