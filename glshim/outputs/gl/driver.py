"""The driver functions that rendering adds to `glshim.spec.driver`'s table, and `gl` itself."""

from __future__ import annotations

import ctypes

from glshim.spec.driver import SIGNATURES, current_context, gl

__all__ = ["current_context", "gl", "integer"]

SIGNATURES.update(
    {
        "glBeginQuery": "uu",
        "glBeginTransformFeedback": "u",
        "glBindAttribLocation": "uup",
        "glBindBufferBase": "uuu",
        "glBindRenderbuffer": "uu",
        "glBlendEquation": "u",
        "glBlendFunc": "uu",
        "glBlitFramebuffer": "iiiiiiiiuu",
        "glBufferData": "unpu",
        "glCheckFramebufferStatus": "u>u",
        "glClear": "u",
        "glClearBufferuiv": "uip",
        "glClearColor": "ffff",
        "glClearDepth": "d",
        "glClearStencil": "i",
        "glClipPlane": "up",
        "glColorMaski": "ubbbb",
        "glCopyTexSubImage2D": "uiiiiiii",
        "glCullFace": "u",
        "glDeleteBuffers": "ip",
        "glDeleteProgram": "u",
        "glDeleteQueries": "ip",
        "glDeleteTextures": "ip",
        "glDepthFunc": "u",
        "glDrawArraysInstanced": "uiii",
        "glDrawBuffer": "u",
        "glDrawElementsInstanced": "uiupi",
        "glDrawPixels": "iiuup",
        "glEdgeFlagPointer": "ip",
        "glEnableVertexAttribArray": "u",
        "glEndQuery": "u",
        "glEndTransformFeedback": "",
        "glFrontFace": "u",
        "glFramebufferRenderbuffer": "uuuu",
        "glFramebufferTexture2D": "uuuui",
        "glGenBuffers": "ip",
        "glGenQueries": "ip",
        "glGenRenderbuffers": "ip",
        "glGenerateMipmap": "u",
        "glGetActiveUniform": "uuipppp",
        "glGetAttachedShaders": "uipp",
        "glGetProgramInfoLog": "uipp",
        "glGetQueryObjectuiv": "uup",
        "glGetShaderInfoLog": "uipp",
        "glGetTexGeniv": "uup",
        "glLineWidth": "f",
        "glPixelTransferf": "uf",
        "glPixelZoom": "ff",
        "glPolygonOffset": "ff",
        "glRenderbufferStorage": "uuii",
        "glScissor": "iiii",
        "glStencilFunc": "uiu",
        "glStencilMask": "u",
        "glStencilOpSeparate": "uuuu",
        "glUniform1f": "if",
        "glUniform1fv": "iip",
        "glUniform1iv": "iip",
        "glUniform2fv": "iip",
        "glUniform3fv": "iip",
        "glUniform4fv": "iip",
        "glUniform4iv": "iip",
        "glUniformMatrix2fv": "iibp",
        "glUniformMatrix3fv": "iibp",
        "glUniformMatrix4fv": "iibp",
        "glUniform1i": "ii",
        "glUniform2f": "iff",
        "glUniform3f": "ifff",
        "glVertex2f": "ff",
        "glVertexAttribDivisor": "uu",
        "glVertexAttribPointer": "uiubip",
        "glWindowPos2i": "ii",
    }
)


def integer(name: int) -> int:
    """What glGetIntegerv says about one value."""
    value = ctypes.c_int()
    gl.glGetIntegerv(name, ctypes.addressof(value))
    return value.value
