"""Recovered meshes in the driver's memory: textures that shaders look elements up in.

Layout: a texel of 16 bytes a vertex and one of 8 (normal, 16 bits), one of 16 bytes an edge and one
of 16 bytes a triangle. `docs/measurements/edge_mesh.md` compares that with the paper's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.driver.objects import delete
from glshim.geometry.crease.creases import Creases, Criterion
from glshim.geometry.meshshaders.edge_mesh import EdgeMesh, edge_mesh, inner_sides
from glshim.geometry.meshshaders.poses import Keyframes, Pose
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.recovery.outward import outward
from glshim.linework.objects import Objects
from glshim.model.batch import PolygonBatch
from glshim.model.caches import AgingCache
from glshim.outputs.gl.device.buffers import Buffer
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.uploads import upload
from glshim.outputs.gl.passes.sieved import Sieved
from glshim.spec.constants import GL_ELEMENT_ARRAY_BUFFER, GL_TEXTURE0, GL_TEXTURE_2D
from glshim.spec.kinds import TEXTURE
from glshim.styling.passes import Element

UNITS = {
    "mesh_positions": 6, "mesh_normals": 7, "mesh_edges": 8, "mesh_triangles": 9,
    "next_positions": 10, "next_normals": 11, "mesh_bones": 10, "mesh_weights": 11,
    "mesh_rest": 12, "mesh_creases": 10,
}  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False)
class Resident:
    """A mesh as textures of the current context."""

    mesh: Mesh
    edges: EdgeMesh
    creases: Creases | None
    """With these its vertices are topology vertices."""
    textures: dict[str, int]
    nbytes: int
    sieved: Sieved
    _device: ModernDevice
    _indices: dict[Element, Buffer] = field(default_factory=dict)

    def count(self, element: Element) -> int:
        """Elements of a kind."""
        if element == "edges":
            return len(self.edges.rows)
        if element == "lines":
            return 3 * len(self.mesh.triangles)
        return len(self.mesh.edges if element == "sides" else self.mesh.triangles)

    def bind(self) -> None:
        """At `UNITS`."""
        for name, texture in self.textures.items():
            gl.glActiveTexture(GL_TEXTURE0 + UNITS[name])
            gl.glBindTexture(GL_TEXTURE_2D, texture)

    def bind_indices(self, element: Element) -> None:
        """Of the triangles."""
        found = self._indices.get(element)
        if found is not None:
            found.bind()
            return
        found = self._indices[element] = Buffer(self._device, GL_ELEMENT_ARRAY_BUFFER)
        own = self.creases or self.mesh
        found.fill(own.triangles if element == "surface" else self.sieved.indices(element))

    def free(self) -> None:
        """Delete the textures and buffers."""
        delete(TEXTURE, self.textures.values())
        for found in self._indices.values():
            found.release()
        self.sieved.free()


@dataclass(frozen=True, slots=True, eq=False)
class Rest:
    """Where the vertices of a mesh were when it was first seen, and which way is out of it."""

    triangles: NDArray[np.int32]
    """The array that is its key, kept so that its number is given to no other."""
    texture: int

    def bind(self) -> None:
        """At its unit."""
        gl.glActiveTexture(GL_TEXTURE0 + UNITS["mesh_rest"])
        gl.glBindTexture(GL_TEXTURE_2D, self.texture)

    def free(self) -> None:
        """Delete the texture."""
        delete(TEXTURE, (self.texture,))


class Residents:
    """Recovers meshes of bodies and keeps what is asked for again. Use it inside the guard.
    most_bytes bounds the driver's memory."""

    def __init__(self, device: ModernDevice, objects: Objects, most_bytes: int) -> None:
        self._device = device
        self._objects = objects
        self._kept: AgingCache[Resident] = AgingCache(most_bytes, drop=Resident.free)
        self._passing: list[Resident] = []
        self._rests: AgingCache[Rest] = AgingCache(most_bytes // 4, drop=Rest.free)

    def tick(self) -> None:
        """A layer has passed."""
        self._kept.tick()
        self._rests.tick()

    def find(
        self,
        batches: Sequence[PolygonBatch],
        criterion: Criterion | None = None,
        tolerance: float = 0.0,
    ) -> Resident:
        """The mesh that batches of one object space make together, welded with a tolerance in
        object units, and parted at its creases where a criterion says what those are. Valid until
        `release`."""
        parts = tuple(batch.key for batch in batches)
        still, key = None not in parts, (parts, criterion, tolerance)
        if still:
            found = self._kept.get(key)
            if found is not None:
                return found
        mesh = self._objects.mesh(batches, tolerance)
        made = _resident(self._device, mesh) if criterion is None else _creased(
            self._device, mesh, self._objects.creases(mesh, criterion)
        )
        if still:
            return self._kept.put(key, made, made.nbytes)
        self._passing.append(made)
        return made

    def bind_rest(self, mesh: Mesh) -> None:
        """Bind the vertices of a mesh as they were first seen (a mesh that moves keeps its array
        of triangles, `Mesh.moved`), and `outward`."""
        rest = self._rests.get(id(mesh.triangles))
        if rest is None:
            rows = _four(mesh.positions)
            rows[:, 3] = outward(mesh)
            rest = Rest(mesh.triangles, upload(rows))
            self._rests.put(id(mesh.triangles), rest, rows.nbytes)
        rest.bind()

    def release(self) -> None:
        """What was made for a moment goes."""
        while self._passing:
            self._passing.pop().free()


def _resident(device: ModernDevice, mesh: Mesh) -> Resident:
    """A mesh as it is."""
    edges = edge_mesh(mesh)
    return _uploaded(device, mesh, edges, None, {
        "mesh_positions": _four(mesh.positions),
        "mesh_normals": _shorts(_outwards(mesh)),
        "mesh_edges": np.concatenate((edges.indices, inner_sides(mesh, edges))),
        "mesh_triangles": _triangles(mesh.triangles, mesh.closed),
    })  # fmt: skip


def _creased(device: ModernDevice, mesh: Mesh, found: Creases) -> Resident:
    """A mesh by its topology vertices, the first of which are its vertices. Normals in whole
    floats: contours are their zeros."""
    edges = edge_mesh(mesh)
    bits = (1, 2, 4) @ found.sides.T | 8 * ((1, 2, 4) @ found.open.T)
    inside_out = outward(mesh) < 0.0
    positions = _four(mesh.positions[found.vertices])
    positions[:, 3] = found.vertices + 1
    normals = np.column_stack(found.facing)
    normals *= np.where(inside_out, np.float32(-1.0), np.float32(1.0))[found.vertices, None]
    bits += 64 * inside_out[mesh.triangles[:, 0]]
    return _uploaded(device, mesh, edges, found, {
        "mesh_positions": positions,
        "mesh_normals": normals,
        "mesh_edges": edges.indices,
        "mesh_triangles": _triangles(found.triangles, mesh.closed + 2 * bits),
        "mesh_creases": found.differences,
    })  # fmt: skip


def _uploaded(
    device: ModernDevice,
    mesh: Mesh,
    edges: EdgeMesh,
    creases: Creases | None,
    rows: dict[str, NDArray[np.generic]],
) -> Resident:
    textures = {name: upload(own) for name, own in rows.items()}
    nbytes = sum(own.nbytes for own in rows.values())
    sieved = Sieved(device, mesh, edges, creases)
    return Resident(mesh, edges, creases, textures, nbytes, sieved, device)


def _triangles(vertices: NDArray[np.int32], flags: NDArray[np.generic]) -> NDArray[np.int32]:
    return np.concatenate((vertices, flags[:, None]), axis=1, dtype=np.int32, casting="unsafe")


def _outwards(mesh: Mesh) -> NDArray[np.float64]:
    """(V, 3) vertex normals, turned round where they would point into their component: apps wind
    their polygons either way."""
    return mesh.vertex_normals * np.where(outward(mesh) < 0.0, -1.0, 1.0)[:, None]


class Posed:
    """The textures of a pose, bound at `UNITS` until `release`."""

    def __init__(self, pose: Pose) -> None:
        if isinstance(pose, Keyframes):
            (a, b), (n, m) = pose.positions, pose.normals
            sources = {"mesh_positions": _four(a), "mesh_normals": _four(n),
                       "next_positions": _four(b), "next_normals": _four(m)}  # fmt: skip
        else:
            sources = {
                "mesh_positions": _four(pose.positions), "mesh_normals": _four(pose.normals),
                "mesh_bones": np.ascontiguousarray(pose.bones, np.int32),
                "mesh_weights": np.ascontiguousarray(pose.weights, np.float32),
            }  # fmt: skip
        self._textures = {name: upload(rows) for name, rows in sources.items()}

    def bind(self) -> None:
        """At `UNITS`."""
        for name, texture in self._textures.items():
            gl.glActiveTexture(GL_TEXTURE0 + UNITS[name])
            gl.glBindTexture(GL_TEXTURE_2D, texture)

    def release(self) -> None:
        """Delete them."""
        delete(TEXTURE, self._textures.values())


def _four(rows: NDArray[np.floating]) -> NDArray[np.float32]:
    """(N, 4) float32 of (N, 3)."""
    wide = np.zeros((len(rows), 4), np.float32)
    wide[:, :3] = rows
    return wide


def _shorts(normals: NDArray[np.float64]) -> NDArray[np.int16]:
    """(N, 4) of unit vectors (N, 3), 32767 for one."""
    wide = np.zeros((len(normals), 4), np.int16)
    wide[:, :3] = np.rint(np.nan_to_num(normals) * 32767.0)
    return wide
