"""Polygons of shapes that C code draws, from feedback mode the first time."""

from __future__ import annotations

from collections.abc import Callable, Hashable

from glshim.model.batch import PolygonBatch
from glshim.model.caches import AgingCache
from glshim.sources.fixed import feedback
from glshim.sources.fixed.immediate import scaled
from glshim.spec.shapes import Shape


class Shapes:
    """The shapes of one context, found again by their keys. Their polygons are the same in all; to
    ask for them takes time, and memory that Mesa 22.3 keeps past the end of the context."""

    def __init__(self) -> None:
        self._kept: AgingCache[tuple[PolygonBatch | None]] = AgingCache()

    def polygons(self, shape: Shape) -> PolygonBatch | None:
        """The polygons of a shape; None where it has none, or where nothing may be asked."""
        if shape.key is None:
            return feedback.polygons(shape.draw) if feedback.possible() else None
        unit = self._find(("shape", shape.key), lambda key: feedback.polygons(shape.draw, key))
        if unit is None or shape.scale == 1.0:
            return unit
        key = ("shape", shape.key, shape.scale)
        return self._find(key, lambda key: scaled(unit, shape.scale, key))

    def tick(self) -> None:
        """A frame has passed."""
        self._kept.tick()

    def _find(
        self, key: Hashable, make: Callable[[Hashable], PolygonBatch | None]
    ) -> PolygonBatch | None:
        found = self._kept.get(key)
        if found is None:
            if not feedback.possible():
                return None
            batch = make(key)
            size = batch.positions.nbytes if batch is not None else 1
            found = self._kept.put(key, (batch,), size)
        return found[0]
