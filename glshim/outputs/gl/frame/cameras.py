"""What a line shader and the fixed state need to know of a camera."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim.driver.functions import gl
from glshim.model.camera import Camera
from glshim.outputs.gl.device.textures import STROKE_UNIT
from glshim.outputs.gl.frame.depth import UNIT as DEPTH_UNIT
from glshim.outputs.gl.frame.depth import Box
from glshim.outputs.gl.frame.frame import Frame
from glshim.spec.constants import GL_STENCIL_TEST

MOST_CLIP_PLANES = 6
Size = tuple[int, int]


def turned(camera: Camera, reversed_depth: bool) -> Camera:
    """The camera with its depth range turned so that greater is farther away. reversed_depth:
    farther is less depth."""
    near, far = camera.depth_range
    return replace(camera, depth_range=(-near, -far)) if reversed_depth else camera


def view_of(camera: Camera, bounds: Size) -> dict[str, NDArray[np.float64]] | None:
    """The camera as uniforms (matrices columns first); None when nothing can be seen by it.
    bounds: pixels of the framebuffer, at most."""
    x, y, width, height = camera.viewport
    if min(width, height) <= 0:
        return None
    if not np.isfinite(camera.projection).all():
        return None
    try:
        unprojection = np.linalg.inv(camera.projection)
    except np.linalg.LinAlgError:
        return None
    half = width / 2.0, height / 2.0
    found = {
        "projection": camera.projection.T,
        "unprojection": unprojection.T,
        "viewpoint": camera.viewpoint,
        "viewport": np.array((x + half[0], y + half[1], *half)),
        "range": np.array(camera.depth_range),
        "port": _port(camera.viewport, bounds),
    }
    if camera.clip_planes:
        found["clip_planes"] = np.array(camera.clip_planes[:MOST_CLIP_PLANES])
    return found


def inputs_of(camera: Camera, frame: Frame) -> dict[str, Any] | None:
    """The uniforms of the preludes of line shaders: those of `view_of`, and the finished depth. The
    camera's depth range is turned (`turned`)."""
    view = view_of(camera, frame.destination.bounds)
    if view is None:
        return None
    depth, destination = frame.depth, frame.destination
    return view | {
        "away": frame.depth_sign, "hair": frame.depth_margin, "blur": depth.sample_offset,
        "finished_depth": DEPTH_UNIT, "depth_size": tuple(map(float, depth.size)),
        "stroke": STROKE_UNIT, "shot": (*destination.origin, destination.scale),
    }  # fmt: skip


def box_of(cameras: Iterable[Camera], bounds: Size) -> Box:
    """The least box around all viewports, in the bounds of the framebuffer."""
    ports = [camera.viewport for camera in cameras]
    x, y = (max(min(port[k] for port in ports), 0) for k in (0, 1))
    right, top = (min(max(port[k] + port[k + 2] for port in ports), bounds[k]) for k in (0, 1))
    return x, y, max(right - x, 0), max(top - y, 0)


def _port(viewport: Box, bounds: Size) -> NDArray[np.float64]:
    """The least and the greatest pixel centre of a viewport that there are."""
    x, y, width, height = viewport
    right, top = (min(a, b) for a, b in zip((x + width, y + height), bounds, strict=True))
    return np.array((max(x, 0) + 0.5, max(y, 0) + 0.5, right - 0.5, top - 0.5))


def scissor(
    camera: Camera, box: Box, origin: tuple[int, int] = (0, 0)
) -> None:
    """Let drawing reach what the camera's viewport and scissor box leave of a box. origin: the
    pixel of the app's framebuffer that is the first of the one drawn to."""
    edges = [box, camera.viewport, *([camera.scissor] if camera.scissor else [])]
    x, y = (max(edge[k] for edge in edges) for k in (0, 1))
    right, top = (min(edge[k] + edge[k + 2] for edge in edges) for k in (0, 1))
    gl.glScissor(x - origin[0], y - origin[1], max(right - x, 0), max(top - y, 0))


def stencil(camera: Camera) -> None:
    """The app's stencil test, as far as it hides."""
    if camera.stencil is None:
        gl.glDisable(GL_STENCIL_TEST)
    else:
        gl.glEnable(GL_STENCIL_TEST)
        gl.glStencilFunc(*camera.stencil)
