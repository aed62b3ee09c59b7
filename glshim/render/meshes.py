"""Recovered meshes in the driver's memory: textures that shaders look elements up in.

Layout: a texel of 16 bytes a vertex and one of 8 (normal, 16 bits), one of 16 bytes an edge and one
of 16 bytes a triangle. `docs/edge_mesh.md` compares that with the paper's.
"""

from __future__ import annotations

import ctypes
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch
from glshim.caches import AgingCache
from glshim.geometry.edge_mesh import EdgeMesh, edge_mesh, inner_sides
from glshim.geometry.edges import join
from glshim.geometry.mesh import Mesh
from glshim.geometry.meshes import Meshes
from glshim.geometry.poses import Keyframes, Pose
from glshim.render.driver import gl

WIDTH = 2048
"""Texels in a row of a texture."""
UNITS = {
    "mesh_positions": 6, "mesh_normals": 7, "mesh_edges": 8, "mesh_triangles": 9,
    "next_positions": 10, "next_normals": 11, "mesh_bones": 10, "mesh_weights": 11,
}  # fmt: skip
_TEXTURE_0, _TEXTURE_2D, _UNPACK_BUFFER = 0x84C0, 0x0DE1, 0x88EC
_FLOAT, _INT, _SHORT, _RGBA, _RGBA_INTEGER = 0x1406, 0x1404, 0x1402, 0x1908, 0x8D99
_RGBA_32F, _RGBA_32I, _RGBA_16_SNORM = 0x8814, 0x8D82, 0x8F9B
_PLAIN = ((0x2801, 0x2600), (0x2800, 0x2600), (0x813D, 0))  # nearest, one level


@dataclass(frozen=True, slots=True, eq=False)
class Resident:
    """A mesh as textures of the current context."""

    mesh: Mesh
    edges: EdgeMesh
    counts: dict[str, int]
    """Rows of each kind of element (`glshim.styling.passes.Element`)."""
    textures: dict[str, int]
    nbytes: int

    def bind(self) -> None:
        """At `UNITS`."""
        for name, texture in self.textures.items():
            gl.glActiveTexture(_TEXTURE_0 + UNITS[name])
            gl.glBindTexture(_TEXTURE_2D, texture)

    def free(self) -> None:
        """Delete the textures."""
        _delete(self.textures.values())


class Residents:
    """Recovers meshes of bodies and keeps what is asked for again. Use it inside the guard.
    most_bytes bounds the driver's memory."""

    def __init__(self, most_bytes: int) -> None:
        self._meshes = Meshes()
        self._kept: AgingCache[Resident] = AgingCache(most_bytes, drop=Resident.free)
        self._passing: list[Resident] = []

    def tick(self) -> None:
        """A layer has passed."""
        self._kept.tick()
        self._meshes.tick()

    def find(self, batches: Sequence[PolygonBatch]) -> Resident:
        """The mesh that batches of one object space make together. Valid until `release`."""
        keys = tuple(batch.key for batch in batches)
        still = None not in keys
        if still:
            found = self._kept.get(keys)
            if found is not None:
                return found
        mesh = self.mesh(batches)
        made = _resident(mesh)
        if still:
            return self._kept.put(keys, made, made.nbytes)
        self._passing.append(made)
        return made

    def mesh(self, batches: Sequence[PolygonBatch]) -> Mesh:
        """The mesh alone."""
        return self._meshes.find(batches[0] if len(batches) == 1 else _joined(batches))

    def release(self) -> None:
        """What was made for a moment goes."""
        while self._passing:
            self._passing.pop().free()


def _joined(batches: Sequence[PolygonBatch]) -> PolygonBatch:
    whole = join(batches)
    keys = tuple(batch.key for batch in batches)
    if None in keys:
        return whole
    return PolygonBatch(
        whole.positions, whole.corners, whole.starts, whole.boundary, ("joined", keys)
    )


def _resident(mesh: Mesh) -> Resident:
    edges = edge_mesh(mesh)
    triangles = np.empty((len(mesh.triangles), 4), np.int32)
    triangles[:, :3] = mesh.triangles
    triangles[:, 3] = mesh.closed
    sources: dict[str, NDArray[np.generic]] = {
        "mesh_positions": _four(mesh.positions),
        "mesh_normals": _shorts(mesh.vertex_normals),
        "mesh_edges": np.concatenate((edges.indices, inner_sides(mesh, edges))),
        "mesh_triangles": triangles,
    }
    textures = {name: _upload(rows) for name, rows in sources.items()}
    nbytes = sum(rows.nbytes for rows in sources.values())
    counts = {
        "edges": len(edges.indices), "sides": len(sources["mesh_edges"]),
        "triangles": len(triangles),
    }  # fmt: skip
    return Resident(mesh, edges, counts, textures, nbytes)


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
        self._textures = {name: _upload(rows) for name, rows in sources.items()}

    def bind(self) -> None:
        """At `UNITS`."""
        for name, texture in self._textures.items():
            gl.glActiveTexture(_TEXTURE_0 + UNITS[name])
            gl.glBindTexture(_TEXTURE_2D, texture)

    def release(self) -> None:
        """Delete them."""
        _delete(self._textures.values())


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


def _upload(rows: NDArray[np.generic]) -> int:
    """The name of a texture whose texels are rows (N, 4)."""
    kinds = {"f": (_RGBA_32F, _RGBA, _FLOAT), "i": (_RGBA_32I, _RGBA_INTEGER, _INT)}
    inner, outer, kind = kinds[rows.dtype.kind]
    if rows.dtype == np.int16:
        inner, outer, kind = _RGBA_16_SNORM, _RGBA, _SHORT
    height = max(1, -(-len(rows) // WIDTH))
    padded = np.zeros((height * WIDTH, 4), rows.dtype)
    padded[: len(rows)] = rows
    name = ctypes.c_uint()
    gl.glGenTextures(1, ctypes.addressof(name))
    gl.glActiveTexture(_TEXTURE_0 + UNITS["mesh_positions"])
    gl.glBindTexture(_TEXTURE_2D, name.value)
    gl.glBindBuffer(_UNPACK_BUFFER, 0)
    for alignment in ((0x0CF5, 4), (0x0CF2, 0), (0x0CF3, 0), (0x0CF4, 0)):
        gl.glPixelStorei(*alignment)
    for parameter, value in _PLAIN:
        gl.glTexParameteri(_TEXTURE_2D, parameter, value)
    gl.glTexImage2D(
        _TEXTURE_2D, 0, inner, WIDTH, height, 0, outer, kind, padded.ctypes.data
    )
    return name.value


def _delete(textures: object) -> None:
    names = list(textures)  # type: ignore[call-overload]
    values = (ctypes.c_uint * len(names))(*names)
    gl.glDeleteTextures(len(names), ctypes.addressof(values))
