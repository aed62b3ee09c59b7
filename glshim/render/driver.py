"""The driver functions that rendering adds to `glshim.spec.driver`'s table, and `gl` itself."""

from __future__ import annotations

from glshim.spec.driver import SIGNATURES, current_context, gl

__all__ = ["current_context", "gl"]

SIGNATURES.update(
    {
        "glBindRenderbuffer": "uu",
        "glBlitFramebuffer": "iiiiiiiiuu",
        "glCheckFramebufferStatus": "u>u",
        "glClear": "u",
        "glClearColor": "ffff",
        "glClearDepth": "d",
        "glColorMaski": "ubbbb",
        "glCopyTexSubImage2D": "uiiiiiii",
        "glDepthFunc": "u",
        "glDrawArraysInstanced": "uiii",
        "glDrawBuffer": "u",
        "glEnableVertexAttribArray": "u",
        "glFramebufferRenderbuffer": "uuuu",
        "glFramebufferTexture2D": "uuuui",
        "glGenFramebuffers": "ip",
        "glGenRenderbuffers": "ip",
        "glLineWidth": "f",
        "glPixelTransferf": "uf",
        "glRenderbufferStorage": "uuii",
        "glScissor": "iiii",
        "glStencilFunc": "uiu",
        "glStencilMask": "u",
        "glVertexAttribDivisor": "uu",
        "glVertexAttribPointer": "uiubip",
    }
)
