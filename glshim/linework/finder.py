"""From a group of batches to the records of their lines, keeping what static geometry gave."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np

from glshim.geometry.edges.edges import Edges, edges, edges_of_each
from glshim.geometry.edges.gather import Placement, merged
from glshim.linework.coherence import Past, kept_with, latest
from glshim.linework.feature_lines import feature_lines, names_of
from glshim.linework.groups import Group
from glshim.linework.objects import Objects
from glshim.linework.pairing import NamedObjects
from glshim.linework.patterns import lay_pattern
from glshim.linework.polygon_lines import lines_of_objects
from glshim.model.arrays import Floats, Indices, Rows
from glshim.model.batch import Item, PolygonBatch, join
from glshim.model.caches import AgingCache
from glshim.model.lines import Line
from glshim.styling.wishes import Features

_LARGE = 4096
"""Corners from which a batch is looked through on its own rather than gathered with others."""


class LineFinder:
    """Finds lines. cache_bytes bounds the memory of the edges of batches with a key."""

    def __init__(self, cache_bytes: int) -> None:
        self._cache: AgingCache[Edges] = AgingCache(cache_bytes)
        self.objects = Objects(cache_bytes)
        self._past: AgingCache[tuple[Past, ...]] = AgingCache(cache_bytes // 16, longest_rest=8)
        self._crowd: tuple[Hashable, Edges, Indices] | None = None
        self._known: dict[Hashable, tuple[Floats, Group]] = {}
        """With the group, whose name holds addresses: no other object may take them meanwhile."""

    def tick(self) -> None:
        """A layer has passed."""
        self._known.clear()
        self._cache.tick()
        self.objects.tick()
        self._past.tick()

    def records(self, group: Group) -> Floats:
        """(L, 21) `glshim.model.lines.Line` records of a group: what its polygons show, or the
        features of the meshes that its batches make together; all but intersections. The same
        lines drawn in several coats of a layer are found once."""
        name = group.name
        known = self._known.get(name)
        if known is None:
            known = self._known[name] = self._records(group), group
        return known[0]

    def _records(self, group: Group) -> Floats:
        wanted = group.wanted
        if isinstance(wanted, Features):
            return self._features(group, wanted)
        large = [item for item in group.items if len(item[0].corners) > _LARGE]
        small = [item for item in group.items if len(item[0].corners) <= _LARGE]
        if len(small) == 1:
            large, small = [*large, *small], []
        parts, objects = [], []
        for batch, camera in large:
            own = self._edges(batch)
            parts.append((own, Placement.one(camera.modelview, len(own.planes))))
            objects.append((_name(batch), camera.modelview))
        if small:
            edges, places, names = self._gathered(small)
            parts.append((edges, places))
            objects += zip(names, places.modelviews, strict=True)
        records, owner = lines_of_objects(parts, group.camera, wanted)
        if wanted.pattern is not None:
            self._lay_pattern(records, owner, tuple(objects), group)
        return records

    def lay_on_crossings(self, records: Floats, group: Group) -> None:
        """The pattern of a group, on records (L, 21) of where its surfaces cross. These go with the
        viewer, as what was drawn first does."""
        pattern = group.wanted.pattern
        assert pattern is not None
        rest = records[:, Line.REST].copy()
        objects = (("crossings", group.camera.modelview),)
        self._lay_pattern(records, np.zeros(len(records), np.intp), objects, group)
        if not pattern.straight:
            records[:, Line.REST] = rest

    def _lay_pattern(
        self, records: Floats, owner: Rows, objects: NamedObjects, group: Group
    ) -> None:
        """Write the pattern of a group into records of its lines, of objects by number (L,), as it
        was in the frame before."""
        camera, pattern = group.camera, group.wanted.pattern
        assert pattern is not None
        view = (group.wanted, camera.viewport)
        before = self._before(view, [name for name, _ in objects])
        past = lay_pattern(records, owner, objects, camera, pattern, past=before)
        self._keep(view, past, before)

    def _features(self, group: Group, wanted: Features) -> Floats:
        items = [(batch, camera.modelview) for batch, camera in group.items]
        placed = self.objects.placed(items, wanted.tolerance)
        camera = group.camera
        if wanted.pattern is None:
            return feature_lines(placed, camera, wanted)[0]
        view = (wanted, camera.viewport)
        before = self._before(view, names_of(placed))
        records, past = feature_lines(placed, camera, wanted, before)
        if past is not None:
            self._keep(view, past, before)
        return records

    def _before(self, view: Hashable, names: Sequence[Hashable]) -> Past | None:
        """What a view showed of objects in the frame before."""
        return latest(self._past.get(view) or (), names)

    def _keep(self, view: Hashable, past: Past, before: Past | None) -> None:
        pasts = kept_with(past, self._past.get(view) or (), before)
        self._past.put(view, pasts, sum(one.nbytes for one in pasts))

    def _edges(self, batch: PolygonBatch) -> Edges:
        """The edges of a batch, found again by key."""
        key = batch.key
        if key is None:
            return edges(batch)
        known = self._cache.get(key)
        if known is None:
            made = edges(batch)
            known = self._cache.put(key, made, made.nbytes)
        return known

    def _gathered(self, items: list[Item]) -> tuple[Edges, Placement, list[Hashable]]:
        """The edges of many small batches, each where it stands, and what stands there."""
        kept = [item for item in items if item[0].key is not None]
        passing: dict[int, list[Item]] = {}
        for item in items:
            if item[0].key is None:
                passing.setdefault(id(item[1]), []).append(item)
        parts, owners = [], []
        if kept:
            keys = tuple(batch.key for batch, _ in kept)
            if self._crowd is None or keys != self._crowd[0]:
                self._crowd = (keys, *merged([self._edges(batch) for batch, _ in kept]))
            parts.append(self._crowd[1])
            owners.append(self._crowd[2])
        if passing:
            fresh, owner = edges_of_each(
                [join([batch for batch, _ in alike]) for alike in passing.values()]
            )
            parts.append(fresh)
            owners.append(owner + np.int32(len(kept)))
        cameras = [camera for _, camera in kept] + [alike[0][1] for alike in passing.values()]
        modelviews = np.stack([camera.modelview for camera in cameras])
        names = [_name(batch) for batch, _ in kept]
        names += [_name(alike[0][0]) for alike in passing.values()]
        return merged(parts)[0], Placement(np.concatenate(owners), modelviews), names


def _name(batch: PolygonBatch) -> Hashable:
    """What a batch is from frame to frame."""
    return len(batch.corners) if batch.key is None else batch.key
