"""What the driver says about a draw, read when the draw begins.

Nothing is shadowed: C libraries change matrices and switches unseen. All of it is read into one
buffer, whose bytes are the key under which the decoded state is found again. The buffers of these
questions are prepared: they are asked at every draw.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from glshim.driver.ask import integer
from glshim.driver.context import PROGRAM_SWITCHES, list_is_open, other_programs
from glshim.driver.functions import gl, quick
from glshim.model.camera import Camera
from glshim.sources.fog import FogReader
from glshim.sources.fog import fog as fog_now
from glshim.sources.lights import LampReader
from glshim.sources.lights import lighting as lights_now
from glshim.spec.constants import (
    GL_CCW,
    GL_CLIP_PLANE0,
    GL_COLOR_WRITEMASK,
    GL_CURRENT_PROGRAM,
    GL_DEPTH_FUNC,
    GL_DEPTH_RANGE,
    GL_DEPTH_TEST,
    GL_DEPTH_WRITEMASK,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_EQUAL,
    GL_FILL,
    GL_FOG,
    GL_FRONT,
    GL_FRONT_FACE,
    GL_LEQUAL,
    GL_LESS,
    GL_LIGHTING,
    GL_MODELVIEW_MATRIX,
    GL_POLYGON_MODE,
    GL_PROGRAM_PIPELINE_BINDING,
    GL_PROJECTION_MATRIX,
    GL_RENDER,
    GL_RENDER_MODE,
    GL_SCISSOR_BOX,
    GL_SCISSOR_TEST,
    GL_SPECULAR,
    GL_STENCIL_FUNC,
    GL_STENCIL_REF,
    GL_STENCIL_TEST,
    GL_STENCIL_VALUE_MASK,
    GL_TEXTURE_2D,
    GL_VERTEX_SHADER,
    GL_VIEWPORT,
)

_CLIP_PLANES = 6
"""As many as every driver has."""

_FLOATS = ((GL_MODELVIEW_MATRIX, 16), (GL_PROJECTION_MATRIX, 16), (GL_DEPTH_RANGE, 2))
_INTEGERS = (
    ("viewport", GL_VIEWPORT, 4),
    ("scissor", GL_SCISSOR_BOX, 4),
    ("scissor_test", GL_SCISSOR_TEST, 1),
    ("polygon_mode", GL_POLYGON_MODE, 2),
    ("color_mask", GL_COLOR_WRITEMASK, 4),
    ("front_face", GL_FRONT_FACE, 1),
    ("depth_test", GL_DEPTH_TEST, 1),
    ("depth_func", GL_DEPTH_FUNC, 1),
    ("depth_mask", GL_DEPTH_WRITEMASK, 1),
    ("render_mode", GL_RENDER_MODE, 1),
    ("program", GL_CURRENT_PROGRAM, 1),
    *(("other_program", name, 1) for name in PROGRAM_SWITCHES),
    ("pipeline", GL_PROGRAM_PIPELINE_BINDING, 1),
    ("stage", GL_VERTEX_SHADER, 1),  # of the pipeline that is bound
    ("framebuffer", GL_DRAW_FRAMEBUFFER_BINDING, 1),
    ("stencil_test", GL_STENCIL_TEST, 1),
    ("stencil", GL_STENCIL_FUNC, 1),
    ("stencil", GL_STENCIL_REF, 1),
    ("stencil", GL_STENCIL_VALUE_MASK, 1),
    ("lighting", GL_LIGHTING, 1),
    ("fog", GL_FOG, 1),
    ("textured", GL_TEXTURE_2D, 1),
    ("specular", GL_SPECULAR, 4),  # of the front material: floats
    *(("clip", plane, 1) for plane in range(GL_CLIP_PLANE0, GL_CLIP_PLANE0 + _CLIP_PLANES)),
)
_MODELVIEW_BYTES = 64
_COUNT = sum(n for _, n in _FLOATS) + sum(n for _, _, n in _INTEGERS)

_DULL = 0.05
"""A material with less of a specular colour does not gleam."""


@dataclass(frozen=True, slots=True, eq=False)
class DrawState:
    """State of the driver when a draw begins."""

    camera: Camera
    framebuffer: int
    """Draw framebuffer name, 0 for the window."""
    depth_tested: bool
    """The depth test is on and means 'nearer wins'."""
    depth_written: bool
    """Polygons drawn now enter the depth buffer."""
    flat: bool
    """Parallel projection."""
    upright: bool
    """And what is drawn there lies as it is drawn: `Camera.upright`."""
    rendered: bool
    """Drawn to a picture, not for selection or feedback."""
    program: int
    """Not 0 where vertices go through a program of the app's own, of whatever kind; 0 for the
    fixed-function pipeline."""
    obstacle: str
    """Why polygons drawn now cannot carry lines, wherever they come from; empty when they can."""
    fill_faces: bool
    """Polygons are filled."""


class StateReader:
    """Reads :class:`DrawState`; equal states give the same object."""

    def __init__(self, *, lighting: bool = False) -> None:
        """lighting: whether `Camera.lit` and what goes with it is asked for."""
        self._lighting = lighting
        self._buffer = (ctypes.c_int32 * _COUNT)()
        self._calls: list[Callable[[], None]] = []
        self._stencil_calls: list[Callable[[], None]] = []
        self._ask_textured: Callable[[], None] | None = None
        self._stencil_test = ctypes.c_int32()
        self._lit_calls: list[Callable[[], None]] = []
        self._lit = ctypes.c_int32()
        self._lamps = LampReader()
        self._foggy = ctypes.c_int32()
        self._fog = FogReader()
        self._clips = False
        self._other_programs: tuple[int, ...] | None = None
        """What tells that some are in use; None: as if there were none."""
        self._pipeline = ctypes.c_int32()
        self._stage = self._at(0)
        self._known: dict[bytes, DrawState] = {}
        self._rest: dict[bytes, DrawState] = {}

    def forget(self) -> None:
        """A clip plane was moved: its equation is not part of the key. From now on the switches of
        clip planes are asked for."""
        self._known.clear()
        self._rest.clear()
        if not self._clips:
            self._clips = True
            self._calls.clear()

    def look_for_programs(self) -> None:
        """The app has to do with programs that are not the one of glUseProgram. From now on they
        are asked for."""
        if self._other_programs is None:
            self._other_programs = other_programs()
            self._calls.clear()

    def read(self) -> DrawState:
        """The state now. A compatibility context must be current, outside glBegin/glEnd."""
        for get in self._calls or self._prepare():
            get()
        # Mesa may find an error in it where a list is open (`ask.is_enabled`).
        if self._ask_textured is not None and not list_is_open():
            self._ask_textured()
        if self._stencil_test.value:
            for get in self._stencil_calls:
                get()
        if self._pipeline.value:
            gl.glGetProgramPipelineiv(self._pipeline.value, GL_VERTEX_SHADER, self._stage)
        if self._lit.value:  # only then: Mesa flushes what it holds when it is asked for a material
            for get in self._lit_calls:
                get()
        key = bytes(self._buffer)
        if self._lit.value:
            key += self._lamps.read()
        if self._foggy.value:
            key += self._fog.read()
        state = self._known.get(key)
        if state is None:
            if len(self._known) > 4096:
                self._known.clear()
            state = self._known[key] = self._decode(key)
        return state

    def _prepare(self) -> list[Callable[[], None]]:
        floats, integers = quick("glGetFloatv"), quick("glGetIntegerv")
        offset = 0
        for name, count in _FLOATS:
            self._calls.append(partial(floats, name, self._at(offset)))
            offset += count
        self._clips = self._clips or _any_clip_plane_was_set()
        if self._other_programs is None and any(map(integer, known := other_programs())):
            self._other_programs = known
        self._stencil_calls = []
        for kind, name, count in _INTEGERS:
            call = partial(integers, name, self._at(offset))
            if kind == "stencil":
                self._stencil_calls.append(call)
            elif kind == "specular":
                material = quick("glGetMaterialfv")
                self._lit_calls = [partial(material, GL_FRONT, name, self._at(offset))]
            elif kind == "stage":
                self._stage = self._at(offset)
            elif kind in ("other_program", "pipeline"):
                if name in (self._other_programs or ()):
                    self._calls.append(call)
            elif kind == "textured":
                self._ask_textured = call if self._lighting else None
            elif _is_asked(kind, clips=self._clips, lighting=self._lighting):
                self._calls.append(call)
            if kind == "lighting":
                self._lit = ctypes.c_int32.from_buffer(self._buffer, 4 * offset)
            if kind == "fog":
                self._foggy = ctypes.c_int32.from_buffer(self._buffer, 4 * offset)
            if kind == "pipeline":
                self._pipeline = ctypes.c_int32.from_buffer(self._buffer, 4 * offset)
            if kind == "stencil_test":
                self._stencil_test = ctypes.c_int32.from_buffer(self._buffer, 4 * offset)
            offset += count
        return self._calls

    def _at(self, offset: int) -> Any:
        return ctypes.c_void_p(ctypes.addressof(self._buffer) + 4 * offset)

    def _decode(self, key: bytes) -> DrawState:
        """All but the modelview is mostly what it was: found again by the rest of the key."""
        rest = self._rest.get(key[_MODELVIEW_BYTES:])
        if rest is None:
            if len(self._rest) > 256:
                self._rest.clear()
            rest = self._rest[key[_MODELVIEW_BYTES:]] = _decode_rest(key, self._lighting)
        c = rest.camera
        modelview = np.frombuffer(key, np.float32, 16).astype(np.float64).reshape(4, 4).T
        camera = Camera(
            modelview, c.projection, c.viewport, c.depth_range, c.front_ccw, c.scissor,
            c.clip_planes, c.stencil, c.lit, c.gleams, c.textured, c.lighting, c.fog,
        )  # fmt: skip
        return DrawState(
            camera, rest.framebuffer, rest.depth_tested, rest.depth_written, rest.flat,
            rest.flat and camera.upright, rest.rendered,
            rest.program, rest.obstacle, rest.fill_faces,
        )  # fmt: skip


def _brightest(words: tuple[int, ...]) -> float:
    """The greatest channel of a colour whose floats were read as integers."""
    red, green, blue, _ = struct.unpack("=4f", struct.pack("=4i", *words))
    return max(float(red), float(green), float(blue))


def _is_asked(kind: str, *, clips: bool, lighting: bool) -> bool:
    """Whether a kind of value is in the key."""
    return {"clip": clips, "lighting": lighting, "fog": lighting}.get(kind, True)


def _decode_rest(key: bytes, lighting: bool) -> DrawState:
    floats = struct.unpack_from("=34f", key)
    integers = struct.unpack_from(f"={_COUNT - 34}i", key, 34 * 4)
    values: dict[str, tuple[int, ...]] = {}
    at = 0
    for name, _, count in _INTEGERS:
        values[name] = values.get(name, ()) + integers[at : at + count]
        at += count
    camera = Camera(
        modelview=np.eye(4),
        projection=np.array(floats[16:32], np.float64).reshape(4, 4).T,
        viewport=values["viewport"],  # type: ignore[arg-type]
        depth_range=(floats[32], floats[33]),
        front_ccw=values["front_face"][0] == GL_CCW,
        scissor=values["scissor"] if values["scissor_test"][0] else None,  # type: ignore[arg-type]
        clip_planes=_clip_planes(values["clip"]),
        stencil=values["stencil"] if values["stencil_test"][0] else None,  # type: ignore[arg-type]
        lit=bool(values["lighting"][0]),
        lighting=lights_now() if lighting and values["lighting"][0] else None,
        fog=fog_now() if values["fog"][0] else None,
        textured=bool(values["textured"][0]),
        gleams=bool(values["lighting"][0]) and _brightest(values["specular"]) > _DULL,
    )
    func = values["depth_func"][0]
    depth = bool(values["depth_test"][0]) and func in (GL_LESS, GL_EQUAL, GL_LEQUAL)
    obstacle = ""
    if not any(values["color_mask"]):
        obstacle = "no colour is written"
    elif values["depth_test"][0] and not depth:
        obstacle = "the depth function is not less or less-or-equal"
    return DrawState(
        camera=camera,
        framebuffer=values["framebuffer"][0],
        depth_tested=depth,
        depth_written=bool(values["depth_mask"][0]),
        flat=camera.orthographic,
        upright=False,
        rendered=values["render_mode"][0] == GL_RENDER,
        program=values["program"][0] or _other_program(values),
        obstacle=obstacle,
        fill_faces=values["polygon_mode"] == (GL_FILL, GL_FILL),
    )


def _other_program(values: dict[str, tuple[int, ...]]) -> int:
    """Not 0 where a program that is not glUseProgram's takes the vertices."""
    return int(any(values["other_program"]) or all((*values["pipeline"], *values["stage"])))


def _any_clip_plane_was_set() -> bool:
    """Whether some clip plane has another equation than the one it begins with, all zero."""
    equation = (ctypes.c_double * 4)()
    for i in range(_CLIP_PLANES):
        gl.glGetClipPlane(GL_CLIP_PLANE0 + i, equation)
        if any(equation):
            return True
    return False


def _clip_planes(enabled: tuple[int, ...]) -> tuple[tuple[float, float, float, float], ...]:
    """Equations in eye space of the user clip planes that are on."""
    found = []
    for i, on in enumerate(enabled):
        if on:
            equation = (ctypes.c_double * 4)()
            gl.glGetClipPlane(GL_CLIP_PLANE0 + i, equation)
            found.append((equation[0], equation[1], equation[2], equation[3]))
    return tuple(found)
