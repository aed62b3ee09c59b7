"""Calls by which a program's objects get their names, as data."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum
from functools import cache

from glshim.spec.constants import (
    GL_ACTIVE_PROGRAM,
    GL_COMPUTE_SHADER,
    GL_CURRENT_PROGRAM,
    GL_FRAGMENT_SHADER,
    GL_GEOMETRY_SHADER,
    GL_PROGRAM,
    GL_SHADER,
    GL_TESS_CONTROL_SHADER,
    GL_TESS_EVALUATION_SHADER,
    GL_TEXTURE_1D,
    GL_TEXTURE_1D_ARRAY,
    GL_TEXTURE_2D,
    GL_TEXTURE_2D_ARRAY,
    GL_TEXTURE_2D_MULTISAMPLE,
    GL_TEXTURE_2D_MULTISAMPLE_ARRAY,
    GL_TEXTURE_3D,
    GL_TEXTURE_BINDING_1D,
    GL_TEXTURE_BINDING_1D_ARRAY,
    GL_TEXTURE_BINDING_2D,
    GL_TEXTURE_BINDING_2D_ARRAY,
    GL_TEXTURE_BINDING_2D_MULTISAMPLE,
    GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY,
    GL_TEXTURE_BINDING_3D,
    GL_TEXTURE_BINDING_BUFFER,
    GL_TEXTURE_BINDING_CUBE_MAP,
    GL_TEXTURE_BINDING_CUBE_MAP_ARRAY,
    GL_TEXTURE_BINDING_RECTANGLE,
    GL_TEXTURE_BUFFER,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_CUBE_MAP_ARRAY,
    GL_TEXTURE_RECTANGLE,
    GL_VERTEX_SHADER,
)
from glshim.spec.kinds import BUFFER, FRAMEBUFFER, RENDERBUFFER, TEXTURE, Kind


class Naming(Enum):
    """How a call has to do with names."""

    GENERATES = "gives some names; their number is at the position, the memory for them next"
    CREATES = "the same, and makes the objects"
    MEETS = "may make an object of the name at the position, which the program chose"


@dataclass(frozen=True, slots=True)
class Row:
    """Of calls alike."""

    kind: Kind
    naming: Naming
    position: int
    pattern: str


ROWS = (
    Row(TEXTURE, Naming.GENERATES, 0, r"glGenTextures(EXT)?"),
    Row(TEXTURE, Naming.CREATES, 1, r"glCreateTextures"),
    Row(TEXTURE, Naming.MEETS, 1, r"glBindTexture(EXT)?"),
    Row(TEXTURE, Naming.MEETS, 2, r"glBindMultiTextureEXT"),
    Row(TEXTURE, Naming.MEETS, 0, r"glGetTexture\w+EXT|gl(Compressed|Copy)Texture\w+EXT"),
    Row(TEXTURE, Naming.MEETS, 0, r"glTexture(?!Light|Material|Normal)\w+EXT"),
    Row(TEXTURE, Naming.MEETS, 0, r"glGenerateTextureMipmapEXT"),
    Row(BUFFER, Naming.GENERATES, 0, r"glGenBuffers(ARB)?"),
    Row(BUFFER, Naming.CREATES, 0, r"glCreateBuffers"),
    Row(BUFFER, Naming.MEETS, 1, r"glBindBuffer(ARB)?|glBindVertexBuffer"),
    Row(BUFFER, Naming.MEETS, 1, r"glVertexArray\w+OffsetEXT"),
    Row(BUFFER, Naming.MEETS, 2, r"glBindBuffer(Base|Range|Offset)(EXT|NV)?"),
    Row(BUFFER, Naming.MEETS, 2, r"glVertexArray(BindVertexBufferEXT|VertexBuffer)"),
    Row(BUFFER, Naming.MEETS, 0, r"gl(Clear|Get|Map|Unmap)?NamedBuffer\w*EXT"),
    Row(BUFFER, Naming.MEETS, 0, r"glFlushMappedNamedBufferRangeEXT"),
    Row(FRAMEBUFFER, Naming.GENERATES, 0, r"glGenFramebuffers(EXT)?"),
    Row(FRAMEBUFFER, Naming.CREATES, 0, r"glCreateFramebuffers"),
    Row(FRAMEBUFFER, Naming.MEETS, 1, r"glBindFramebuffer(EXT)?"),
    Row(FRAMEBUFFER, Naming.MEETS, 0, r"glClearNamedFramebuffer(fi|(f|i|ui)v)"),
    Row(FRAMEBUFFER, Naming.MEETS, 0, r"gl(Check|Get)?NamedFramebuffer\w+EXT"),
    Row(FRAMEBUFFER, Naming.MEETS, 0, r"glFramebuffer(Draw|Read)Buffers?EXT"),
    Row(FRAMEBUFFER, Naming.MEETS, 0, r"glGetFramebufferParameterivEXT"),
    Row(RENDERBUFFER, Naming.GENERATES, 0, r"glGenRenderbuffers(EXT)?"),
    Row(RENDERBUFFER, Naming.CREATES, 0, r"glCreateRenderbuffers"),
    Row(RENDERBUFFER, Naming.MEETS, 1, r"glBindRenderbuffer(EXT)?"),
    Row(RENDERBUFFER, Naming.MEETS, 0, r"gl(Get)?NamedRenderbuffer\w+EXT"),
)  # fmt: skip

MAKERS = r"glCreate(Program|Shader)(ObjectARB)?|glCreateShaderProgram(v|vEXT|EXT)"
"""Calls that make a program or shader and return its name."""
RETURNS = r"glGetHandleARB"
"""Calls that return the name of one that is there."""
PLACES: tuple[tuple[tuple[int, ...], str], ...] = (
    ((0,), r"glActive(ProgramEXT|VaryingNV)|glBind(Attrib|FragData)Location\w*"),
    ((0,), r"glCompileShader(ARB|IncludeARB)?|glDelete(Program|Shader|ObjectARB)"),
    ((0,), r"glGetActive(AtomicCounterBuffer|Attrib|Subroutine|Uniform|Varying)\w*"),
    ((0,), r"glGetAttached(Shaders|ObjectsARB)|glGetAttribLocation(ARB)?|glGetFragData\w+"),
    ((0,), r"glGetInfoLogARB|glGetObjectParameter[fi]vARB|glGetShader(InfoLog|Source(ARB)?|iv)"),
    ((0,), r"glGetProgram(Binary|InfoLog|Interfaceiv|Resource(?!sResident)\w+|Stageiv|iv)"),
    ((0,), r"glGetSubroutine(Index|UniformLocation)|glGetTransformFeedbackVarying(EXT|NV)?"),
    ((0,), r"glGetn?Uniform([dfi]|ui|u?i64)v(ARB|EXT|KHR|NV)?|glGetVaryingLocationNV"),
    ((0,), r"glGetUniform(BlockIndex|BufferSizeEXT|Indices|Location(ARB)?|OffsetEXT)"),
    ((0,), r"glIs(Program|Shader)|glLinkProgram(ARB)?|glProgramBinary|glValidateProgram(ARB)?"),
    ((0,), r"glProgramParameteri(ARB|EXT)?|glProgramPathFragmentInputGenNV|glProgramUniform\w+"),
    ((0,), r"glShaderSource(ARB)?|glShaderStorageBlockBinding|glSpecializeShader(ARB)?"),
    ((0,), r"glTransformFeedbackVaryings(EXT|NV)?|glUniform(BlockBinding|BufferEXT)"),
    ((0,), r"glUseProgram(ObjectARB)?"),
    ((0, 1), r"gl(Attach|Detach)(Shader|ObjectARB)"),
    ((1,), r"glActiveShaderProgram(EXT)?|glUseShaderProgramEXT"),
    ((2,), r"glUseProgramStages(EXT)?"),
)
"""Calls with names of programs and shaders among their arguments, by position."""
PLAIN = (
    ("OpenGL.GL.VERSION.GL_2_0", "glShaderSource"),
    ("OpenGL.GL.ARB.shader_objects", "glShaderSourceARB"),
)
"""Of these, modules where PyOpenGL has another function of ctypes' beside the raw one."""
LABELS = r"gl(Get)?ObjectLabel(KHR)?"
"""Calls whose second argument is such a name where the first says so."""
LABELLED = (GL_PROGRAM, GL_SHADER)
ROWS_OF_NAMES = {
    r"glShaderBinary": (0, 1), r"glGetAttachedShaders|glGetAttachedObjectsARB": (2, 3),
}  # fmt: skip
"""Where calls have the number of names in an array, and the array."""
ANSWERS: dict[str, tuple[str, int]] = {
    "glGetIntegerv": ("i", 1), "glGetInteger64v": ("n", 1), "glGetFloatv": ("f", 1),
    "glGetDoublev": ("d", 1), "glGetProgramPipelineiv": ("i", 2),
    "glGetProgramPipelineivEXT": ("i", 2),
}  # fmt: skip
"""Calls that may answer with such a name: the letter of its type (`glshim.spec.signatures`), and
the position of the memory for it, after that of the question."""
ASKED = (
    GL_CURRENT_PROGRAM, GL_ACTIVE_PROGRAM, GL_VERTEX_SHADER, GL_FRAGMENT_SHADER,
    GL_GEOMETRY_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_COMPUTE_SHADER,
)  # fmt: skip
"""Questions that are answered so."""

BINDINGS = {
    GL_TEXTURE_1D: GL_TEXTURE_BINDING_1D,
    GL_TEXTURE_2D: GL_TEXTURE_BINDING_2D,
    GL_TEXTURE_3D: GL_TEXTURE_BINDING_3D,
    GL_TEXTURE_CUBE_MAP: GL_TEXTURE_BINDING_CUBE_MAP,
    GL_TEXTURE_RECTANGLE: GL_TEXTURE_BINDING_RECTANGLE,
    GL_TEXTURE_1D_ARRAY: GL_TEXTURE_BINDING_1D_ARRAY,
    GL_TEXTURE_2D_ARRAY: GL_TEXTURE_BINDING_2D_ARRAY,
    GL_TEXTURE_CUBE_MAP_ARRAY: GL_TEXTURE_BINDING_CUBE_MAP_ARRAY,
    GL_TEXTURE_BUFFER: GL_TEXTURE_BINDING_BUFFER,
    GL_TEXTURE_2D_MULTISAMPLE: GL_TEXTURE_BINDING_2D_MULTISAMPLE,
    GL_TEXTURE_2D_MULTISAMPLE_ARRAY: GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY,
}
"""Of textures by target."""


@cache
def row_of(name: str) -> Row | None:
    """What a GL entry point has to do with names, if anything."""
    return next((row for row in ROWS if re.fullmatch(row.pattern, name)), None)


@cache
def places_of(name: str) -> tuple[int, ...]:
    """Where a GL entry point has names of programs and shaders among its arguments."""
    found = (places for places, pattern in PLACES if re.fullmatch(pattern, name))
    return next(found, ())


def makes(name: str) -> bool:
    """Whether a GL entry point makes a program or shader and returns its name."""
    return re.fullmatch(MAKERS, name) is not None


def returns(name: str) -> bool:
    """Whether it returns the name of one that is there."""
    return re.fullmatch(RETURNS, name) is not None


def labels(name: str) -> bool:
    """Whether its first two arguments say what it is about."""
    return re.fullmatch(LABELS, name) is not None


def row_of_names(name: str) -> tuple[int, int] | None:
    """Where it has a number of names of shaders, and the array of them."""
    found = (at for pattern, at in ROWS_OF_NAMES.items() if re.fullmatch(pattern, name))
    return next(found, None)
