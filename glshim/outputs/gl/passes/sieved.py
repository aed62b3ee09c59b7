"""The elements that a sieve leaves of a recovered mesh: their numbers as a texture, and indices of
lines and triangles with adjacency."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.driver.objects import delete
from glshim.geometry.crease.creases import Creases
from glshim.geometry.meshshaders.edge_mesh import CONTOUR, EdgeMesh
from glshim.geometry.meshshaders.extent import Extent
from glshim.geometry.meshshaders.sieve import EdgeSieve, TriangleSieve
from glshim.geometry.recovery.halfedges import twins, with_adjacency
from glshim.geometry.recovery.mesh import Mesh
from glshim.linework.touching import Touching
from glshim.outputs.gl.device.buffers import Buffer
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.uploads import upload
from glshim.spec.constants import (
    GL_ELEMENT_ARRAY_BUFFER,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
)
from glshim.spec.kinds import TEXTURE
from glshim.styling.passes import Element, Sieve

UNIT = 12
"""Texture unit of the numbers."""
Ints = NDArray[np.int32]
_INDEXED = ("adjacency", "lines")
_LINE = np.array((4, 0, 2, 1))
"""Where in the six of a triangle the four of its first side are: c, a, b, across."""


@dataclass(slots=True)
class _Remaining:
    """What a sieve left for the last eye that looked."""

    name: bytes = b""
    """Of what it depends on."""
    texture: int = 0
    """Of the numbers."""
    count: int = 0
    indices: Buffer | None = None

    def free(self) -> None:
        """Delete what it holds."""
        if self.texture:
            delete(TEXTURE, (self.texture,))
        if self.indices is not None:
            self.indices.release()


class Sieved:
    """Of one mesh, sieve by sieve: passes that ask for unlike elements take turns in each frame.
    Use it inside the guard."""

    def __init__(
        self, device: ModernDevice, mesh: Mesh, edges: EdgeMesh, creases: Creases | None
    ) -> None:
        self._device = device
        self._mesh, self._edges, self._creases = mesh, edges, creases
        self._left: dict[tuple[int, tuple[float, float], Element], _Remaining] = {}

    @cached_property
    def adjacency(self) -> Ints:
        """(T, 6) the triangles with the vertices across their sides."""
        if self._creases is not None:
            return self._creases.adjacency
        return with_adjacency(self._mesh.triangles, twins(self._mesh))

    @cached_property
    def extent(self) -> Extent:
        """Of the mesh."""
        return Extent.of(self._mesh.positions, self._mesh.edges)

    @cached_property
    def _edge_sieve(self) -> EdgeSieve:
        return EdgeSieve(self._mesh, self._edges)

    @cached_property
    def _triangle_sieve(self) -> TriangleSieve | None:
        return None if self._creases is None else TriangleSieve(self._creases)

    def indices(self, element: Element, rows: Ints | None = None) -> Ints:
        """Buffer of some lines, or triangles with adjacency, or of all."""
        if element == "adjacency":
            return self.adjacency if rows is None else self.adjacency.take(rows, axis=0)
        if rows is None:
            rows = np.arange(3 * len(self._mesh.triangles), dtype=np.int32)
        side = rows % 3
        places = (2 * side[:, None] + _LINE) % 6 + 6 * (rows // 3)[:, None]
        return np.asarray(self.adjacency.ravel().take(places))

    def bind(
        self,
        eye: NDArray[np.float64],
        sieve: Sieve,
        element: Element,
        touching: Touching | None = None,
    ) -> int:
        """Bind the texture of the elements that remain at `UNIT`, with how their sides touch other
        objects, and the indices of what has any; how many those are."""
        left = self._left.setdefault((sieve.wanted, sieve.angles, element), _Remaining())
        bits = None if touching is None else self._bits(touching)
        name = eye.tobytes() + (b"" if bits is None else bits.tobytes())
        if left.name != name:
            rows = self._remaining(eye, sieve, element)
            if left.texture:
                delete(TEXTURE, (left.texture,))
            texels = np.zeros((len(rows), 4), np.int32)
            texels[:, 0] = rows
            if bits is not None and element == "adjacency":
                texels[:, 1] = bits[rows]
            elif bits is not None and element == "lines":
                texels[:, 1] = bits[rows // 3] >> (rows % 3) & 9
            left.name, left.texture, left.count = name, upload(texels), len(rows)
            if element in _INDEXED:
                left.indices = left.indices or Buffer(
                    self._device, GL_ELEMENT_ARRAY_BUFFER, dynamic=True
                )
                left.indices.fill(self.indices(element, rows))
        if left.indices is not None:
            left.indices.bind()
        gl.glActiveTexture(GL_TEXTURE0 + UNIT)
        gl.glBindTexture(GL_TEXTURE_2D, left.texture)
        return left.count

    def _bits(self, touching: Touching) -> Ints | None:
        """(T,) 1, 2, 4: of sides that lie on those of other objects; 8, 16, 32: of those that are
        no edges of the whole. None: no side."""
        found = np.zeros(3 * len(self._mesh.triangles), np.int32)
        for bit, edges in ((1, touching.shared), (8, touching.inside)):
            halves = self._mesh.halves[edges]
            found[halves[halves >= 0]] |= bit
        if not found.any():
            return None
        return np.asarray(found.reshape(-1, 3) @ np.array((1, 2, 4), np.int32))

    def _remaining(self, eye: NDArray[np.float64], sieve: Sieve, element: Element) -> Ints:
        """The elements that remain, in rising order."""
        if self._triangle_sieve is not None:
            return self._triangle_sieve.candidates(eye, sieve.wanted)
        rows = self._edge_sieve.candidates(eye, sieve.wanted, sieve.angles)
        if element not in _INDEXED:
            return rows
        halves = self._halves.take(rows)
        if sieve.wanted & CONTOUR:  # a contour may be inside a flat polygon that is seen edge on
            doubtful = self._edge_sieve.facing.doubtful(eye)
            if len(doubtful):
                more = (3 * doubtful[:, None] + np.arange(3)).ravel()
                halves = np.unique(np.concatenate((halves, more))).astype(np.int32)
        return halves if element == "lines" else np.unique(halves // 3)

    @cached_property
    def _halves(self) -> Ints:
        """(R,) the halfedge that draws each row of the edge mesh: that whose corner off it has the
        lesser number."""
        rows = self._edges.rows
        (a, b), (c, d) = self._mesh.halves[rows].T, self._mesh.opposite[rows].T
        return np.asarray(np.where((b < 0) | (c <= d), a, b))

    def free(self) -> None:
        """Delete what it made."""
        for left in self._left.values():
            left.free()
        self._left.clear()
