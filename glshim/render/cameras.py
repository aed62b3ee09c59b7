"""What a line shader and the fixed state need to know of a camera."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from glshim.geometry.camera import Camera
from glshim.render.driver import gl
from glshim.styling.protocol import Draw

_SCISSOR_TEST, _STENCIL_TEST = 0x0C11, 0x0B90
MOST_CLIP_PLANES = 6
_HAIR = 4.0
"""Steps of the depth buffer between a line and the surface that it belongs to."""


def grouped(draws: Iterable[Draw]) -> list[list[Draw]]:
    """Draws that one GL draw can serve: alike in all but batch and modelview."""
    groups: dict[Hashable, list[Draw]] = {}
    seen: dict[int, tuple[Camera, Hashable]] = {}
    for draw in draws:
        if draw.batch.polygon_count == 0:
            continue
        known = seen.get(id(draw.camera))
        if known is None:
            camera = draw.camera.affine()
            if not np.isfinite(camera.modelview).all():
                continue
            known = seen[id(draw.camera)] = (camera, _lens(camera))
        camera, lens = known
        same = (lens, draw.choice, draw.shader, tuple(draw.uniforms.items()))
        groups.setdefault(same, []).append(replace(draw, camera=camera))
    return list(groups.values())


def _lens(camera: Camera) -> Hashable:
    """All of a camera but its modelview."""
    return (
        camera.projection.tobytes(),
        camera.viewport,
        camera.depth_range,
        camera.front_ccw,
        camera.scissor,
        camera.clip_planes,
        camera.stencil,
    )


def hair_of(camera: Camera, bits: int, greater: bool) -> float:
    """A few steps of the depth buffer in normalised device depth, positive away from the viewer."""
    near, far = camera.depth_range
    away = -1.0 if greater != (near > far) else 1.0
    return away * 2.0 * _HAIR / 2.0**bits / max(abs(far - near), 1e-6)


def view_of(camera: Camera) -> dict[str, NDArray[np.float64]] | None:
    """The camera's matrices as uniforms (columns first); None when nothing can be seen by it."""
    if min(camera.viewport[2:]) <= 0:
        return None
    if not np.isfinite(camera.projection).all():
        return None
    try:
        unprojection = np.linalg.inv(camera.projection)
    except np.linalg.LinAlgError:
        return None
    return {
        "modelview": camera.modelview.T,
        "projection": camera.projection.T,
        "unprojection": unprojection.T,
        "normal_matrix": camera.normal_matrix.T,
        "viewpoint": camera.viewpoint,
    } | ({"clip_planes": np.array(camera.clip_planes[:6])} if camera.clip_planes else {})


def set_up(camera: Camera) -> None:
    """The fixed state that belongs to a camera."""
    gl.glViewport(*camera.viewport)
    gl.glDepthRange(*camera.depth_range)
    if camera.scissor is None:
        gl.glDisable(_SCISSOR_TEST)
    else:
        gl.glEnable(_SCISSOR_TEST)
        gl.glScissor(*camera.scissor)
    if camera.stencil is None:
        gl.glDisable(_STENCIL_TEST)
    else:
        gl.glEnable(_STENCIL_TEST)
        gl.glStencilFunc(*camera.stencil)
    for plane in range(MOST_CLIP_PLANES):
        switch = gl.glEnable if plane < len(camera.clip_planes) else gl.glDisable
        switch(0x3000 + plane)
