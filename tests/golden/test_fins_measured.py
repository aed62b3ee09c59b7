"""Short parts of `docs/measurements/fins.md`: the score, the flicker, and the sieve's picture."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from glshim_stylers.fins import Fins
from OpenGL import GL

from glshim.geometry.meshshaders.extent import Extent
from glshim.geometry.recovery.mesh import mesh
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.benchmarks.fins import Unsieved
from tests.coherence import turning
from tests.score import meshes, views
from tests.score.__main__ import LIMIT

VIEWS = {"torus": (2, 11), "gear": (5, 11), "terrain": (6, 20), "scan": (1,)}
"""Of the 24 of the command; dots were in two of them."""


@pytest.fixture(scope="module")
def backend():
    with look.window(views.SIZE, views.SIZE):
        yield Backend.attach()


@pytest.mark.parametrize("name", VIEWS)
def test_fins_lie_on_silhouettes_and_nowhere_else(backend, name):
    tally = views.Tally()
    batch = meshes.MESHES[name]()
    for view in views.look_at_views(backend, batch, only=VIEWS[name], name="fins"):
        tally.add(view.number, view.verdicts["silhouettes"])
    assert tally.sure > 1500
    assert tally.passes(LIMIT), (tally.precision, tally.recall, tally.dots)


@pytest.mark.parametrize("name", ["torus", "lathe"])
def test_fins_flicker_no_more_than_chains_of_edges(backend, name):
    batch = replace(turning.MESHES[name](), key=f"flicker of {name}")
    turn = list(turning.cameras(10))
    found = {
        style: turning.measured(turning.inks(backend, turning.STYLES[style], batch, turn))
        for style in (turning.BASIS, "fins")
    }
    assert found["fins"].ink > 1000
    assert found["fins"].ink == pytest.approx(found[turning.BASIS].ink, rel=0.1)
    assert 0.0 < found["fins"].flicker <= found[turning.BASIS].flicker, found
    assert found["fins"].blinks < 0.1


def test_flicker_tells_a_steady_line_from_one_that_pops():
    still = np.zeros((8, 20, 20))
    still[:, 5] = 1.0
    pops = still.copy()
    pops[4, 15] = 1.0
    assert turning.measured(iter(still)) == turning.Flicker(0.0, 0.0, 20.0)
    found = turning.measured(iter(pops))
    assert found.flicker == pytest.approx(20 * (1 + 2 + 1) / (6 * 20 + 20))
    assert found.blinks == pytest.approx(20 / 6)


@pytest.mark.parametrize("name", ["torus", "terrain", "scan"])
@pytest.mark.parametrize("style", [Fins(), Fins(joints="overhang", spine=False)])
def test_the_sieve_leaves_every_byte_of_the_picture(backend, name, style):
    batch = replace(meshes.MESHES[name](), key=f"sieve of {name}")
    for camera in islice(views.camera_path(), 1, 24, 9):
        frames = []
        for drawn in (style, Unsieved(style)):
            look.clear()
            look.draw_base(batch, camera)
            before = look.pixels(views.SIZE, views.SIZE)
            backend.render(drawn.draws(Layer(((batch, camera),))))
            GL.glFinish()
            frames.append(look.pixels(views.SIZE, views.SIZE))
        assert (frames[0] != before).any()
        assert (frames[0] == frames[1]).all()


@pytest.mark.parametrize("name", ["torus", "gear"])
def test_no_side_is_longer_on_the_screen_than_its_bound(name):
    found = mesh(meshes.MESHES[name]())
    extent = Extent.of(found.positions, found.edges)
    for camera in views.camera_path(8):
        clip = np.c_[found.positions, np.ones(len(found.positions))]
        clip = clip @ (camera.projection @ camera.modelview).T
        places = clip[:, :2] / clip[:, 3:] * views.SIZE / 2
        a, b = places[found.edges].transpose(1, 0, 2)
        longest = np.linalg.norm(b - a, axis=1).max()
        assert longest <= extent.pixels(camera) < 12 * longest


def test_the_bound_is_none_where_a_mesh_reaches_the_viewer():
    found = mesh(look.torus())
    camera = Camera(look.look_at((1.0, 0.0, 0.1)), look.perspective(), (0, 0, 100, 100))
    assert Extent.of(found.positions, found.edges).pixels(camera) == np.inf
