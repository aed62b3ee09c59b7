"""Runs passes of stylers over recovered meshes (`glshim.styling.passes`)."""

from __future__ import annotations

import ctypes
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import hypot, isfinite
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.errors import RenderError
from glshim.geometry.meshshaders.poses import Keyframes, Pose
from glshim.linework.groups import lens_of
from glshim.linework.objects import Objects
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.programs import Program
from glshim.outputs.gl.device.textures import Textures
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, inputs_of, scissor, stencil, turned
from glshim.outputs.gl.frame.colour import UNIT as COLOUR_UNIT
from glshim.outputs.gl.frame.colour import ColourCopy
from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.outputs.gl.passes.gbuffer import UNIT as GBUFFER_UNIT
from glshim.outputs.gl.passes.gbuffer import GBuffer
from glshim.outputs.gl.passes.meshes import UNITS, Posed, Resident, Residents
from glshim.outputs.gl.passes.meshprograms import MeshPrograms
from glshim.outputs.gl.passes.sieved import UNIT as SIEVED_UNIT
from glshim.outputs.gl.passes.stage import NOTHING_DRAWN, Stage
from glshim.spec.driver import gl
from glshim.styling.passes import VERTICES, Comparison, Pass, State, Stencil
from glshim.styling.values import Body

_MODES = {"lines": 0x0001, "triangles": 0x0004, "quads": 0x0007}
_BY_INDEX = {"surface": (0x0004, 3), "adjacency": (0x000C, 6), "lines": (0x000A, 4)}
"""Elements that are drawn by index: the mode, and indices of each."""
_TESTS = {"never": 0x0200, "less": 0x0201, "equal": 0x0202, "lequal": 0x0203, "greater": 0x0204,
          "notequal": 0x0205, "gequal": 0x0206, "always": 0x0207}  # fmt: skip
_TURNED: dict[Comparison, Comparison] = {
    "less": "greater", "lequal": "gequal", "greater": "less", "gequal": "lequal"
}  # fmt: skip
_ACTIONS = {"keep": 0x1E00, "replace": 0x1E01, "increase": 0x8507, "decrease": 0x8508, "zero": 0}
_BLEND, _CULL, _STENCIL, _DEPTH_TEST = 0x0BE2, 0x0B44, 0x0B90, 0x0B71
_OFFSET, _OFFSET_LINE, _CLAMP, _PRIMITIVE_RESTART = 0x8037, 0x2A02, 0x864F, 0x8F9D
_ARRAY_BUFFER, _UNSIGNED_INT = 0x8892, 0x1405
_FEEDBACK_BUFFER, _DISCARD, _GENERATED = 0x8C8E, 0x8C89, 0x8C87
_UNITS = UNITS | {
    "mesh_sieved": SIEVED_UNIT, "app_colour": COLOUR_UNIT, "gbuffer": GBUFFER_UNIT
}  # fmt: skip


class Runner:
    """Draws passes in one context. Make and use it inside the state guard."""

    def __init__(self, context: Any, objects: Objects, most_bytes: int) -> None:
        self._context = context
        self.residents = Residents(objects, most_bytes)
        self._stage = Stage()
        self._colour = ColourCopy()
        self._gbuffer: GBuffer | None = None
        self._programs = MeshPrograms(context)
        array = ctypes.c_uint()
        gl.glGenVertexArrays(1, ctypes.addressof(array))
        self._array = array.value
        gl.glBindVertexArray(self._array)
        # Compatibility contexts draw nothing without an array 0: one value for all vertices.
        self._nothing = context.buffer(np.zeros(4, np.float32))
        gl.glBindBuffer(_ARRAY_BUFFER, self._nothing.glo)
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, 0x1406, 0, 0, None)
        gl.glVertexAttribDivisor(0, 1 << 30)

    def run(
        self,
        passes: Sequence[Pass],
        window: int,
        box: Box,
        depth: DepthCopy,
        textures: Textures,
        *,
        last: Camera,
        greater: bool,
        hair: float,
    ) -> None:
        """All passes on the stage, which then goes over the window where the stencil test of the
        last camera lets it. greater: the app's depth test lets greater depths win; hair in window
        depth."""
        deep = any(one.state.depth != "always" or one.state.writes_depth for one in passes)
        self._stage.open(box, deep=deep)
        if any("app_colour" in one.shader.fragment for one in passes):
            self._colour.take(window, box)
        before = False
        views: dict[Hashable, dict[str, Any] | None] = {}
        for one in passes:
            if one.image is not None:
                textures.bind(one.image)
            gl.glScissor(*box)  # what a pass clears
            if one.buffer != before:
                self._turn_to_buffer(box, greater) if one.buffer else self._stage.reopen()
                before = one.buffer
            _set(one.state, greater)
            for body in one.bodies:
                camera = body.camera.affine()
                if not all(map(isfinite, camera.modelview.ravel().tolist())):
                    continue
                lens = lens_of(camera)
                if lens not in views:
                    view, away = turned(camera, greater)
                    views[lens] = inputs_of(view, depth, away=away, hair=hair)
                inputs = views[lens]
                if inputs is None:
                    continue
                self._draw(one, replace(body, camera=camera), inputs, box)
            self.residents.release()
        if before:
            self._stage.reopen()
        _set(State(depth="always", blend="off"), greater)
        stencil(last)
        self._stage.put_over(window, box)

    def _turn_to_buffer(self, box: Box, greater: bool) -> None:
        """Draw into the G-buffer, empty, from now on; it can be read after that."""
        if self._gbuffer is None:
            self._gbuffer = GBuffer()
        self._gbuffer.open(box, greater=greater)
        self._gbuffer.bind_texture()

    def varyings(
        self, one: Pass, names: Mapping[str, int], *, depth: DepthCopy, hair: float
    ) -> list[dict[str, NDArray[np.float32]]]:
        """What the vertex shader of a pass makes of each body: (elements, vertices, size) by name,
        for names and their sizes (floats); with a geometry shader what that makes, (triangles, 3,
        size). Transform feedback; what tests hold to the numpy references."""
        found = []
        for body in one.bodies:
            camera = body.camera.affine()
            inputs = inputs_of(camera, depth, away=1.0, hair=hair)
            if inputs is None:
                raise RenderError("this camera sees nothing")
            gl.glBindVertexArray(self._array)
            ready = self._ready(one, replace(body, camera=camera), inputs, tuple(names))
            if ready is None:
                raise RenderError("this pose is another mesh's")
            width = sum(names.values())
            gl.glUseProgram(ready.program.name)
            gl.glEnable(_DISCARD)
            by_index = one.element in _BY_INDEX
            shape, kind = (ready.elements, ready.each), 0x0004 if by_index else 0
            if one.shader.geometry:
                shape, kind = (_triangles_of(one, ready), 3), 0x0004
            count = shape[0] * shape[1]
            target = self._context.buffer(reserve=max(count, 1) * width * 4)
            gl.glBindBufferBase(_FEEDBACK_BUFFER, 0, target.glo)
            gl.glBeginTransformFeedback(kind)
            _issue(one, ready, mode=0)
            gl.glEndTransformFeedback()
            gl.glDisable(_DISCARD)
            ready.release()
            rows = np.frombuffer(target.read(), np.float32)[: count * width]
            rows = rows.reshape(*shape, width)
            target.release()
            ends = np.cumsum(list(names.values()))
            found.append(
                {
                    name: rows[..., end - size : end]
                    for (name, size), end in zip(names.items(), ends, strict=True)
                }
            )
            self.residents.release()
        return found

    def _draw(self, one: Pass, body: Body, inputs: dict[str, Any], box: Box) -> None:
        gl.glBindVertexArray(self._array)
        ready = self._ready(one, body, inputs)
        if ready is None:
            return
        camera = body.camera
        gl.glViewport(*camera.viewport)
        gl.glDepthRange(*camera.depth_range)
        scissor(camera, box)
        gl.glUseProgram(ready.program.name)
        _issue(one, ready)
        ready.release()

    def _ready(
        self, one: Pass, body: Body, inputs: dict[str, Any], varyings: tuple[str, ...] = ()
    ) -> _Ready | None:
        """A pass over a body with its textures bound and its uniforms set."""
        camera = body.camera
        resident: Resident | None = None
        count, each = 1, 3
        if one.element != "screen":
            resident = self.residents.find(body.batches, one.weld.creases, one.weld.tolerance)
            count = resident.count(one.element)
            each = VERTICES[one.primitives.kind] * one.primitives.each
            if one.element in _BY_INDEX:
                each = _BY_INDEX[one.element][1]
            least = one.sieve.shortest if one.sieve is not None else 0.0
            if least and not resident.sieved.extent.pixels(camera) >= least:
                return None
        posed = None
        if one.pose is not None and resident is not None:
            if _size_of(one.pose) != len(resident.mesh.positions):
                say_once(
                    f"style shader {one.shader.name!r} is left out: its pose has "
                    f"{_size_of(one.pose)} vertices, the mesh {len(resident.mesh.positions)}"
                )
                return None
            posed = Posed(one.pose)
        sieve = one.sieve if posed is None else None
        program = self._programs.find(
            one.shader, one.pose, sieved=sieve is not None,
            planes=min(len(camera.clip_planes), MOST_CLIP_PLANES), varyings=varyings,
        )  # fmt: skip
        lit = program.wants("light")
        if lit and one.light is None:
            raise RenderError(
                f"shader {one.shader.name!r} reads `light`: give its Pass light=layer.light, or "
                "light=HEADLIGHT for one at the viewer"
            )
        seen = seen_from(camera, one.light if lit else None)
        if resident is not None and sieve is not None:
            count = resident.sieved.bind(np.array(seen["eye"]), sieve, one.element)
            if not count:
                return None
        for values in (inputs, seen, _UNITS, {"vertices_each": each}):
            program.set(values)
        program.set(one.uniforms)
        if isinstance(one.pose, Keyframes):
            program.set({"share": one.pose.share})
        elif one.pose is not None:
            program.set({"bones": one.pose.matrices.transpose(0, 2, 1)})
        if resident is not None:
            if "rest(" in one.shader.vertex:
                self.residents.bind_rest(resident.mesh)  # first: it may upload where others lie
            resident.bind()
            if one.element in _BY_INDEX and sieve is None:
                resident.bind_indices(one.element)
        if posed is not None:
            posed.bind()
        return _Ready(program, count, each, posed)


@dataclass(frozen=True, slots=True)
class _Ready:
    """A program with all that it reads."""

    program: Program
    elements: int
    each: int
    """Vertices of an element."""
    posed: Posed | None

    def release(self) -> None:
        if self.posed is not None:
            self.posed.release()


def _issue(one: Pass, ready: _Ready, mode: int | None = None) -> None:
    """The draw itself; mode: of what is not drawn by index, else the pass's own."""
    count = ready.elements * ready.each
    if count and one.element in _BY_INDEX:
        gl.glDrawElementsInstanced(
            _BY_INDEX[one.element][0], count, _UNSIGNED_INT, None, one.primitives.copies
        )
    elif count:
        own = _MODES[one.primitives.kind] if mode is None else mode
        gl.glDrawArraysInstanced(own, 0, count, one.primitives.copies)


def _triangles_of(one: Pass, ready: _Ready) -> int:
    """How many triangles a geometry shader makes."""
    query, found = ctypes.c_uint(), ctypes.c_uint()
    gl.glGenQueries(1, ctypes.addressof(query))
    gl.glBeginQuery(_GENERATED, query.value)
    _issue(one, ready)
    gl.glEndQuery(_GENERATED)
    gl.glGetQueryObjectuiv(query.value, 0x8866, ctypes.addressof(found))
    gl.glDeleteQueries(1, ctypes.addressof(query))
    return found.value


def seen_from(camera: Camera, light: Sequence[float] | None = None) -> dict[str, Any]:
    """The uniforms of ``mesh.glsl`` that tell where the viewer and, if asked for, the light are;
    light is homogeneous, in eye space."""
    way = _way(camera.projection.tobytes())
    turned_round = float(np.linalg.det(camera.modelview[:3, :3])) < 0.0
    if turned_round:
        way = -way
    x, y, z, w = (camera.object_centre * way).tolist()
    point = abs(w) > 0.0 and w > 1e-12 * max(abs(x), abs(y), abs(z))
    scale = max(w if point else hypot(x, y, z), 1e-300)
    found = {
        "modelview": camera.modelview.T,
        "eye": (x / scale, y / scale, z / scale, w / scale),
        "facing": way * (1.0 if camera.front_ccw else -1.0),
    }
    if light is not None:
        try:
            lamp = np.linalg.inv(camera.modelview) @ np.asarray(light, np.float64)
        except np.linalg.LinAlgError:
            lamp = np.array((0.0, 0.0, 1.0, 0.0))
        found["light"] = tuple(lamp.tolist())
    return found


@lru_cache(maxsize=64)
def _way(projection: bytes) -> float:
    """1 where `Camera.centre` points to the viewer, else -1; 0 where nothing is seen."""
    lens = Camera(np.eye(4), np.frombuffer(projection).reshape(4, 4), (0, 0, 1, 1))
    return float(np.sign(lens.centre @ lens.viewpoint))


def _size_of(pose: Pose) -> int:
    return len(pose.positions[0] if isinstance(pose, Keyframes) else pose.positions)


def _set(state: State, greater: bool) -> None:
    """The fixed state of a pass."""
    # Not only let through by it: a driver in software would look depths up all the same.
    _switch(_DEPTH_TEST, state.depth != "always" or state.writes_depth)
    test = _TURNED.get(state.depth, state.depth) if greater else state.depth
    gl.glDepthFunc(_TESTS[test])
    gl.glDepthMask(int(state.writes_depth))
    gl.glColorMask(*[int(state.writes_colour)] * 4)
    _switch(_BLEND, state.blend != "off")
    gl.glBlendEquation(0x8008 if state.blend == "greatest" else 0x8006)
    gl.glBlendFunc(1, 0x0303)
    _switch(_CULL, state.cull != "none")
    if state.cull != "none":
        gl.glCullFace(0x0404 if state.cull == "front" else 0x0405)
    factor, units = state.offset
    for capability in (_OFFSET, _OFFSET_LINE):
        _switch(capability, factor != 0.0 or units != 0.0)
    way = -1.0 if greater else 1.0
    gl.glPolygonOffset(way * factor, way * units)
    _switch(_CLAMP, state.clamps)
    gl.glDisable(_PRIMITIVE_RESTART)
    _stencil(state.stencil, state.clears_stencil)


def _stencil(stencil: Stencil | None, clears: bool) -> None:
    gl.glStencilMask(0xFF)
    if clears:
        gl.glClearStencil(NOTHING_DRAWN)
        gl.glClear(0x0400)
    _switch(_STENCIL, stencil is not None)
    if stencil is None:
        return
    gl.glStencilFunc(_TESTS[stencil.test], stencil.reference, 0xFF)
    for face, actions in ((0x0404, stencil.front), (0x0405, stencil.back)):
        gl.glStencilOpSeparate(face, *(_ACTIONS[action] for action in actions))


def _switch(capability: int, on: bool) -> None:
    (gl.glEnable if on else gl.glDisable)(capability)
