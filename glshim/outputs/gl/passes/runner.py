"""Runs passes of stylers over recovered meshes (`glshim.styling.passes`)."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import hypot, isfinite
from typing import Any

import numpy as np

from glshim.driver.functions import gl
from glshim.errors import RenderError
from glshim.geometry.meshshaders.poses import Keyframes, Pose
from glshim.linework.objects import Objects
from glshim.linework.touching import Touching
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import put_away
from glshim.outputs.gl.device.buffers import Buffer
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.textures import Textures
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, inputs_of, scissor, stencil, turned
from glshim.outputs.gl.frame.colour import UNIT as COLOUR_UNIT
from glshim.outputs.gl.frame.colour import ColourCopy
from glshim.outputs.gl.frame.depth import Box
from glshim.outputs.gl.frame.frame import Frame
from glshim.outputs.gl.passes.gbuffer import UNIT as GBUFFER_UNIT
from glshim.outputs.gl.passes.gbuffer import GBuffer
from glshim.outputs.gl.passes.meshes import UNITS, Posed, Resident, Residents
from glshim.outputs.gl.passes.meshprograms import MeshPrograms
from glshim.outputs.gl.passes.sieved import UNIT as SIEVED_UNIT
from glshim.outputs.gl.passes.stage import Stage
from glshim.outputs.gl.passes.state import set_state
from glshim.outputs.gl.passes.together import Together
from glshim.spec.constants import (
    GL_FLOAT,
    GL_LINES,
    GL_LINES_ADJACENCY,
    GL_QUADS,
    GL_TRIANGLES,
    GL_TRIANGLES_ADJACENCY,
    GL_UNSIGNED_INT,
)
from glshim.styling.passes import VERTICES, Pass, State
from glshim.styling.values import Body

_MODES = {"lines": GL_LINES, "triangles": GL_TRIANGLES, "quads": GL_QUADS}
BY_INDEX = {
    "surface": (GL_TRIANGLES, 3), "adjacency": (GL_TRIANGLES_ADJACENCY, 6),
    "lines": (GL_LINES_ADJACENCY, 4),
}  # fmt: skip
"""Elements that are drawn by index: the mode, and indices of each."""
_UNITS = UNITS | {
    "mesh_sieved": SIEVED_UNIT, "app_colour": COLOUR_UNIT, "gbuffer": GBUFFER_UNIT
}  # fmt: skip


class Runner:
    """Draws passes in one context. Make and use it inside the state guard."""

    def __init__(self, device: ModernDevice, objects: Objects, most_bytes: int) -> None:
        self.residents = Residents(device, objects, most_bytes)
        self._together = Together(objects)
        self._stage = Stage(device)
        self._colour = ColourCopy()
        self._gbuffer: GBuffer | None = None
        self._programs = MeshPrograms(device)
        # Compatibility contexts draw nothing without an array 0: one value for all vertices.
        self._nowhere = Buffer(device)
        self._nowhere.fill(np.zeros(4, np.float32))

    def run(
        self,
        passes: Sequence[Pass],
        frame: Frame,
        textures: Textures,
        *,
        last: Camera,
    ) -> None:
        """All passes on the stage, which then goes over the frame where the stencil test of the
        last camera lets it."""
        box, reversed_depth = frame.box, frame.reversed_depth
        deep = any(one.state.depth != "always" or one.state.writes_depth for one in passes)
        self._stage.open(box, deep=deep)
        if any("app_colour" in (one.shader.needs or ()) for one in passes):
            self._colour.take(frame.framebuffer, box)
        self._open_array()
        before = False
        views: dict[Hashable, dict[str, Any] | None] = {}
        for one in passes:
            if one.image is not None:
                textures.bind(one.image)
            gl.glScissor(*box)  # what a pass clears
            if one.buffer != before:
                self._turn_to_buffer(frame) if one.buffer else self._stage.reopen()
                before = one.buffer
            set_state(one.state, reversed_depth)
            touching = self._together.find(one) if one.lines and one.sieve else {}
            for body in one.bodies:
                camera = body.camera.affine()
                if not all(map(isfinite, camera.modelview.ravel().tolist())):
                    continue
                lens = camera.lens
                if lens not in views:
                    views[lens] = inputs_of(turned(camera, reversed_depth), frame)
                inputs = views[lens]
                if inputs is None:
                    continue
                self._draw(
                    one, replace(body, camera=camera), inputs, box, touching.get(id(body))
                )
            self.residents.release()
        put_away((0,))
        if before:
            self._stage.reopen()
        set_state(State(depth="always", blend="off"), reversed_depth)
        stencil(last)
        self._stage.put_over(frame.framebuffer, box)

    def _open_array(self) -> None:
        """Vertices have a place from now on, all the same one."""
        self._nowhere.bind()
        gl.glEnableVertexAttribArray(0)
        gl.glVertexAttribPointer(0, 4, GL_FLOAT, 0, 0, None)
        gl.glVertexAttribDivisor(0, 1 << 30)

    def _turn_to_buffer(self, frame: Frame) -> None:
        """Draw into the G-buffer, empty, from now on; it can be read after that."""
        if self._gbuffer is None:
            self._gbuffer = GBuffer()
        self._gbuffer.open(frame.box, reversed_depth=frame.reversed_depth)
        self._gbuffer.bind_texture()

    def _draw(
        self,
        one: Pass,
        body: Body,
        inputs: dict[str, Any],
        box: Box,
        touching: Touching | None = None,
    ) -> None:
        ready = self._ready(one, body, inputs, touching)
        if ready is None:
            return
        camera = body.camera
        gl.glViewport(*camera.viewport)
        gl.glDepthRange(*camera.depth_range)
        scissor(camera, box)
        issue(one, ready)
        ready.release()

    def _ready(
        self, one: Pass, body: Body, inputs: dict[str, Any], touching: Touching | None = None
    ) -> Ready | None:
        """A pass over a body with its textures bound, its uniforms set and its program in use."""
        camera = body.camera
        resident: Resident | None = None
        count, each = 1, 3
        if one.element != "screen":
            resident = self.residents.find(body.batches, one.weld.creases, one.weld.tolerance)
            count = resident.count(one.element)
            each = VERTICES[one.primitives.kind] * one.primitives.each
            if one.element in BY_INDEX:
                each = BY_INDEX[one.element][1]
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
            planes=min(len(camera.clip_planes), MOST_CLIP_PLANES),
        )  # fmt: skip
        lit = program.wants("light")
        if lit and one.light is None:
            raise RenderError(
                f"shader {one.shader.name!r} reads `light`: give its Pass light=layer.light, or "
                "light=HEADLIGHT for one at the viewer"
            )
        seen = seen_from(camera, one.light if lit else None)
        if resident is not None and sieve is not None:
            count = resident.sieved.bind(
                np.array(seen["eye"]), sieve, one.element, touching
            )
            if not count:
                return None
        program.use(inputs, seen, _UNITS, {"vertices_each": each}, one.uniforms)
        if isinstance(one.pose, Keyframes):
            program.set({"share": one.pose.share})
        elif one.pose is not None:
            program.set({"bones": one.pose.matrices.transpose(0, 2, 1)})
        if resident is not None:
            if "rest" in (one.shader.needs or ()):
                self.residents.bind_rest(resident.mesh)  # first: it may upload where others lie
            resident.bind()
            if one.element in BY_INDEX and sieve is None:
                resident.bind_indices(one.element)
        if posed is not None:
            posed.bind()
        return Ready(count, each, posed)


@dataclass(frozen=True, slots=True)
class Ready:
    """What a draw of a program in use is made of."""

    elements: int
    each: int
    """Vertices of an element."""
    posed: Posed | None

    def release(self) -> None:
        if self.posed is not None:
            self.posed.release()


def issue(one: Pass, ready: Ready) -> None:
    """The draw itself."""
    count = ready.elements * ready.each
    if count and one.element in BY_INDEX:
        gl.glDrawElementsInstanced(
            BY_INDEX[one.element][0], count, GL_UNSIGNED_INT, None, one.primitives.copies
        )
    elif count:
        mode = _MODES[one.primitives.kind]
        gl.glDrawArraysInstanced(mode, 0, count, one.primitives.copies)


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
