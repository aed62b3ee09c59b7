"""What the driver says about a draw, read when the draw begins.

Nothing is shadowed: C libraries change matrices and switches unseen. All of it is read into one
buffer, whose bytes are the key under which the decoded state is found again.
"""

from __future__ import annotations

import ctypes
import struct
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from glshim.model.camera import Camera
from glshim.spec.attributes import BY_NAME
from glshim.spec.context import shortcoming
from glshim.spec.driver import current_context, gl, quick

_FLOATS = ((0x0BA6, 16), (0x0BA7, 16), (0x0B70, 2))
_INTEGERS = (
    ("viewport", 0x0BA2, 4),
    ("scissor", 0x0C10, 4),
    ("scissor_test", 0x0C11, 1),
    ("polygon_mode", 0x0B40, 2),
    ("color_mask", 0x0C23, 4),
    ("front_face", 0x0B46, 1),
    ("depth_test", 0x0B71, 1),
    ("depth_func", 0x0B74, 1),
    ("depth_mask", 0x0B72, 1),
    ("render_mode", 0x0C40, 1),
    ("program", 0x8B8D, 1),
    ("framebuffer", 0x8CA6, 1),
    ("stencil_test", 0x0B90, 1),
    ("stencil", 0x0B92, 1),
    ("stencil", 0x0B97, 1),
    ("stencil", 0x0B93, 1),
    ("lighting", 0x0B50, 1),
    ("textured", 0x0DE1, 1),
    ("specular", 0x1202, 4),  # of the front material: floats
    *(("clip", plane, 1) for plane in range(0x3000, 0x3006)),
)
_MODELVIEW_BYTES = 64
_COUNT = sum(n for _, n in _FLOATS) + sum(n for _, _, n in _INTEGERS)

_CCW, _FILL, _RENDER = 0x0901, 0x1B02, 0x1C00
_LIGHT_0, _POSITION = 0x4000, 0x1203
_LIGHTING, _COLOR_MATERIAL, _CURRENT_COLOR = 0x0B50, 0x0B57, 0x0B00
_FRONT, _DIFFUSE = 0x0404, 0x1201
_CURRENT_NORMAL = 0x0B02
_DULL = 0.05
"""A material with less of a specular colour does not gleam."""
_LESS, _EQUAL, _LEQUAL = 0x0201, 0x0202, 0x0203


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
    obstacle: str
    """Why polygons drawn now cannot carry lines; empty when they can."""
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
        self._stencil_test = ctypes.c_int32()
        self._lit_calls: list[Callable[[], None]] = []
        self._lit = ctypes.c_int32()
        self._clips = False
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

    def read(self) -> DrawState:
        """The state now. A compatibility context must be current, outside glBegin/glEnd."""
        for get in self._calls or self._prepare():
            get()
        if self._stencil_test.value:
            for get in self._stencil_calls:
                get()
        if self._lit.value:  # only then: Mesa flushes what it holds when it is asked for a material
            for get in self._lit_calls:
                get()
        key = bytes(self._buffer)
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
        self._stencil_calls = []
        for kind, name, count in _INTEGERS:
            call = partial(integers, name, self._at(offset))
            if kind == "stencil":
                self._stencil_calls.append(call)
            elif kind == "specular":
                material = quick("glGetMaterialfv")
                self._lit_calls = [partial(material, _FRONT, name, self._at(offset))]
            elif _is_asked(kind, clips=self._clips, lighting=self._lighting):
                self._calls.append(call)
            if kind == "lighting":
                self._lit = ctypes.c_int32.from_buffer(self._buffer, 4 * offset)
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
            rest = self._rest[key[_MODELVIEW_BYTES:]] = _decode_rest(key)
        c = rest.camera
        modelview = np.frombuffer(key, np.float32, 16).astype(np.float64).reshape(4, 4).T
        camera = Camera(
            modelview, c.projection, c.viewport, c.depth_range, c.front_ccw, c.scissor,
            c.clip_planes, c.stencil, c.lit, c.gleams, c.textured,
        )  # fmt: skip
        return DrawState(
            camera, rest.framebuffer, rest.depth_tested, rest.depth_written, rest.flat,
            rest.obstacle, rest.fill_faces,
        )  # fmt: skip


def _brightest(words: tuple[int, ...]) -> float:
    """The greatest channel of a colour whose floats were read as integers."""
    red, green, blue, _ = struct.unpack("=4f", struct.pack("=4i", *words))
    return max(float(red), float(green), float(blue))


def _is_asked(kind: str, *, clips: bool, lighting: bool) -> bool:
    """Whether a kind of value is in the key."""
    return {"clip": clips, "lighting": lighting, "textured": lighting}.get(kind, True)


def _decode_rest(key: bytes) -> DrawState:
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
        front_ccw=values["front_face"][0] == _CCW,
        scissor=values["scissor"] if values["scissor_test"][0] else None,  # type: ignore[arg-type]
        clip_planes=_clip_planes(values["clip"]),
        stencil=values["stencil"] if values["stencil_test"][0] else None,  # type: ignore[arg-type]
        lit=bool(values["lighting"][0]),
        textured=bool(values["textured"][0]),
        gleams=bool(values["lighting"][0]) and _brightest(values["specular"]) > _DULL,
    )
    func = values["depth_func"][0]
    depth = bool(values["depth_test"][0]) and func in (_LESS, _EQUAL, _LEQUAL)
    obstacle = ""
    if values["render_mode"][0] != _RENDER:
        obstacle = "selection or feedback"
    elif values["program"][0]:
        obstacle = "the app's own shader program is in use"
    elif not any(values["color_mask"]):
        obstacle = "no colour is written"
    elif values["depth_test"][0] and not depth:
        obstacle = "the depth function is not less or less-or-equal"
    return DrawState(
        camera=camera,
        framebuffer=values["framebuffer"][0],
        depth_tested=depth,
        depth_written=bool(values["depth_mask"][0]),
        flat=camera.orthographic,
        obstacle=obstacle,
        fill_faces=values["polygon_mode"] == (_FILL, _FILL),
    )


def _any_clip_plane_was_set() -> bool:
    """Whether some clip plane has another equation than the one it begins with, all zero."""
    equation = (ctypes.c_double * 4)()
    for i in range(6):
        gl.glGetClipPlane(0x3000 + i, equation)
        if any(equation):
            return True
    return False


def _clip_planes(enabled: tuple[int, ...]) -> tuple[tuple[float, float, float, float], ...]:
    """Equations in eye space of the user clip planes that are on."""
    found = []
    for i, on in enumerate(enabled):
        if on:
            equation = (ctypes.c_double * 4)()
            gl.glGetClipPlane(0x3000 + i, equation)
            found.append((equation[0], equation[1], equation[2], equation[3]))
    return tuple(found)


def light() -> tuple[float, float, float, float]:
    """Where GL_LIGHT0 is in eye space, homogeneous: a direction towards it where w = 0. It stays
    there when lighting is off."""
    place = (ctypes.c_float * 4)()
    gl.glGetLightfv(_LIGHT_0, _POSITION, ctypes.addressof(place))
    return place[0], place[1], place[2], place[3]


def colour() -> bytes:
    """The record of a glColor4f with the colour that vertices have until they are given another:
    the material's where lighting knows no other. Outside glBegin/glEnd."""
    shade = (ctypes.c_float * 4)()
    if gl.glIsEnabled(_LIGHTING) and not gl.glIsEnabled(_COLOR_MATERIAL):
        gl.glGetMaterialfv(_FRONT, _DIFFUSE, ctypes.addressof(shade))
    else:
        gl.glGetFloatv(_CURRENT_COLOR, ctypes.addressof(shade))
    row = BY_NAME["glColor4f"]
    return row.pack.pack(*shade, row.tag)


def normal() -> bytes:
    """The record of a glNormal3f with the normal that vertices have until they are given another.
    Outside glBegin/glEnd."""
    now = (ctypes.c_float * 4)()
    gl.glGetFloatv(_CURRENT_NORMAL, ctypes.addressof(now))
    row = BY_NAME["glNormal3f"]
    return row.pack.pack(*now[:3], row.tag)


def unsupported() -> str:
    """Why the current context cannot be styled, empty when it can. Costs a few queries."""
    if not current_context():
        return "no context is current"
    return shortcoming()
