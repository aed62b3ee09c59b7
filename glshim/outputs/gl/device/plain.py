"""The plain state that drawing of ours begins in."""

from __future__ import annotations

from glshim.outputs.gl.device.guard import drain
from glshim.spec.driver import gl

_OFF = (  # what would change or drop the ink: each is enabled by some app
    0x0B44,  # cull face
    0x0B90,  # stencil test
    0x0BE2,  # blend
    0x0BC0,  # alpha test
    0x0BF1, 0x0BF2,  # logic ops
    0x0B42, 0x0B41,  # polygon stipple, smooth
    0x8037,  # polygon offset fill
    0x809E, 0x809F, 0x80A0,  # sample alpha to coverage, alpha to one, coverage
    0x8C89,  # rasterizer discard
    0x864F,  # depth clamp
    *range(0x3000, 0x3006),  # clip planes
    0x0B71,  # depth test: shaders look depth up
)  # fmt: skip


def plainly() -> None:
    """Inside the state guard: nothing drops what is drawn, colour alone is written, faces are
    filled."""
    for capability in _OFF:
        gl.glDisable(capability)
    drain()  # what older versions do not know of these
    gl.glDepthMask(0)
    gl.glStencilMask(0)
    gl.glColorMask(1, 1, 1, 1)
    gl.glPolygonMode(0x0408, 0x1B02)
