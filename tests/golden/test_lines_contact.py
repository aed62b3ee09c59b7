"""Where things touch: objects that stand on others, ink of the app's own on the same edges,
windows without depth."""

from __future__ import annotations

import ctypes
from itertools import product

import numpy as np
import pytest
from glshim_stylers.raskar import Raskar
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.geometry.edges.edges import edges
from glshim.geometry.edges.gather import Placement
from glshim.linework.polygon_lines import polygon_lines
from glshim.model.camera import Camera
from glshim.model.lines import RIDGE, Line
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.device.triangles import triangles
from glshim.styling.protocol import Layer
from glshim.styling.wishes import Choice
from tests import look, oracle
from tests.sweep import some

SIZE = 400
STYLE = Raskar(silhouette_width=3, ridge_width=2)
PORT = (0, 0, SIZE, SIZE)


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def floor(level):
    return look.batch([(x, y, level) for x, y in ((-9, -9), (9, -9), (9, 9), (-9, 9))],
                      [[0, 1, 2, 3]])  # fmt: skip


def stands(half=0.9):
    return np.float32(-half)


def line_pixels(segment, spread):
    """Pixels along a segment (x, y, depth ends), each with its neighbours within spread."""
    points, _ = oracle.samples([segment])
    return oracle.near(points, (SIZE, SIZE), spread)


def blobs(mask):
    """Sizes of the 8-connected parts of a mask that the picture's border does not cut."""
    label = np.where(mask, np.arange(mask.size).reshape(mask.shape) + 1, 0)
    while True:
        padded = np.pad(label, 1)
        around = [padded[1 + i : 1 + i + SIZE, 1 + j : 1 + j + SIZE]
                  for i in (-1, 0, 1) for j in (-1, 0, 1)]  # fmt: skip
        grown = np.where(mask, np.max(around, axis=0), 0)
        if (grown == label).all():
            rim = np.ones_like(mask)
            rim[2:-2, 2:-2] = False
            cut = np.unique(label[mask & rim])
            return np.unique(label[mask & ~np.isin(label, cut)], return_counts=True)[1]
        label = grown


PLACES = tuple(product([14.0, 20.0, 35.0, 60.0], [10.0, 33.0, 71.0], [False, True]))


@pytest.mark.parametrize(("elevation", "turn", "parallel"), some(PLACES, 13))
def test_a_box_on_the_floor_is_closed_at_its_foot(backend, elevation, turn, parallel):
    """The contour where it meets the coplanar floor is inked along its whole length, and no dot
    of ink stands alone."""
    e, t = np.radians((elevation, turn))
    eye = 6 * np.array((np.cos(e) * np.cos(t), np.cos(e) * np.sin(t), np.sin(e)))
    projection = look.orthographic() if parallel else look.perspective()
    camera = Camera(look.look_at(eye, up=(0, 0, 1)), projection, PORT)
    box, ground = look.cube(), floor(stands())
    before, after, _ = look.styled(backend, STYLE, (ground, camera), (box, camera))
    ink = (before != after).any(axis=2)
    true = oracle.truth(look.polygons_of(box), box.positions, camera)
    for segment in true.silhouettes:
        points, _ = oracle.samples([segment])
        inside = ((points[:, :2] > 4) & (points[:, :2] < SIZE - 4)).all(axis=1)
        column, row = np.floor(points[inside, :2]).astype(int).T
        beside = np.any([ink[row + i, column + j] for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)
        assert beside.all(), (segment, (~beside).sum())
    assert (blobs(ink) > 30).all(), blobs(ink)


def test_a_drum_on_a_disc_has_no_lonely_dots(backend):
    """Round foot on a coplanar top, each a batch of its own, as demo_apps/03_robot_arm has it."""
    drum, disc = look.cylinder(32, 0.5, 0.4), look.cylinder(32, 1.2, 0.2)
    for elevation in (12, 22, 40):
        e = np.radians(elevation)
        view = look.look_at((0, -6 * np.cos(e), 6 * np.sin(e)), up=(0, 0, 1))
        lift = np.eye(4)
        lift[2, 3] = 0.6
        items = [(disc, Camera(view, look.perspective(), PORT)),
                 (drum, Camera(view @ lift, look.perspective(), PORT))]  # fmt: skip
        before, after, _ = look.styled(backend, STYLE, *items)
        sizes = blobs((before != after).any(axis=2))
        assert (sizes > 12).all(), (elevation, sizes)


def test_what_stands_inside_another_thing_does_not_shine_through(backend):
    """A cube inside a sphere that is a few pixels larger stays hidden."""
    ball = look.sphere(48, 28, 1.2)
    box = look.cube(0.64)  # corners at 1.11, edges at 0.9
    for direction in look.directions(8):
        camera = Camera(look.look_at(5 * direction), look.perspective(), PORT)
        alone = look.styled(backend, STYLE, (ball, camera))[1]
        both = look.styled(backend, STYLE, (ball, camera), (box, camera))[1]
        assert (alone == both).all()


def test_hexagons_at_the_default_threshold_are_ridges_whole(backend):
    """A hexagonal bolt folds by exactly 120 degrees, in any place and turn: inclusive."""
    choice = Choice(ridge_angle=np.radians(120.0))
    rng = np.random.default_rng(4)
    for _ in range(40):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0] * rng.uniform(0.01, 100)
        bolt = look.cylinder(6)
        bolt = look.batch(bolt.positions @ turn + rng.normal(size=3) * 5, look.polygons_of(bolt))
        found = edges(bolt)
        assert (np.degrees(found.folds) < 120.06).sum() + (np.degrees(found.folds) > 239.9).sum()
        seen = Camera(look.look_at((900, 700, 800)), look.orthographic(), PORT)
        parts = [(found, Placement.one(seen.modelview, len(found.planes)))]
        ridges = polygon_lines(parts, seen, choice)[:, Line.KIND] == RIDGE
        assert ridges.sum() == 2 + 3
    camera = Camera(look.look_at((3.3, 2, 2.5)), look.perspective(), PORT)
    bolt = look.cylinder(6)
    before, after, _ = look.styled(backend, STYLE, (bolt, camera))
    ink = (before != after).any(axis=2)
    true = oracle.truth(look.polygons_of(bolt), bolt.positions, camera, ridge_angle=120.01)
    assert len(true.ridges) == 5
    for segment in true.ridges:
        points, _ = oracle.samples([segment])
        column, row = np.floor(points[4:-4, :2]).astype(int).T
        around = np.any([ink[row + i, column + j] for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)
        assert around.all()


def test_lines_of_the_apps_own_on_the_same_edges_do_not_break_ours(backend):
    """The app draws GL_LINES on the cube's edges, as pygame's glcube does: every silhouette and
    ridge keeps the pixels that it has without them, but for the app's own inside the outline."""
    box = look.cube()
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), PORT)
    style = Raskar(silhouette_width=3, ridge_width=4, ink="#e8641b")
    plain = look.styled(backend, style, (box, camera))[1]
    look.clear()
    look.draw_base(box, camera)
    GL.glColor3f(1, 1, 1)
    GL.glBegin(GL.GL_LINES)
    for face in look.polygons_of(box):
        for i, j in zip(face, np.roll(face, -1), strict=True):
            GL.glVertex3fv(box.positions[i])
            GL.glVertex3fv(box.positions[j])
    GL.glEnd()
    backend.render(style.draws(Layer(((box, camera),))))
    ink = np.array((0xE8, 0x64, 0x1B))
    ours, with_lines = ((picture == ink).all(axis=2) for picture in (plain, look.pixels()))
    assert (ours & ~with_lines).sum() <= 0.01 * ours.sum()


def test_a_window_without_depth_gets_the_lines_of_one_with(backend):
    """Two tori, one in front of the other; the picture of the app is kept."""
    torus = look.torus()
    view = look.look_at((3, 2, 2.5))
    behind = np.eye(4)
    behind[:3, 3] = (-1.5, -1.0, -1.0)
    items = [(torus, Camera(view @ place, look.perspective(), PORT))
             for place in (np.eye(4), behind)]  # fmt: skip
    before, wanted, _ = look.styled(backend, STYLE, *items)
    colour, name = ctypes.c_uint(), ctypes.c_uint()
    colour, name = (int(make(1)) for make in (GL.glGenTextures, GL.glGenFramebuffers))
    GL.glBindTexture(GL.GL_TEXTURE_2D, colour)
    GL.glTexImage2D(GL.GL_TEXTURE_2D, 0, GL.GL_RGBA8, SIZE, SIZE, 0, GL.GL_RGBA,
                    GL.GL_UNSIGNED_BYTE, before[..., [0, 1, 2, 0]].copy())  # fmt: skip
    GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, name)
    GL.glFramebufferTexture2D(GL.GL_FRAMEBUFFER, GL.GL_COLOR_ATTACHMENT0, GL.GL_TEXTURE_2D,
                              colour, 0)  # fmt: skip
    GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
    try:
        assert GL.glGetIntegerv(GL.GL_DEPTH_BITS) == 0
        for _ in range(2):
            GL.glBindTexture(GL.GL_TEXTURE_2D, colour)
            GL.glTexSubImage2D(GL.GL_TEXTURE_2D, 0, 0, 0, SIZE, SIZE, GL.GL_RGBA,
                               GL.GL_UNSIGNED_BYTE, before[..., [0, 1, 2, 0]].copy())  # fmt: skip
            GL.glBindTexture(GL.GL_TEXTURE_2D, 0)
            backend.render(STYLE.draws(Layer(tuple(items))))
            assert gl.glGetError() == 0
        found = look.pixels()
    finally:
        GL.glBindFramebuffer(GL.GL_FRAMEBUFFER, 0)
        GL.glDeleteFramebuffers(1, [name])
    assert (found != wanted).any(axis=2).mean() < 1e-3
    assert (found != before).any()


def test_several_samples_a_pixel(backend):
    """A multisampled window: its depth is resolved for the spines."""
    box, ground = look.cube(), floor(stands())
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), PORT)
    single = look.styled(backend, STYLE, (ground, camera), (box, camera))[1]
    with look.multisampled(SIZE, SIZE):
        several = look.styled(Backend.attach(), STYLE, (ground, camera), (box, camera))[1]
        assert gl.glGetError() == 0
    dark = np.argwhere((single < 60).all(axis=2)[1:-1, 1:-1]) + 1
    around = np.min([several[dark[:, 0] + i, dark[:, 1] + j].max(axis=1)
                     for i in (-1, 0, 1) for j in (-1, 0, 1)], axis=0)  # fmt: skip
    assert (around < 120).mean() > 0.99


def test_triangles_are_fans():
    mesh = look.batch(np.eye(3).repeat(2, axis=0), [[0, 1, 2, 3, 4], [3, 4], [1, 2, 5]])
    found = triangles(mesh)
    assert len(found) == 4
    assert (found[:3, 0] == mesh.positions[0]).all()
    assert (found[3] == mesh.positions[[1, 2, 5]]).all()
