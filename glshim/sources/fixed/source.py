"""The fixed-function pipeline as a source: immediate mode, arrays, display lists, shapes in C."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import suppress
from dataclasses import replace
from typing import Any

from glshim.bindings.base import PrimitiveStream
from glshim.driver.arguments import number
from glshim.driver.ask import integer
from glshim.driver.functions import current_context, gl
from glshim.model.batch import WHOLE, PolygonBatch, Wanted
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.sources.fixed import normals
from glshim.sources.fixed.arrays import Unfetchable
from glshim.sources.fixed.compiler import ListCompiler
from glshim.sources.fixed.current import colour, normal_of
from glshim.sources.fixed.evaluators import evaluator_key
from glshim.sources.fixed.fetch import VertexFetch
from glshim.sources.fixed.materials import material_change
from glshim.sources.fixed.primitive import OpenPrimitive
from glshim.sources.fixed.rectangles import rectangle
from glshim.sources.fixed.shapes import Shapes
from glshim.sources.fixed.steps import Opening
from glshim.sources.source import ArrayDraw, Call, Drawn, Polygons, Primitive
from glshim.sources.state import DrawState
from glshim.spec.attributes import BY_NAME
from glshim.spec.constants import (
    GL_DRAW_FRAMEBUFFER,
    GL_FRAMEBUFFER_COMPLETE,
    GL_MATRIX_MODE,
    GL_QUADS,
)
from glshim.spec.roles import LIST_CALLS, Role
from glshim.spec.shapes import Shape
from glshim.system.interrupts import is_ours

_VERTEX = BY_NAME["glVertex3f"]


class FixedFunction:
    """A `glshim.sources.source.Source`, of one context. What lists hold and which buffers were
    written it follows whether anything is drawn or not. Into a list goes all that can be known
    (`WHOLE`), for the styles under which it is called."""

    def __init__(
        self, stream: PrimitiveStream, wanted: Wanted, shapes: Shapes | None = None
    ) -> None:
        """shapes: that are known already."""
        self.lists = ListCompiler(stream, wanted)
        self.fetch = VertexFetch()
        self._stream = stream
        self._wanted = wanted
        self.shapes = shapes or Shapes()
        self._primitive = OpenPrimitive(stream)

    def restyle(self, wanted: Wanted) -> None:
        """Batches shall come with something else from now on."""
        self._wanted = self.lists.book.wanted = wanted

    def tick(self) -> None:
        """A frame has passed."""
        self.shapes.tick()
        self.fetch.tick()

    # -- what is followed ------------------------------------------------------------------------

    def begin(self, state: DrawState | None) -> None:
        """Before a primitive; state: the one it is drawn in, if its polygons carry lines."""
        primitive, wanted = self._primitive, self._wanted
        if not primitive.is_whole:
            primitive.forget()
        if self.lists.needs_base:
            self.lists.look_at_base()
        colours = wanted.colours or self.lists.is_open
        primitive.colour = colour() if colours else b""
        primitive.normal = normal_of(state, wanted) if wanted.normals else b""

    def end(self, mode: int, record: bytes) -> Drawn:
        """After it: what was drawn. An open list holds it now."""
        primitive = self._primitive
        if not primitive.is_whole:
            record = primitive.with_elements(record, self._element)
            again = primitive.again(mode, record)
            if again is not None:
                shape = Shape(None, again)
                self.lists.add(shape)
                return shape
        record = primitive.colour + record
        if self.lists.is_open:
            # A list begins with the normal of whoever calls it, not with today's.
            self.lists.add(Primitive(mode, record))
        return Primitive(mode, primitive.normal + record)

    def unfinished(self, mode: int, record: bytes) -> None:
        """An open list leaves the primitive open that it began."""
        self.lists.add(Opening(mode, self._primitive.with_elements(record, self._element)))

    def inside(
        self, role: Role, name: str, args: tuple[Any, ...], call: Callable[..., Any]
    ) -> tuple[int, bytes] | None:
        """A call inside a primitive, or between those of an open list. Mode and record of the
        primitive when that has ended it."""
        if not self._stream.inside():
            self._stream.extend(normals.said(name, args))
        elif role is Role.ARRAY_ELEMENT:
            self._primitive.element(number(args, 0))
        elif role is Role.EVALUATION or role is Role.EVALUATOR_MESH:
            self._primitive.evaluation(_again(call, args))
        elif role is Role.NORMAL:
            if self._wanted.normals or self.lists.is_open:
                self._stream.extend(normals.said(name, args))
        elif role is Role.MATERIAL and self.lists.is_open:
            change = material_change(name, args)
            if change is not None:
                self.lists.material_inside(change)
        elif role in LIST_CALLS:
            return self.lists.called_inside(self.lists.names(role, args, inside=True))
        return None

    def drawn(
        self,
        role: Role,
        name: str,
        args: tuple[Any, ...],
        call: Callable[..., Any],
        state: DrawState | None,
    ) -> Drawn | None:
        """What an array draw, a rectangle or an evaluated grid has drawn, None where an open list
        alone holds it now, or where that cannot be known."""
        if role is Role.ARRAY_DRAW:
            arrays = ArrayDraw(name, args)
            if self.lists.is_open:
                whole = self._fetched(arrays, WHOLE)
                if whole is not None:
                    self.lists.add(whole)
            return arrays
        try:
            if role is Role.EVALUATOR_MESH:
                draw = _again(call, args)
                if not self.lists.is_open:
                    return Shape(evaluator_key(name, args), draw)
                # Its map may be set by the list itself: asked when the list is called.
                self.lists.add(Shape(None, draw))
                return None
            record = rectangle(name, args)
        except (TypeError, OverflowError) as reason:
            if not is_ours(reason):
                raise
            say_once(f"unstyled: {name}, because {reason}")
            return None
        self.lists.add(Primitive(GL_QUADS, record))
        return Primitive(GL_QUADS, normal_of(state, self._wanted) + record)

    def resume(self, name: int) -> None:
        """A list was called that left a primitive open, which goes on now."""
        self.lists.resume(name)
        self._primitive.colour = self._primitive.normal = b""

    # -- what it gives ---------------------------------------------------------------------------

    def obstacle(self, state: DrawState) -> str | None:
        """All draws without a program of the app's own are this source's."""
        return None if state.program else ""

    def polygons(self, drawn: Drawn, state: DrawState) -> Iterable[tuple[Polygons, Camera]]:
        """What was drawn, in object space, and the camera of the matrix stacks."""
        if isinstance(drawn, Primitive):
            return ((drawn, state.camera),)
        if isinstance(drawn, Call):
            return self._called(drawn, state.camera)
        if isinstance(drawn, ArrayDraw):
            batch = self._of_arrays(drawn, state)
        else:
            batch = self._of_shape(drawn, state.camera)
        return () if batch is None else ((batch, state.camera),)

    def _of_arrays(self, drawn: ArrayDraw, state: DrawState) -> PolygonBatch | None:
        if gl.glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE:
            return None  # GL has read nothing of the arrays
        batch = self._fetched(drawn, self._wanted)
        if self._wanted.normals and batch is not None and batch.normals is None:
            current = normal_of(state, self._wanted)
            if current:
                batch = normals.throughout(batch, current)
        return batch

    def _of_shape(self, shape: Shape, camera: Camera) -> PolygonBatch | None:
        if self.lists.is_open:  # what is said to the driver now goes into the list
            return None
        if shape.camera_bound and shape.key is not None:
            view = (camera.modelview.tobytes(), camera.projection.tobytes(), camera.viewport)
            shape = replace(shape, key=(shape.key, view))
        return self.shapes.polygons(shape)

    def _called(self, call: Call, camera: Camera) -> Iterable[tuple[PolygonBatch, Camera]]:
        for name in call.names:
            found = self.lists.book.polygons(
                name, integer(GL_MATRIX_MODE), self.shapes.polygons, current_context()
            )
            if found.relative is not None:
                yield found.relative, camera
            for batch, modelview in found.absolute:
                yield batch, replace(camera, modelview=modelview)

    # -- arrays ----------------------------------------------------------------------------------

    def _fetched(self, drawn: ArrayDraw, wanted: Wanted) -> PolygonBatch | None:
        try:
            return self.fetch.batch(drawn.name, drawn.args, wanted)
        except Unfetchable as reason:
            say_once(f"unstyled: {drawn.name}, because {reason}")
            return None

    def _element(self, index: int) -> bytes:
        """The records of the vertex of a glArrayElement call; empty where they cannot be had."""
        try:
            vertex = _VERTEX.pack.pack(*self.fetch.element(index), _VERTEX.tag)
            normals_too = self._wanted.normals or self.lists.is_open
            given = self.fetch.element_normal(index) if normals_too else b""
        except Unfetchable as reason:
            say_once(f"unstyled: glArrayElement, because {reason}")
            return b""
        return given + vertex


def _again(call: Callable[..., Any], args: tuple[Any, ...]) -> Callable[[], None]:
    """Makes a call once more. What GL made an error of draws nothing then, either."""

    def draw() -> None:
        from OpenGL.error import GLError  # not before the app has set its flags

        with suppress(GLError):
            call(*args)

    return draw
