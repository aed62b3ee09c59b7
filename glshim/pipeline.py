"""The composition root: app call -> capture -> assembly -> styler -> render -> frame."""

from __future__ import annotations

import ctypes
import functools
from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import replace
from typing import Any, TypeVar

from .assembly import feedback
from .assembly.batch import PolygonBatch
from .assembly.evaluators import evaluator_key
from .assembly.fetch import Unfetchable, VertexFetch
from .assembly.immediate import POLYGON_MODES, QUADS
from .assembly.layers import LayerCollector
from .assembly.lists import (
    Bare,
    Call,
    Change,
    Closing,
    Item,
    ListBook,
    Opening,
    Primitive,
    Shape,
    list_names,
)
from .assembly.rectangles import rectangle
from .capture import forward, frames
from .capture.clibraries import C_LIBRARIES
from .capture.raw import RAW
from .capture.recorder import RECORDER
from .capture.state import DrawState, StateReader, unsupported
from .capture.watch import WATCH
from .errors import GlshimError
from .notices import say_fault, say_once
from .render.backend import Backend
from .render.surface import Surface
from .spec.attributes import BY_NAME
from .spec.driver import current_context, gl
from .spec.roles import Role
from .styling.protocol import Layer, Styler

_COMPILE, _COMPILE_AND_EXECUTE = 0x1300, 0x1301
_COLOR_AND_DEPTH, _DEPTH_BIT = 0x4100, 0x100
_PICK_AREA = 64
"""A readback of at most so many pixels is an app looking for what lies under the pointer: it gets
the app's own colours. A larger one is a picture and shows the lines."""

F = TypeVar("F", bound=Callable[..., Any])


def _contained(method: F) -> F:
    """A fault of ours ends the styling, never the app's call."""

    @functools.wraps(method)
    def safe(self: Pipeline, *args: Any) -> Any:
        try:
            return method(self, *args)
        except Exception as error:
            self.give_up(error)
            return None

    return safe  # type: ignore[return-value]


class _Context:
    """What belongs to one GL context."""

    def __init__(self) -> None:
        self.refused = unsupported()
        self.reader = StateReader()
        self.layer = LayerCollector()
        self.lists = ListBook()
        self.fetch = VertexFetch()
        self.shapes: OrderedDict[Hashable, PolygonBatch | None] = OrderedDict()
        self.backend: Backend | None = None
        self.compiling = 0
        if self.refused:
            say_once(f"unstyled: {self.refused}; the program runs as it would without a style")


class Pipeline:
    """Watches the app's draws and adds a styler's at the end of each layer."""

    def __init__(self, styler: Styler) -> None:
        self.styler = styler
        self._surface = Surface(styler.surface)
        self._contexts: dict[int, _Context] = {}
        self._now: _Context | None = None
        self._drawing: DrawState | None = None
        self._reruns: list[tuple[int, Callable[[], Any]]] = []
        self._broken = False

    # -- life ----------------------------------------------------------------------------------

    def start(self) -> None:
        """Watch from now on."""
        WATCH.attach(self)
        C_LIBRARIES.attach(self)
        frames.install(self.finish_frame)

    def stop(self) -> None:
        """Watch no more; what is pending is dropped."""
        frames.uninstall(self.finish_frame)
        C_LIBRARIES.detach()
        WATCH.detach()
        self._surface.uncover()

    def give_up(self, error: BaseException) -> None:
        """A fault in the shim or in a styler: said once with its traceback, styling ends."""
        if not self._broken:
            self._broken = True
            say_fault(f"style {self.styler.name!r} is switched off, the program runs on", error)
            self.stop()

    # -- capture: primitives ---------------------------------------------------------------------

    @_contained
    def begin(self, mode: int) -> None:
        """PrimitiveSink: before glBegin."""
        if self._reruns:
            self._reruns = []
        self._now = self._context()
        self._open(mode in POLYGON_MODES, self._now)

    @_contained
    def end(self, mode: int, stream: bytes) -> None:
        """PrimitiveSink: after glEnd."""
        state = self._close()
        context = self._now
        if context is None or mode not in POLYGON_MODES:
            return
        program = context.lists.open
        if program is not None:
            again = self._rerun(mode, stream) if self._reruns else None
            program.items.append(Shape(None, again) if again else Primitive(mode, stream))
        if state is None:
            return
        if self._reruns:
            self._shape(context, state, None, self._rerun(mode, stream))
        else:
            context.layer.add_primitive(state, mode, stream)

    def _rerun(self, mode: int, stream: bytes) -> Callable[[], None]:
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

    @_contained
    def bare(self, stream: bytes) -> None:
        """PrimitiveSink: vertices of a list outside any primitive of it."""
        if stream:
            self._compile(Bare(stream))

    @_contained
    def stray_end(self) -> None:
        """PrimitiveSink: a list ends a primitive that it did not begin."""
        self._compile(Closing())

    @_contained
    def unfinished(self, mode: int, stream: bytes) -> None:
        """PrimitiveSink: a list leaves the primitive open that it began."""
        self._close()
        self._compile(Opening(mode, stream))

    def _compile(self, item: Item) -> None:
        context = self._context()
        if context is not None and context.lists.open is not None:
            context.lists.open.items.append(item)

    @_contained
    def inside(self, name: str, args: tuple[Any, ...], call: Callable[[], Any]) -> None:
        """Watcher: something legal inside glBegin/glEnd was called."""
        context = self._context()
        if context is None or context.refused:
            return
        if name.startswith("glArrayElement"):
            row = BY_NAME["glVertex3f"]
            x, y, z = context.fetch.element(int(args[0]))
            RECORDER.extend(row.pack.pack(x, y, z, row.tag))
        elif name.startswith("glEval"):
            self._reruns.append((RECORDER.position(), call))
        elif name.startswith("glCallList"):
            self._called_inside(context, name, args)

    def _called_inside(self, context: _Context, name: str, args: tuple[Any, ...]) -> None:
        """A list called inside a primitive: it adds vertices, and may end it."""
        names = list_names(name, args, _integer(0x0B32) if name == "glCallLists" else 0)
        if context.lists.open is not None:
            context.lists.open.items.append(Call(names))
        for item in (item for each in names for item in context.lists.items(each)):
            if isinstance(item, Bare):
                RECORDER.extend(item.stream)
            elif isinstance(item, Closing):
                finished = RECORDER.finish()
                if finished is not None:
                    self.end(*finished)

    # -- capture: draws by role ------------------------------------------------------------------

    @_contained
    def before(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """Watcher: before a call by role."""
        if role is Role.CLEAR:
            if name != "glClear" or int(args[0]) & _COLOR_AND_DEPTH:
                self.finish_layer()
                context = self._context()
                if context is not None and (name != "glClear" or int(args[0]) & _DEPTH_BIT):
                    context.layer.forget_depth()
        elif role is Role.READBACK:
            if not (name.startswith("glRead") and int(args[2]) * int(args[3]) <= _PICK_AREA):
                self.finish_layer()
        elif role is Role.TARGET:
            self.finish_layer()
        elif role is Role.BUFFER_WRITE:
            context = self._context()
            if context is not None and not context.refused:
                context.fetch.buffer_written(name, args)
        elif role is Role.LIST_CLOSE:
            self._close_list()
        elif role is Role.CLIP_PLANE:
            context = self._context()
            if context is not None:
                context.reader.forget()
        elif role is Role.LIST_FORGET:
            context = self._context()
            if context is not None:
                context.lists.forget(int(args[0]), int(args[1]))
        elif role in (Role.PIXELS, Role.OPAQUE_DRAW):
            self._open(False, self._context())
        elif role in (Role.ARRAY_DRAW, Role.RECT, Role.EVALUATOR_MESH, Role.LIST_CALL):
            self._open(True, self._context())

    @_contained
    def after(self, role: Role, name: str, args: tuple[Any, ...]) -> None:
        """Watcher: after a call by role."""
        context = self._context()
        if context is None or context.refused:
            return
        if role is Role.LIST_OPEN:
            context.lists.begin(int(args[0]))
            context.compiling = int(args[1])
        elif role in (Role.MATRIX, Role.SWITCH):
            if context.lists.open is not None:
                context.lists.open.items.append(Change.of(name, args))
        elif role is Role.LIST_CALL:
            self._called(context, self._close(), name, args)
        elif role in (Role.ARRAY_DRAW, Role.RECT, Role.EVALUATOR_MESH):
            drawing = self._close()
            if drawing is not None or context.lists.open is not None:
                self._drawn(context, drawing, role, name, args)
        elif role in (Role.PIXELS, Role.OPAQUE_DRAW):
            self._close()

    def _drawn(
        self,
        context: _Context,
        state: DrawState | None,
        role: Role,
        name: str,
        args: tuple[Any, ...],
    ) -> None:
        program = context.lists.open
        if role is Role.EVALUATOR_MESH:
            call = RAW.original(name)
            draw = functools.partial(call, *args) if call is not None else None
            if draw is not None and program is not None:
                program.items.append(Shape(None, draw))
            elif draw is not None and state is not None:
                self._shape(context, state, evaluator_key(name, args), draw)
            return
        if role is Role.RECT:
            stream = rectangle(name, args)
            if program is not None:
                program.items.append(Primitive(QUADS, stream))
            if state is not None:
                context.layer.add_primitive(state, QUADS, stream)
            return
        try:
            batch = context.fetch.batch(name, args)
        except Unfetchable as reason:
            say_once(f"unstyled: {name}, because {reason}")
            return
        if batch is None:
            return
        if program is not None:
            program.items.append(batch)
        if state is not None:
            context.layer.add_batch(state, batch)

    # -- capture: display lists ------------------------------------------------------------------

    def _close_list(self) -> None:
        context = self._context()
        if context is None:
            return
        name = context.lists.end()
        context.compiling = 0
        for other in self._contexts.values():
            if other is not context and name is not None:
                other.lists.redefined_elsewhere(name)

    def _called(
        self, context: _Context, state: DrawState | None, name: str, args: tuple[Any, ...]
    ) -> None:
        names = list_names(name, args, _integer(0x0B32) if name == "glCallLists" else 0)
        if context.lists.open is not None:
            context.lists.open.items.append(Call(names))
        if context.compiling == _COMPILE:
            return
        if state is None:
            return
        for each in names:
            if context.lists.leaves_open(each):
                self._left_open(context, state, each)
                return
            found = context.lists.polygons(
                each, _integer(0x0BA0), functools.partial(self._polygons, context), current_context()
            )
            if found.relative is not None:
                context.layer.add_batch(state, found.relative)
            for batch, modelview in found.absolute:
                context.layer.add_batch(state, batch, replace(state.camera, modelview=modelview))

    def _left_open(self, context: _Context, state: DrawState, name: int) -> None:
        """The primitive goes on after the list that began it, recorded as any other."""
        mode, stream = 0, b""
        for item in context.lists.items(name):
            if isinstance(item, Opening):
                mode, stream = item.mode, item.stream
        RECORDER.resume(mode, stream)
        self._now, self._drawing = context, state

    # -- capture: shapes drawn in C ----------------------------------------------------------------

    @_contained
    def before_shape(self, name: str) -> None:
        """ShapeWatcher: GLU, GLUT or GLE is about to draw."""
        self._open(True, self._context())

    @_contained
    def after_shape(
        self, name: str, key: Hashable | None, draw: Callable[[], Any] | None, camera_bound: bool
    ) -> None:
        """ShapeWatcher: it has drawn."""
        state = self._close()
        context = self._context()
        if context is None or context.refused or draw is None:
            return
        if context.lists.open is not None:
            context.lists.open.items.append(Shape(key, draw))
            return
        if state is None:
            return
        if camera_bound and key is not None:
            camera = state.camera
            key = (key, camera.modelview.tobytes(), camera.projection.tobytes(), camera.viewport)
        self._shape(context, state, key, draw)

    def _shape(
        self, context: _Context, state: DrawState, key: Hashable | None, draw: Callable[[], Any]
    ) -> None:
        batch = self._polygons(context, key, draw)
        if batch is not None:
            context.layer.add_batch(state, batch)

    def _polygons(
        self, context: _Context, key: Hashable | None, draw: Callable[[], Any]
    ) -> PolygonBatch | None:
        """A shape's polygons, from feedback mode the first time."""
        if key is None:
            return feedback.polygons(draw)
        if key in context.shapes:
            context.shapes.move_to_end(key)
            return context.shapes[key]
        batch = context.shapes[key] = feedback.polygons(draw, ("shape", key))
        if len(context.shapes) > 256:
            context.shapes.popitem(last=False)
        return batch

    # -- layers and frames -------------------------------------------------------------------------

    def _context(self) -> _Context | None:
        handle = current_context()
        if not handle:
            return None
        context = self._contexts.get(handle)
        if context is None:
            context = self._contexts[handle] = _Context()
        return context

    def _open(self, polygons: bool, context: _Context | None) -> None:
        """A draw begins: the layer may end, and its polygons may carry lines."""
        self._drawing = None
        if context is None or context.refused:
            return
        compiling = context.lists.open is not None
        if compiling and context.compiling != _COMPILE_AND_EXECUTE:
            return
        layer = context.layer
        if not polygons and not layer.pending:
            return
        state = context.reader.read()
        if layer.pending and layer.ends_with(state) and not compiling:
            self._finish(context)
        if not polygons:
            return
        if layer.carries(state):
            self._drawing = state
            if self._surface.changes and not compiling:
                self._surface.cover()
        elif state.obstacle:
            say_once(f"unstyled: polygons drawn while {state.obstacle}")

    def _close(self) -> DrawState | None:
        """The draw is over: its state if its polygons carry lines."""
        state, self._drawing = self._drawing, None
        if self._surface.changes:
            self._surface.uncover()
        return state

    @_contained
    def finish_layer(self) -> None:
        """The depth of the current context's layer is final: add the extra geometry."""
        context = self._context()
        if context is not None and context.layer.pending and not context.lists.open:
            self._finish(context)

    def _finish(self, context: _Context) -> None:
        items = context.layer.take()
        if not items:
            return
        draws = list(self.styler.draws(Layer(items)))
        if not draws:
            return
        try:
            if context.backend is None:
                context.backend = Backend.attach()
            context.backend.render(draws)
        except GlshimError as error:
            context.refused = str(error)
            say_once(f"unstyled: {error}; the program runs as it would without a style")

    @_contained
    def finish_frame(self) -> None:
        """A toolkit is about to present the current context's picture."""
        self.finish_layer()
        context = self._context()
        if context is not None:
            context.layer.forget_depth()

    def flush(self, call: Callable[[], Any]) -> Any:
        """Watcher: glFlush and glFinish end the frame of a single-buffered or off-screen context."""
        context = self._context()
        if context is None or context.refused or _integer(0x0C32):
            return call()
        return frames.present(call)


def _integer(name: int) -> int:
    value = ctypes.c_int(0)
    gl.glGetIntegerv(name, ctypes.byref(value))
    return value.value


_current: Pipeline | None = None


def install(style: str | Styler) -> None:
    """Restyle this process's OpenGL from now on, in a style given as text or as a styler.

    May be called before or after the app has imported PyOpenGL, and again with another style.
    Raises StyleError for a text that names no style; nothing is installed then.
    """
    global _current
    if isinstance(style, str):
        from .options import parse_style

        style = parse_style(style)
    if _current is not None:
        _current.stop()
        _current = None
    if not RAW.installed:
        RAW.install()
        RECORDER.install()
        WATCH.install()
    if style.wants_polygons:
        _current = Pipeline(style)
        _current.start()


def uninstall() -> None:
    """Leave PyOpenGL and the toolkits as they were found."""
    global _current
    if _current is not None:
        _current.stop()
        _current = None
    if RAW.installed:
        WATCH.uninstall()
        RECORDER.uninstall()
        RAW.uninstall()
