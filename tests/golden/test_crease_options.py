"""Style crease: widths of halves, indicators, depth tests, sieves, textures."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.crease import Crease

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import creased, look
from tests.golden.test_crease import cameras, wide
from tests.golden.test_fins_reference import inside_out
from tests.score import meshes as scored
from tests.score import sight

VIEWPORT = (0, 0, 400, 400)


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def picture(backend, passes, items):
    look.clear()
    for mesh, camera in items:
        look.draw_base(mesh, camera)
    backend.render(passes)
    return look.pixels()


def profile(ink, place, out, reach):
    """Ink on the inner and on the outer side of a place, pixels, a bilinear sample every tenth."""
    sums = []
    for side in (-1.0, 1.0):
        spots = place + side * np.outer((np.arange(int(10 * reach)) + 0.5) / 10, out) - 0.5
        low = np.floor(spots).astype(int)
        f = spots - low
        x, y = low.T
        above = ink[y + 1, x] * (1 - f[:, 0]) + ink[y + 1, x + 1] * f[:, 0]
        below = ink[y, x] * (1 - f[:, 0]) + ink[y, x + 1] * f[:, 0]
        sums.append(float((below * (1 - f[:, 1]) + above * f[:, 1]).sum() / 10))
    return sums


@pytest.mark.parametrize("name, width", [
    *(("cube", width) for width in (1.0, 2.5, 6.0, 16.0, 30.0)),
    *(("cylinder", width) for width in (1.0, 2.5, 6.0)),
])  # fmt: skip
def test_both_halves_of_all_creases_are_as_wide(backend, name, width):
    """On contours (section 6 leaves half of them) and between faces that are seen."""
    mesh, measured = creased.MESHES[name](), {"inner": [], "contour": []}
    for camera in cameras(8):
        before, after, depth = look.styled(backend, wide(width), (mesh, camera))
        ink = look.ink(before, after)
        lines = creased.crease_lines(mesh, camera)
        smooth = creased.smooth_lines(mesh, camera, depth)
        places = [creased.places_of(pair)[:, :2] for pair in (*lines.ends, *smooth.ends)]
        for k, (ends, seen) in enumerate(zip(lines.ends, lines.seen, strict=True)):
            if (seen != sight.SURE).any():
                continue
            way = ends[1, :2] - ends[0, :2]
            size = np.linalg.norm(way)
            out = np.array((way[1], -way[0])) / size
            middle = ends[:, :2].mean(axis=0)
            others = np.concatenate([*places[:k], *places[k + 1 :]])
            t = (others - middle) @ way / size
            d = (others - middle) @ out
            reach = width / 2 + 2.0
            near = (np.abs(t) < width + 4) & (np.abs(d) < width + 4)
            if near.any() or size < width / 2 + 4:
                continue
            kind = "contour" if lines.fronts[k] == 1 else "inner"
            measured[kind].append(profile(ink, middle, out, reach))
    for kind, rows in measured.items():
        if rows:
            assert np.allclose(rows, width / 2, atol=0.12 + 0.01 * width), (kind, np.array(rows))
    assert sum(map(len, measured.values())) > 5


ORDINARY = {"cube": look.cube, "cylinder": look.cylinder, "lathe": creased.lathe,
            "ell": creased.ell}  # fmt: skip


@pytest.mark.parametrize("name", ORDINARY)
def test_verifiers_draw_what_flags_draw(backend, name):
    mesh = ORDINARY[name]()
    for camera in cameras(4):
        layer, items = Layer(((mesh, camera),)), [(mesh, camera)]
        flags, verifiers = (
            picture(backend, wide(2.5, silhouettes=False, indicator=kind).draws(layer), items)
            for kind in ("flags", "verifiers")
        )
        assert np.array_equal(flags, verifiers)
        assert (flags < 100).sum() > 300


def test_verifiers_also_take_diagonals_for_creases(backend):
    """Those of squares that lie along the x axis, whose ends have verifiers of zero."""
    mesh, extra = scored.part(), 0
    for camera in cameras(4):
        layer, items = Layer(((mesh, camera),)), [(mesh, camera)]
        flags, verifiers = (
            picture(backend, wide(2.5, silhouettes=False, indicator=kind).draws(layer), items)
            for kind in ("flags", "verifiers")
        )
        assert (verifiers <= flags).all()
        extra += (verifiers < flags).any(axis=2).sum()
    assert extra > 50


SIEVED = {**ORDINARY, "part": scored.part, "torus": look.torus, "bowl": look.bowl,
          "inside out": lambda: inside_out(creased.lathe()),
          "sheet inside out": lambda: inside_out(look.bowl()),
          "terrain": scored.terrain}  # fmt: skip


@pytest.mark.parametrize("name", SIEVED)
def test_sieved_and_unsieved_passes_draw_the_same(backend, name):
    mesh = SIEVED[name]()
    mesh = look.batch(mesh.positions, look.polygons_of(mesh), key=name)
    views = [*cameras(6), Camera(look.look_at((0.5, 0.2, 0.1)), look.perspective(80), VIEWPORT)]
    for camera in views:
        items, layer = [(mesh, camera)], Layer(((mesh, camera),))
        passes = list(wide(3.0).draws(layer))
        assert all(one.sieve for one in passes)
        sieved = picture(backend, passes, items)
        whole = picture(backend, [replace(one, sieve=None) for one in passes], items)
        assert np.array_equal(sieved, whole)


@pytest.mark.parametrize("make", [look.cube, creased.lathe, creased.ell])
@pytest.mark.parametrize("turned", [False, True])
def test_winding_and_mirrors_change_nothing(backend, make, turned):
    mesh = make()
    tilted = look.look_at((3.5, -2.9, 2.6))
    plain = Camera(tilted, look.perspective(), VIEWPORT)
    mirror = np.diag((-1.0, 1.0, 1.0, 1.0))
    mirrored = look.batch(mesh.positions * (-1, 1, 1), look.polygons_of(mesh))
    wanted = look.ink(*look.styled(backend, wide(3.0), (mesh, plain))[:2])
    other = inside_out(mirrored) if turned else mirrored
    camera = replace(plain, modelview=tilted @ mirror)
    found = look.ink(*look.styled(backend, wide(3.0), (other, camera))[:2])
    assert wanted.sum() > 1000
    assert (np.abs(found - wanted) > 0.2).sum() < 5


def square(z, half=1.0, x=0.0):
    return look.batch([(x - half, -half, z), (x + half, -half, z), (x + half, half, z),
                       (x - half, half, z)], [[0, 1, 2, 3]])  # fmt: skip


FRONT = Camera(look.look_at((0, 0, 6), up=(0, 1, 0)), look.orthographic(2.0), VIEWPORT)
PIXEL = 4.0 / 400


@pytest.mark.parametrize("behind", [0.0, 1.0, 3.0, 4.0, 5.0, 8.0])
def test_creases_fade_with_the_depth_that_they_lie_behind(backend, behind):
    """A sheet's border, so many pixels' worth of depth behind a sheet that covers it: whole up to
    bias, gone beyond bias + fade."""
    style = Crease(crease_width=5.0, silhouettes=False, spine=False, bias=2.0, fade=4.0)
    lines, cover = square(0.0, 1.0), square(behind * PIXEL, 1.7)
    look.clear()
    look.draw_base(lines, FRONT)
    look.draw_base(cover, FRONT)
    before = look.pixels()
    backend.render(style.draws(Layer(((lines, FRONT),))))
    ink = look.ink(before, look.pixels())
    on_surface = ink[190:210, 100:102].mean()
    assert on_surface == pytest.approx(np.clip(1.0 - (behind - 2.0) / 4.0, 0.0, 1.0), abs=0.06)


def test_the_spine_hides_what_the_soft_depth_test_alone_would_show(backend):
    lines, cover = square(0.0, 1.0), square(3.0 * PIXEL, 1.7)
    inks = []
    for spine in (False, True):
        style = Crease(crease_width=5.0, silhouettes=False, spine=spine, bias=20.0)
        look.clear()
        look.draw_base(lines, FRONT)
        look.draw_base(cover, FRONT)
        before = look.pixels()
        backend.render(style.draws(Layer(((lines, FRONT),))))
        inks.append(look.ink(before, look.pixels()).sum())
    assert inks[0] > 500
    assert inks[1] == 0


def silhouettes_of(backend, items, **options):
    look.clear()
    for mesh, camera in items:
        look.draw_base(mesh, camera)
    before = look.pixels()
    style = Crease(silhouettes=True, creases=False, silhouette_width=3.0, **options)
    backend.render(style.draws(Layer(tuple(items))))
    return look.ink(before, look.pixels())


def test_back_faces_hide_silhouettes_behind_closed_objects(backend):
    """The far one of two balls, half behind the near one: both ways hide it, since the near one's
    back lies before it."""
    far = Camera(FRONT.modelview @ shift(0.0, 0.0, -3.0), FRONT.projection, VIEWPORT)
    near = Camera(FRONT.modelview @ shift(0.9, 0.0, 1.0), FRONT.projection, VIEWPORT)
    ball = look.sphere(48, 32, 0.8)
    inks = {
        kind: silhouettes_of(backend, [(ball, far), (ball, near)], hidden_by=kind)
        for kind in ("surfaces", "back_faces")
    }
    inside = (slice(150, 250), slice(255, 340))  # of the near one's outline
    for kind, ink in inks.items():
        assert ink[inside].sum() < 1.0, kind
        assert ink[195:205, 115:125].max() > 0.9, kind  # the far one's free side
    # A sheet has no back there: it hides by its surface alone.
    sheet, before = square(2.0, 1.0), {}
    for kind in ("surfaces", "back_faces"):
        before[kind] = silhouettes_of(backend, [(sheet, FRONT), (ball, FRONT)], hidden_by=kind)
    assert before["surfaces"].sum() < 1.0
    assert before["back_faces"].sum() > 1000.0


def shift(x, y, z):
    m = np.eye(4)
    m[:3, 3] = x, y, z
    return m


@pytest.mark.parametrize("kind", ["surfaces", "back_faces"])
def test_the_hidden_part_of_a_torus_inner_silhouette_is_hidden(backend, kind):
    mesh = look.torus(72, 36)
    camera = Camera(look.look_at((0, -6, 1.6), up=(0, 0, 1)), look.perspective(), VIEWPORT)
    ink = silhouettes_of(backend, [(mesh, camera)], hidden_by=kind)
    look.clear()
    look.draw_base(mesh, camera)
    lines = creased.smooth_lines(mesh, camera, look.depths())
    hidden = np.concatenate([creased.places_of(pair)[state == sight.HIDDEN]
                             for pair, state in zip(lines.ends, lines.seen, strict=True)])
    seen = np.concatenate([creased.places_of(pair)[state == sight.SURE]
                           for pair, state in zip(lines.ends, lines.seen, strict=True)])
    apart = np.linalg.norm(hidden[:, None, :2] - seen[None, :, :2], axis=2).min(axis=1)
    hidden = hidden[apart > 6.0].astype(int)
    assert len(hidden) > 20
    assert ink[hidden[:, 1], hidden[:, 0]].mean() < 0.06


@pytest.mark.parametrize("texture", ["dotted", "dashed", "pen", "charcoal"])
def test_textures_leave_no_seam_of_their_own(backend, texture):
    """Textured ink lies where plain ink lies, on all of its length."""
    mesh, camera = creased.lathe(), cameras()[1]
    _, plain, _ = look.styled(backend, wide(12.0), (mesh, camera))
    before, drawn, _ = look.styled(backend, wide(12.0, texture=texture), (mesh, camera))
    flat, ink = look.ink(before, plain), look.ink(before, drawn)
    assert (ink <= flat + 0.02).all()
    assert 0.2 < ink.sum() / flat.sum() < 1.0
