"""When two cameras are alike."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from glshim.model.camera import Camera
from tests import look

CAMERA = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 300))
OTHERS = {
    "projection": look.orthographic(), "viewport": (0, 0, 400, 301), "depth_range": (0.0, 0.5),
    "front_ccw": False, "scissor": (1, 2, 3, 4), "clip_planes": ((0.0, 0.0, 1.0, 0.0),),
    "stencil": (0x0207, 1, 255),
}  # fmt: skip


@pytest.mark.parametrize("name", OTHERS)
def test_the_lens_and_the_key_hold_all_that_shows_a_space_otherwise(name):
    other = replace(CAMERA, **{name: OTHERS[name]})
    assert other.lens != CAMERA.lens and other.key != CAMERA.key


def test_the_lens_leaves_the_modelview_out_and_the_key_has_it():
    other = CAMERA.under(np.eye(4))
    assert other.lens == CAMERA.lens and other.key != CAMERA.key


def test_how_polygons_are_lit_parts_no_cameras():
    other = replace(CAMERA, lit=True, gleams=True, textured=True)
    assert (other.lens, other.key) == (CAMERA.lens, CAMERA.key)
