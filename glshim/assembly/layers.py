"""Layers: what is drawn until the depth buffer or the camera stops meaning the same thing.

Primitives of one state are assembled together when the layer ends; small ones of many states, each
with its own modelview, are moved to eye space and share one batch. What was seen before with the
same content is found again, so a still picture costs its hash.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable
from dataclasses import replace

import numpy as np

from ..capture.state import DrawState
from ..geometry.camera import Camera
from .batch import PolygonBatch
from .immediate import assemble_many, concatenate, transformed

_SMALL = 200 * 20
"""Bytes of recorded stream below which primitives of a state join others in eye space."""

Primitive = tuple[int, bytes]
Item = tuple[PolygonBatch, Camera]


class ContentCache:
    """Batches by the content that they were made from, kept from the second sight on."""

    def __init__(self, most_bytes: int = 256 << 20) -> None:
        self._kept: OrderedDict[int, PolygonBatch] = OrderedDict()
        self._seen: OrderedDict[int, None] = OrderedDict()
        self._most, self._bytes = most_bytes, 0

    def batch(self, primitives: list[Primitive]) -> PolygonBatch:
        """The polygons of these primitives."""
        content = hash(tuple(primitives))
        found = self._kept.get(content)
        if found is not None:
            self._kept.move_to_end(content)
            return found
        batch = assemble_many(primitives)
        if content in self._seen:
            batch = replace(batch, key=("content", content, object()))
            self._kept[content] = batch
            self._bytes += _size(batch)
            while self._bytes > self._most and len(self._kept) > 1:
                _, old = self._kept.popitem(last=False)
                self._bytes -= _size(old)
        self._seen[content] = None
        if len(self._seen) > 4096:
            self._seen.popitem(last=False)
        return batch


def _size(batch: PolygonBatch) -> int:
    return batch.positions.nbytes + batch.corners.nbytes + batch.starts.nbytes


class LayerCollector:
    """Gathers the polygons of the current layer of one context."""

    def __init__(self) -> None:
        self._content = ContentCache()
        self._primitives: dict[DrawState, list[Primitive]] = {}
        self._batches: list[Item] = []
        self._last: DrawState | None = None
        self._deep = False

    def __bool__(self) -> bool:
        return self._last is not None

    def carries(self, state: DrawState) -> bool:
        """Whether polygons drawn in this state get lines."""
        return (
            state.depth_tested
            and state.depth_written
            and state.fill_faces
            and not state.obstacle
            and not (state.flat and self._deep)
        )

    def ends_with(self, state: DrawState) -> bool:
        """Whether a draw in this state no longer belongs to the current layer."""
        last = self._last
        return last is not None and (
            state.framebuffer != last.framebuffer
            or not state.depth_tested
            or (state.flat and not last.flat)
        )

    def forget_depth(self) -> None:
        """The depth buffer was cleared or the frame ended: nothing is a HUD yet."""
        self._deep = False

    def add_primitive(self, state: DrawState, mode: int, stream: bytes) -> None:
        """A recorded primitive drawn in this state."""
        self._note(state)
        group = self._primitives.get(state)
        if group is None:
            group = self._primitives[state] = []
        group.append((mode, stream))

    def add_batch(self, state: DrawState, batch: PolygonBatch, camera: Camera | None = None) -> None:
        """Polygons drawn in this state, or under another camera than the state's."""
        self._note(state)
        self._batches.append((batch, camera or state.camera))

    def _note(self, state: DrawState) -> None:
        self._last = state
        if not state.flat:
            self._deep = True

    def take(self) -> tuple[Item, ...]:
        """The finished layer's items; the next layer begins empty."""
        items = self._batches
        loose: dict[Hashable, list[tuple[DrawState, list[Primitive]]]] = {}
        for state, primitives in self._primitives.items():
            if sum(len(s) for _, s in primitives) >= _SMALL or not _affine(state.camera):
                items.append((self._content.batch(primitives), state.camera))
            else:
                loose.setdefault(_eye_key(state.camera), []).append((state, primitives))
        for group in loose.values():
            items.extend(self._joined(group))
        self._primitives, self._batches, self._last = {}, [], None
        return tuple(item for item in items if len(item[0].corners))

    def _joined(self, group: list[tuple[DrawState, list[Primitive]]]) -> list[Item]:
        if len(group) == 1:
            state, primitives = group[0]
            return [(self._content.batch(primitives), state.camera)]
        parts = [transformed(assemble_many(p), s.camera.modelview) for s, p in group]
        camera = replace(group[0][0].camera, modelview=np.eye(4))
        return [(concatenate(parts), camera)]


def _affine(camera: Camera) -> bool:
    return bool(np.array_equal(camera.modelview[3], (0.0, 0.0, 0.0, 1.0)))


def _eye_key(camera: Camera) -> Hashable:
    """Equal for cameras that differ in the modelview only."""
    return (
        camera.projection.tobytes(), camera.viewport, camera.depth_range, camera.front_ccw,
        camera.scissor, camera.clip_planes,
    )  # fmt: skip
