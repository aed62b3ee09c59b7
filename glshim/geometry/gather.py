"""Many small batches as one, in eye space: what a thousand objects cost is one draw."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from glshim.assembly.batch import PolygonBatch
from glshim.geometry.camera import cofactors
from glshim.geometry.edges import Doubles, Edges


def moved(batch: PolygonBatch, modelview: Doubles) -> PolygonBatch:
    """A batch taken through an affine (4, 4) modelview; it has no key."""
    turn, shift = modelview[:3, :3].T.astype(np.float32), modelview[:3, 3].astype(np.float32)
    positions = batch.positions @ turn + shift
    return PolygonBatch(positions, batch.corners, batch.starts, batch.boundary)


def placed(edges: Edges, modelviews: Doubles) -> Edges:
    """One `Edges` for copies of another under affine modelviews (N, 4, 4)."""
    copies, count = len(modelviews), len(edges)
    turn, shift = modelviews[:, :3, :3], modelviews[:, None, :3, 3]
    corners = edges.sides.reshape(-1, 3)
    sides = (corners @ turn.transpose(0, 2, 1) + shift).astype(np.float32).reshape(-1, 9)
    normals = edges.planes[:, :3] @ cofactors(modelviews).transpose(0, 2, 1)
    length = np.sqrt(np.einsum("npi,npi->np", normals, normals))
    normals /= np.maximum(length, 1e-300)[:, :, None]
    feet = -edges.planes[:, 3:] * edges.planes[:, :3] @ turn.transpose(0, 2, 1) + shift
    planes = np.empty((copies, len(edges.planes), 4))
    planes[..., :3] = normals
    planes[..., 3] = -np.einsum("npi,npi->np", normals, feet)
    step = np.arange(copies)[:, None]
    polygon = edges.polygon + step.astype(np.int32) * np.int32(len(edges.planes))
    return Edges(
        sides,
        polygon.ravel(),
        planes.reshape(-1, 4),
        (edges.order + step * count).ravel(),
        (edges.first + step * count).ravel(),
        np.tile(edges.forward, copies),
    )


def together(parts: Sequence[Edges]) -> Edges:
    """Several `Edges` of one space as one, each with its own neighbours. One or more."""
    if len(parts) == 1:
        return parts[0]
    sides = np.cumsum([0] + [len(part) for part in parts[:-1]])
    planes = np.cumsum([0] + [len(part.planes) for part in parts[:-1]])
    return Edges(
        np.concatenate([part.sides for part in parts]),
        np.concatenate(
            [part.polygon + np.int32(at) for part, at in zip(parts, planes, strict=True)]
        ),
        np.concatenate([part.planes for part in parts]),
        np.concatenate([part.order + at for part, at in zip(parts, sides, strict=True)]),
        np.concatenate([part.first + at for part, at in zip(parts, sides, strict=True)]),
        np.concatenate([part.forward for part in parts]),
    )
