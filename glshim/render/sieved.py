"""The edges that a sieve leaves of a recovered mesh, as a texture of their numbers."""

from __future__ import annotations

from collections.abc import Hashable

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.edge_mesh import EdgeMesh
from glshim.geometry.recovery.mesh import Mesh
from glshim.geometry.sieve import EdgeSieve
from glshim.render.driver import gl
from glshim.render.uploads import delete, upload
from glshim.styling.passes import Sieve

UNIT = 12
"""Texture unit of the numbers."""


class Sieved:
    """Of one mesh, for the last eye that looked. Use it inside the guard."""

    def __init__(self, mesh: Mesh, edges: EdgeMesh) -> None:
        self._source = mesh, edges
        self._sieve: EdgeSieve | None = None
        self._last: Hashable = None
        self._texture = self._count = 0

    def bind(self, eye: NDArray[np.float64], sieve: Sieve) -> int:
        """Bind the texture of the edges that remain at `UNIT`; how many those are."""
        key = eye.tobytes(), sieve
        if key != self._last:
            if self._sieve is None:
                self._sieve = EdgeSieve(*self._source)
            rows = self._sieve.candidates(eye, sieve.wanted, sieve.angles)
            self.free()
            texels = np.zeros((len(rows), 4), np.int32)
            texels[:, 0] = rows
            self._texture, self._count, self._last = upload(texels), len(rows), key
        gl.glActiveTexture(0x84C0 + UNIT)
        gl.glBindTexture(0x0DE1, self._texture)
        return self._count

    def free(self) -> None:
        """Delete the texture."""
        if self._texture:
            delete((self._texture,))
            self._texture, self._last = 0, None
