"""Layers: what is drawn until the depth buffer or the camera stops meaning the same thing.

Primitives of one state are assembled together when the layer ends; small ones of many states, each
with its own modelview, are moved to eye space and share one batch. What was seen before with the
same content is found again, so a still picture costs its hash.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import dataclass, replace
from itertools import count

import numpy as np

from ..capture.state import DrawState
from ..geometry.camera import Camera
from .batch import PolygonBatch
from .immediate import assemble_many, concatenate, transformed

_SMALL_STREAM = 200 * 20
_SMALL_CORNERS = 2000
"""Bytes of stream, or corners, below which what one camera sees joins others in eye space."""
_serial = count()
_FEW = 4
"""Fewer pieces than this are not worth joining."""

Primitive = tuple[int, bytes]
Item = tuple[PolygonBatch, Camera]


class ContentCache:
    """Batches by the content that they were made from, kept from the second sight on."""

    def __init__(self, most_bytes: int = 256 << 20) -> None:
        self._kept: OrderedDict[int, PolygonBatch] = OrderedDict()
        self._seen: OrderedDict[int, None] = OrderedDict()
        self._most, self._bytes = most_bytes, 0

    def found(self, content: Hashable, make: Callable[[], PolygonBatch]) -> PolygonBatch:
        """The batch of this content, made when it is not kept."""
        digest = hash(content)
        found = self._kept.get(digest)
        if found is not None:
            self._kept.move_to_end(digest)
            return found
        batch = make()
        if digest in self._seen:
            batch = replace(batch, key=("content", digest, next(_serial)))
            self._kept[digest] = batch
            self._bytes += _size(batch)
            while self._bytes > self._most and len(self._kept) > 1:
                _, old = self._kept.popitem(last=False)
                self._bytes -= _size(old)
        self._seen[digest] = None
        if len(self._seen) > 4096:
            self._seen.popitem(last=False)
        return batch


def _size(batch: PolygonBatch) -> int:
    return batch.positions.nbytes + batch.corners.nbytes + batch.starts.nbytes


@dataclass(frozen=True, slots=True)
class Piece:
    """Polygons under one camera: recorded primitives or a batch."""

    camera: Camera
    primitives: list[Primitive] | None = None
    batch: PolygonBatch | None = None

    def polygons(self, cache: ContentCache) -> PolygonBatch:
        """In object space."""
        batch = self.batch
        if batch is not None:
            return batch if batch.key is not None else cache.found(_content(batch), lambda: batch)
        primitives = self.primitives or []
        return cache.found(tuple(primitives), lambda: assemble_many(primitives))

    def in_eye_space(self) -> PolygonBatch:
        """Moved by the camera's modelview."""
        batch = self.batch if self.batch is not None else assemble_many(self.primitives or [])
        return transformed(batch, self.camera.modelview)

    def content(self) -> Hashable:
        """Equal for equal polygons in eye space."""
        batch = self.batch
        inner = _content(batch) if batch is not None else tuple(self.primitives or [])
        return inner, self.camera.modelview.tobytes()


def _content(batch: PolygonBatch) -> Hashable:
    if batch.key is not None:
        return batch.key
    return batch.positions.tobytes(), batch.corners.tobytes(), batch.boundary.tobytes()


class LayerCollector:
    """Gathers the polygons of the current layer of one context."""

    def __init__(self) -> None:
        self._content = ContentCache()
        self._primitives: dict[DrawState, list[Primitive]] = {}
        self._batches: list[Item] = []
        self._last: DrawState | None = None
        self._deep = False

    @property
    def pending(self) -> bool:
        """Whether the layer holds polygons."""
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
        if state is not self._last:
            self._note(state)
        group = self._primitives.get(state)
        if group is None:
            group = self._primitives[state] = []
        group.append((mode, stream))

    def add_batch(
        self, state: DrawState, batch: PolygonBatch, camera: Camera | None = None
    ) -> None:
        """Polygons drawn in this state, or under another camera than the state's."""
        self._note(state)
        self._batches.append((batch, camera or state.camera))

    def _note(self, state: DrawState) -> None:
        self._last = state
        if not state.flat:
            self._deep = True

    def take(self) -> tuple[Item, ...]:
        """The finished layer's items; the next layer begins empty."""
        items: list[Item] = []
        loose: dict[Hashable, list[Piece]] = {}

        def place(piece: Piece, small: bool) -> None:
            if small and _affine(piece.camera):
                loose.setdefault(_eye_key(piece.camera), []).append(piece)
            else:
                items.append((piece.polygons(self._content), piece.camera))

        for state, primitives in self._primitives.items():
            size = sum(len(s) for _, s in primitives)
            place(Piece(state.camera, primitives=primitives), size < _SMALL_STREAM)
        for batch, camera in self._batches:
            place(Piece(camera, batch=batch), len(batch.corners) < _SMALL_CORNERS)
        for group in loose.values():
            if len(group) < _FEW:
                items.extend((piece.polygons(self._content), piece.camera) for piece in group)
            else:
                items.append(self._joined(group))
        self._primitives, self._batches, self._last = {}, [], None
        return tuple(item for item in items if len(item[0].corners))

    def _joined(self, group: list[Piece]) -> Item:
        """Many small pieces as one batch in eye space."""
        batch = self._content.found(
            tuple(piece.content() for piece in group),
            lambda: concatenate([piece.in_eye_space() for piece in group]),
        )
        return batch, replace(group[0].camera, modelview=np.eye(4))


def _affine(camera: Camera) -> bool:
    return bool(np.array_equal(camera.modelview[3], (0.0, 0.0, 0.0, 1.0)))


def _eye_key(camera: Camera) -> Hashable:
    """Equal for cameras that differ in the modelview only."""
    return (
        camera.projection.tobytes(), camera.viewport, camera.depth_range, camera.front_ccw,
        camera.scissor, camera.clip_planes,
    )  # fmt: skip
