"""The driver functions that rendering adds to `glshim.spec.driver`'s table, and `gl` itself."""

from __future__ import annotations

from glshim.spec.driver import SIGNATURES, current_context, gl

__all__ = ["current_context", "gl"]

SIGNATURES.update(
    {
        "glBindRenderbuffer": "uu",
        "glBlitFramebuffer": "iiiiiiiiuu",
        "glColorMaski": "ubbbb",
        "glCopyTexSubImage2D": "uiiiiiii",
        "glDepthFunc": "u",
        "glDrawArraysInstanced": "uiii",
        "glDrawBuffer": "u",
        "glEnableVertexAttribArray": "u",
        "glFramebufferTexture2D": "uuuui",
        "glGenFramebuffers": "ip",
        "glLineWidth": "f",
        "glPixelTransferf": "uf",
        "glScissor": "iiii",
        "glStencilFunc": "uiu",
        "glStencilMask": "u",
        "glVertexAttribDivisor": "uu",
        "glVertexAttribPointer": "uiubip",
    }
)
