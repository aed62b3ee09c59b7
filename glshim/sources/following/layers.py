"""Layers: what is drawn until the depth buffer or the camera stops meaning the same thing.

Primitives of one state are assembled together when the layer ends. What was seen before with the
same content is found again, so a still picture costs its hash.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, replace
from itertools import count

from glshim.model.batch import POSITIONS, Item, PolygonBatch, Wanted
from glshim.model.caches import AgingCache
from glshim.model.camera import Camera
from glshim.model.lights import Lighting
from glshim.sources.fixed.immediate import assemble_many
from glshim.sources.following import census
from glshim.sources.source import Polygons, Primitive
from glshim.sources.state import DrawState

_serial = count()

Rectangle = tuple[int, int, int, int]


class ContentCache:
    """Batches by the content that they were made from, kept from the second sight on."""

    def __init__(self, wanted: Wanted) -> None:
        self._wanted = wanted
        self._kept: AgingCache[PolygonBatch] = AgingCache()
        self._seen: AgingCache[bool] = AgingCache()

    def of_primitives(self, primitives: list[Primitive]) -> PolygonBatch:
        """The polygons of recorded primitives."""
        return self._found(
            tuple(primitives), lambda: assemble_many(primitives, wanted=self._wanted)
        )

    def of_batch(self, batch: PolygonBatch) -> PolygonBatch:
        """The batch, with a key when its content was seen before."""
        return batch if batch.key is not None else self._found(_content(batch), lambda: batch)

    def tick(self) -> None:
        """A layer has passed."""
        self._kept.tick()
        self._seen.tick()

    def _found(self, content: Hashable, make: Callable[[], PolygonBatch]) -> PolygonBatch:
        digest = hash(content)
        found = self._kept.get(digest)
        if found is not None:
            return found
        batch = make()
        if not self._seen.get(digest):
            self._seen.put(digest, True, 1)
            return batch
        batch = replace(batch, key=("content", digest, next(_serial)))
        return self._kept.put(digest, batch, _size(batch))


def _size(batch: PolygonBatch) -> int:
    given = 0 if batch.normals is None else batch.normals.nbytes
    return batch.positions.nbytes + batch.corners.nbytes + batch.starts.nbytes + given


def _content(batch: PolygonBatch) -> Hashable:
    given = None if batch.normals is None else batch.normals.tobytes()
    return batch.positions.tobytes(), batch.corners.tobytes(), batch.boundary.tobytes(), given


def _overlap(state: DrawState, other: Rectangle) -> bool:
    """Whether a draw's viewport covers more than a sliver of another one."""
    x, y, w, h = state.camera.viewport
    ox, oy, ow, oh = other
    across = min(x + w, ox + ow) - max(x, ox)
    up = min(y + h, oy + oh) - max(y, oy)
    return across > 2 and up > 2


@dataclass(frozen=True, slots=True)
class FinishedLayer:
    """A layer whose depth is final."""

    items: tuple[Item, ...]
    """Polygons, and the cameras that they were drawn with."""
    over: bool
    """An earlier layer of the frame lies below it."""
    fresh: bool
    """The depth buffer held nothing when it began."""
    lighting: Lighting | None
    """The lights when the first lit polygons of the layer were drawn."""


class LayerCollector:
    """Gathers the polygons of the current layer of one context."""

    def __init__(self, wanted: Wanted = POSITIONS) -> None:
        """wanted: what batches shall come with."""
        self._content = ContentCache(wanted)
        self._primitives: dict[DrawState, list[Primitive]] = {}
        self._batches: list[Item] = []
        self._last: DrawState | None = None
        self._deep: set[Rectangle] = set()
        self._over = False
        self._fresh = True
        self.overdue = False
        """It has ended, but a query of the app's is open: what would be drawn now would be counted.
        """
        self.lighting: Lighting | None = None
        """The lights when the first lit polygons of the layer were drawn."""

    @property
    def pending(self) -> bool:
        """Whether the layer holds polygons."""
        return self._last is not None

    def carries(self, state: DrawState) -> bool:
        """Whether polygons drawn in this state get lines, if nothing else is in the way."""
        return (
            state.depth_tested
            and state.depth_written
            and state.fill_faces
            and not self._is_hud(state)
        )

    def shortfall(self, state: DrawState) -> str:
        """Why polygons that are drawn in this state get no lines, when they do not."""
        if not state.depth_tested:
            return census.NO_DEPTH_TEST
        if not state.fill_faces:
            return census.NOT_FILLED
        return census.NO_DEPTH_WRITES if not state.depth_written else census.HUD

    def ends_with(self, state: DrawState) -> bool:
        """Whether a draw in this state no longer belongs to the current layer."""
        last = self._last
        return last is not None and (
            state.framebuffer != last.framebuffer
            or not state.depth_tested
            or (state.flat and not last.flat and _overlap(state, last.camera.viewport))
        )

    def same_target(self, state: DrawState) -> bool:
        """Whether a draw in this state goes where the layer was drawn."""
        return self._last is not None and state.framebuffer == self._last.framebuffer

    def _is_hud(self, state: DrawState) -> bool:
        """A flat projection over a picture that has depth; the views of a CAD program that stand
        side by side are none."""
        return state.flat and any(_overlap(state, viewport) for viewport in self._deep)

    def forget_depth(self) -> None:
        """The depth buffer was cleared: nothing is a HUD yet."""
        self._deep.clear()
        self._fresh = True

    def end_frame(self) -> None:
        """What is drawn now is another picture."""
        self.forget_depth()
        self._over = False

    def add(self, state: DrawState, polygons: Polygons, camera: Camera) -> None:
        """Polygons drawn in this state and seen by a camera: of a primitive the state's."""
        if not isinstance(polygons, Primitive):
            self._note(state)
            self._batches.append((polygons, camera))
            return
        if state is not self._last:
            self._note(state)
        group = self._primitives.get(state)
        if group is None:
            group = self._primitives[state] = []
        group.append(polygons)

    def _note(self, state: DrawState) -> None:
        self._last = state
        if not state.flat:
            self._deep.add(state.camera.viewport)

    def take(self) -> FinishedLayer:
        """The finished layer; the next one begins empty."""
        items: list[Item] = [
            (self._content.of_primitives(primitives), state.camera)
            for state, primitives in self._primitives.items()
        ]
        items.extend((self._content.of_batch(batch), camera) for batch, camera in self._batches)
        with_corners = tuple(item for item in items if len(item[0].corners))
        finished = FinishedLayer(with_corners, self._over, self._fresh, self.lighting)
        self._primitives, self._batches, self._last = {}, [], None
        self.lighting = None
        self._over, self._fresh = self._over or bool(items), self._fresh and not items
        self._content.tick()
        return finished
