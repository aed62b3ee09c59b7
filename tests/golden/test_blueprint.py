"""Blueprint: lines that overshoot, and dimensions that are true."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.blueprint import Blueprint
from glshim_stylers.blueprint.dimensions import characters

from glshim.linework.groups import grouped
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.frame.frame import depth_margin
from glshim.styling.protocol import Layer, Lines
from tests import look
from tests.captured import CapturingPen

CAMERA = Camera(look.look_at((6, 4, 4)), look.perspective(), (0, 0, 400, 400))
SIZES = (1.25, 2.0, 0.8)
PAPER = np.array((0, 0, 128))


def box(sizes=SIZES):
    cube = look.cube(0.5)
    return replace(cube, positions=(cube.positions * np.array(sizes)).astype(np.float32))


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def drawn(backend, mesh, camera=CAMERA, **options):
    look.clear((0.9, 0.2, 0.2))
    look.draw_base(mesh, camera)
    there = look.depths() < 1.0
    backend.render(Blueprint(grid=0.0, shade=0.0, **options).draws(Layer(((mesh, camera),))))
    return look.pixels().astype(int), there


def light(picture):
    """(H, W) 0..1 of white on the paper."""
    return picture[..., 0] / 255.0


def test_all_is_paper_but_the_lines(backend):
    picture, _ = drawn(backend, box(), overshoot=0.0, dimensions=0.0)
    ink = light(picture) > 0.15
    assert 0.003 < ink.mean() < 0.05
    assert np.abs(picture[~ink] - PAPER).max() < 45  # the paper's grain and soft edges
    assert np.median(np.abs(picture[~ink] - PAPER).max(axis=1)) < 12


def test_lines_go_on_beyond_corners_by_a_share_of_their_length(backend):
    outside = {}
    for share in (0.0, 0.1, 0.3):
        picture, there = drawn(
            backend, box(), overshoot=share, overshoot_most=100.0, dimensions=0.0
        )
        wide = there.copy()
        for axis in (0, 1):
            for step in (-4, 4):
                wide |= np.roll(there, step, axis)
        outside[share] = (light(picture) > 0.15)[~wide].sum()
    assert outside[0.0] <= 3  # soft edges
    assert outside[0.1] > 50
    assert 1.8 < outside[0.3] / outside[0.1] < 6.0


def lengths(backend, mesh, camera=CAMERA, **options):
    """The lengths that dimensions tell, sorted: what the vertex shader gives of all edges, before
    it asks whether they are seen."""
    look.clear()
    look.draw_base(mesh, camera)
    draws = Blueprint(dimensions=1.0, **options).draws(Layer(((mesh, camera),)))
    last = [draw for draw in draws if isinstance(draw, Lines)][-1]
    medium = last.medium
    assert medium.shader.name == "dimension"
    text = medium.shader.vertex.replace("if (!seen_at", "if (false && seen_at")
    shader = replace(medium.shader, vertex=text)
    (group,) = grouped([last])
    records = backend._finder.records(group)
    found = CapturingPen().varyings(
        records, replace(camera, depth_range=(0.0, 1.0)), shader, medium.uniforms,
        {"dimension": 2}, hair=depth_margin(24),
    )  # fmt: skip
    told = found["dimension"][:, 0]
    return np.unique(told[told[:, 0] > 0.0][:, 0].round(4))


def test_dimensions_are_lengths_in_the_programs_world(backend):
    assert lengths(backend, box()) == pytest.approx(sorted(SIZES))


def test_a_scaled_object_has_the_length_that_it_is_drawn_with(backend):
    camera = replace(CAMERA, modelview=CAMERA.modelview @ np.diag((1.5, 1.5, 1.5, 1.0)))
    assert lengths(backend, box(), camera) == pytest.approx([1.5 * size for size in sorted(SIZES)])


def test_curves_and_short_edges_have_none(backend):
    assert not len(lengths(backend, look.torus()))
    assert not len(lengths(backend, box((0.1, 0.1, 0.1))))


@pytest.mark.parametrize(
    ("size", "text"), [(2.0, "2.00"), (1.374, "1.37"), (12.0, "12.0"), (345.0, "345")]
)
def test_the_number_is_written_as_drawings_have_it(backend, size, text):
    """Each place of the number shows the character that is due there, of all the most alike."""
    half = size / 2.0
    wall = look.batch([(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)],
                      [(0, 1, 2, 3)])  # fmt: skip
    lens = look.orthographic(size, near=0.1, far=50.0 * size)
    camera = Camera(look.look_at((0, 0, 5.0 * size), up=(0, 1, 0)), lens, (0, 0, 400, 400))
    found = [light(drawn(backend, wall, camera, dimensions=share, overshoot=0.0)[0])
             for share in (0.0, 1.0)]  # fmt: skip
    extra = np.clip(found[1] - found[0], 0.0, 1.0)
    # The lower edge, 100 pixels up: its dimension line is 15 below, the number 3 below that.
    left = 200.0 - 7.0 * len(text) / 2.0
    signs = characters().pixels[::-1, :, 3].reshape(44, 11, 28).transpose(1, 0, 2) / 255.0
    small = [sign.reshape(11, 4, 7, 4).mean(axis=(1, 3)) for sign in signs]
    for place, character in enumerate(text):
        x = round(left + 7.0 * place)
        scores = []
        for sign in small:
            best = max(
                np.corrcoef(extra[y : y + 11, x + dx : x + dx + 7].ravel(), sign.ravel())[0, 1]
                for y in range(66, 76) for dx in (-1, 0, 1)
            )  # fmt: skip
            scores.append(best)
        assert "0123456789."[int(np.argmax(scores))] == character


@pytest.mark.parametrize("mesh", [look.torus(48, 24), look.sphere(48, 32)], ids=["torus", "sphere"])
def test_round_outlines_have_no_horns(backend, mesh):
    picture, there = drawn(backend, mesh, overshoot=0.3, overshoot_most=100.0, dimensions=0.0)
    near = there.copy()
    for axis in (0, 1):
        for step in (-3, 3):
            near |= np.roll(there, step, axis)
    assert (light(picture) > 0.15)[~near].sum() == 0


def test_lines_go_on_less_far_in_a_small_window(backend):
    small = replace(CAMERA, viewport=(0, 0, 150, 150))
    options = {"overshoot": 1.0, "overshoot_most": 60.0, "dimensions": 0.0}
    most = []
    for camera in (CAMERA, small):
        style = Blueprint(**options)
        lines = [d for d in style.draws(Layer(((box(), camera),))) if isinstance(d, Lines)]
        most.append(lines[0].medium.uniforms["overshoot"])
    assert most == pytest.approx([50.0, 18.75])


@pytest.mark.parametrize("drop", [False, True], ids=["free", "taken"])
def test_a_dimension_has_its_place_for_itself(backend, drop):
    """Below the lower edge of a wall lies nothing, or another wall that ends there."""
    def wall(x, y, z):
        points = [(-x, -1 - y, z), (x, -1 - y, z), (x, 1 - y, z), (-x, 1 - y, z)]
        return look.batch(points, [(0, 1, 2, 3)])

    lens = look.orthographic(2.0, near=0.1, far=50.0)
    camera = Camera(look.look_at((0, 0, 10.0), up=(0, 1, 0)), lens, (0, 0, 400, 400))
    meshes = [wall(1.0, 0.0, 0.0), *([wall(0.5, 0.2, -1.0)] if drop else [])]
    inks = []
    for share in (0.0, 1.0):
        look.clear((0.9, 0.2, 0.2))
        for mesh in meshes:
            look.draw_base(mesh, camera)
        style = Blueprint(grid=0.0, shade=0.0, overshoot=0.0, dimensions=share)
        backend.render(style.draws(Layer(tuple((mesh, camera) for mesh in meshes))))
        inks.append(light(look.pixels().astype(int))[82:96, 110:290])
    assert bool(np.abs(inks[1] - inks[0]).max() > 0.2) is not drop
