"""What belongs to one GL context: its lists, buffers, shapes and current layer."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Hashable
from dataclasses import replace
from typing import Any

from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.model.batch import POSITIONS, PolygonBatch, Wanted
from glshim.model.caches import AgingCache
from glshim.notices import say_once
from glshim.sources.fixed import feedback, normals
from glshim.sources.fixed.fetch import VertexFetch
from glshim.sources.fixed.immediate import scaled
from glshim.sources.fixed.lists import Bare, Call, Closing, Item, ListBook, Opening, list_names
from glshim.sources.fixed.state import DrawState, StateReader, normal, unsupported
from glshim.sources.layers import LayerCollector
from glshim.spec.ask import integer
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import (
    GL_COMPILE,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FRAMEBUFFER,
    GL_LIST_BASE,
    GL_MATRIX_MODE,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_VERTEX_ARRAY_BINDING,
)
from glshim.spec.context import has_vertex_arrays
from glshim.spec.driver import current_context, gl
from glshim.spec.roles import Role
from glshim.spec.shapes import Shape

_MARKER = 997


class Scene:
    """The book-keeping of one context. Make it while that context is current."""

    def __init__(self, wanted: Wanted = POSITIONS) -> None:
        """wanted: what batches shall come with."""
        self.refused = unsupported()
        """Why nothing can be styled here; empty when it can."""
        self.unpainted = ""
        """Why the style that is on cannot be drawn here; empty when it can. Lists and buffers are
        followed all the same, for another one."""
        self.reader = StateReader(lighting=wanted.lights)
        self.layer = LayerCollector(wanted)
        self.drawing: DrawState | None = None
        """State of the draw that is under way, if its polygons carry lines."""
        self.lists = ListBook(wanted)
        self.fetch = VertexFetch()
        self._shapes: AgingCache[tuple[PolygonBatch | None]] = AgingCache()
        self._compiling = 0
        self._marker = 0
        self._list_base = 0
        self._partial_lists = False

    def restyle(self, wanted: Wanted) -> None:
        """Batches shall come with something else from now on, in a layer that begins anew. Lists,
        buffers and shapes stay known."""
        self.unpainted = ""
        self.reader = StateReader(lighting=wanted.lights)
        self.layer = LayerCollector(wanted)
        self.lists.wanted = wanted

    def mark(self) -> None:
        """Leave a mark in the context, so that :attr:`stale` can tell. When the first layer ends:
        until then nothing of ours is in it."""
        if not self._marker:
            self._marker = _mark()

    @property
    def stale(self) -> bool:
        """Whether the current context is another one, at the address of the one that was."""
        if not self._marker:
            return False
        is_there = gl.glIsVertexArray if has_vertex_arrays() else gl.glIsFramebuffer
        return not is_there(self._marker)

    # -- display lists ---------------------------------------------------------------------------

    @property
    def compiles_only(self) -> bool:
        """A list is open that does not draw while it is compiled."""
        return self.lists.open is not None and self._compiling == GL_COMPILE

    def open_list(self, name: int, mode: int) -> None:
        """glNewList."""
        self.lists.begin(name)
        self._compiling = mode

    def compile(self, item: Item) -> None:
        """Note what an open list holds; without an open list, nothing."""
        if self.lists.open is not None:
            if not isinstance(item, Bare):
                RECORDER.settle()  # what was said before it comes before it
            self.lists.open.items.append(item)
            if isinstance(item, (Bare, Closing)):
                self._partial_lists = True

    @property
    def needs_list_base(self) -> bool:
        """Whether a list called inside a primitive may matter: it adds vertices or ends it."""
        return self._partial_lists or self.lists.open is not None

    def read_list_base(self) -> None:
        """Ask for it before a primitive: inside, nothing may be asked."""
        self._list_base = integer(GL_LIST_BASE)

    def names(self, role: Role, args: tuple[Any, ...], *, inside: bool = False) -> tuple[int, ...]:
        """The lists that a call of LIST_CALLS runs."""
        if role is Role.LIST_CALL:
            return list_names(role, args, 0)
        return list_names(role, args, self._list_base if inside else integer(GL_LIST_BASE))

    def left_open(self, names: tuple[int, ...]) -> int | None:
        """The first list that, called, ends inside a primitive that it began."""
        return next(filter(self.lists.leaves_open, names), None)

    def lists_called(self, state: DrawState, names: tuple[int, ...], opening: int | None) -> None:
        """Lists were drawn in this state, up to the one that left a primitive open, if any: its
        rest is recorded from now on."""
        for name in names:
            if name == opening:
                self._resume(name)
                return
            found = self.lists.polygons(
                name, integer(GL_MATRIX_MODE), self.polygons, current_context()
            )
            if found.relative is not None:
                self.layer.add_batch(state, found.relative)
            for batch, modelview in found.absolute:
                self.layer.add_batch(state, batch, replace(state.camera, modelview=modelview))

    def _resume(self, name: int) -> None:
        said = b""
        for item in self.lists.items(name):
            if isinstance(item, Opening):
                RECORDER.resume(item.mode, normals.after(said, normals.UNKNOWN) + item.stream)
            # The list's own normal before it, if nothing else came between.
            said = item.stream if isinstance(item, Bare) else b""

    def list_called_inside(self, names: tuple[int, ...]) -> tuple[int, bytes] | None:
        """Lists were called inside a primitive: they add vertices. Mode and stream of the primitive
        when they ended it."""
        self.compile(Call(names))
        for item in (item for name in names for item in self.lists.items(name)):
            if isinstance(item, Bare):
                RECORDER.extend(item.stream)
            elif isinstance(item, Closing):
                return RECORDER.finish()
        return None

    # -- vertices and shapes ---------------------------------------------------------------------

    def array_element(self, index: int, wanted: Wanted) -> bytes:
        """The records of the vertex of a glArrayElement call."""
        row = BY_NAME["glVertex3f"]
        vertex = row.pack.pack(*self.fetch.element(index), row.tag)
        return (self.fetch.element_normal(index) if wanted.normals else b"") + vertex

    def polygons(self, shape: Shape) -> PolygonBatch | None:
        """Polygons of a shape that C code draws, from feedback mode the first time."""
        if shape.key is None:
            return feedback.polygons(shape.draw) if feedback.possible() else None
        unit = self._kept(("shape", shape.key), lambda key: feedback.polygons(shape.draw, key))
        if unit is None or shape.scale == 1.0:
            return unit
        key = ("shape", shape.key, shape.scale)
        return self._kept(key, lambda key: scaled(unit, shape.scale, key))

    def _kept(
        self, key: Hashable, make: Callable[[Hashable], PolygonBatch | None]
    ) -> PolygonBatch | None:
        found = self._shapes.get(key)
        if found is None:
            if not feedback.possible():
                return None
            batch = make(key)
            size = batch.positions.nbytes if batch is not None else 1
            found = self._shapes.put(key, (batch,), size)
        return found[0]

    def tick(self) -> None:
        """A frame has passed."""
        self._shapes.tick()
        self.fetch.tick()

    def add_shape(self, state: DrawState, shape: Shape) -> None:
        """C code drew a shape in this state."""
        batch = self.polygons(shape)
        if batch is not None:
            self.layer.add_batch(state, batch)


class Scenes:
    """The scenes of this process by context."""

    def __init__(self, wanted: Wanted = POSITIONS) -> None:
        self._wanted = wanted
        self._by_context: dict[int, Scene] = {}

    def current(self) -> Scene | None:
        """The current context's scene; None without a context."""
        handle = current_context()
        if not handle:
            return None
        scene = self._by_context.get(handle)
        if scene is None:
            scene = self._by_context[handle] = Scene(self._wanted)
            if scene.refused:
                say_unstyled(scene.refused)
        return scene

    def restyle(self, wanted: Wanted) -> None:
        """`Scene.restyle`, of all."""
        self._wanted = wanted
        for scene in self._by_context.values():
            scene.restyle(wanted)

    def renewed(self) -> bool:
        """Look whether the current context is new, at an old one's address; it gets a new scene
        then. Ask now and then, outside primitives: at a clear, before a list."""
        scene = self._by_context.get(current_context())
        if scene is None or not scene.stale:
            return False
        del self._by_context[current_context()]
        return True

    def close_list(self, scene: Scene) -> None:
        """glEndList. Other contexts may share the list that changed."""
        name = scene.lists.end()
        if name is not None:
            for other in self._by_context.values():
                if other is not scene:
                    other.lists.redefined_elsewhere(name)


def normal_of(state: DrawState | None, wanted: Wanted) -> bytes:
    """The record of the normal that holds where a draw says none, if wanted. A style that wants
    lights takes it for none where nothing is lit: it is left over from something else."""
    if not wanted.normals or state is None:
        return b""
    return b"" if wanted.lights and not state.camera.lit else normal()


def _mark() -> int:
    """An object of a kind that contexts do not share, under a name that no app comes to: a vertex
    array, or where there are none a framebuffer."""
    arrays = has_vertex_arrays()
    names = (ctypes.c_uint * _MARKER)()
    if arrays:
        bound = integer(GL_VERTEX_ARRAY_BINDING)
        gl.glGenVertexArrays(_MARKER, names)
        gl.glDeleteVertexArrays(_MARKER - 1, names)
        gl.glBindVertexArray(names[_MARKER - 1])
        gl.glBindVertexArray(bound)
    else:
        bounds = (
            (GL_DRAW_FRAMEBUFFER, integer(GL_DRAW_FRAMEBUFFER_BINDING)),
            (GL_READ_FRAMEBUFFER, integer(GL_READ_FRAMEBUFFER_BINDING)),
        )
        gl.glGenFramebuffers(_MARKER, names)
        gl.glDeleteFramebuffers(_MARKER - 1, names)
        gl.glBindFramebuffer(GL_FRAMEBUFFER, names[_MARKER - 1])
        for target, name in bounds:
            gl.glBindFramebuffer(target, name)
    return int(names[_MARKER - 1])


def say_unstyled(why: str) -> None:
    """Once: nothing can be styled in a context."""
    say_once(f"unstyled: {why}; the program runs as it would without a style")
