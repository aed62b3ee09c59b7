"""Follows the app's draws: what the watch hears becomes polygons in its context's layer."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from typing import Any, Protocol, TypeVar

from glshim.bindings.pyopengl import forward
from glshim.bindings.pyopengl.raw import RAW
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.model.batch import POSITIONS, WHOLE, Wanted
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.evaluators import evaluator_key
from glshim.sources.fixed.fetch import Unfetchable
from glshim.sources.fixed.immediate import POLYGON_MODES, QUADS
from glshim.sources.fixed.lights import lighting
from glshim.sources.fixed.lists import Bare, Call, Change, Closing, Opening, Primitive
from glshim.sources.fixed.rectangles import rectangle
from glshim.sources.fixed.state import DrawState, colour
from glshim.sources.scene import Scene, Scenes, normal_of
from glshim.spec.constants import GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT
from glshim.spec.driver import gl
from glshim.spec.roles import BUFFER_WRITES, IN_LISTS, LIST_CALLS, OTHER_DRAWS, POLYGON_DRAWS, Role
from glshim.spec.shapes import Shape

_COLOR_AND_DEPTH = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT
_PICK_AREA = 64
"""A readback of at most so many pixels is an app looking for what lies under the pointer: it gets
the app's own colours. A larger one is a picture and shows the lines."""

F = TypeVar("F", bound=Callable[..., Any])


class Studio(Protocol):
    """Where finished layers go, and who looks after faults."""

    def layer_ends(self, scene: Scene) -> None:
        """The depth of the scene's layer is final."""

    def context_renewed(self) -> None:
        """The current context has the address of one that is gone, and none of its objects."""

    def cover(self) -> None:
        """Polygons that carry lines are about to be drawn by the app."""

    def uncover(self) -> None:
        """They have been drawn."""

    def flush(self, call: Callable[[], Any], scene: Scene | None) -> Any:
        """glFlush or glFinish, which ``call`` makes; it may end a frame."""

    def give_up(self, error: BaseException) -> None:
        """A fault of ours: no more styling; the app's call goes on."""


def contained(method: F) -> F:
    """A fault of ours ends the styling, never the app's call."""

    @functools.wraps(method)
    def safe(self: Follower, *args: Any) -> Any:
        try:
            return method(self, *args)
        except Exception as error:
            self.studio.give_up(error)
            return None

    return safe  # type: ignore[return-value]


class Follower:
    """A `capture.watch.Watcher` and `capture.clibraries.ShapeWatcher`."""

    def __init__(self, studio: Studio) -> None:
        """Of no style yet: :meth:`restyle`."""
        self.studio = studio
        self._idle = True
        """Nothing is drawn: only what lists hold and which buffers were written is followed."""
        self._wanted = POSITIONS
        self._colour = self._normal = b""
        """Records of what a primitive begins with and has until it says another, if wanted."""
        self._scenes = Scenes()
        self._now: Scene | None = None
        self._reruns: list[tuple[int, Callable[[], Any]]] = []
        self._elements: list[tuple[int, int]] = []
        """Positions in the record of glArrayElement calls, and their indices: nothing may be
        asked inside a primitive, so their vertices are fetched at its end."""

    def restyle(self, wanted: Wanted | None) -> None:
        """Polygons shall come with something else from now on, or (None) not at all. What layers
        hold is dropped: between frames nothing."""
        self._idle = wanted is None
        self._wanted = wanted or POSITIONS
        self._scenes.restyle(self._wanted)

    def _recorded(self, scene: Scene) -> Wanted:
        """What is recorded now: in a list all there is, for the styles under which it is called."""
        return WHOLE if scene.lists.open is not None else self._wanted

    # -- primitives ------------------------------------------------------------------------------

    @contained
    def begin(self, mode: int) -> None:
        """Before glBegin."""
        if self._reruns or self._elements:
            self._reruns, self._elements = [], []
        self._now = self._scenes.current()
        self._open(mode in POLYGON_MODES, self._now)
        if self._now is not None and self._now.needs_list_base:
            self._now.read_list_base()
        if self._now is not None:
            self._colour = colour() if self._recorded(self._now).colours else b""
            self._normal = normal_of(self._now.drawing, self._wanted)

    @contained
    def end(self, mode: int, stream: bytes) -> None:
        """After glEnd."""
        scene = self._now
        state = self._close(scene)
        if scene is None or mode not in POLYGON_MODES:
            return
        if self._elements:
            stream = self._with_elements(scene, stream)
        again = self._rerun(mode, stream) if self._reruns else None
        if again is None:
            stream = self._colour + stream
        # A list begins with the normal of whoever calls it, not with today's.
        scene.compile(Shape(None, again) if again else Primitive(mode, stream))
        if state is not None and again:
            scene.add_shape(state, Shape(None, again))
        elif state is not None:
            scene.layer.add_primitive(state, mode, self._normal + stream)

    def _with_elements(self, scene: Scene, stream: bytes) -> bytes:
        """The record with the vertices of glArrayElement in their places."""
        parts: list[bytes] = []
        at = 0
        reruns = list(self._reruns)
        try:
            for position, index in self._elements:
                vertex = scene.array_element(index, self._recorded(scene))
                parts += [stream[at:position], vertex]
                at = position
                self._reruns = [
                    (place + len(vertex) if old >= position else place, call)
                    for (place, call), (old, _) in zip(self._reruns, reruns, strict=True)
                ]
        except Unfetchable as reason:
            say_once(f"unstyled: glArrayElement, because {reason}")
        self._elements = []
        return b"".join((*parts, stream[at:]))

    def _rerun(self, mode: int, stream: bytes) -> Callable[[], None]:
        """Says a primitive with evaluated vertices again."""
        calls = list(self._reruns)

        def draw() -> None:
            gl.glBegin(mode)
            at = 0
            for position, call in calls:
                forward.replay(stream[at:position])
                call()
                at = position
            forward.replay(stream[at:])
            gl.glEnd()

        return draw

    @contained
    def bare(self, stream: bytes) -> None:
        """An open list has vertices outside any primitive of it."""
        scene = self._scenes.current()
        if scene is not None and stream:
            scene.compile(Bare(stream))

    @contained
    def stray_end(self) -> None:
        """An open list ends a primitive that it did not begin."""
        scene = self._scenes.current()
        if scene is not None:
            scene.compile(Closing())

    @contained
    def unfinished(self, mode: int, stream: bytes) -> None:
        """An open list leaves the primitive open that it began."""
        scene = self._scenes.current()
        self._close(scene)
        if scene is not None:
            scene.compile(Opening(mode, self._with_elements(scene, stream)))

    @contained
    def inside(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[[], Any]
    ) -> None:
        """Something that is legal inside glBegin/glEnd was called there, or in an open list."""
        scene = self._scenes.current()
        if scene is None or scene.refused:
            return
        if not RECORDER.inside():  # in a list, between its primitives
            RECORDER.extend(normals.said(name, args))
        elif role is Role.ARRAY_ELEMENT:
            self._elements.append((RECORDER.position(), _number(args, 0)))
        elif role is Role.EVALUATION or role is Role.EVALUATOR_MESH:
            self._reruns.append((RECORDER.position(), call))
        elif role is Role.NORMAL:
            if self._recorded(scene).normals:
                RECORDER.extend(normals.said(name, args))
        elif role in LIST_CALLS:
            finished = scene.list_called_inside(scene.names(role, args, inside=True))
            if finished is not None:
                self.end(*finished)

    # -- draws by role ---------------------------------------------------------------------------

    @contained
    def before(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """Before a call by role."""
        if role in _RENEWALS and self._scenes.renewed():
            self.studio.context_renewed()
        scene = self._scenes.current()
        if scene is None:
            return
        if role in POLYGON_DRAWS:
            self._open(True, scene)
        elif role in OTHER_DRAWS:
            self._open(False, scene)
        elif role in (Role.CLEAR, Role.CLEAR_BUFFER):
            self._clear(scene, _number(args, 0) if role is Role.CLEAR else _COLOR_AND_DEPTH)
        elif role is Role.READ_PIXELS:
            if _number(args, 2) * _number(args, 3) > _PICK_AREA:
                self.finish_layer()
        elif role is Role.READBACK or role is Role.TARGET:
            self.finish_layer()
        elif role in BUFFER_WRITES:
            if not scene.refused:
                scene.fetch.buffer_written(role, args)
        elif role is Role.LIST_CLOSE:
            self._scenes.close_list(scene)
        elif role is Role.LIST_FORGET:
            scene.lists.forget(_number(args, 0), _number(args, 1))
        elif role is Role.CLIP_PLANE:
            scene.reader.forget()

    def _clear(self, scene: Scene, mask: int) -> None:
        if mask & _COLOR_AND_DEPTH:
            self.finish_layer()
        if mask & GL_DEPTH_BUFFER_BIT:
            scene.layer.forget_depth()

    @contained
    def after(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """After a call by role, also when PyOpenGL found a GL error."""
        scene = self._scenes.current()
        if scene is None or scene.refused:
            return
        if role is Role.LIST_OPEN:
            scene.open_list(int(args[0]), int(args[1]))
        elif role in IN_LISTS:
            scene.compile(Change.of(name, args))
        elif role in LIST_CALLS:
            self._lists_called(scene, scene.names(role, args))
        elif role in POLYGON_DRAWS:
            state = self._close(scene)
            if state is not None or scene.lists.open is not None:
                self._drawn(scene, state, role, name, args)
        elif role in OTHER_DRAWS:
            self._close(scene)

    @contained
    def refused(self) -> None:
        """PyOpenGL refused the arguments: nothing was drawn."""
        self._close(self._scenes.current())

    def _lists_called(self, scene: Scene, names: tuple[int, ...]) -> None:
        state = scene.drawing
        opening = None if state is None else scene.left_open(names)
        if opening is None:
            self._close(scene)
        scene.compile(Call(names))
        if state is not None:
            scene.lists_called(state, names, opening)
        if opening is not None:  # GL is inside a primitive: it stays covered until that ends
            self._now = scene
            self._colour = self._normal = b""

    def _drawn(
        self, scene: Scene, state: DrawState | None, role: Role, name: str, args: tuple[Any, ...]
    ) -> None:
        """An array draw, a rectangle or an evaluated grid."""
        if role is Role.EVALUATOR_MESH:
            call = RAW.original(name)
            if call is not None:
                self._shape(scene, state, name, args, functools.partial(call, *args))
        elif role is Role.RECT:
            stream = rectangle(name, args)
            scene.compile(Primitive(QUADS, stream))
            if state is not None:
                scene.layer.add_primitive(state, QUADS, normal_of(state, self._wanted) + stream)
        else:
            try:
                if scene.lists.open is not None:
                    whole = scene.fetch.batch(name, args, WHOLE)
                    if whole is not None:
                        scene.compile(whole)
                batch = None if state is None else scene.fetch.batch(name, args, self._wanted)
            except Unfetchable as reason:
                say_once(f"unstyled: {name}, because {reason}")
                return
            if state is not None and batch is not None:
                current = normal_of(state, self._wanted) if batch.normals is None else b""
                if current:
                    batch = normals.throughout(batch, current)
                scene.layer.add_batch(state, batch)

    def _shape(
        self,
        scene: Scene,
        state: DrawState | None,
        name: str,
        args: tuple[Any, ...],
        draw: Callable[[], Any],
    ) -> None:
        if scene.lists.open is not None:
            # Its map may be set by the list itself: asked when the list is called.
            scene.compile(Shape(None, draw))
        elif state is not None:
            scene.add_shape(state, Shape(evaluator_key(name, args), draw))

    # -- shapes drawn in C -----------------------------------------------------------------------

    @contained
    def before_shape(self, name: str) -> None:
        """GLU, GLUT or GLE is about to draw."""
        self._open(True, self._scenes.current())

    @contained
    def after_shape(self, shape: Shape | None) -> None:
        """It has drawn a shape, or (None) no polygons."""
        scene = self._scenes.current()
        state = self._close(scene)
        if scene is None or scene.refused or shape is None:
            return
        if scene.lists.open is not None:
            scene.compile(shape)
        elif state is not None:
            if shape.camera_bound and shape.key is not None:
                c = state.camera
                view = (c.modelview.tobytes(), c.projection.tobytes(), c.viewport)
                shape = replace(shape, key=(shape.key, view))
            scene.add_shape(state, shape)

    # -- layers ----------------------------------------------------------------------------------

    def _open(self, polygons: bool, scene: Scene | None) -> None:
        """A draw begins: the layer may end, and its polygons may carry lines."""
        if scene is None:
            return
        scene.drawing = None
        if self._idle or scene.refused or scene.unpainted or scene.compiles_only:
            return
        layer = scene.layer
        if not polygons and not layer.pending:
            return
        state = scene.reader.read()
        compiling = scene.lists.open is not None
        if layer.pending and layer.ends_with(state) and not compiling:
            self.studio.layer_ends(scene)
        if not polygons:
            return
        if layer.carries(state):
            scene.drawing = state
            if not compiling:
                if state.camera.lit and layer.lighting is None:
                    layer.lighting = lighting()
                self.studio.cover()
        elif state.obstacle:
            say_once(f"unstyled: polygons drawn while {state.obstacle}")

    def _close(self, scene: Scene | None) -> DrawState | None:
        """The draw is over: its state if its polygons carry lines."""
        if scene is None:
            return None
        state, scene.drawing = scene.drawing, None
        if state is not None:
            self.studio.uncover()
        return state

    @contained
    def finish_layer(self) -> None:
        """The depth of the current context's layer is final."""
        scene = self._scenes.current()
        if scene is not None and scene.layer.pending and not scene.lists.open:
            self.studio.layer_ends(scene)

    @contained
    def finish_frame(self) -> None:
        """A toolkit is about to present the current context's picture."""
        self.finish_layer()
        scene = self._scenes.current()
        if scene is not None:
            scene.layer.end_frame()
            scene.tick()

    def flush(self, call: Callable[[], Any]) -> Any:
        """In place of glFlush or glFinish."""
        return self.studio.flush(call, self._scenes.current())


def _number(args: tuple[Any, ...], position: int) -> int:
    """An integer argument; 0 where there is none, as PyOpenGL will say."""
    try:
        return int(args[position])
    except (IndexError, TypeError, ValueError):
        return 0


_RENEWALS = frozenset((Role.CLEAR, Role.CLEAR_BUFFER, Role.TARGET, Role.LIST_OPEN))
"""When a new context at an old one's address is looked out for: a program that draws comes by."""
