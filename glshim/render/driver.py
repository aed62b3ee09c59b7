"""The driver functions that rendering adds to `glshim.spec.driver`'s table, and `gl` itself."""

from __future__ import annotations

from glshim.spec.driver import SIGNATURES, current_context, gl

__all__ = ["current_context", "gl"]

SIGNATURES.update(
    {
        "glBindRenderbuffer": "uu",
        "glColorMaski": "ubbbb",
        "glDepthFunc": "u",
        "glDrawArraysInstanced": "uiii",
        "glEnableVertexAttribArray": "u",
        "glLineWidth": "f",
        "glScissor": "iiii",
        "glStencilFunc": "uiu",
        "glStencilMask": "u",
        "glVertexAttribDivisor": "uu",
        "glVertexAttribPointer": "uiubip",
    }
)
