"""The plain state that drawing of ours begins in."""

from __future__ import annotations

from glshim.driver.errorflag import drain
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_ALPHA_TEST,
    GL_BLEND,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE1,
    GL_CLIP_PLANE2,
    GL_CLIP_PLANE3,
    GL_CLIP_PLANE4,
    GL_CLIP_PLANE5,
    GL_COLOR_LOGIC_OP,
    GL_CULL_FACE,
    GL_DEPTH_CLAMP,
    GL_DEPTH_TEST,
    GL_FILL,
    GL_FRONT_AND_BACK,
    GL_INDEX_LOGIC_OP,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_RASTERIZER_DISCARD,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_STENCIL_TEST,
)

OFF = (
    GL_CULL_FACE, GL_STENCIL_TEST, GL_BLEND, GL_ALPHA_TEST, GL_INDEX_LOGIC_OP, GL_COLOR_LOGIC_OP,
    GL_POLYGON_STIPPLE, GL_POLYGON_SMOOTH, GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD, GL_DEPTH_CLAMP,
    GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2, GL_CLIP_PLANE3, GL_CLIP_PLANE4, GL_CLIP_PLANE5,
    GL_DEPTH_TEST,
)  # fmt: skip
"""What would change or drop ink: each is enabled by some app. Depth is looked up by shaders."""


def plainly() -> None:
    """Inside the state guard: nothing drops what is drawn, colour alone is written, faces are
    filled."""
    for capability in OFF:
        gl.glDisable(capability)
    drain()  # what older versions do not know of these
    gl.glDepthMask(0)
    gl.glStencilMask(0)
    gl.glColorMask(1, 1, 1, 1)
    gl.glPolygonMode(GL_FRONT_AND_BACK, GL_FILL)
