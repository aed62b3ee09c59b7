"""Any command of OpenGL 1.0 to 4.6, with arguments of the right kinds, mostly."""

from __future__ import annotations

from functools import cache

from tests.fuzz.registry import Command, Parameter, registry
from tests.fuzz.writing import Writer, area

LEFT_OUT = {
    "reads counts from memory that is anything": (
        "glDrawArraysIndirect",
        "glDrawElementsIndirect",
        "glMultiDrawArraysIndirect",
        "glMultiDrawElementsIndirect",
        "glDispatchComputeIndirect",
        "glMultiDrawArraysIndirectCount",
        "glMultiDrawElementsIndirectCount",
    ),
    "reads addresses from memory that is anything": (
        "glMultiDrawElements",
        "glMultiDrawElementsBaseVertex",
        "glShaderSource",
        "glCreateShaderProgramv",
        "glTransformFeedbackVaryings",
        "glGetUniformIndices",
        "glBindVertexBuffers",
        "glVertexArrayVertexBuffers",
    ),
    "draws from whatever the arrays point to: see arrays": (
        "glDrawArrays",
        "glDrawElements",
        "glDrawRangeElements",
        "glArrayElement",
        "glMultiDrawArrays",
        "glDrawArraysInstanced",
        "glDrawElementsInstanced",
        "glDrawElementsBaseVertex",
        "glDrawRangeElementsBaseVertex",
        "glDrawElementsInstancedBaseVertex",
        "glDrawArraysInstancedBaseInstance",
        "glDrawElementsInstancedBaseInstance",
        "glDrawElementsInstancedBaseVertexBaseInstance",
    ),
    "keeps the address of memory for later: see arrays, pixels and programs": (
        "glVertexPointer",
        "glColorPointer",
        "glNormalPointer",
        "glTexCoordPointer",
        "glIndexPointer",
        "glEdgeFlagPointer",
        "glFogCoordPointer",
        "glSecondaryColorPointer",
        "glInterleavedArrays",
        "glVertexAttribPointer",
        "glVertexAttribIPointer",
        "glVertexAttribLPointer",
        "glSelectBuffer",
        "glFeedbackBuffer",
        "glDebugMessageCallback",
        "glBufferStorage",
        "glNamedBufferStorage",
    ),
    "takes an object of the driver's, or crashes": (
        "glDeleteSync",
        "glWaitSync",
        "glClientWaitSync",
        "glGetSynciv",
        "glIsSync",
    ),
    "gives an address to memory": (
        "glMapBuffer",
        "glMapBufferRange",
        "glMapNamedBuffer",
        "glMapNamedBufferRange",
        "glGetPointerv",
        "glGetBufferPointerv",
        "glGetNamedBufferPointerv",
        "glGetVertexAttribPointerv",
        "glGetVertexArrayIndexed64iv",
    ),
    "writes as much as the state says, or reads it": (
        "glReadPixels",
        "glReadnPixels",
        "glGetTexImage",
        "glGetTextureImage",
        "glGetTextureSubImage",
        "glGetCompressedTexImage",
        "glGetCompressedTextureImage",
        "glGetCompressedTextureSubImage",
        "glGetnTexImage",
        "glGetnCompressedTexImage",
        "glDrawPixels",
        "glBitmap",
        "glMap1d",
        "glMap1f",
        "glMap2d",
        "glMap2f",
        "glGetnMapdv",
        "glGetProgramBinary",
        "glProgramBinary",
        "glShaderBinary",
        "glCallLists",
    ),
    "depends on the time": (
        "glQueryCounter",
        "glGetQueryObjectui64v",
        "glGetQueryObjecti64v",
        "glGetQueryBufferObjectui64v",
        "glGetQueryBufferObjecti64v",
    ),
    "crashes Mesa 22.3 with some arguments": ("glInvalidateTexSubImage", "glInvalidateTexImage"),
    "differs from one play to the next": ("glAreTexturesResident", "glGetInternalformativ"),
}
"""By reason. Most have an area of their own."""
_COUNTS = {
    "count",
    "n",
    "width",
    "height",
    "depth",
    "bufSize",
    "size",
    "drawcount",
    "instancecount",
    "primcount",
    "levels",
    "samples",
    "num_groups_x",
    "num_groups_y",
    "num_groups_z",
    "maxCount",
    "layer",
    "level",
}
_DTYPES = {
    "GLfloat": "f",
    "GLdouble": "d",
    "GLint": "i",
    "GLuint": "I",
    "GLshort": "h",
    "GLushort": "H",
    "GLbyte": "b",
    "GLubyte": "B",
    "GLboolean": "B",
    "GLsizei": "i",
    "GLint64": "q",
    "GLuint64": "Q",
    "GLenum": "I",
    "GLintptr": "q",
    "GLsizeiptr": "q",
    "GLchar": "B",
    "void": "B",
}
_REALS = ("GLfloat", "GLdouble")


@cache
def commands() -> tuple[Command, ...]:
    """Those that may be called anyhow."""
    left_out = {name for names in LEFT_OUT.values() for name in names}
    return tuple(
        each
        for name, each in registry().commands.items()
        if name not in left_out and not name.startswith(("glBegin", "glEnd"))
    )


@area(8)
def any_call(w: Writer) -> None:
    """Some calls."""
    for _ in range(w.whole(1, 3)):
        command = w.pick(commands())
        odd, module = w.odd, w.pick(("GL", "GL", "raw"))
        if module == "raw":
            w.odd = 0.0  # what is no array becomes a null pointer there
        arguments = ", ".join(_argument(w, p) for p in command.parameters)
        w.odd = odd
        w.say(f"{module}.{command.name}({arguments})")


def _argument(w: Writer, parameter: Parameter) -> str:
    if parameter.pointer:
        return _pointer(w, parameter)
    if parameter.type in ("GLenum", "GLbitfield"):
        members = registry().groups.get(parameter.kind, ())
        if not members or w.maybe(0.04):
            return w.pick(("0", "0xFFFF", "1", "-1", "0x1700", "0x0DE1"))
        return w.enum(w.pick(members))
    if parameter.type == "GLboolean":
        return w.fill("{flag}")
    if parameter.type in _REALS:
        return w.real()
    if parameter.kind and parameter.kind not in registry().groups:
        return w.name(
            "vertex array" if parameter.kind == "vertex_array" else parameter.kind.replace("_", " ")
        )
    if parameter.name in _COUNTS:
        return w.pick(("0", "1", "1", "2", "3", "4", "-1"))
    return (
        w.integer(0, 4)
        if w.maybe(0.9)
        else w.pick(
            (
                "-1",
                "-3",
                "17",
                "300",
                "2**31 - 1" if parameter.name in ("x", "y", "v0", "v1", "index") else "9",
            )
        )
    )


def _pointer(w: Writer, parameter: Parameter) -> str:
    kind = _DTYPES.get(parameter.type, "B")
    if parameter.pointer == "out":
        return f"room('{kind}')"
    if parameter.type == "GLchar":
        return w.pick(("b'gl_Position'", "b'tint'", "'more'"))
    if parameter.length.isdigit() and w.maybe(0.7):
        return w.vector(int(parameter.length), kind)
    return (
        {"f": "floats(2)", "d": "doubles(2)", "B": "octets(9)"}.get(kind, "indices(3)")
        if kind in "fdB"
        else f"np.arange(64).astype('{kind}')"
    )
