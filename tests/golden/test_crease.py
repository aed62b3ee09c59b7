"""Style crease: no seam, no fold, no gap at any width; both halves of a crease as wide."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from glshim_stylers.crease import Crease

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from tests import creased, look
from tests.sweep import some

WIDTHS = (1.0, 2.5, 6.0, 16.0, 60.0)
SOFT = 0.3  # of a pixel: how far rounding may move a border
VIEWPORT = (0, 0, 400, 400)


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def cameras(count=6):
    return [
        Camera(look.look_at(6 * d), look.perspective() if k % 2 else look.orthographic(2.4),
               VIEWPORT)
        for k, d in enumerate(look.directions(count))
    ]  # fmt: skip


def wide(width, **options):
    return Crease(crease_width=width, silhouette_width=width, angle=creased.ANGLE, **options)


@cache
def known(name, view):
    """A mesh, its lines in a view, and how to find those that its depth picture shows."""
    mesh, camera = creased.MESHES[name](), cameras()[view]
    smooth = cache(lambda depth: creased.smooth_lines(mesh, camera, np.frombuffer(
        depth, np.float32).reshape(400, 400)))  # fmt: skip
    return mesh, camera, creased.crease_lines(mesh, camera), smooth


@pytest.mark.parametrize("name", creased.MESHES)
@pytest.mark.parametrize("width", WIDTHS)
def test_ink_is_all_of_the_band_around_lines_and_nothing_else(backend, name, width):
    for k in some(range(6), 3, WIDTHS.index(width)):
        mesh, camera, creases, smooth = known(name, k)
        before, after, depth = look.styled(backend, wide(width), (mesh, camera))
        lines = [(creases, width), (smooth(depth.tobytes()), width)]
        band = creased.band(lines, depth)
        ink = look.ink(before, after)
        gaps = np.argwhere(ink < band.least - SOFT)
        stray = np.argwhere(ink > band.most + 0.02)
        assert not len(gaps), (k, len(gaps), gaps[:5, ::-1])
        assert not len(stray), (k, len(stray), stray[:5, ::-1])
        assert band.asked > 0.5
