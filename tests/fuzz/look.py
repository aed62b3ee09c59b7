"""What a program could ask about its context, all at once: some thousands of values as bytes.

Asked below PyOpenGL, without touching the error flag or anything else: rows that fail in a fresh
context of this kind are left out, and those about an object are asked where there is one.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache

from OpenGL import GL
from OpenGL.raw.GL._glgets import _glget_size_mapping as SIZES

from tests.fuzz.bare import driver
from tests.fuzz.registry import registry

UNITS, ATTRIBUTES, NAMES = 4, 16, 8
"""Texture units, generic attributes and names of objects that are looked at."""
_LEFT_OUT = (
    "TIMESTAMP", "READ_FORMAT", "READ_TYPE", "NUM_EXTENSIONS", "FRAMEBUFFER_DEFAULT",
    "CONTEXT_FLAGS", "DEBUG_LOGGED", "DEBUG_NEXT", "CURRENT_PROGRAM",
)  # fmt: skip
"""Values that depend on the moment, that need a complete framebuffer, or that say who debugs.
Programs and shaders have other names below PyOpenGL: programs ask for those themselves."""
_MATRICES = ("GL_MODELVIEW_MATRIX", "GL_PROJECTION_MATRIX", "GL_COLOR_MATRIX")
_OF_A_UNIT = ("TEXTURE_MATRIX", "CURRENT_RASTER_TEXTURE", "TEXTURE_COORD", "TEXTURE_BINDING")
"""Errors, where more units have images than have coordinates: asked unit by unit."""


@dataclass(frozen=True, slots=True)
class Row:
    """One question."""

    name: str
    function: str
    args: tuple[int, ...]
    size: int
    """Bytes of the answer: of the pointer, or of what is returned."""
    returns: bool = False
    guard: tuple[str, int] | None = None
    """Asked only if this glIs* is true of this name."""

    @property
    def is_address(self) -> bool:
        """Whether the answer may be one, which is another in each process."""
        return "Pointer" in self.function or "BINDING_OFFSET" in self.name


def _values() -> Iterator[Row]:
    seen = set()
    groups = registry().groups
    tokens = (*groups["GetPName"], *groups["EnableCap"], *_MORE)
    for name in dict.fromkeys(tokens):
        token = getattr(GL, name, None)
        if token is None or int(token) in seen or any(part in name for part in _LEFT_OUT):
            continue
        if any(part in name for part in _OF_A_UNIT):
            continue
        seen.add(int(token))
        shape = SIZES.get(int(token), (1,))
        count = 1
        for length in shape if isinstance(shape, tuple) else (4,):
            count *= int(length)
        if name in _MATRICES or ("MATRIX" in name and "DEPTH" not in name and "MODE" not in name):
            count = 16
        yield Row(name, "glGetDoublev", (int(token),), 8 * min(max(count, 4), 16))


_MORE = (
    "GL_POLYGON_MODE", "GL_FOG_COORD_ARRAY", "GL_SECONDARY_COLOR_ARRAY",
    "GL_RASTER_POSITION_UNCLIPPED_IBM", "GL_CURRENT_PROGRAM", "GL_PROGRAM_PIPELINE_BINDING",
    "GL_SAMPLER_BINDING", "GL_FRAMEBUFFER_BINDING", "GL_READ_FRAMEBUFFER_BINDING",
    "GL_RENDERBUFFER_BINDING", "GL_VERTEX_ARRAY_BINDING", "GL_RENDER_MODE",
    "GL_TRANSFORM_FEEDBACK_BINDING", "GL_TRANSFORM_FEEDBACK_ACTIVE",
    "GL_TRANSFORM_FEEDBACK_PAUSED", "GL_FEEDBACK_BUFFER_SIZE", "GL_SELECTION_BUFFER_SIZE",
    "GL_LIST_MODE", "GL_LIST_INDEX", "GL_LIST_BASE", "GL_CLIENT_ACTIVE_TEXTURE",
    "GL_ELEMENT_ARRAY_BUFFER_BINDING", "GL_DRAW_INDIRECT_BUFFER_BINDING", "GL_COPY_READ_BUFFER",
    "GL_COPY_WRITE_BUFFER", "GL_QUERY_BUFFER_BINDING", "GL_CLIP_ORIGIN", "GL_CLIP_DEPTH_MODE",
    "GL_PROVOKING_VERTEX", "GL_PRIMITIVE_RESTART_INDEX", "GL_SAMPLE_COVERAGE_VALUE",
    "GL_RESCALE_NORMAL", "GL_NORMALIZE", "GL_COLOR_SUM", "GL_FOG_COORD_SRC",
    "GL_CURRENT_FOG_COORD", "GL_CURRENT_SECONDARY_COLOR", "GL_DEBUG_OUTPUT",
    "GL_DEBUG_OUTPUT_SYNCHRONOUS", "GL_DEBUG_GROUP_STACK_DEPTH", "GL_CLAMP_READ_COLOR",
    "GL_CLAMP_VERTEX_COLOR", "GL_CLAMP_FRAGMENT_COLOR", "GL_PATCH_VERTICES",
    "GL_MIN_SAMPLE_SHADING_VALUE", "GL_SAMPLE_SHADING",
)  # fmt: skip
_INDEXED = (
    ("GL_UNIFORM_BUFFER_BINDING", 4), ("GL_TRANSFORM_FEEDBACK_BUFFER_BINDING", 4),
    ("GL_SHADER_STORAGE_BUFFER_BINDING", 4), ("GL_ATOMIC_COUNTER_BUFFER_BINDING", 2),
    ("GL_IMAGE_BINDING_NAME", 4), ("GL_SAMPLE_MASK_VALUE", 1), ("GL_VERTEX_BINDING_STRIDE", 16),
    ("GL_VERTEX_BINDING_OFFSET", 16), ("GL_VERTEX_BINDING_DIVISOR", 16),
    ("GL_VERTEX_BINDING_BUFFER", 16), ("GL_BLEND_SRC_RGB", 4), ("GL_BLEND_EQUATION_RGB", 4),
    ("GL_VIEWPORT", 3), ("GL_SCISSOR_BOX", 3),
)  # fmt: skip
_LIGHT = {"AMBIENT": 4, "DIFFUSE": 4, "SPECULAR": 4, "POSITION": 4, "SPOT_DIRECTION": 3,
          "SPOT_EXPONENT": 1, "SPOT_CUTOFF": 1, "CONSTANT_ATTENUATION": 1, "LINEAR_ATTENUATION": 1,
          "QUADRATIC_ATTENUATION": 1}  # fmt: skip
_MATERIAL = {"AMBIENT": 4, "DIFFUSE": 4, "SPECULAR": 4, "EMISSION": 4, "SHININESS": 1,
             "COLOR_INDEXES": 3}  # fmt: skip
_POINTERS = (
    "VERTEX_ARRAY", "NORMAL_ARRAY", "COLOR_ARRAY", "INDEX_ARRAY", "EDGE_FLAG_ARRAY",
    "FOG_COORD_ARRAY", "SECONDARY_COLOR_ARRAY", "FEEDBACK_BUFFER", "SELECTION_BUFFER",
    "DEBUG_CALLBACK_FUNCTION", "DEBUG_CALLBACK_USER_PARAM",
)  # fmt: skip
_ATTRIBUTE = ("ENABLED", "SIZE", "STRIDE", "TYPE", "NORMALIZED", "INTEGER", "DIVISOR",
              "BUFFER_BINDING")  # fmt: skip
_TARGETS = ("1D", "2D", "3D", "CUBE_MAP", "RECTANGLE", "1D_ARRAY", "2D_ARRAY", "BUFFER",
            "2D_MULTISAMPLE", "CUBE_MAP_ARRAY")  # fmt: skip
_TEXTURE = ("MAG_FILTER", "MIN_FILTER", "WRAP_S", "WRAP_T", "WRAP_R", "BASE_LEVEL", "MAX_LEVEL",
            "PRIORITY", "COMPARE_MODE", "DEPTH_STENCIL_TEXTURE_MODE",
            "IMMUTABLE_FORMAT")  # fmt: skip
_LEVEL = ("WIDTH", "HEIGHT", "DEPTH", "INTERNAL_FORMAT", "SAMPLES")
_ENV = {"MODE": 1, "COLOR": 4}
_COMBINE = ("COMBINE_RGB", "COMBINE_ALPHA", "SRC0_RGB", "SRC1_RGB", "OPERAND0_RGB", "RGB_SCALE")
_OBJECTS = ("Texture", "Buffer", "Framebuffer", "Renderbuffer", "Query",
            "Sampler", "VertexArray", "TransformFeedback", "ProgramPipeline", "List")  # fmt: skip


def _gl(name: str) -> int:
    return int(getattr(GL, "GL_" + name))


def _rows() -> Iterator[Row]:
    """What may be asked while a list is open, too."""
    yield from _values()
    for name, count in _INDEXED:
        for index in range(count):
            real = name in ("GL_VIEWPORT", "GL_SCISSOR_BOX")
            yield Row(f"{name} {index}", "glGetDoublei_v" if real else "glGetIntegeri_v",
                      (int(getattr(GL, name)), index), 32)  # fmt: skip
    for index in range(4):
        for name in ("GL_BLEND", "GL_SCISSOR_TEST"):
            yield Row(f"{name} {index}", "glIsEnabledi", (int(getattr(GL, name)), index), 1, True)
        yield Row(
            f"GL_COLOR_WRITEMASK {index}", "glGetBooleani_v", (GL.GL_COLOR_WRITEMASK, index), 4
        )
    for face in ("FRONT", "BACK"):
        for name, count in _MATERIAL.items():
            yield Row(f"{face} {name}", "glGetMaterialfv", (_gl(face), _gl(name)), 4 * count)
    for light in range(3):
        for name, count in _LIGHT.items():
            yield Row(
                f"light {light} {name}",
                "glGetLightfv",
                (GL.GL_LIGHT0 + light, _gl(name)),
                4 * count,
            )
    for plane in range(3):
        yield Row(f"clip plane {plane}", "glGetClipPlane", (GL.GL_CLIP_PLANE0 + plane,), 32)
    for name in _POINTERS:
        whole = name if name.startswith("DEBUG") else name + "_POINTER"
        yield Row(f"pointer {name}", "glGetPointerv", (_gl(whole),), 8)
    for index in range(ATTRIBUTES):
        for name in _ATTRIBUTE:
            whole = f"VERTEX_ATTRIB_ARRAY_{name}"
            yield Row(f"attribute {index} {name}", "glGetVertexAttribiv", (index, _gl(whole)), 4)
        yield Row(f"attribute {index} pointer", "glGetVertexAttribPointerv",
                  (index, GL.GL_VERTEX_ATTRIB_ARRAY_POINTER), 8)  # fmt: skip
        if index:
            yield Row(f"attribute {index} now", "glGetVertexAttribdv",
                      (index, GL.GL_CURRENT_VERTEX_ATTRIB), 32)  # fmt: skip
    for kind in _OBJECTS:
        for name in range(1, NAMES + 1):
            yield Row(f"is {kind} {name}", f"glIs{kind}", (name,), 1, True)
    for target in ("SAMPLES_PASSED", "ANY_SAMPLES_PASSED", "PRIMITIVES_GENERATED", "TIME_ELAPSED",
                   "TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN"):  # fmt: skip
        yield Row(f"query {target}", "glGetQueryiv", (_gl(target), GL.GL_CURRENT_QUERY), 4)
    yield from _objects()


def _objects() -> Iterator[Row]:
    for name in range(1, NAMES + 1):
        is_texture = ("glIsTexture", name)
        for what in _TEXTURE:
            whole = what if what.startswith("DEPTH") else f"TEXTURE_{what}"
            yield Row(f"texture {name} {what}", "glGetTextureParameteriv", (name, _gl(whole)), 4,
                      guard=is_texture)  # fmt: skip
        is_buffer = ("glIsBuffer", name)
        for what in ("SIZE", "USAGE", "ACCESS", "MAPPED"):
            yield Row(f"buffer {name} {what}", "glGetNamedBufferParameteriv",
                      (name, _gl(f"BUFFER_{what}")), 4, guard=is_buffer)  # fmt: skip
        is_renderbuffer = ("glIsRenderbuffer", name)
        for what in ("WIDTH", "HEIGHT", "INTERNAL_FORMAT", "SAMPLES"):
            yield Row(f"renderbuffer {name} {what}", "glGetNamedRenderbufferParameteriv",
                      (name, _gl(f"RENDERBUFFER_{what}")), 4, guard=is_renderbuffer)  # fmt: skip
        is_framebuffer = ("glIsFramebuffer", name)
        for what in ("COLOR_ATTACHMENT0", "DEPTH_ATTACHMENT", "STENCIL_ATTACHMENT"):
            yield Row(f"framebuffer {name} {what}", "glGetNamedFramebufferAttachmentParameteriv",
                      (name, _gl(what), GL.GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE), 4,
                      guard=is_framebuffer)  # fmt: skip


def _unit_rows() -> Iterator[Row]:
    """What hangs on the active texture unit."""
    yield Row("texture matrix", "glGetDoublev", (GL.GL_TEXTURE_MATRIX,), 128)
    yield Row("texture stack", "glGetIntegerv", (GL.GL_TEXTURE_STACK_DEPTH,), 4)
    yield Row("texture coordinates", "glGetDoublev", (GL.GL_CURRENT_TEXTURE_COORDS,), 32)
    yield Row("raster coordinates", "glGetDoublev", (GL.GL_CURRENT_RASTER_TEXTURE_COORDS,), 32)
    for target in _TARGETS:
        yield Row(f"binding {target}", "glGetIntegerv", (_gl(f"TEXTURE_BINDING_{target}"),), 4)
    for target in ("1D", "2D", "3D", "CUBE_MAP", "GEN_S", "GEN_T", "GEN_R", "GEN_Q"):
        yield Row(f"enabled {target}", "glIsEnabled", (_gl(f"TEXTURE_{target}"),), 1, True)
    yield Row("sampler", "glGetIntegerv", (GL.GL_SAMPLER_BINDING,), 4)
    for name, count in _ENV.items():
        yield Row(
            f"env {name}",
            "glGetTexEnvfv",
            (GL.GL_TEXTURE_ENV, _gl(f"TEXTURE_ENV_{name}")),
            4 * count,
        )
    for name in _COMBINE:
        yield Row(f"env {name}", "glGetTexEnviv", (GL.GL_TEXTURE_ENV, _gl(name)), 4)
    yield Row("bias", "glGetTexEnvfv", (GL.GL_TEXTURE_FILTER_CONTROL, GL.GL_TEXTURE_LOD_BIAS), 4)
    for coordinate in ("S", "T", "R", "Q"):
        yield Row(
            f"gen {coordinate}", "glGetTexGeniv", (_gl(coordinate), GL.GL_TEXTURE_GEN_MODE), 4
        )
        for plane in ("OBJECT_PLANE", "EYE_PLANE"):
            yield Row(
                f"gen {coordinate} {plane}", "glGetTexGendv", (_gl(coordinate), _gl(plane)), 32
            )
    for level in (0, 1):
        for what in _LEVEL:
            yield Row(f"2D level {level} {what}", "glGetTexLevelParameteriv",
                      (GL.GL_TEXTURE_2D, level, _gl(f"TEXTURE_{what}")), 4)  # fmt: skip


def _client_rows() -> Iterator[Row]:
    yield Row("texture array", "glIsEnabled", (GL.GL_TEXTURE_COORD_ARRAY,), 1, True)
    for what in ("SIZE", "TYPE", "STRIDE", "BUFFER_BINDING"):
        yield Row(
            f"texture array {what}", "glGetIntegerv", (_gl(f"TEXTURE_COORD_ARRAY_{what}"),), 4
        )
    yield Row("texture array pointer", "glGetPointerv", (GL.GL_TEXTURE_COORD_ARRAY_POINTER,), 8)


ROWS, UNIT_ROWS, CLIENT_ROWS = tuple(_rows()), tuple(_unit_rows()), tuple(_client_rows())
_ROOM = 256
"""Bytes beyond the last answer: a driver may say more than its registry does."""


@cache
def _offsets(rows: tuple[Row, ...]) -> tuple[int, ...]:
    found, at = [], 0
    for row in rows:
        found.append(at)
        at += row.size
    return (*found, at)


class Eyes:
    """Looks at contexts of one kind; made while a fresh one is current."""

    def __init__(self) -> None:
        self._buffer = ctypes.create_string_buffer(max(_offsets(ROWS)[-1], 1) + _ROOM)
        self._base = ctypes.addressof(self._buffer)
        self._good = {part: self._probe(rows) for part, rows in PARTS.items()}

    def _probe(self, rows: tuple[Row, ...]) -> list[tuple[Row, int]]:
        good = []
        for row, at in zip(rows, _offsets(rows), strict=False):
            while driver.glGetError():
                pass
            try:
                function = getattr(driver, row.function)
            except AttributeError:
                continue
            if row.guard is None:
                function(*row.args, *(() if row.returns else (self._base + at,)))
            if not driver.glGetError():
                good.append((row, at))
        return good

    def _ask(self, part: str, place: Callable[[int], int]) -> bytes:
        size = _offsets(PARTS[part])[-1]
        ctypes.memset(self._base, 0, size + _ROOM)
        for row, at in self._good[part]:
            if row.guard is not None and not getattr(driver, row.guard[0])(row.guard[1]):
                continue
            function = getattr(driver, row.function)
            if row.returns:
                self._buffer[at] = function(*row.args)
            else:
                function(*row.args, self._base + at)
                if row.is_address:
                    self._put(at, place(self._get(at)))
        return bytes(self._buffer[:size])

    def _get(self, at: int) -> int:
        return int.from_bytes(self._buffer[at : at + 8], "little")

    def _put(self, at: int, value: int) -> None:
        self._buffer[at : at + 8] = value.to_bytes(8, "little")

    def look(self, place: Callable[[int], int]) -> dict[str, bytes]:
        """By part of the state. Not inside a primitive: nothing can be asked there. place: what is
        told of an address, which is another in each process."""
        number = ctypes.c_int(-1)
        driver.glGetIntegerv(GL.GL_LIST_INDEX, ctypes.addressof(number))
        found = {"state": self._ask("state", place)}
        if number.value:  # what selects a unit would be compiled
            return found
        for part, name, select in (
            ("unit", GL.GL_ACTIVE_TEXTURE, driver.glActiveTexture),
            ("client", GL.GL_CLIENT_ACTIVE_TEXTURE, driver.glClientActiveTexture),
        ):
            if not self._good[part]:
                continue
            driver.glGetIntegerv(name, ctypes.addressof(number))
            for unit in range(UNITS):
                select(GL.GL_TEXTURE0 + unit)
                found[f"{part} {unit}"] = self._ask(part, place)
            select(number.value)
        return found


PARTS = {"state": ROWS, "unit": UNIT_ROWS, "client": CLIENT_ROWS}


def inside() -> bool:
    """Whether a primitive is open: then glGet* fails."""
    number = ctypes.c_int(-1)
    driver.glGetIntegerv(GL.GL_LIST_INDEX, ctypes.addressof(number))
    return number.value < 0


def explain(part: str, one: bytes, other: bytes) -> Iterator[tuple[str, str, str]]:
    """Name and both answers, of each row that differs."""
    rows = PARTS[part.partition(" ")[0]]
    for row, at in zip(rows, _offsets(rows), strict=False):
        a, b = one[at : at + row.size], other[at : at + row.size]
        if a != b:
            yield f"{part}: {row.name}", _said(row, a), _said(row, b)


def _said(row: Row, answer: bytes) -> str:
    for ending, kind, size in (("dv", "d", 8), ("ei_v", "d", 8), ("fv", "f", 4)):
        if row.function.endswith(ending) and not len(answer) % size:
            return str([float(f"{x:.7g}") for x in memoryview(answer).cast(kind)])
    if not len(answer) % 4:
        return str(memoryview(answer).cast("i").tolist())
    return str(list(answer))
