"""Style fins, step by step as in the article, and surfaces lit from the G-buffer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.fins import Fins, as_printed
from OpenGL import GL

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.golden.test_fins_reference import MESHES, mobius

WHITE, SHADE, HALF = (1.0, 1.0, 1.0), (0.8, 0.6, 0.4), 6.0
CAMERA = Camera(look.look_at((3, 2, 3)), look.perspective(), (0, 0, 400, 400))
STEPS = {
    "bare": {"joints": "none", "tip": 0.0, "spine": False},
    "smooth": {"joints": "none", "spine": False},
    "spine": {"joints": "none"},
    "overhang": {"joints": "overhang"},
    "round": {"joints": "round"},
}


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def drawn(backend, items, **options):
    """The app's frame, the styled one, and where surfaces are."""
    look.clear(WHITE)
    for mesh, camera in items:
        look.draw_base(mesh, camera, SHADE)
    before, there = look.pixels(), look.depths() < 1.0
    light = options.pop("light", (0.0, 0.0, 1.0, 0.0))
    backend.render(Fins(**options).draws(Layer(tuple(items), light=light)))
    return before, look.pixels(), there


def widened(mask, radius):
    """Pixels within a radius of some."""
    found = np.zeros_like(mask)
    reach = int(radius)
    for y in range(-reach, reach + 1):
        for x in range(-reach, reach + 1):
            if x * x + y * y <= radius * radius:
                found |= np.roll(mask, (y, x), (0, 1))
    return found


def pieces(mask):
    """How many connected regions a mask has."""
    left, count = mask.copy(), 0
    while left.any():
        count += 1
        seed = np.zeros_like(left)
        seed[tuple(np.argwhere(left)[0])] = True
        while True:
            grown = widened(seed, 1.5) & left
            if (grown == seed).all():
                break
            seed = grown
        left &= ~seed
    return count


@pytest.fixture(scope="module")
def steps(backend):
    """Ink (H, W) of each step, and where the torus is. Against the background alone."""
    found = {}
    for name, options in STEPS.items():
        before, after, there = drawn(backend, [(look.torus(20, 12), CAMERA)],
                                     half_width=HALF, **options)  # fmt: skip
        found[name] = look.ink(before, after)
    return found, there


def shares(ink, there):
    """Ink in the band within the outline, and in that without it, of the band's area."""
    inner, outer = there & widened(~there, HALF - 1), ~there & widened(there, HALF - 1)
    return ink[inner].mean(), ink[outer].mean()


def greys(ink):
    return int(((ink > 0.05) & (ink < 0.95)).sum())


def test_the_first_step_shows_the_outer_half_with_steps(steps):
    ink, there = steps[0]["bare"], steps[1]
    inside, outside = shares(ink, there)
    assert outside > 0.85 and inside < 0.12 * outside
    assert greys(ink) == 0


def test_the_second_step_smooths_the_outer_edge(steps):
    ink, there = steps[0]["smooth"], steps[1]
    inside, outside = shares(ink, there)
    assert outside > 0.8 and inside < 0.12 * outside
    assert greys(ink) > 500
    # Grey lies at the rim, half the width away from the outline.
    grey = (ink > 0.05) & (ink < 0.95) & ~there
    assert (grey & widened(there, HALF - 2.5)).sum() < 0.15 * grey.sum()
    assert len(np.unique(np.rint(20 * ink[grey]))) > 8


def test_the_spine_test_shows_both_halves(steps):
    found, there = steps
    inside, outside = shares(found["spine"], there)
    assert abs(inside - outside) < 0.12 and outside > 0.8
    assert greys(found["spine"]) > 1.5 * greys(found["smooth"])


@pytest.mark.parametrize(("joints", "most"), [("overhang", 0.1), ("round", 0.0)])
def test_the_last_step_fills_the_gaps(steps, joints, most):
    found, there = steps
    band = ~there & widened(there, HALF - 2.0)
    open_ = [band & (found[name] < 0.5) for name in ("spine", joints)]
    gaps = [pieces(mask) for mask in open_]
    assert gaps[0] > 15
    assert gaps[1] <= most * gaps[0]
    assert open_[1].sum() <= 0.05 * open_[0].sum()


def test_no_overhang_is_no_overhang(backend, steps):
    before, after, _ = drawn(backend, [(look.torus(20, 12), CAMERA)], half_width=HALF,
                             joints="overhang", overhang=0.0)  # fmt: skip
    assert (look.ink(before, after) == steps[0]["spine"]).all()


def test_overhang_is_a_share_of_the_length(backend):
    """Of a square's four fins each goes on by its length at both ends."""
    square = look.batch([(-0.4, -0.4, 0), (0.4, -0.4, 0), (0.4, 0.4, 0), (-0.4, 0.4, 0)],
                        [[0, 1, 2, 3]])  # fmt: skip
    camera = Camera(np.eye(4), np.diag((1.0, 1.0, -1.0, 1.0)), (0, 0, 400, 400))
    for overhang in (0.0, 0.25, 0.5):
        before, after, _ = drawn(backend, [(square, camera)], joints="overhang",
                                 overhang=overhang, tip=0.0, half_width=3.0)  # fmt: skip
        row = look.ink(before, after)[120]  # through the lower fin: 160 pixels from 120 to 280
        columns = np.flatnonzero(row > 0.5)
        beyond = max(160 * overhang, 3.0)  # or half the width of the fins at its ends
        assert abs(columns[0] - (120 - beyond)) <= 1.0
        assert abs(columns[-1] + 1 - (280 + beyond)) <= 1.0


def test_lines_are_as_wide_as_asked(backend):
    camera = Camera(look.look_at((0, -5, 0.001)), look.orthographic(), (0, 0, 400, 400))
    tall = look.batch([(x, 0, z) for x, z in ((-0.5, -3), (0.5, -3), (0.5, 3), (-0.5, 3))],
                      [[0, 1, 2, 3]])  # fmt: skip
    for half in (0.5, 1.0, 2.5, 8.0, 30.0):
        before, after, _ = drawn(backend, [(tall, camera)], half_width=half)
        line = look.ink(before, after)[200, :200].sum()
        # The rim fades within the width: half a pixel of ink less on both sides.
        assert abs(line - (2 * half - min(half, 1.0))) < 0.35


@pytest.mark.parametrize("make", MESHES)
@pytest.mark.parametrize("joints", ["none", "round"])
def test_the_sieve_changes_no_picture(backend, make, joints):
    mesh = MESHES[make]()
    inked = 0
    for direction in look.directions(5):
        camera = Camera(look.look_at(5 * direction), look.perspective(), (0, 0, 400, 400))
        found = []
        for sieved in (True, False):
            look.clear(WHITE)
            look.draw_base(mesh, camera, SHADE)
            before = look.pixels()
            passes = Fins(joints=joints).draws(Layer(((mesh, camera),)))
            backend.render([one if sieved else as_printed(one) for one in passes])
            found.append(look.pixels())
        assert (found[0] == found[1]).all()
        inked += (before != found[0]).any(axis=2).sum()
    assert inked > 1000


def test_a_twisted_strip_has_its_whole_outline(backend):
    for direction in look.directions(12):
        camera = Camera(look.look_at(5 * direction), look.perspective(), (0, 0, 400, 400))
        before, after, there = drawn(backend, [(mobius(), camera)])
        outline = ~there & widened(there, 1.0)
        ink = look.ink(before, after)
        assert (ink[outline] > 0.3).mean() > 0.999


# Surfaces lit from the G-buffer


@pytest.mark.parametrize("fill", ["lit", "cel"])
@pytest.mark.parametrize("name", ["torus", "bowl", "cube"])
def test_surfaces_are_lit_and_nothing_else_is(backend, fill, name):
    _, bare, there = drawn(backend, [(look.MESHES[name](), CAMERA)])
    before, after, _ = drawn(backend, [(look.MESHES[name](), CAMERA)], fill=fill,
                             paint="#3060c0", light=(1.0, 1.0, 1.0, 0.0))  # fmt: skip
    inked = (bare != before).any(axis=2)
    changed = (before != after).any(axis=2)
    assert changed[there & ~inked].mean() > 0.995
    assert not changed[~there & ~inked].any()
    blue = after[there & ~inked].astype(int)
    assert (blue[:, 2] >= blue[:, 0]).mean() > 0.995


def test_light_falls_as_lambert_has_it(backend):
    """A sphere of many facets under parallel light: brightness by the cosine."""
    sphere = look.sphere(96, 48)
    at = look.look_at((0, -5, 0.4))
    camera = Camera(at, look.orthographic(), (0, 0, 400, 400))
    light = np.array((0.6, 0.48, 0.64))
    _, after, there = drawn(backend, [(sphere, camera)], fill="lit", paint="#ffffff",
                            shine=0.0, light=(*light, 0.0), half_width=0.5)  # fmt: skip
    y, x = np.mgrid[0:400, 0:400]
    n = np.stack(((x - 199.5) / 100, (y - 199.5) / 100), axis=2) / 1.2
    flat = (n**2).sum(axis=2)
    inner = there & (flat < 0.85)
    normal = np.dstack((n, np.sqrt(np.maximum(1 - flat, 0))))
    diffuse = np.maximum(normal @ light, 0.3 * normal[..., 2])
    wanted = 255 * (0.35 + 0.65 * diffuse)
    assert np.abs(after[inner][:, 0] - wanted[inner]).max() < 6
    assert wanted[inner].max() - wanted[inner].min() > 100


@pytest.mark.parametrize("bands", [2, 3, 5])
def test_a_cel_has_so_many_shades_with_smooth_steps(backend, bands):
    camera = Camera(look.look_at((0, -5, 0.4)), look.orthographic(), (0, 0, 400, 400))
    _, after, there = drawn(backend, [(look.sphere(96, 48), camera)], fill="cel", bands=bands,
                            paint="#ffffff", shine=0.0, light=(0.8, 0.0, 0.6, 0.0),
                            half_width=0.5)  # fmt: skip
    inner = there & ~widened(~there, 3.0)
    values, counts = np.unique(after[inner][:, 0], return_counts=True)
    flat = values[counts > 0.01 * inner.sum()]
    assert len(flat) == bands
    between = counts[~np.isin(values, flat)].sum()
    assert 50 < between < 0.03 * inner.sum()


def test_a_cube_without_normals_has_flat_faces(backend):
    camera = replace(CAMERA, projection=look.orthographic())
    _, after, there = drawn(backend, [(look.cube(), camera)], fill="lit", paint="#ffffff",
                            shine=0.0, light=(0.3, 0.5, 0.8, 0.0), half_width=0.5)  # fmt: skip
    inner = after[there & ~widened(~there, 3.0)][:, 0]
    _, counts = np.unique(inner, return_counts=True)
    assert counts[np.argsort(counts)[-3:]].sum() > 0.97 * len(inner)


def test_the_apps_hue_is_kept_and_no_light_is_needed(backend):
    _, after, there = drawn(backend, [(look.torus(), CAMERA)], fill="lit", shine=0.0,
                            light=(0.0, 0.0, 0.0, 0.0), half_width=0.5)  # fmt: skip
    inner = after[there & ~widened(~there, 3.0)].astype(float)
    assert np.allclose(inner[:, 1] / inner[:, 0], 0.75, atol=0.03)
    assert np.allclose(inner[:, 2] / inner[:, 0], 0.5, atol=0.03)
    assert inner[:, 0].std() > 10


def with_marks():
    """A torus, and before it large points."""
    look.clear(WHITE)
    look.draw_base(look.torus(), CAMERA, SHADE)
    GL.glPointSize(9.0)
    GL.glColor3f(0.1, 0.9, 0.2)
    GL.glBegin(GL.GL_POINTS)
    for k in range(12):
        a = k * np.pi / 6
        GL.glVertex3f(np.cos(a), np.sin(a), 0.55)
    GL.glEnd()
    GL.glPointSize(1.0)


@pytest.mark.parametrize("fill", ["lit", "cel"])
def test_what_the_app_draws_besides_stays(backend, fill):
    with_marks()
    before = look.pixels()
    marks = (before == (26, 230, 51)).all(axis=2)
    assert marks.sum() > 500
    style = Fins(fill=fill, half_width=0.5, paint="#ff00ff")
    backend.render(style.draws(Layer(((look.torus(), CAMERA),))))
    after = look.pixels()
    kept = (before == after).all(axis=2)
    assert kept[marks].mean() > 0.97  # ink may cross them
    assert not kept[(before == (204, 153, 102)).all(axis=2)].mean() > 0.05


@pytest.mark.parametrize("fill", ["lit", "cel"])
def test_greater_depths_may_win(backend, fill):
    mesh, turned = look.torus(), replace(CAMERA, depth_range=(1.0, 0.0))
    _, usual, _ = drawn(backend, [(mesh, CAMERA)], fill=fill, light=(1.0, 2.0, 2.0, 1.0))
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    try:
        _, other, _ = drawn(backend, [(mesh, turned)], fill=fill, light=(1.0, 2.0, 2.0, 1.0))
    finally:
        GL.glClearDepth(1.0)
        GL.glDepthFunc(GL.GL_LESS)
    assert (np.abs(usual.astype(int) - other).max(axis=2) > 3).mean() < 0.002


def test_every_lens_has_its_own_places(backend):
    """Two viewports, and in one of them two projections: as lit as each alone."""
    mesh, options = look.torus(), {"fill": "lit", "paint": "#ffffff", "light": (2.0, 3, 1, 1)}
    small = replace(CAMERA, viewport=(0, 0, 200, 400), projection=look.perspective(aspect=0.5))
    beside = replace(small, viewport=(200, 0, 200, 400), projection=look.orthographic(aspect=0.5))
    aside = np.eye(4)
    aside[0, 3] = 0.5
    moved = replace(small, projection=aside @ look.perspective(60, 0.5))
    items = [(mesh, small), (look.cube(0.2), moved), (mesh, beside)]
    _, whole, _ = drawn(backend, items, **options)
    for columns, some in ((slice(0, 200), items[:2]), (slice(200, 400), items[2:])):
        _, alone, _ = drawn(backend, some, **options)
        assert (alone[:, columns] == whole[:, columns]).all()
    _, cube, there = drawn(backend, items[1:2], **options)
    sure = there & ~widened(~there, 4.0)
    assert sure.sum() > 200
    covered = (cube[sure] == whole[sure]).all(axis=1)
    assert covered.mean() > 0.6  # the rest lies behind the torus


@pytest.mark.parametrize("fill", ["lit", "cel"])
def test_what_the_app_cuts_off_hides_nothing(backend, fill):
    """Behind a cut bowl a square is lit where it is seen through the hole."""
    plane = (0.0, 0.0, -1.0, -5.2)  # eye space: keeps what is farther than 5.2
    camera = Camera(look.look_at((0, -6, 0.001)), look.perspective(), (0, 0, 400, 400))
    cut = replace(camera, clip_planes=(plane,))
    wall = look.batch([(-1, 2, -1), (1, 2, -1), (1, 2, 1), (-1, 2, 1)], [[0, 1, 2, 3]])
    look.clear(WHITE)
    look.draw_base(wall, camera, SHADE)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glClipPlane(GL.GL_CLIP_PLANE0, plane)
    GL.glEnable(GL.GL_CLIP_PLANE0)
    bare = look.bowl()
    look.draw_base(bare, cut, (0.2, 0.2, 0.9))
    GL.glDisable(GL.GL_CLIP_PLANE0)
    before, there = look.pixels(), look.depths() < 1.0
    style = Fins(fill=fill, half_width=0.5, paint="#00ff00", shine=0.0)
    backend.render(style.draws(Layer(((wall, camera), (bare, cut)))))
    after = look.pixels()
    changed = (before != after).any(axis=2)
    assert changed[there].mean() > 0.97


@pytest.mark.parametrize("fill", ["lit", "cel"])
def test_a_still_picture_stands_still(backend, fill):
    one, other = (drawn(backend, [(look.torus(), CAMERA)], fill=fill)[1] for _ in range(2))
    assert (one == other).all()


@pytest.mark.parametrize("fill", ["lit", "cel"])
def test_windows_with_samples_are_lit_too(backend, fill):
    with look.multisampled():
        own = Backend.attach()
        before, after, there = drawn(own, [(look.torus(), CAMERA)], fill=fill, paint="#ff00ff")
        changed = (before != after).any(axis=2)
        assert changed[there].mean() > 0.99
        assert not changed[~widened(there, 3.0)].any()


@pytest.mark.parametrize("turn", [0, 7, 30, 45, 77])
def test_a_box_seen_straight_on_has_its_whole_outline(backend, turn):
    """Its sides are seen edge on: rounding says which of their triangles face the viewer."""
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    spin = np.eye(4)
    spin[:2, :2] = (c, -s), (s, c)
    for k in range(3):
        axes = np.eye(4)
        axes[:3, :3] = np.roll(np.eye(3), k, axis=0)
        at = spin @ axes
        at[2, 3] = -5.0
        camera = Camera(at, look.orthographic(), (0, 0, 400, 400))
        before, after, there = drawn(backend, [(look.cube(), camera)])
        outline = ~there & widened(there, 1.0)
        assert (look.ink(before, after)[outline] > 0.3).mean() > 0.99


@pytest.mark.parametrize("make", [look.torus, look.cube, look.cylinder])
def test_lines_lie_alike_however_polygons_wind(backend, make):
    mesh = make()
    back = look.batch(mesh.positions, [p[::-1] for p in look.polygons_of(mesh)])
    for direction in look.directions(4):
        camera = Camera(look.look_at(5 * direction), look.perspective(), (0, 0, 400, 400))
        inks = [look.ink(*drawn(backend, [(one, camera)])[:2]) for one in (mesh, back)]
        assert (inks[0] > 0.5).sum() > 500
        assert (np.abs(inks[0] - inks[1]) > 0.1).sum() < 0.01 * (inks[0] > 0.5).sum()


def test_the_foot_of_a_box_is_drawn_on_the_floor(backend):
    """Open or closed: nothing says that a box and what it stands on are one."""
    floor = look.batch([(-3, -3, -0.9), (3, -3, -0.9), (3, 3, -0.9), (-3, 3, -0.9)],
                       [[0, 1, 2, 3]])  # fmt: skip
    box = look.cube()
    sides = look.batch(box.positions, look.polygons_of(box)[2:4] + look.polygons_of(box)[:2])
    camera = Camera(look.look_at((4, 3, 2.5)), look.perspective(), (0, 0, 400, 400))
    foot = np.array([(0.9, y, -0.9) for y in np.linspace(-0.8, 0.8, 60)])
    at = np.c_[foot, np.ones(60)] @ (camera.projection @ camera.modelview).T
    x, y = np.floor((at[:, :2] / at[:, 3:] + 1) * 200).astype(int).T
    for mesh in (box, sides):
        before, after, _ = drawn(backend, [(floor, camera), (mesh, camera)])
        assert (look.ink(before, after)[y, x] > 0.9).mean() > 0.97


def test_the_apps_stencil_test_holds_where_passes_go_over_its_picture(backend):
    """A mirror's image stays in the mirror: half of the window, in the app's stencil."""
    mesh = look.torus()
    free = Camera(look.look_at((3, -2.5, 2.2)), look.perspective(), (0, 0, 400, 400))
    held = replace(free, stencil=(GL.GL_EQUAL, 1, 255))

    def picture(*cameras: Camera) -> np.ndarray:
        look.clear()
        GL.glEnable(GL.GL_SCISSOR_TEST)
        GL.glScissor(0, 0, 200, 400)
        GL.glClearStencil(1)
        GL.glClear(GL.GL_STENCIL_BUFFER_BIT)
        GL.glDisable(GL.GL_SCISSOR_TEST)
        GL.glClearStencil(0)
        look.draw_base(mesh, free)
        backend.render(Fins().draws(Layer(tuple((mesh, camera) for camera in cameras))))
        return look.pixels()

    whole, half, bare = picture(free), picture(held), picture()
    assert (half[:, :200] == whole[:, :200]).all()
    assert (half[:, 200:] == bare[:, 200:]).all()
    assert (whole[:, 200:] != bare[:, 200:]).any()
    beside = replace(held, modelview=look.look_at((3, 2.5, 2.2)))
    both = picture(free, beside)
    assert (both[:, 200:] == whole[:, 200:]).all()
    assert (both[:, :200] != whole[:, :200]).any()
