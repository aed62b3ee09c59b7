"""Hatching says where the light is, and is held by the surface."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.shared.hand.hatching import Hatching, hatched
from OpenGL import GL

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look

CAMERA = Camera(look.look_at((3, 2, 2)), look.perspective(), (0, 0, 400, 400))
BLACK = (0.0, 0.0, 0.0)
SHADE = (0.9, 0.9, 0.9)


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


RIGHT = (1.0, 0.0, 0.0, 0.0)


def ink(backend, mesh, camera=CAMERA, light=RIGHT, *, shade=SHADE, edit=None, **named):
    """(H, W) 0..1 of hatching on the app's picture."""
    hatching = Hatching(BLACK, **named)
    look.clear()
    look.draw_base(mesh, camera, shade)
    before = look.pixels().astype(float)
    passes = list(hatched(hatching, Layer(((mesh, camera),), light)))
    backend.render(passes if edit is None else map(edit, passes))
    return (before - look.pixels()).max(axis=2) / (255.0 * max(shade))


def on_surface(mesh, camera=CAMERA):
    look.clear()
    look.draw_base(mesh, camera)
    return look.depths() < 1.0


@pytest.mark.parametrize("mesh", [look.cube(), look.cylinder(), look.torus()])
def test_a_still_surface_holds_it_where_its_own_places_are(backend, mesh):
    """Topology vertices of creased meshes find where their vertex was first."""
    def by_position(one):
        text = one.shader.vertex
        assert "rest(gl_VertexID).xyz" in text
        text = text.replace("rest(gl_VertexID).xyz", "position(gl_VertexID)")
        return replace(one, shader=replace(one.shader, vertex=text))

    held, there = ink(backend, mesh), ink(backend, mesh, edit=by_position)
    assert held.max() > 0.5
    assert (held == there).all()


def test_a_mesh_seen_for_the_first_time_is_hatched_as_later(backend):
    fresh = Backend.attach()
    first, second = (ink(fresh, look.cube(0.8)) for _ in range(2))
    assert first.max() > 0.5
    assert (first == second).all()


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_side_away_from_the_light_is_hatched(backend, side):
    mesh = look.sphere(48, 28)
    found = ink(backend, mesh, light=(side, 0.0, 0.0, 0.0), by_picture=0.0)
    there = on_surface(mesh)
    columns = np.flatnonzero(there.any(axis=0))
    left, _, right = np.array_split(columns, 3)
    lit, dark = (left, right) if side < 0 else (right, left)
    shares = [found[:, some][there[:, some]].mean() for some in (lit, dark)]
    assert shares[1] > 2.5 * shares[0] and shares[1] > 0.1


def test_dark_paint_is_hatched_more(backend):
    mesh = look.sphere(48, 28)
    light, dark = (
        ink(backend, mesh, by_picture=1.0, shade=shade)[on_surface(mesh)].mean()
        for shade in ((0.95, 0.95, 0.95), (0.3, 0.3, 0.3))
    )
    assert dark > 2.0 * light


@pytest.mark.parametrize("away", [3.0, 5.0, 8.0, 12.0])
def test_strokes_are_as_far_apart_however_near_the_object_is(backend, away):
    """Counted along columns and rows of the middle of a wall."""
    wall = look.batch([(-9, -9, 0), (9, -9, 0), (9, 9, 0), (-9, 9, 0)], [(0, 1, 2, 3)])
    camera = replace(CAMERA, modelview=look.look_at((0, 0, away), up=(0, 1, 0)))
    found = ink(backend, wall, camera, light=(0.0, 0.3, -1.0, 0.0), by_picture=0.0, jitter=0.0)
    some = found[150:250, 150:250] > 0.15
    steps = [(np.diff(some.astype(int), axis=axis) > 0).sum() / 100.0 for axis in (0, 1)]
    apart = 100.0 / np.hypot(*steps)
    assert 4.0 < apart < 13.0  # pixels; half of the strokes fade at every other distance


def test_it_moves_with_the_object(backend):
    """An object that moves by whole pixels under parallel light takes its strokes along."""
    mesh, ortho = look.torus(), look.orthographic(2.0)
    still = replace(CAMERA, projection=ortho)
    moved = replace(still, modelview=still.modelview.copy())
    moved.modelview[0, 3] += 20 * 4.0 / 400
    first, second = (ink(backend, mesh, one, jitter=0.0) for one in (still, moved))
    a, b = first[:, :-20].ravel(), second[:, 20:].ravel()
    assert np.corrcoef(a, b)[0, 1] > 0.85  # the rest is the paper's tooth


def test_no_darkness_no_pass():
    assert not list(hatched(Hatching(BLACK, darkness=0.0), Layer(((look.cube(), CAMERA),))))


def test_light_that_an_app_has_not_placed_comes_from_the_upper_left(backend):
    mesh = look.sphere(48, 28)
    found = ink(backend, mesh, light=(0.0, 0.0, 1.0, 0.0), by_picture=0.0)
    there = on_surface(mesh)
    rows, columns = np.nonzero(there)
    rightwards = (columns - columns.mean()) - (rows - rows.mean())  # row 0 is the lowest
    found = found[rows, columns]
    assert found[rightwards > 60].mean() > 2.0 * found[rightwards < -60].mean()
    assert GL.glGetError() == 0
