"""The meshes that draws of one object space make together, with what their edges are."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from weakref import WeakKeyDictionary, WeakValueDictionary

from glshim.geometry.crease.creases import Creases, Criterion, creases
from glshim.geometry.edges.folds import Topology
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.meshes import Meshes
from glshim.linework import steady
from glshim.linework.feature_lines import EdgeLines
from glshim.model.arrays import Doubles
from glshim.model.batch import PolygonBatch, join
from glshim.model.caches import AgingCache
from glshim.notices import say_once


class Objects:
    """Recovers meshes, and finds again what they gave. most_bytes bounds the memory."""

    def __init__(self, most_bytes: int) -> None:
        self._most_bytes = most_bytes
        self._meshes: dict[float, Meshes] = {}
        self._whole: AgingCache[Mesh] = AgingCache(most_bytes)
        self._lines: WeakKeyDictionary[Mesh, EdgeLines] = WeakKeyDictionary()
        self._topologies: WeakValueDictionary[int, Topology] = WeakValueDictionary()
        self._steady: WeakKeyDictionary[Topology, steady.Creases] = WeakKeyDictionary()
        """Which edges of meshes were creases last: it goes with their connectivity."""
        self._creases: AgingCache[Creases] = AgingCache(most_bytes)
        self._parted: WeakValueDictionary[tuple[int, Criterion], Creases] = WeakValueDictionary()
        self._reported = False

    def tick(self) -> None:
        """A layer has passed."""
        self._whole.tick()
        self._creases.tick()
        for meshes in self._meshes.values():
            meshes.tick()

    def mesh(self, batches: Sequence[PolygonBatch], tolerance: float = 0.0) -> Mesh:
        """The mesh that batches of one object space make together; vertices weld within the
        tolerance, object units."""
        if tolerance not in self._meshes:
            self._meshes[tolerance] = Meshes(tolerance, self._most_bytes)
        mesh = self._recovered(batches, self._meshes[tolerance], tolerance)
        if not self._reported and mesh.mixed:
            self._reported = True
            say_once(f"a mesh winds its polygons both ways, they are taken as one: {mesh.report}")
        return mesh

    def _recovered(
        self, batches: Sequence[PolygonBatch], meshes: Meshes, tolerance: float
    ) -> Mesh:
        if len(batches) == 1:
            return meshes.find(batches[0])
        keys: tuple[Hashable, ...] = tuple(batch.key for batch in batches)
        if None in keys:
            return meshes.find(join(batches))
        mesh = self._whole.get((keys, tolerance))
        if mesh is None:
            mesh = meshes.find(join(batches))
            self._whole.put((keys, tolerance), mesh, mesh.nbytes)
        return mesh

    def lines(self, batches: Sequence[PolygonBatch], tolerance: float) -> EdgeLines:
        """What is known of the mesh's edges whatever the viewer."""
        mesh = self.mesh(batches, tolerance)
        lines = self._lines.get(mesh)
        if lines is None:
            # A mesh that moved keeps its array of triangles (`Mesh.moved`), which a topology holds.
            known = self._topologies.get(id(mesh.triangles))
            lines = self._lines[mesh] = EdgeLines(
                mesh, topology=known, creases=self._steady.get(known) if known else None
            )
            self._topologies[id(mesh.triangles)] = lines.topology
            self._steady[lines.topology] = lines.creases
        return lines

    def creases(self, mesh: Mesh, criterion: Criterion) -> Creases:
        """The creases of a mesh, by a criterion."""
        known = self._creases.get((id(mesh), criterion))  # of a mesh that it holds
        if known is None:
            before = self._parted.get((id(mesh.triangles), criterion))
            # A mesh that moved keeps its array of triangles.
            known = (
                before.moved(mesh, mesh.corner_normals)
                if before
                else creases(mesh, mesh.corner_normals, **criterion._asdict())
            )
            self._creases.put((id(mesh), criterion), known, known.nbytes)
            self._parted[id(mesh.triangles), criterion] = known
        return known

    def placed(
        self,
        items: Sequence[tuple[PolygonBatch, Doubles]],
        tolerance: float,
    ) -> list[tuple[EdgeLines, Doubles]]:
        """Batches, each under its modelview (4, 4), as objects: those that share one, even across
        glBegin and lists, are one object."""
        together: dict[bytes, tuple[list[PolygonBatch], Doubles]] = {}
        for batch, modelview in items:
            together.setdefault(modelview.tobytes(), ([], modelview))[0].append(batch)
        return [
            (self.lines(batches, tolerance), modelview)
            for batches, modelview in together.values()
        ]
