"""The ink itself: the same in any order of drawing, smooth, and right over any background."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from glshim_stylers.raskar import Raskar
from OpenGL import GL

from glshim.geometry.raskar import Strokes
from glshim.model.camera import Camera
from glshim.model.lines import RIDGE
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look

SIZE = 400
PORT = (0, 0, SIZE, SIZE)


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def scene():
    """A torus, a step with a hollow edge, a crossing plate and an open bowl, in one object space:
    points and polygons."""
    step = look.batch(
        [(x, y, z) for x in (-1.2, 1.2) for y, z in ((-1.9, -1.2), (-1.9, 0), (-1.2, 0),
                                                     (-1.2, -0.7), (-0.3, -0.7), (-0.3, -1.2))],
        [[0, 1, 2, 3, 4, 5], [11, 10, 9, 8, 7, 6],
         *[[i, i + 6, (i + 1) % 6 + 6, (i + 1) % 6] for i in range(6)]],
    )  # fmt: skip
    plate = look.batch([(-1.6, 0.4, -0.6), (1.6, 0.4, -0.5), (1.6, 0.6, 0.7), (-1.6, 0.6, 0.6)],
                       [[0, 1, 2, 3]])  # fmt: skip
    bowl = look.bowl(16, 6)
    parts = [(look.torus(24, 12), (0, 0.6, 0)), (step, (0, 0, 0)), (plate, (0, 0, 0)),
             (bowl, (0.2, -0.9, 0.9))]  # fmt: skip
    points, polygons = np.empty((0, 3), np.float32), []
    for part, place in parts:
        polygons += [p + len(points) for p in look.polygons_of(part)]
        points = np.concatenate([points, part.positions * 0.7 + np.float32(place)])
    return (np.round(points * 4096) / 4096).astype(np.float32), polygons


VIEWS = [(3, 2, 2.5), (-2.6, -3.1, 2.0), (0.5, -4.2, 1.4)]


@pytest.mark.parametrize("eye", VIEWS)
@pytest.mark.parametrize("features", ["", "silhouettes", "ridges", "valleys", "intersections"])
def test_order_and_objects_do_not_matter(backend, eye, features):
    """Polygons in 20 random orders, cut into any number of batches and objects (each with a
    camera and an object space of its own): at most one grey level apart."""
    points, polygons = scene()
    view, projection = look.look_at(eye), look.perspective()
    names = ("silhouettes", "ridges", "valleys", "intersections")
    only = {name: features in ("", name) for name in names}
    style = Raskar(**only)
    whole = look.batch(points, polygons)
    first = look.styled(backend, style, (whole, Camera(view, projection, PORT)))
    hidden = features == "intersections" and eye == VIEWS[2]
    assert (first[0] != first[1]).any() != hidden
    rng = np.random.default_rng(11)
    for _ in range(20):
        order = rng.permutation(len(polygons))
        owner = rng.integers(0, rng.integers(1, 12), len(polygons))
        items = []
        for number in np.unique(owner):
            some = [polygons[i] for i in order if owner[i] == number]
            space = np.eye(4)
            # Spaces in which the same places can be written: rounding is the app's own.
            space[:3, :3] *= rng.choice((0.5, 1.0, 2.0))
            space[:3, 3] = rng.integers(-32, 33, 3) / 16
            back = np.linalg.inv(space)
            moved = points @ back[:3, :3].T + back[:3, 3]
            items.append((look.batch(moved, some), Camera(view @ space, projection, PORT)))
        # The app's own picture may differ in a last bit of depth: lines are compared on one.
        look.clear()
        look.draw_base(whole, Camera(view, projection, PORT))
        backend.render(style.draws(Layer(tuple(items))))
        apart = np.abs(look.pixels().astype(int) - first[1]).max()
        assert apart <= 1


def test_what_the_app_draws_first_does_not_matter(backend):
    """Whole frames, the polygons drawn in another order each time."""
    points, polygons = scene()
    camera = Camera(look.look_at(VIEWS[0]), look.perspective(), PORT)
    rng = np.random.default_rng(5)
    pictures = []
    for _ in range(6):
        order = rng.permutation(len(polygons))
        mesh = look.batch(points, [polygons[i] for i in order])
        found = look.styled(backend, Raskar(intersections=True), (mesh, camera))[1]
        pictures.append(found.astype(int))
    assert max(np.abs(picture - pictures[0]).max() for picture in pictures) <= 1


@pytest.mark.parametrize("eye", VIEWS)
def test_features_work_alone_and_with_any_other(backend, eye):
    """The picture of any of them together has at each pixel the darkest of theirs alone."""
    points, polygons = scene()
    item = (look.batch(points, polygons), Camera(look.look_at(eye), look.perspective(), PORT))
    names = ("silhouettes", "ridges", "valleys", "intersections")
    pictures = {}
    for count in range(1, 5):
        for some in combinations(names, count):
            style = Raskar(**{name: name in some for name in names})
            pictures[some] = look.styled(backend, style, item)[1].astype(int)
    # Specks are removed from the whole canvas: what is one alone may join another kind's line.
    for some, found in pictures.items():
        darkest = np.min([pictures[(name,)] for name in some], axis=0)
        apart = np.abs(found - darkest).max(axis=2) > 1
        assert apart.sum() <= 12, (some, apart.sum())
        assert (found <= darkest + 1).all()


def backgrounds():
    rng = np.random.default_rng(3)
    yield np.full((SIZE, SIZE, 3), 255)
    yield np.full((SIZE, SIZE, 3), 0)
    yield rng.integers(0, 256, (SIZE, SIZE, 3))
    yield np.indices((SIZE, SIZE, 3)).sum(axis=0) * 255 // (2 * SIZE)


@pytest.mark.parametrize("colour", ["#000000", "#e8641b", "#ffffff"])
def test_ink_is_mixed_with_whatever_lies_below(backend, colour):
    """One share of ink a pixel, over white, black, noise and a gradient alike."""
    mesh, camera = look.torus(), Camera(look.look_at((3, 2, 2.5)), look.perspective(), PORT)
    style = Raskar(ink=colour, fill="none")
    white = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)])
    look.clear()
    look.draw_base(mesh, camera)
    share = None
    for below in backgrounds():
        GL.glDisable(GL.GL_DEPTH_TEST)
        GL.glWindowPos2i(0, 0)
        GL.glPixelStorei(GL.GL_UNPACK_ALIGNMENT, 1)
        GL.glDrawPixels(SIZE, SIZE, GL.GL_RGB, GL.GL_UNSIGNED_BYTE, below.astype(np.uint8))
        GL.glEnable(GL.GL_DEPTH_TEST)
        backend.render(style.draws(Layer(((mesh, camera),))))
        found = look.pixels().astype(float)
        if share is None:
            share = ink_of(backend, mesh, camera, style)
            assert ((share > 0.05) & (share < 0.95)).sum() > 500  # there are smooth edges
        wanted = below * (1 - share[..., None]) + white * share[..., None]
        assert np.abs(found - wanted).max() <= 2.0


def ink_of(backend, mesh, camera, style):
    """(SIZE, SIZE) the share of ink, from black ink on white."""
    black = replace(style, ink=(0.0, 0.0, 0.0))
    look.clear()
    look.draw_base(mesh, camera, (1, 1, 1))
    backend.render(black.draws(Layer(((mesh, camera),))))
    return 1 - look.pixels()[..., 0] / 255.0


@pytest.mark.parametrize("width", [1.0, 2.5, 6.0])
def test_edges_are_smooth(backend, width):
    """Across a slanting line the ink is the share of the pixel within it, to a tenth."""
    square = look.batch([(-1, -0.8, 0), (1.1, -1, 0), (0.9, 1, 0), (-1.2, 0.7, 0)], [[0, 1, 2, 3]])
    camera = Camera(look.look_at((0, 0, 5), up=(0, 1, 0)), look.orthographic(), PORT)
    ink = ink_of(backend, square, camera, Raskar(silhouette_width=width, ridges=False))
    corners = (square.positions[:, :2] / 2 + 1) * SIZE / 2
    a, b = corners[0], corners[1]
    along = (b - a) / np.hypot(*(b - a))
    y, x = np.mgrid[0:SIZE, 0:SIZE] + 0.5
    t = (x - a[0]) * along[0] + (y - a[1]) * along[1]
    s = (x - a[0]) * along[1] - (y - a[1]) * along[0]
    within = (t > 15) & (t < np.hypot(*(b - a)) - 15) & (np.abs(s) < width + 3)
    wanted = np.clip(width - s, 0, 1) * np.clip(s + 1, 0, 1)
    assert within.sum() > 300
    assert np.abs(ink - wanted)[within].max() < 0.1


def test_a_multisampled_window_gets_the_same_lines(backend):
    mesh, camera = look.cube(), Camera(look.look_at((3, 2, 2.5)), look.perspective(), PORT)
    style = Raskar(silhouette_width=3, ridge_width=3)
    single = ink_of(backend, mesh, camera, style)
    with look.multisampled(SIZE, SIZE):
        several = ink_of(Backend.attach(), mesh, camera, style)
    apart = np.abs(single - several)
    assert (apart > 0.05).mean() < 1e-3 and (apart > 0.5).sum() <= 2, apart.max()


def test_the_reference_of_coverage_is_a_box_filter():
    """One pixel wide ramps about the rims, round at the ends of what is not an outline."""
    from glshim.geometry.raskar import coverage

    one = np.ones((1, 2))
    line = Strokes(
        np.array([True]), np.array([[10.0, 10, 0]]), np.array([[20.0, 10, 0]]), 0 * one,
        np.zeros((1, 4)), np.array([[-1.0, 1.0, RIDGE]]), one, 0 * one,
    )  # fmt: skip
    pixels = np.array([(15, 10), (15, 11), (15, 8.5), (22, 10), (20.6, 10.8), (5, 10)], float)
    assert np.allclose(coverage(line, 0, pixels), [1, 0.5, 0, 0, 0.5, 0])
