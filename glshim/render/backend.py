"""Draws to pixels, in the app's own GL context and inside the state guard."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from importlib.resources import files
from typing import Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from glshim.assembly.batch import PolygonBatch
from glshim.caches import AgingCache
from glshim.errors import RenderError
from glshim.geometry.camera import Camera
from glshim.geometry.edges import Edges, edges, edges_of_each, join
from glshim.geometry.gather import Places, together
from glshim.geometry.lines import RECORD, choose
from glshim.render.cameras import MOST_CLIP_PLANES, grouped, hair_of, set_up, view_of
from glshim.render.canvas import DEPTH_BITS, DEPTH_ONLY, Canvas, triangles
from glshim.render.depth import UNIT, DepthCopy
from glshim.render.driver import gl
from glshim.render.guard import Guard, possible
from glshim.styling.protocol import Draw, Shader, Uniform

_SHADERS = files(__package__) / "shaders"
_VERTEX = (_SHADERS / "line.glsl").read_text("utf-8")
_FRAGMENT = (_SHADERS / "depth.glsl").read_text("utf-8")
_OFF = (  # what would change or drop the ink: each is enabled by some app
    0x0B44,  # cull face
    0x0B90,  # stencil test
    0x0BE2,  # blend
    0x0BC0,  # alpha test
    0x0BF1, 0x0BF2,  # logic ops
    0x0B42, 0x0B41,  # polygon stipple, smooth
    0x8037,  # polygon offset fill
    0x809E, 0x809F, 0x80A0,  # sample alpha to coverage, alpha to one, coverage
    0x8C89,  # rasterizer discard
    0x864F,  # depth clamp
    *range(0x3000, 0x3006),  # clip planes
)  # fmt: skip
_DEPTH_TEST = 0x0B71
_DEPTH_FUNC, _DEPTH_BITS, _FRAMEBUFFER_BINDING = 0x0B74, 0x0D56, 0x8CA6
_LEQUAL, _GREATER, _GEQUAL = 0x0203, 0x0204, 0x0206
_STRIP = 0x0005
_INPUTS = ("edge_a", "edge_b", "edge_c", "edge_plane", "edge_kind")
_LARGE = 4096
"""Corners from which a batch is drawn on its own rather than gathered with others."""


@dataclass(frozen=True, slots=True)
class _Program:
    program: Any
    uniforms: dict[str, Any]

    def set(self, name: str, value: Any) -> None:
        found = self.uniforms.get(name)
        if found is not None:
            found.value = value

    def write(self, name: str, value: NDArray[np.float64]) -> None:
        found = self.uniforms.get(name)
        if found is not None:
            found.write(np.ascontiguousarray(value, np.float32))


class Backend:
    """Draws extra geometry in one GL context. Make it with `attach` while that is current."""

    def __init__(self, context: Any, cache_bytes: int, ring_bytes: int) -> None:
        self._context = context
        self._programs: dict[tuple[Shader, int, tuple[str, ...]], _Program] = {}
        self._cache: AgingCache[Edges] = AgingCache(cache_bytes)
        self._ring = context.buffer(reserve=ring_bytes, dynamic=True)
        self._ring_at = 0
        self._crowd: tuple[Hashable, Edges, NDArray[np.int32]] | None = None
        self._depth = DepthCopy()
        self._canvas: Canvas | None = None
        self._copied: dict[tuple[int, int, int, int], bool] = {}
        array = ctypes.c_uint()
        gl.glGenVertexArrays(1, ctypes.addressof(array))
        self._array = array.value
        gl.glBindVertexArray(self._array)
        for location in range(5):
            gl.glEnableVertexAttribArray(location)
            gl.glVertexAttribDivisor(location, 1)

    @classmethod
    def attach(cls, *, cache_bytes: int = 256 << 20, ring_bytes: int = 8 << 20) -> Backend:
        """A backend in the current context, whose state stays as it was.

        cache_bytes bounds the memory of the edges of batches with a key; ring_bytes is the GPU
        memory through which lines stream (it grows when one draw needs more). Raises
        `RenderError` when no context is current, or it is older than OpenGL 3.3.
        """
        version = gl.glGetString(0x1F02)
        if not version:
            raise RenderError("no GL context is current: nothing can be drawn")
        text = ctypes.string_at(version).decode("ascii", "replace")
        number = re.search(r"(\d+)\.(\d+)", text)
        if " ES " in text or not number or tuple(map(int, number.groups())) < (3, 3):
            raise RenderError(f"lines need OpenGL 3.3 or newer; this context is {text}")
        if not possible():
            raise RenderError("GL is compiling a list, selecting, or its attribute stack is full")
        with Guard():
            try:
                context = moderngl.create_context(require=330)
                return cls(context, cache_bytes, ring_bytes)
            except Exception as error:
                raise RenderError(f"no drawing in this context ({text}): {error}") from error

    def render(self, draws: Iterable[Draw]) -> None:
        """Add draws to the framebuffer that is bound, against its depth, and touch nothing else.

        Where it has no depth buffer, the batches' own depth is laid down elsewhere. Does nothing
        where GL cannot draw now (a list being compiled, selection, a full attribute stack). Raises
        `RenderError` when a shader does not compile.
        """
        self._cache.tick()
        groups = grouped(draws)
        if not groups or not possible():
            return
        with Guard():
            bits, function = _integer(_DEPTH_BITS), _integer(_DEPTH_FUNC)
            greater = function in (_GREATER, _GEQUAL)
            for capability in _OFF:
                gl.glDisable(capability)
            gl.glEnable(_DEPTH_TEST)
            gl.glDepthFunc(_GEQUAL if greater else _LEQUAL)
            gl.glStencilMask(0)
            gl.glColorMask(1, 1, 1, 1)
            gl.glPolygonMode(0x0408, 0x1B02)
            window = _integer(_FRAMEBUFFER_BINDING)
            if not bits:
                self._lay_depth(groups, greater)
            gl.glDepthMask(0)
            self._copied.clear()
            for group in groups:
                self._draw(group, bits or DEPTH_BITS, greater)
            if not bits and self._canvas is not None:
                self._canvas.put_over(window)

    def _lay_depth(self, groups: list[list[Draw]], greater: bool) -> None:
        """Bind a canvas with the depth of the draws' polygons."""
        if self._canvas is None:
            self._canvas = Canvas(self._context)
        ports = [draw.camera.viewport for group in groups for draw in group]
        extent = (max(x + width for x, _, width, _ in ports),
                  max(y + height for _, y, _, height in ports))  # fmt: skip
        self._canvas.open(*extent, greater)
        gl.glColorMask(0, 0, 0, 0)
        for draw in (draw for group in groups for draw in group):
            view = view_of(draw.camera)
            points = triangles(draw.batch)
            if view is None or not len(points):
                continue
            program = self._ready(DEPTH_ONLY, draw.camera, view, {}, 0.0, spines=False)
            set_up(draw.camera)
            gl.glUseProgram(program.program.glo)
            source = self._context.buffer(points)
            array = self._context.vertex_array(program.program, [(source, "3f", "edge_a")])
            array.render(moderngl.TRIANGLES)
            array.release()
            source.release()
        gl.glColorMask(1, 1, 1, 1)

    def _draw(self, group: list[Draw], bits: int, greater: bool) -> None:
        """Draws alike in all but batch and modelview, as few GL draws."""
        first = group[0]
        large = [draw for draw in group if len(draw.batch.corners) > _LARGE]
        small = [draw for draw in group if len(draw.batch.corners) <= _LARGE]
        if len(small) == 1:
            large, small = [*large, *small], []
        for draw in large:
            records = choose(self._edges(draw.batch), draw.camera, first.choice)
            self._draw_records(draw, records, bits, greater)
        if small:
            found, places = self._gathered(small)
            camera = replace(first.camera, modelview=np.eye(4))
            records = choose(found, camera, first.choice, places)
            self._draw_records(replace(first, camera=camera), records, bits, greater)

    def _draw_records(
        self,
        draw: Draw,
        records: NDArray[np.float32],
        bits: int,
        greater: bool,
    ) -> None:
        view = view_of(draw.camera)
        if view is None or not len(records):
            return
        hair = hair_of(draw.camera, bits, greater)
        offset = self._stream(records)
        viewport = draw.camera.viewport
        if viewport not in self._copied:
            self._copied.clear()
            self._copied[viewport] = self._depth.take(viewport, bits)
        spines = self._copied[viewport]
        program = self._ready(draw.shader, draw.camera, view, draw.uniforms, hair, spines=spines)
        set_up(draw.camera)
        gl.glUseProgram(program.program.glo)
        self._point_at(offset)
        gl.glDrawArraysInstanced(_STRIP, 0, draw.shader.vertices, len(records))

    def vertices(
        self,
        records: NDArray[np.float32],
        camera: Camera,
        shader: Shader,
        uniforms: Mapping[str, Uniform],
        hair: float,
        *,
        spines: bool = True,
    ) -> NDArray[np.float32]:
        """(L, shader.vertices, 4) clip-space vertices that the GPU makes of line records, by
        transform feedback: what tests hold to the numpy reference. hair, spines: `line.glsl`."""
        view = view_of(camera)
        if view is None:
            raise RenderError("this camera sees nothing")
        with Guard():
            program = self._ready(
                shader, camera, view, uniforms, hair, spines=spines, varyings=("gl_Position",)
            )
            source = self._context.buffer(records)
            target = self._context.buffer(reserve=len(records) * shader.vertices * 16)
            layout = "3f 3f 3f 4f 2f /i"
            array = self._context.vertex_array(program.program, [(source, layout, *_INPUTS)])
            array.transform(target, moderngl.POINTS, shader.vertices, instances=len(records))
            found = np.frombuffer(target.read(), np.float32)
            for held in (array, source, target):
                held.release()
        return found.reshape(len(records), shader.vertices, 4)

    def _ready(
        self,
        shader: Shader,
        camera: Camera,
        view: dict[str, NDArray[np.float64]],
        uniforms: Mapping[str, Uniform],
        hair: float,
        *,
        spines: bool,
        varyings: tuple[str, ...] = (),
    ) -> _Program:
        """The program of a shader with its uniforms set."""
        planes = min(len(camera.clip_planes), MOST_CLIP_PLANES)
        program = self._program(shader, planes, varyings)
        range_ = camera.depth_range
        for name, matrix in view.items():
            program.write(name, matrix)
        program.set("half_viewport", (camera.viewport[2] / 2.0, camera.viewport[3] / 2.0))
        program.set("hair", hair)
        program.set("away", 1.0 if (hair > 0.0) == (range_[1] >= range_[0]) else -1.0)
        program.set("range", range_)
        program.set("spines", spines)
        program.set("finished_depth", UNIT)
        program.set("blur", self._depth.blur)
        for key, value in uniforms.items():
            program.set(key, value)
        return program

    def _point_at(self, offset: int) -> None:
        """Let the inputs of the vertex shader read records at a byte offset of the ring."""
        gl.glBindVertexArray(self._array)
        gl.glBindBuffer(0x8892, self._ring.glo)
        for location, (size, start) in enumerate(((3, 0), (3, 3), (3, 6), (4, 9), (2, 13))):
            gl.glVertexAttribPointer(location, size, 0x1406, 0, RECORD * 4, offset + start * 4)

    def _edges(self, batch: PolygonBatch) -> Edges:
        """The edges of a batch, found again by key."""
        key = batch.key
        if key is None:
            return edges(batch)
        found = self._cache.get(key)
        if found is None:
            made = edges(batch)
            found = self._cache.put(key, made, made.nbytes)
        return found

    def _gathered(self, draws: list[Draw]) -> tuple[Edges, Places]:
        """The edges of many small batches, each where it stands."""
        kept = [draw for draw in draws if draw.batch.key is not None]
        passing: dict[int, list[Draw]] = {}
        for draw in draws:
            if draw.batch.key is None:
                passing.setdefault(id(draw.camera), []).append(draw)
        parts, owners = [], []
        if kept:
            keys = tuple(draw.batch.key for draw in kept)
            if self._crowd is None or keys != self._crowd[0]:
                self._crowd = (keys, *together([self._edges(draw.batch) for draw in kept]))
            parts.append(self._crowd[1])
            owners.append(self._crowd[2])
        if passing:
            found, owner = edges_of_each(
                [join([draw.batch for draw in alike]) for alike in passing.values()]
            )
            parts.append(found)
            owners.append(owner + np.int32(len(kept)))
        cameras = [draw.camera for draw in kept] + [alike[0].camera for alike in passing.values()]
        modelviews = np.stack([camera.modelview for camera in cameras])
        return together(parts)[0], Places(np.concatenate(owners), modelviews)

    def _stream(self, records: NDArray[np.float32]) -> int:
        """Byte offset in the ring at which records now lie."""
        size = records.nbytes
        if size > self._ring.size:
            self._ring.release()
            self._ring = self._context.buffer(reserve=2 * size, dynamic=True)
            self._ring_at = 0
        if self._ring_at + size > self._ring.size:
            self._ring.orphan()
            self._ring_at = 0
        offset = self._ring_at
        self._ring.write(records, offset=offset)
        self._ring_at = offset + size
        return offset

    def _program(self, shader: Shader, planes: int, varyings: tuple[str, ...]) -> _Program:
        key = (shader, planes, varyings)
        found = self._programs.get(key)
        if found is None:
            head = f"#version 330\n#define CLIP_PLANES {planes}\n"
            try:
                program = self._context.program(
                    vertex_shader=f"{head}{_VERTEX}\n#line 1\n{shader.vertex}",
                    fragment_shader=None
                    if varyings
                    else f"{head}{_FRAGMENT}\n#line 1\n{shader.fragment}",
                    varyings=varyings,
                )
            except moderngl.Error as error:
                raise RenderError(f"shader {shader.name!r} does not compile: {error}") from error
            members = {name: program[name] for name in program}
            uniforms = {n: m for n, m in members.items() if isinstance(m, moderngl.Uniform)}
            found = self._programs[key] = _Program(program, uniforms)
        return found


def _integer(name: int) -> int:
    value = ctypes.c_int()
    gl.glGetIntegerv(name, ctypes.addressof(value))
    return value.value
