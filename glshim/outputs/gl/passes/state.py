"""The fixed state of a pass."""

from __future__ import annotations

from glshim.driver.functions import gl
from glshim.outputs.gl.passes.stage import NOTHING_DRAWN
from glshim.spec.constants import (
    GL_ALWAYS,
    GL_BACK,
    GL_BLEND,
    GL_CULL_FACE,
    GL_DECR_WRAP,
    GL_DEPTH_CLAMP,
    GL_DEPTH_TEST,
    GL_EQUAL,
    GL_FRONT,
    GL_FUNC_ADD,
    GL_GEQUAL,
    GL_GREATER,
    GL_INCR_WRAP,
    GL_KEEP,
    GL_LEQUAL,
    GL_LESS,
    GL_MAX,
    GL_NEVER,
    GL_NOTEQUAL,
    GL_ONE,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_PRIMITIVE_RESTART,
    GL_REPLACE,
    GL_STENCIL_BUFFER_BIT,
    GL_STENCIL_TEST,
    GL_ZERO,
)
from glshim.styling.passes import Comparison, State, Stencil

_TESTS = {
    "never": GL_NEVER, "less": GL_LESS, "equal": GL_EQUAL, "lequal": GL_LEQUAL,
    "greater": GL_GREATER, "notequal": GL_NOTEQUAL, "gequal": GL_GEQUAL, "always": GL_ALWAYS,
}  # fmt: skip
_TURNED: dict[Comparison, Comparison] = {
    "less": "greater", "lequal": "gequal", "greater": "less", "gequal": "lequal"
}  # fmt: skip
"""Tests where greater depth is nearer."""
_ACTIONS = {
    "keep": GL_KEEP, "replace": GL_REPLACE, "increase": GL_INCR_WRAP, "decrease": GL_DECR_WRAP,
    "zero": GL_ZERO,
}  # fmt: skip


def set_state(state: State, reversed_depth: bool) -> None:
    """Inside the guard. reversed_depth: the app's depth test lets greater depths win."""
    # Not only let through by it: a driver in software would look depths up all the same.
    _switch(GL_DEPTH_TEST, state.depth != "always" or state.writes_depth)
    test = _TURNED.get(state.depth, state.depth) if reversed_depth else state.depth
    gl.glDepthFunc(_TESTS[test])
    gl.glDepthMask(int(state.writes_depth))
    gl.glColorMask(*[int(state.writes_colour)] * 4)
    _switch(GL_BLEND, state.blend != "off")
    gl.glBlendEquation(GL_MAX if state.blend == "greatest" else GL_FUNC_ADD)
    gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
    _switch(GL_CULL_FACE, state.cull != "none")
    if state.cull != "none":
        gl.glCullFace(GL_FRONT if state.cull == "front" else GL_BACK)
    factor, units = state.offset
    for capability in (GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE):
        _switch(capability, factor != 0.0 or units != 0.0)
    way = -1.0 if reversed_depth else 1.0
    gl.glPolygonOffset(way * factor, way * units)
    _switch(GL_DEPTH_CLAMP, state.clamps)
    gl.glDisable(GL_PRIMITIVE_RESTART)
    _stencil(state.stencil, state.clears_stencil)


def _stencil(stencil: Stencil | None, clears: bool) -> None:
    gl.glStencilMask(0xFF)
    if clears:
        gl.glClearStencil(NOTHING_DRAWN)
        gl.glClear(GL_STENCIL_BUFFER_BIT)
    _switch(GL_STENCIL_TEST, stencil is not None)
    if stencil is None:
        return
    gl.glStencilFunc(_TESTS[stencil.test], stencil.reference, 0xFF)
    for face, actions in ((GL_FRONT, stencil.front), (GL_BACK, stencil.back)):
        gl.glStencilOpSeparate(face, *(_ACTIONS[action] for action in actions))


def _switch(capability: int, on: bool) -> None:
    (gl.glEnable if on else gl.glDisable)(capability)
