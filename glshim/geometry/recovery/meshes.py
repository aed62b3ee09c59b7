"""Meshes found again: a topology is recovered once, however often its positions move."""

from __future__ import annotations

from collections.abc import Hashable
from hashlib import sha256

import numpy as np

from glshim.geometry.recovery.mesh import Mesh, mesh
from glshim.model.batch import PolygonBatch
from glshim.model.caches import AgingCache

_MOST_ALIKE = 8
"""Meshes of one structure that are kept to try: a stream of triangles has no structure but its
length, and several objects may share it."""


class Meshes:
    """The meshes of batches, recovered once for each topology (an animation is found again).

    Batches under one matrix are one mesh: join them first (`glshim.geometry.edges.edges.join`).
    """

    def __init__(self, tolerance: float = 0.0, most_bytes: int = 256 << 20) -> None:
        """tolerance in object units, see `weld`; most_bytes bounds what is held."""
        self._tolerance = tolerance
        self._share = most_bytes // 2
        self._keyed: AgingCache[Mesh] = AgingCache(self._share)
        self._alike: AgingCache[tuple[Mesh, ...]] = AgingCache(self._share)
        self.recovered = 0
        """How often connectivity was recovered, and not found."""

    def find(self, batch: PolygonBatch) -> Mesh:
        """The mesh of a batch."""
        if batch.key is None:
            return self._like(batch)
        known = self._keyed.get(batch.key)
        if known is None:
            known = self._like(batch)
            self._keyed.put(batch.key, known, known.nbytes)
        return known

    def tick(self) -> None:
        """A frame has passed: what nobody asked for in a long time goes."""
        self._keyed.tick()
        self._alike.tick()

    def _like(self, batch: PolygonBatch) -> Mesh:
        """The mesh of a batch, from one of the same structure if it only moved."""
        structure = _structure(batch)
        known = self._alike.get(structure) or ()
        for at, before in enumerate(known):
            current = before.moved(batch.positions, batch.normals)
            if current is not None:
                known = (*known[:at], *known[at + 1 :])
                break
        else:
            current = mesh(batch, self._tolerance)
            self.recovered += 1
        # The latest first: most streams go on where they were.
        known = (current, *known[: _MOST_ALIKE - 1])
        while len(known) > 1 and sum(one.nbytes for one in known) > self._share:
            known = known[:-1]
        self._alike.put(structure, known, sum(one.nbytes for one in known))
        return current


def _structure(batch: PolygonBatch) -> Hashable:
    """Equal for batches whose polygons have the same corners, wherever they are and
    whatever their normals."""
    digest = sha256()
    for part in (batch.corners, batch.starts, batch.boundary):
        digest.update(np.ascontiguousarray(part).data)
    if batch.regions is not None:
        digest.update(np.ascontiguousarray(batch.regions).data)
    sizes = len(batch.positions), len(batch.corners), batch.normals is None
    return *sizes, digest.digest()
