"""Layers: what is drawn until the depth buffer or the camera stops meaning the same thing.

Primitives of one state are assembled together when the layer ends. What was seen before with the
same content is found again, so a still picture costs its hash.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from dataclasses import dataclass, replace
from itertools import count

from glshim.model.batch import POSITIONS, Item, PolygonBatch, Wanted
from glshim.model.boxes import Box, Unbacked, covers, overlap
from glshim.model.caches import AgingCache
from glshim.model.camera import Camera
from glshim.model.lights import Lighting, Shade
from glshim.sources.fixed.immediate import assemble_many
from glshim.sources.following import census
from glshim.sources.following.backing import Backing
from glshim.sources.following.ground import Clear, Ground
from glshim.sources.source import Polygons, Primitive
from glshim.sources.state import DrawState

_serial = count()
View = tuple[int, Box]
"""The name of a framebuffer, and a viewport in it."""


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


@dataclass(frozen=True, slots=True)
class FinishedLayer:
    """A layer whose depth is final."""

    items: tuple[Item, ...]
    """Polygons, and the cameras that they were drawn with."""
    over: bool
    """An earlier layer of the frame lies below it, somewhere in its views."""
    bare: tuple[Box, ...]
    """Where none does in the views of a layer over others, as boxes."""
    fresh: bool
    """The depth buffer held nothing there when it began."""
    lighting: Lighting | None
    """The lights when the first lit polygons of the layer were drawn."""
    backed: bool = False
    """The style's background was laid before all that is drawn there."""
    glass: tuple[Item, ...] = ()
    """Solids that were blended over it, without depth."""
    own_background: Shade = (0.0, 0.0, 0.0)
    """The program's, where the style's was laid."""


class LayerCollector:
    """Gathers the polygons of the current layer of one context."""

    def __init__(self, wanted: Wanted = POSITIONS) -> None:
        """wanted: what batches shall come with."""
        self._content = ContentCache(wanted)
        self._primitives: dict[DrawState, list[Primitive]] = {}
        self._batches: list[Item] = []
        self._glass: dict[DrawState, list[Primitive]] = {}
        self._glass_batches: list[Item] = []
        self._last: DrawState | None = None
        self._pictures, self._depths = Ground(), Ground()
        """Of earlier layers of the frame."""
        self.backing = Backing()
        self._backed: View | None = None
        """The view that was last found to lack nothing."""
        self._deep: set[View] = set()
        """Views with depth that is there."""
        self._solid: dict[tuple[View, bytes], int] = {}
        """By view of something solid, and projection, the last frame that had it."""
        self._frame = 0
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
            or (
                state.flat
                and not last.flat
                and overlap(state.camera.viewport, last.camera.viewport)
            )
        )

    def same_target(self, state: DrawState) -> bool:
        """Whether a draw in this state goes where the layer was drawn."""
        return self._last is not None and state.framebuffer == self._last.framebuffer

    def lies_over(self, state: DrawState) -> bool:
        """Whether earlier layers of the frame left pictures where a draw in this state goes."""
        return self._pictures.touches(state.framebuffer, (state.camera.viewport,))

    def has_pictures(self, framebuffer: int) -> bool:
        """Whether earlier layers of the frame left pictures in a framebuffer, or the style's
        background lies there."""
        return self._pictures.has(framebuffer) or self.backing.lies_in(framebuffer)

    def _is_hud(self, state: DrawState) -> bool:
        """A flat projection over a picture that has depth; the views of a CAD program that stand
        side by side are none. Where depth has been cleared for it, or is yet to come, it is drawn
        parallel to the screen, in another projection than what is solid there."""
        if not state.flat:
            return False
        own = state.camera.viewport
        if any(at == state.framebuffer and overlap(own, view) for at, view in self._deep):
            return True
        if not self._solid or not state.upright:
            return False
        projection = state.camera.projection.tobytes()
        return any(
            at == state.framebuffer and other != projection and covers(own, view)
            for (at, view), other in self._solid
        )

    def cleared(self, clear: Clear) -> None:
        """The program has cleared something."""
        if clear.blank:
            self._pictures.remove(clear.framebuffer, clear.box)
            self.backing.cleared(clear.framebuffer, clear.box)
        if clear.depth:
            self.backing.free_depth |= clear.box is None
            self._depths.remove(clear.framebuffer, clear.box)
            self._deep = {
                (at, view) for at, view in self._deep
                if at != clear.framebuffer or (clear.box and not covers(clear.box, view))
            }  # fmt: skip

    def end_frame(self) -> None:
        """What is drawn now is another picture."""
        self._pictures.clear()
        self._depths.clear()
        self.backing.end_frame()
        self._deep.clear()
        self._solid = {key: at for key, at in self._solid.items() if at == self._frame}
        self._frame += 1

    def unbacked(self, state: DrawState, *, carries: bool, polygons: bool) -> Unbacked | None:
        """Where the style's background is to be laid before a draw in this state: in its view,
        where nothing lies yet but what the program has behind it all. carries: it is polygons of a
        layer; polygons: any. Flat ones without a layer are backdrops, menus and HUDs, and belong to
        a scene where the last frame was known to have one."""
        view = state.framebuffer, state.camera.viewport
        if view == self._backed and not self.backing.awaited:
            return None
        fits = self.backing.fits(polygons, flat=state.flat)
        if not carries and not (state.rendered and fits):
            return None
        free = self._pictures.free(state.framebuffer, (state.camera.viewport,))
        missing = self.backing.missing(state.framebuffer, free)
        if missing:
            return Unbacked(tuple(missing), self.backing.free_depth)
        self._backed = view
        return None

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

    def add_glass(self, state: DrawState, drawn: Iterable[tuple[Polygons, Camera]]) -> None:
        """Polygons that are blended over the layer, without depth. What is drawn twice, for its
        inside and its outside, is there once."""
        for polygons, camera in drawn:
            if not isinstance(polygons, Primitive):
                self._glass_batches.append((polygons, camera))
            elif polygons not in self._glass.setdefault(state, []):
                self._glass[state].append(polygons)

    def _all_glass(self) -> tuple[Item, ...]:
        """Each once."""
        items: list[Item] = [
            (self._content.of_primitives(primitives), state.camera)
            for state, primitives in self._glass.items()
        ]
        items += [(self._content.of_batch(batch), camera) for batch, camera in self._glass_batches]
        self._glass, self._glass_batches = {}, []
        once: dict[Hashable, Item] = {}
        for batch, camera in items:
            own = camera.modelview.tobytes(), camera.viewport
            content = batch.positions.tobytes(), batch.corners.tobytes()
            if len(batch.corners):
                once.setdefault((own, content), (batch, camera))
        return tuple(once.values())

    def _note(self, state: DrawState) -> None:
        self._last = state
        camera = state.camera
        view = state.framebuffer, camera.viewport
        if not state.flat:
            self._deep.add(view)
            self._solid[view, b""] = self._frame
        elif not state.upright:
            self._solid[view, camera.projection.tobytes()] = self._frame

    def take(self) -> FinishedLayer:
        """The finished layer; the next one begins empty."""
        items: list[Item] = [
            (self._content.of_primitives(primitives), state.camera)
            for state, primitives in self._primitives.items()
        ]
        items.extend((self._content.of_batch(batch), camera) for batch, camera in self._batches)
        with_corners = tuple(item for item in items if len(item[0].corners))
        views = tuple({camera.viewport: True for _, camera in items})
        at = self._last.framebuffer if self._last is not None else 0
        over, free = self._pictures.touches(at, views), self._pictures.free(at, views)
        finished = FinishedLayer(
            with_corners, over, tuple(free) if over else (),
            not self._depths.touches(at, views), self.lighting,
            not self.backing.missing(at, free), self._all_glass(),
            self.backing.own,
        )  # fmt: skip
        self.backing.used = True
        self._pictures.add(at, views)
        self._depths.add(at, views)
        self._primitives, self._batches, self._last = {}, [], None
        self.lighting = None
        self._content.tick()
        return finished
