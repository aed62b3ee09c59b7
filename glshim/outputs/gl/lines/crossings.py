"""Which polygons pass through each other where it is seen: found by the GPU, made lines in numpy.

Raskar 2001, section 2.4, in two passes over the polygons. The first notes the visible triangle of
each pixel. The second traps those that lie between it and a second depth, and notes both: the
paper's test per pixel, but it yields which polygons cross rather than black pixels. Their common
segments are lines like any other (`glshim.linework.intersections`).
"""

from __future__ import annotations

import ctypes
from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from glshim.driver.ask import integer
from glshim.driver.functions import gl
from glshim.driver.pixels import pack_plainly
from glshim.geometry.recovery.welding import distinct
from glshim.linework import intersections
from glshim.model.arrays import Doubles, Flags, Floats, Rows
from glshim.model.batch import Item, PolygonBatch, join
from glshim.model.caches import AgingCache
from glshim.model.camera import Camera
from glshim.model.lines import RECORD
from glshim.outputs.gl.device.buffers import Buffer, Ring
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.programs import Program, shader_text
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.device.triangles import triangles
from glshim.outputs.gl.frame.cameras import MOST_CLIP_PLANES, box_of, scissor
from glshim.outputs.gl.frame.depth import UNIT, Box
from glshim.outputs.gl.frame.frame import Frame
from glshim.spec.constants import (
    GL_CLIP_PLANE0,
    GL_COLOR,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_COMPONENT32F,
    GL_DEPTH_TEST,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_FLOAT,
    GL_GREATER,
    GL_LESS,
    GL_READ_FRAMEBUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RG32UI,
    GL_RG_INTEGER,
    GL_RGBA32UI,
    GL_SCISSOR_TEST,
    GL_TEXTURE0,
    GL_TEXTURE_2D,
    GL_TRIANGLES,
    GL_UNSIGNED_INT,
)

_SMALL = 512
"""Triangles up to which what has one modelview is drawn together with others."""
_MOST_TRIANGLES, _MOST_PIXELS = 1 << 30, 1 << 24
_FRONT = 1 << 31
"""What the shader adds to the numbers of triangles that face the viewer."""
_UNIT = 12


class _Body:
    """Batches in one object space, as triangles."""

    def __init__(self, batches: Sequence[PolygonBatch]) -> None:
        self.corners: Floats = triangles(join(batches))
        """(T, 3, 3) object space."""
        fans = [int(np.maximum(np.diff(batch.starts) - 2, 0).sum()) for batch in batches]
        self.owner = np.repeat(np.arange(len(batches), dtype=np.int32), fans)
        """(T,) the batch of each."""
        self.buffer: Buffer | None = None
        """The corners on the GPU, where they stay."""

    def __len__(self) -> int:
        return len(self.corners)

    @cached_property
    def neighbours(self) -> Rows:
        """(T, 3) the triangle at each side, -1 for none."""
        return intersections.neighbours(self.corners, self.owner)

    def release(self) -> None:
        """Free the memory on the GPU."""
        if self.buffer is not None:
            self.buffer.release()
            self.buffer = None


@dataclass(frozen=True, slots=True, eq=False)
class _Chunk:
    """Triangles that one GL draw serves."""

    corners: Floats
    """(T, 3, 3) in the space before modelview."""
    modelview: Doubles
    buffer: Buffer | Ring
    offset: int
    """Bytes to the first in the buffer."""


class _Scene:
    """Triangles of a group, numbered through. An `intersections.Triangles` in eye space."""

    def __init__(
        self, chunks: Sequence[_Chunk], bodies: Sequence[_Body], state: Hashable | None
    ) -> None:
        self.chunks = chunks
        self.first = np.cumsum([0] + [len(chunk.corners) for chunk in chunks])
        """(chunks + 1,) number of each chunk's first triangle."""
        self._bodies = bodies
        self._starts = np.cumsum([0] + [len(body) for body in bodies])
        self.state = state
        """Equal states are equal scenes; None: this one is seen once."""

    def __getitem__(self, index: Rows, /) -> Doubles:
        found = np.empty((len(index), 3, 3))
        which = np.searchsorted(self.first, index, side="right") - 1
        for at in np.flatnonzero(np.bincount(which)).tolist():
            chunk, rows = self.chunks[at], np.flatnonzero(which == at)
            found[rows] = _moved(chunk.corners[index[rows] - self.first[at]], chunk.modelview)
        return found

    def of_one_mesh(self, pairs: Rows) -> Flags:
        """(N,) whether both triangles of pairs (N, 2) come from one batch."""
        which = np.searchsorted(self._starts, pairs, side="right") - 1
        owner = np.concatenate([body.owner for body in self._bodies])[pairs]
        return np.asarray((which[:, 0] == which[:, 1]) & (owner[:, 0] == owner[:, 1]))

    def neighbours(self, pairs: Rows) -> Rows:
        """(T, 3) the triangle at each side, of bodies that are named in pairs; else -1."""
        first = self._starts
        beside = np.full((int(first[-1]), 3), -1, np.intp)
        which = np.searchsorted(first, pairs.ravel(), side="right") - 1
        named = np.flatnonzero(np.bincount(which)).tolist()
        for at in named:
            own = self._bodies[at].neighbours
            beside[first[at] : first[at + 1]] = np.where(own >= 0, own + first[at], -1)
        if len(named) > 1:
            among = [np.arange(first[at], first[at + 1]) for at in named]
            intersections.bridge(self, beside, np.concatenate(among))
        return beside


class Crossings:
    """Finds visible intersections. Make and use it inside the state guard."""

    def __init__(self, device: ModernDevice, cache_bytes: int = 128 << 20) -> None:
        self._device = device
        self._bodies: AgingCache[_Body] = AgingCache(cache_bytes, drop=_Body.release)
        self._programs: dict[tuple[int, bool], Program] = {}
        self._ring = Ring(device, 1 << 16)
        self._last: tuple[Hashable, Rows, Floats] | None = None
        self._targets = tuple(
            RenderTarget(kind, (GL_DEPTH_COMPONENT32F,), unit=_UNIT)
            for kind in (GL_RGBA32UI, GL_RG32UI)
        )
        """Of both passes."""

    def tick(self) -> None:
        """A layer has passed."""
        self._bodies.tick()

    def find(self, items: Sequence[Item], frame: Frame) -> Floats:
        """(L, 21) records (`glshim.model.lines`) where polygons of batches cross.

        items: of a `glshim.linework.groups.Group`. What is not in the frame's finished depth is
        left out. Blending, culling and the like are off; bindings come back as they were, depth
        test and writes are off afterwards.
        """
        camera = items[0][1]
        scene = self._scene(items)
        box = box_of([camera], frame.destination.bounds)
        pixels = box[2] * box[3]
        if not 0 < scene.first[-1] < _MOST_TRIANGLES or not 0 < pixels <= _MOST_PIXELS:
            return np.empty((0, RECORD), np.float32)
        seeds = self._seeds(scene, camera, box, frame)
        last = self._last
        same = last is not None and scene.state is not None and scene.state == last[0]
        if last is not None and same and np.array_equal(seeds, last[1]):
            return last[2]
        records = _lines(scene, seeds)
        self._last = (scene.state, seeds, records)
        return records

    def _scene(self, items: Sequence[Item]) -> _Scene:
        """The triangles of batches on the GPU: large ones stay there, the others go through a ring,
        many small ones as one."""
        alike: dict[tuple[bytes, bool], list[Item]] = {}
        for batch, camera in items:
            place = camera.modelview.tobytes(), batch.key is not None
            alike.setdefault(place, []).append((batch, camera))
        placed = []
        for (_, keyed), same in alike.items():
            key = tuple(batch.key for batch, _ in same) if keyed else None
            body = self._body([batch for batch, _ in same], key)
            placed.append((key, body, same[0][1].modelview))
        large = [entry for entry in placed if len(entry[1]) > _SMALL]
        kept = [(body, at) for key, body, at in large if key in self._bodies]
        passing = [(body, at) for key, body, at in large if key not in self._bodies]
        small = [(body, at) for _, body, at in placed if len(body) <= _SMALL]
        streamed = [(body.corners, at) for body, at in passing]
        if small:
            with np.errstate(all="ignore"):  # an app may send anything
                eye = [_moved(body.corners, at) for body, at in small]
                streamed.append((np.concatenate(eye).astype(np.float32), np.eye(4)))
        offset = self._ring.put(*(corners for corners, _ in streamed))
        chunks = [_Chunk(body.corners, at, self._held(body), 0) for body, at in kept]
        for corners, at in streamed:
            chunks.append(_Chunk(corners, at, self._ring, offset))
            offset += corners.nbytes
        keys = tuple(key for key, _, _ in placed)
        state = None if None in keys else (tuple(alike), keys)
        return _Scene(chunks, [body for body, _ in (*kept, *passing, *small)], state)

    def _body(self, batches: list[PolygonBatch], key: Hashable | None) -> _Body:
        if key is None:
            return _Body(batches)
        found = self._bodies.get(key)
        if found is None:
            made = _Body(batches)
            found = self._bodies.put(key, made, 100 * len(made))  # 36 each here, there; 24 beside
        return found

    def _held(self, body: _Body) -> Buffer:
        """The buffer with a body's corners."""
        if body.buffer is None:
            body.buffer = Buffer(self._device)
            body.buffer.fill(body.corners)
        return body.buffer

    def _seeds(self, scene: _Scene, camera: Camera, box: Box, frame: Frame) -> Rows:
        """(N, 2) the pairs of triangles that both passes found, each once: their numbers, plus
        `_FRONT` where they face the viewer."""
        draw, read = integer(GL_DRAW_FRAMEBUFFER_BINDING), integer(GL_READ_FRAMEBUFFER_BINDING)
        for target in self._targets:
            target.fit(*box[2:])
        gl.glActiveTexture(GL_TEXTURE0 + _UNIT)
        gl.glEnable(GL_DEPTH_TEST)
        gl.glDepthMask(1)
        gl.glDepthFunc(GL_GREATER if frame.reversed_depth else GL_LESS)
        gl.glClearDepth(0.0 if frame.reversed_depth else 1.0)
        gl.glEnableVertexAttribArray(0)
        planes = camera.clip_planes[:MOST_CLIP_PLANES]
        for plane in range(len(planes)):
            gl.glEnable(GL_CLIP_PLANE0 + plane)
        nothing = (ctypes.c_uint * 4)()
        for trap, target in enumerate(self._targets):
            target.bind()
            gl.glDisable(GL_SCISSOR_TEST)
            gl.glClear(GL_DEPTH_BUFFER_BIT)
            gl.glClearBufferuiv(GL_COLOR, 0, ctypes.addressof(nothing))
            _place(camera, box)
            program = self._program(len(planes), bool(trap))
            program.use({"projection": camera.projection.T, "clip_planes": planes})
            if trap:
                program.set({"seen": _UNIT, "away": frame.depth_sign})
                self._targets[0].bind_texture()
            else:
                margin = {"hair": frame.depth_margin}
                program.set(margin | {"finished": UNIT, "corner_at": box[:2]})
                gl.glBindTexture(GL_TEXTURE_2D, 0)
            for chunk, first in zip(scene.chunks, scene.first.tolist(), strict=False):
                program.set({"modelview": chunk.modelview.T, "first_triangle": first})
                chunk.buffer.bind()
                gl.glVertexAttribPointer(0, 3, GL_FLOAT, 0, 12, chunk.offset)
                gl.glDrawArrays(GL_TRIANGLES, 0, 3 * len(chunk.corners))
        gl.glDisableVertexAttribArray(0)
        noted = np.empty((box[2] * box[3], 2), np.uint32)
        pack_plainly()
        gl.glReadPixels(0, 0, *box[2:], GL_RG_INTEGER, GL_UNSIGNED_INT, noted.ctypes.data)
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw)
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, read)
        gl.glDisable(GL_DEPTH_TEST)
        gl.glDepthMask(0)
        gl.glEnable(GL_SCISSOR_TEST)
        for plane in range(len(planes)):
            gl.glDisable(GL_CLIP_PLANE0 + plane)
        code = noted.view(np.uint64)[:, 0]
        code = distinct(code[code != 0])
        return code.view(np.uint32).reshape(-1, 2).astype(np.intp) - 1

    def _program(self, planes: int, trap: bool) -> Program:
        found = self._programs.get((planes, trap))
        if found is None:
            defines = f"#define CLIP_PLANES {planes}\n#define TRAP {int(trap)}\n"
            head = f"#version 330\n{defines}#line 1\n"
            found = self._programs[planes, trap] = self._device.program(
                "crossings", head + shader_text("crossings.vert.glsl"),
                head + shader_text("crossings.frag.glsl"),
            )  # fmt: skip
        return found


def _moved(corners: Floats, modelview: Doubles) -> Doubles:
    """(T, 3, 3) corners under an affine matrix; numpy is slow with many matrices of 3 by 3."""
    points = corners.reshape(-1, 3) @ modelview[:3, :3].T
    return np.asarray(points + modelview[:3, 3]).reshape(-1, 3, 3)


def _lines(scene: _Scene, seeds: Rows) -> Floats:
    """(L, 21) line records of seeds (N, 2) and what follows from them."""
    numbers = seeds & (_FRONT - 1)
    crossing, near = intersections.sift(scene, numbers)
    if not crossing.any():  # as a rule: neighbours are not even looked for
        return np.empty((0, RECORD), np.float32)
    beside = scene.neighbours(numbers)
    # Along its silhouette a mesh's front and back lie near each other: no need to go and look.
    near &= ((seeds[:, 0] ^ seeds[:, 1]) & _FRONT == 0) | ~scene.of_one_mesh(numbers)
    closer = intersections.approach(scene, beside, numbers[near])
    followed = intersections.trace(scene, beside, np.concatenate((numbers[crossing], closer)))
    return intersections.records(scene, beside, followed)


def _place(camera: Camera, box: Box) -> None:
    """Viewport, depth range and scissor of a camera, in a framebuffer that holds a box."""
    x, y = box[:2]
    left, low, across, up = camera.viewport
    gl.glEnable(GL_SCISSOR_TEST)
    scissor(camera, box, (x, y))
    gl.glViewport(left - x, low - y, across, up)
    gl.glDepthRange(*camera.depth_range)
