"""Draws that go together: one camera but for the modelview, one look."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import replace
from math import isfinite

from glshim.model.camera import Camera
from glshim.styling.protocol import Draw


def grouped(draws: Iterable[Draw]) -> list[list[Draw]]:
    """Draws that one GL draw can serve: alike in all but batch and modelview."""
    groups: dict[Hashable, list[Draw]] = {}
    seen: dict[int, tuple[Camera, Hashable]] = {}
    last: Draw | None = None
    look: Hashable = None
    for draw in draws:
        if draw.batch.polygon_count == 0:
            continue
        known = seen.get(id(draw.camera))
        if known is None:
            camera = draw.camera.affine()
            if not all(map(isfinite, camera.modelview.ravel().tolist())):
                continue
            known = seen[id(draw.camera)] = (camera, lens_of(camera))
        camera, lens = known
        if last is None or not _look_alike(draw, last):
            look = (draw.choice, draw.shader, tuple(draw.uniforms.items()), draw.image)
        last = draw
        moved = draw if camera is draw.camera else replace(draw, camera=camera)
        groups.setdefault((lens, look), []).append(moved)
    return list(groups.values())


def _look_alike(draw: Draw, other: Draw) -> bool:
    """Whether their looks are the same objects, as they are of one styler."""
    return (
        draw.choice is other.choice
        and draw.shader is other.shader
        and draw.uniforms is other.uniforms
        and draw.image is other.image
    )


def lens_of(camera: Camera) -> Hashable:
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
