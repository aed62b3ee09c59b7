"""From eye space to the window: what of a side can be seen, and where that is."""

from __future__ import annotations

import numpy as np

from glshim.model.arrays import Doubles, Flags
from glshim.model.camera import Camera


def cut(a: Doubles, b: Doubles, camera: Camera) -> tuple[list[Doubles], Flags, Flags]:
    """The sides a to b (L, 3) as far as they lie behind the near plane and inside the app's clip
    planes; which of them keep their b; which are left at all. Eye space."""
    planes = [camera.projection[2] + camera.projection[3], *map(np.array, camera.clip_planes)]
    whole_b, left = np.ones(len(a), bool), np.ones(len(a), bool)
    for plane in planes:
        near_a, near_b = (end @ plane[:3] + plane[3] for end in (a, b))
        left &= (near_a >= 0.0) | (near_b >= 0.0)
        apart = np.where(near_a == near_b, 1.0, near_a - near_b)
        share = (near_a / apart)[:, None]
        crossing = a + share * (b - a)
        whole_b &= near_b >= 0.0
        a = np.where(((near_a < 0.0) & (near_b > 0.0))[:, None], crossing, a)
        b = np.where(((near_b < 0.0) & (near_a > 0.0))[:, None], crossing, b)
    return [a, b], whole_b, left


def window(eye: Doubles, camera: Camera) -> Doubles:
    """(L, 3) window coordinates of eye-space points: pixels of the framebuffer, depth."""
    x, y, width, height = camera.viewport
    near, far = camera.depth_range
    clip = np.c_[eye, np.ones(len(eye))] @ camera.projection.T
    ndc = clip[:, :3] / np.where(np.abs(clip[:, 3:]) < 1e-30, 1e-30, clip[:, 3:])
    scale = np.array((width, height, far - near)) / 2.0
    return np.asarray(ndc * scale + (x + width / 2.0, y + height / 2.0, (far + near) / 2.0))
