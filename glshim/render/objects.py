"""The meshes that draws of one object space make together, with what their edges are."""

from __future__ import annotations

from collections.abc import Sequence
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch
from glshim.geometry.edges import join
from glshim.geometry.feature_lines import EdgeLines
from glshim.geometry.mesh import Mesh
from glshim.geometry.meshes import Meshes
from glshim.styling.protocol import Draw


class Objects:
    """Recovers meshes, and finds again what they gave."""

    def __init__(self) -> None:
        self._meshes = Meshes()
        self._lines: WeakKeyDictionary[Mesh, EdgeLines] = WeakKeyDictionary()

    def tick(self) -> None:
        """A layer has passed."""
        self._meshes.tick()

    def of(self, draws: Sequence[Draw]) -> list[tuple[EdgeLines, NDArray[np.float64]]]:
        """The objects of draws, each with its modelview (4, 4): batches that share one, even
        across glBegin and lists, are one object."""
        together: dict[bytes, list[Draw]] = {}
        for draw in draws:
            together.setdefault(draw.camera.modelview.tobytes(), []).append(draw)
        found = []
        for alike in together.values():
            mesh = self._meshes.find(joined([draw.batch for draw in alike]))
            lines = self._lines.get(mesh)
            if lines is None:
                lines = self._lines[mesh] = EdgeLines(mesh)
            found.append((lines, alike[0].camera.modelview))
        return found


def joined(batches: Sequence[PolygonBatch]) -> PolygonBatch:
    """Batches in one object space as one, with a key if all have one."""
    if len(batches) == 1:
        return batches[0]
    whole, keys = join(batches), tuple(batch.key for batch in batches)
    if None in keys:
        return whole
    return PolygonBatch(
        whole.positions, whole.corners, whole.starts, whole.boundary, ("joined", keys)
    )
