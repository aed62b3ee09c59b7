"""Follows the app's draws: what the binding tells becomes polygons in its context's layer."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from glshim.bindings.base import PrimitiveStream
from glshim.driver.arguments import name as name_among
from glshim.driver.arguments import number
from glshim.driver.queries import UNCOUNTED, counting
from glshim.model.batch import POSITIONS, Wanted
from glshim.model.lights import Materials
from glshim.notices import say_once
from glshim.sources.fixed.immediate import POLYGON_MODES
from glshim.sources.fixed.materials import material_change
from glshim.sources.fixed.steps import Change, Closing, LooseVertices, Marks
from glshim.sources.following import census
from glshim.sources.following.behind import lay_behind
from glshim.sources.following.census import Census
from glshim.sources.following.changing import cover_anew
from glshim.sources.following.faults import Faults, contained, styling
from glshim.sources.following.gathering import is_let_through, is_wire, lay_ink, mind_ink
from glshim.sources.following.glass import is_glass
from glshim.sources.following.ground import clear
from glshim.sources.following.picking import pick_begins, pick_ends
from glshim.sources.following.scene import Scene, Scenes
from glshim.sources.following.sink import LayerSink
from glshim.sources.source import Call, Drawn
from glshim.sources.state import DrawState
from glshim.spec.roles import (
    BUFFER_WRITES,
    CONDITIONS,
    IN_LISTS,
    LIST_CALLS,
    OTHER_DRAWS,
    POLYGON_DRAWS,
    READERS,
    RENEWALS,
    Role,
)
from glshim.spec.shapes import Shape, draws_no_polygons
from glshim.system.interrupts import Held

_REFUSED = frozenset((Role.ARRAY_DRAW, Role.EVALUATOR_MESH))
"""Draws that read the app's memory, or must be made again: with an error GL has made none of it."""


class _Open(threading.local):
    """The open primitive of a thread."""

    scene: Scene | None = None
    """Where it is drawn."""
    spoilt = False
    """Something of it could not be followed."""
    is_ink = False
    """The shape of a C library's that is under way has no polygons."""


class Follower:
    """A `glshim.bindings.base.Watcher`."""

    def __init__(self, stream: PrimitiveStream, sink: LayerSink) -> None:
        """Of no style yet: :meth:`restyle`. stream: the binding's."""
        self.census = Census()
        self._sink = sink
        self._stream = stream
        self._idle = True
        """Nothing is drawn: only what lists hold and which buffers were written is followed."""
        self._scenes = Scenes(stream, sink.context_ended)
        self._primitive = _Open()
        self.faults = Faults(self._drop, sink.give_up)

    def restyle(self, wanted: Wanted | None) -> None:
        """Polygons shall come with something else from now on, or (None) not at all. What layers
        hold is dropped: between frames nothing."""
        self._idle = wanted is None
        self._scenes.restyle(wanted or POSITIONS)

    # -- faults ----------------------------------------------------------------------------------

    def _drop(self) -> None:
        """What the current call draws carries no lines."""
        if self._stream.inside():  # nothing may be said to GL here: the end of it closes
            self._primitive.spoilt = True
            return
        scene = self._scenes.current()
        if scene is not None:
            self._close(scene)

    # -- primitives ------------------------------------------------------------------------------

    @contained
    def begin(self, mode: int) -> None:
        """Before glBegin."""
        self._primitive.scene = scene = self._scenes.current()
        self._primitive.spoilt = False
        if scene is not None:
            self._open(mode in POLYGON_MODES, scene, ink=mode not in POLYGON_MODES)
            scene.fixed.begin(scene.drawing)

    @contained
    def end(self, mode: int, stream: bytes) -> None:
        """After glEnd."""
        self._ended(mode, stream)

    def _ended(self, mode: int, stream: bytes) -> None:
        scene = self._primitive.scene
        if scene is None:
            return
        state = self._close(scene)
        if mode in POLYGON_MODES:
            drawn = scene.fixed.end(mode, stream)
            if state is not None and not self._primitive.spoilt:
                self._add(scene, state, drawn)

    @contained
    def loose(self, stream: bytes) -> None:
        """An open list has vertices outside any primitive of it."""
        scene = self._scenes.current()
        if scene is not None and stream:
            scene.fixed.lists.add(LooseVertices(stream))

    @contained
    def stray_end(self) -> None:
        """An open list ends a primitive that it did not begin."""
        scene = self._scenes.current()
        if scene is not None:
            scene.fixed.lists.add(Closing())

    @contained
    def unfinished(self, mode: int, stream: bytes) -> None:
        """An open list leaves the primitive open that it began."""
        scene = self._scenes.current()
        if scene is not None:
            self._close(scene)
            scene.fixed.unfinished(mode, stream)

    def listed(self) -> int:
        """How many things an open list holds."""
        scene = self._scenes.current()
        return 0 if scene is None else scene.fixed.lists.held()

    @contained
    def material_changes(self) -> None:
        """A primitive changes its materials from vertex to vertex: it is begun anew, with nothing
        of it drawn, so that its surface can be one that follows them."""
        scene = self._primitive.scene
        if scene is not None:
            cover_anew(self._sink, self._stream, scene)

    @contained
    def inside(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        """Something that is legal inside glBegin/glEnd was called there, or in an open list."""
        scene = self._scenes.current()
        if scene is None or scene.refused:
            return
        if role is Role.MATERIAL and scene.drawing is not None:
            change = material_change(name, args)
            if change is not None:
                self._sink.material(change)
        finished = scene.fixed.inside(role, name, args, call)
        if finished is not None:
            self._ended(*finished)

    # -- calls by role ---------------------------------------------------------------------------

    @contained
    def before(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """Before a call by role."""
        if role in RENEWALS:
            self._scenes.look_here()
        scene = self._scenes.current()
        if scene is None:
            return
        if role in POLYGON_DRAWS:
            self._open_polygons(scene, role, args)
        elif role in OTHER_DRAWS:
            ink = role is Role.BITMAP or (role is Role.PIXELS and is_let_through())
            self._open(False, scene, ink=ink)
        elif role is Role.CLEAR or role is Role.CLEAR_BUFFER:
            self._clear(scene, role, args)
        elif role is Role.READ_PIXELS:
            if not pick_begins(self._sink, scene, args):
                self._finish(scene, waits=True)
        elif role in READERS:
            self._finish(scene, waits=role is not Role.TARGET)
        elif role in BUFFER_WRITES:
            if not scene.refused:
                scene.fixed.fetch.buffer_written(role, args)
        elif role is Role.LIST_CLOSE:
            self._scenes.close_list(scene)
        elif role is Role.LIST_FORGET:
            scene.fixed.lists.book.forget(name_among(args, 0), number(args, 1))
        elif role is Role.CLIP_PLANE:
            scene.reader.forget()
        elif role is Role.OTHER_PROGRAM:
            scene.reader.look_for_programs()

    def _clear(self, scene: Scene, role: Role, args: tuple[Any, ...]) -> None:
        if scene.refused or scene.fixed.lists.only_compiles or scene.condition.discards:
            return
        found = clear(role, args)
        if found.colour or found.depth:
            scene.ink.cleared(colour=found.colour)
            self._finish(scene)
            scene.layer.cleared(found)

    @contained
    def after(self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]) -> None:
        """After a call by role."""
        self._after(role, name, args, call)

    @contained
    def failed(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        """After one that PyOpenGL found a GL error of."""
        scene = self._scenes.current()
        if scene is not None and role in _REFUSED:
            self._close(scene)
            if not scene.fixed.lists.is_open:
                return
        self._after(role, name, args, call)  # the error may be older, or the list has it now

    def _after(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> None:
        scene = self._scenes.current()
        if scene is None or scene.refused:
            return
        fixed = scene.fixed
        if role in LIST_CALLS:
            self._lists_called(scene, fixed.lists.names(role, args))
        elif role in POLYGON_DRAWS:
            state = self._close(scene)
            if state is not None or fixed.lists.is_open:
                drawn = fixed.drawn(role, name, args, call, state)
                if state is not None and drawn is not None:
                    self._add(scene, state, drawn)
        elif role in OTHER_DRAWS:
            self._close(scene)
            if role is Role.BITMAP:
                fixed.lists.add(Marks())
        elif role is Role.READ_PIXELS:
            pick_ends(self._sink, scene)
        elif role in IN_LISTS:
            fixed.lists.add(Change.of(name, args))
        elif role in CONDITIONS:
            self._scenes.condition_called(scene, role, args)
        elif role is Role.LIST_OPEN:
            fixed.lists.open(name_among(args, 0), name_among(args, 1))

    @contained
    def refused(self) -> None:
        """PyOpenGL refused the arguments: nothing was drawn."""
        scene = self._scenes.current()
        if scene is not None:
            self._close(scene)
            pick_ends(self._sink, scene)

    def _lists_called(self, scene: Scene, names: tuple[int, ...]) -> None:
        state = scene.drawing
        opening = None if state is None else scene.fixed.lists.left_open(names)
        if opening is None:
            self._close(scene)
        scene.fixed.lists.add(Call(names))
        if state is not None:
            whole = names if opening is None else names[: names.index(opening)]
            self._add(scene, state, Call(whole))
        if opening is not None:  # GL is inside a primitive: it stays covered until that ends
            self._primitive.scene = scene
            scene.fixed.resume(opening)

    # -- shapes drawn in C -----------------------------------------------------------------------

    @contained
    def before_shape(self, name: str) -> None:
        """GLU, GLUT or GLE is about to draw."""
        scene = self._scenes.current()
        self.census.latest = ""
        if scene is not None:
            self._primitive.is_ink = drawing = draws_no_polygons(name)
            if drawing:
                scene.fixed.lists.add(Marks())
            self._open(not drawing, scene, ink=drawing)

    @contained
    def after_shape(self, shape: Shape | None) -> None:
        """It has drawn a shape, or (None) no polygons."""
        scene = self._scenes.current()
        if scene is None:
            return
        state = self._close(scene)
        if shape is None and not (self._idle or self._primitive.is_ink):
            self.census.drew_no_polygons()
        if scene.refused or shape is None:
            return
        scene.fixed.lists.add(shape)
        if state is not None:
            self._add(scene, state, shape)

    # -- draws and layers ------------------------------------------------------------------------

    def _open_polygons(self, scene: Scene, role: Role, args: tuple[Any, ...]) -> None:
        """A draw of POLYGON_DRAWS begins. Some draw lines alone."""
        if role is Role.ARRAY_DRAW:
            polygons = number(args, 0) in POLYGON_MODES
            self._open(polygons, scene, ink=not polygons)
        elif role not in LIST_CALLS:
            self._open(True, scene)
        else:
            ink, materials = scene.fixed.lists.called(role, args)
            self._open(not ink, scene, materials, ink=ink, listed=True)

    def _open(
        self, polygons: bool, scene: Scene, materials: Materials = Materials.STAY, *,
        ink: bool = False, listed: bool = False,
    ) -> None:
        """A draw begins: the layer may end, and its polygons may carry lines. materials: what
        they do during the draw. ink: it draws lines or text. listed: a display list does."""
        scene.drawing = None
        refused = scene.refused or scene.unpainted
        if refused:
            self.census.refused.add(refused)
        if self._idle or refused or scene.fixed.lists.only_compiles:
            return
        layer, gathers = scene.layer, self._sink.gathers_ink
        if not polygons:
            self.census.others += 1
            backs = self._sink.background is not None and layer.backing.awaited
            if not (layer.pending or gathers or backs):
                return
        state = scene.reader.read()
        compiling = scene.fixed.lists.is_open
        if layer.pending and not compiling and (layer.overdue or layer.ends_with(state)):
            self._end_layer(scene, waits=layer.same_target(state))
        obstacle = scene.obstacle(state)
        text = polygons and not (obstacle or compiling) and scene.lettering.draws(state)
        carries = polygons and not (obstacle or text or scene.condition.discards)
        carries = carries and layer.carries(state)
        if self._sink.background is not None and not compiling:
            lay_behind(self._sink, scene, state, carries=carries, polygons=polygons)
        if gathers and not compiling:
            ink = not obstacle and (ink or text or is_wire(state))
            mind_ink(self._sink, scene, state, ink, carries=carries, listed=listed)
        if not polygons:
            return
        if carries:
            scene.drawing = state
            if not compiling:
                if state.camera.lit and layer.lighting is None:
                    layer.lighting = state.camera.lighting
                self._sink.cover(materials)
            return
        if not (obstacle or text or compiling) and is_glass(state, layer, self._sink.background):
            scene.drawing = state  # for its outline: it is not covered
        if obstacle:
            say_once(f"unstyled: polygons drawn while {obstacle}")
        self.census.passes(obstacle or (census.TEXT if text else layer.shortfall(state)))

    def _close(self, scene: Scene) -> DrawState | None:
        """The draw is over: its state if its polygons carry lines."""
        if scene.ink.is_drawn:
            scene.ink.is_drawn = False
            self._sink.ink_gathered()
        state = scene.drawing
        if state is not None:
            self._sink.uncover()
            scene.drawing = None
        return state

    def _add(self, scene: Scene, state: DrawState, drawn: Drawn) -> None:
        """The layer gets what was drawn, from the source that the draw is of."""
        if not state.depth_written:
            scene.layer.add_glass(state, scene.source.polygons(drawn, state))
            return
        before = self.census.carried
        with scene.condition.lifted():
            for polygons, camera in scene.source.polygons(drawn, state):
                scene.layer.add(state, polygons, camera)
                self.census.carries(drawn, polygons)
        self.census.others += self.census.carried == before

    def _end_layer(self, scene: Scene, *, waits: bool = False) -> None:
        """waits: what comes next leaves the depth as it is, so that it may end later, over that."""
        counted = counting()
        scene.layer.overdue = counted and waits
        if scene.layer.overdue:
            return
        layer = scene.layer.take()
        if counted:
            self.census.refused.add(UNCOUNTED)
            say_once(f"unstyled: {UNCOUNTED}")
        elif layer.items:
            with styling(), Held(), scene.condition.lifted():
                self._sink.layer_ends(layer, scene)
        lay_ink(self._sink, scene)

    def _finish(self, scene: Scene, *, waits: bool = False) -> None:
        if scene.layer.pending and not scene.fixed.lists.is_open:
            self._end_layer(scene, waits=waits)
        lay_ink(self._sink, scene)

    @contained
    def finish_frame(self) -> None:
        """A toolkit is about to present the current context's picture."""
        if self._stream.inside():  # an error, or refused: nothing may be said to GL here
            return
        scene = self._scenes.current()
        if scene is not None:
            self._finish(scene)
            scene.ink.shown()
            scene.layer.end_frame()
            scene.fixed.tick()
            self._scenes.frame_ends()
