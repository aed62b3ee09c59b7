"""Styles cartoon and technical: light on the GPU is the numpy reference's, on a sphere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from glshim_stylers.cartoon import Cartoon
from glshim_stylers.hiddenline import HiddenLine
from glshim_stylers.shared.shading import UNLIT, UPPER_LEFT
from glshim_stylers.technical import Technical
from OpenGL import GL

from glshim.model.camera import Camera
from glshim.model.lights import Light, Lighting, banded, gooch, incoming
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer, Lines
from tests import look

RADIUS = 1.2
EYE = (2.5, 2.0, 3.0)
CAMERA = Camera(
    look.look_at(EYE), look.perspective(), (0, 0, 400, 400), lit=True
)
DARK = replace(CAMERA, lit=False)
PAINT = (0.6, 0.4, 0.8)
BEHIND = (0.2, 0.5, 0.3)
SUN = Light((0.4, 0.5, 0.7, 0.0), diffuse=(0.7, 0.6, 0.5))
LAMP = Light(
    (-1.5, 0.5, -2.0, 1.0), diffuse=(0.3, 0.5, 0.9), attenuation=(0.8, 0.1, 0.05)
)
SPOT = Light(
    (0.5, 1.0, 0.0, 1.0), diffuse=(0.9, 0.9, 0.3), spot_direction=(-0.1, -0.2, -1.0),
    spot_cutoff=20.0, spot_exponent=8.0,
)  # fmt: skip
LIT = {"sun": (SUN,), "lamp": (LAMP,), "spot": (SPOT,), "all": (SUN, LAMP, SPOT)}
PLAIN = {"highlight": 0.0, "intersections": "off"}


@pytest.fixture(scope="module")
def backend():
    with look.window():
        yield Backend.attach()


def ball():
    b = look.sphere(96, 64, RADIUS)
    normals = (b.positions / RADIUS)[b.corners]
    return replace(b, normals=np.ascontiguousarray(normals, np.float32))


def drawn(backend, style, *cameras, lights=(SUN,), mesh=None):
    """(400, 400, 3) floats 0..1 of the mesh over a background, in a style; row 0 at the bottom."""
    mesh = mesh or ball()
    look.clear(BEHIND)
    for camera in cameras:
        look.draw_base(mesh, camera, PAINT)
    items = tuple((mesh, camera) for camera in cameras)
    lighting = Lighting(lights) if lights is not None else None
    backend.render(list(style.draws(Layer(items, lighting=lighting))))
    return look.pixels() / 255.0


def seen():
    """Of each pixel of the picture: where it sees the sphere in eye space (N, 3), the normal there
    (N, 3), and which pixels those are (400, 400). Well within the outline, where no ink is."""
    x, y = np.meshgrid(np.arange(400) + 0.5, np.arange(400) + 0.5)
    focus = CAMERA.projection[0, 0]
    rays = np.stack([(x / 200 - 1) / focus, (y / 200 - 1) / focus, -np.ones_like(x)], axis=2)
    rays /= np.linalg.norm(rays, axis=2, keepdims=True)
    centre = CAMERA.modelview[:3, 3]
    along = rays @ centre
    left = RADIUS**2 - (centre @ centre - along**2)
    hit = left > 0.05
    points = rays[hit] * (along[hit] - np.sqrt(left[hit]))[:, None]
    return points, (points - centre) / RADIUS, hit


@pytest.mark.parametrize("name", LIT)
@pytest.mark.parametrize("bands", [2, 3, 7])
def test_bands_are_those_of_the_reference(backend, name, bands):
    lights = LIT[name]
    style = Cartoon(
        bands=bands, exposure=1.3, shadow=0.4, shadow_tint="#80c0ff", saturation=1.0, **PLAIN
    )
    picture = drawn(backend, style, CAMERA, lights=lights)
    points, normals, hit = seen()
    light = incoming(lights, points, normals)
    brightest = light.max(axis=1)
    level = banded(1.3 * brightest, bands)[:, None]
    own = bands * 1.3 * brightest
    # Bands are smooth over a pixel at their edges, which tessellation moves a little.
    image = np.zeros(hit.shape)
    image[hit] = own
    down, across = np.gradient(image)
    margin = 0.03 + 1.5 * (np.abs(down) + np.abs(across))[hit]
    near = np.abs(own[:, None] - np.arange(1, bands)).min(axis=1) < margin
    together = np.minimum(np.sum([one.diffuse for one in lights], axis=0), 1.0)
    together /= together.max()
    most = brightest[:, None]
    seen_light = np.minimum(light, 1.0) / np.clip(most, 1e-9, 1.0)
    hue = np.where(most > 0, (together + seen_light) / 2, together)
    dark = 0.4 * np.array((128, 192, 255)) / 255
    wanted = np.asarray(PAINT) * ((1 - level) * dark + level * hue)
    off = np.abs(picture[hit] - wanted).max(axis=1)
    cone = np.zeros(len(points), bool)
    if SPOT in lights:
        way = points - np.asarray(SPOT.position[:3])
        axis = np.asarray(SPOT.spot_direction) / np.linalg.norm(SPOT.spot_direction)
        angle = np.degrees(np.arccos(way @ axis / np.linalg.norm(way, axis=1)))
        cone = np.abs(angle - SPOT.spot_cutoff) < 0.5
    plain = ~near & ~cone
    assert plain.mean() > 0.4
    assert (off[plain] > 3 / 255).mean() < 0.002
    assert len(np.unique(level)) > 1  # there is something to see


@pytest.mark.parametrize("paint", ["app", "#40c080"])
def test_tones_are_those_of_gooch(backend, paint):
    style = Technical(paint=paint, hidden="none", **PLAIN)
    picture = drawn(backend, style, CAMERA)
    _, normals, hit = seen()
    way = np.asarray(UPPER_LEFT.position[:3])
    base = PAINT if paint == "app" else (64 / 255, 192 / 255, 128 / 255)
    tint = Lighting((SUN,)).tint if paint == "app" else 1.0
    wanted = gooch(
        np.full((len(normals), 3), base) * tint, normals @ (way / np.linalg.norm(way)),
        blue=style.blue, yellow=style.yellow, alpha=style.alpha, beta=style.beta,
        hue=style.hue,
    )  # fmt: skip
    assert np.abs(picture[hit] - wanted).max() < 4 / 255


def test_the_light_may_be_the_apps(backend):
    style = Technical(light="app", hidden="none", **PLAIN)
    picture = drawn(backend, style, CAMERA, lights=(SUN,))
    _, normals, hit = seen()
    way = np.asarray(SUN.position[:3])
    wanted = gooch(
        np.full((len(normals), 3), PAINT) * Lighting((SUN,)).tint,
        normals @ (way / np.linalg.norm(way)),
        blue=style.blue, yellow=style.yellow, alpha=style.alpha, beta=style.beta,
        hue=style.hue,
    )  # fmt: skip
    assert np.abs(picture[hit] - wanted).max() < 4 / 255


def test_the_references_are_the_papers_and_gls():
    """By hand: the light's full strength, at half of it, from behind, and beyond a spot."""
    normals = np.array([(0, 0, 1), (0, np.sqrt(0.75), 0.5), (0, 0, -1.0)])
    points = np.zeros((3, 3))
    ahead = Light((0, 0, 2, 0), diffuse=(1, 0.5, 0))
    assert np.allclose(incoming((ahead,), points, normals)[:, 0], (1, 0.5, 0))
    near = Light((0, 0, 4, 2), attenuation=(0, 1, 1))  # a point at a distance of 2
    assert np.allclose(incoming((near,), points, normals)[:, 0], np.array((1, 0.5, 0)) / 6)
    aside = replace(near, spot_direction=(0, 1, -1), spot_cutoff=44.0)
    assert not incoming((aside,), points, normals).any()
    assert incoming((replace(aside, spot_cutoff=46.0),), points, normals).any()
    assert banded(np.array((0, 0.32, 0.34, 0.7, 1.0, 5.0)), 3).tolist() == [0, 0, 0.5, 1, 1, 1]
    tones = gooch(
        np.full((2, 3), 0.5), np.array((1.0, -1.0)), blue=0.4, yellow=0.4, alpha=0.2, beta=0.6
    )
    assert np.allclose(tones, [(0.7, 0.7, 0.3), (0.1, 0.1, 0.5)])


def centre_of(picture):
    """The colours of the sphere, well within its outline."""
    return picture[seen()[2]]


@pytest.mark.parametrize("make", [Cartoon, Technical])
def test_what_the_app_does_not_light_keeps_its_picture(backend, make):
    """A sun, a sky, a wall with a light map."""
    as_it_is = centre_of(drawn(backend, make(shade_unlit="off", **PLAIN, **bare(make)), DARK))
    assert np.abs(as_it_is - PAINT).max() < 2 / 255
    # With anything lit beside it, auto leaves it alone, too; alone in the layer it gets some form,
    # in its own hue and nearly as light.
    kept = centre_of(drawn(backend, make(**PLAIN, **bare(make)), DARK, lights=(SUN,)))
    assert (kept == as_it_is).all()
    formed = centre_of(drawn(backend, make(**PLAIN, **bare(make)), DARK, lights=None)) / PAINT
    assert formed.min() > UNLIT - 0.01
    assert np.ptp(formed.mean(axis=1)) > 0.08
    assert np.ptp(formed, axis=1).max() < 0.02
    forced = make(shade_unlit="head", **PLAIN, **bare(make))
    textured = replace(DARK, textured=True)
    shaded = [centre_of(drawn(backend, forced, camera)) for camera in (DARK, textured)]
    assert (shaded[0] == shaded[1]).all()
    assert np.abs(shaded[0] - PAINT).max() > 0.1
    mapped = centre_of(drawn(backend, make(**PLAIN, **bare(make)), textured, lights=None))
    assert (mapped == as_it_is).all()


def bare(make):
    """Options under which the colours of the surfaces alone are seen."""
    return {"saturation": 1.0} if make is Cartoon else {"hidden": "none"}


def test_highlights_are_where_the_material_gleams(backend):
    def bright(camera, **options):
        style = Cartoon(intersections="off", saturation=1.0, **options)
        return (drawn(backend, style, camera, lights=(SUN,)) > 0.85).all(axis=2).sum()

    dull, glossy = CAMERA, replace(CAMERA, gleams=True)
    assert bright(dull, highlight=1.0) == 0 == bright(glossy, highlight=0.0)
    large, small = (bright(glossy, highlight=1.0, gloss=gloss) for gloss in (10.0, 100.0))
    assert large > 2 * small > 100


def test_what_was_drawn_over_the_surfaces_stays(backend):
    """Not of the meshes, nearer: neither bands nor tones go over it."""
    mesh = ball()
    look.clear(BEHIND)
    look.draw_base(mesh, CAMERA, PAINT)
    GL.glMatrixMode(GL.GL_MODELVIEW)
    GL.glLoadIdentity()
    GL.glColor3f(0, 1, 0)
    GL.glBegin(GL.GL_QUADS)
    for x, y in ((-0.1, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.1, 0.1)):
        GL.glVertex3f(x, y, -1)
    GL.glEnd()
    before = look.pixels()
    over = (before == (0, 255, 0)).all(axis=2)
    for style in (Cartoon(), Technical()):
        layer = Layer(((mesh, CAMERA),), lighting=Lighting((SUN,)))
        backend.render(list(style.draws(layer)))
    assert over.sum() > 1000
    inner = over[:, 1:-1] & over[:, 2:] & over[:, :-2]
    assert (look.pixels()[:, 1:-1][inner] == (0, 255, 0)).all()


def test_posterised_paints_are_few(backend):
    """A picture with a ramp of colours."""
    found = {}
    for levels in (0, 4):
        mesh = look.cube(2.0)
        camera = Camera(look.look_at((0, 0, 5), up=(0, 1, 0)), look.orthographic(1.5),
                        (0, 0, 400, 400), lit=True)  # fmt: skip
        look.clear(BEHIND)
        look.draw_base(mesh, camera)
        GL.glDepthFunc(GL.GL_ALWAYS)
        GL.glDepthMask(0)
        GL.glMatrixMode(GL.GL_PROJECTION)
        GL.glLoadIdentity()
        GL.glMatrixMode(GL.GL_MODELVIEW)
        GL.glLoadIdentity()
        GL.glBegin(GL.GL_QUADS)
        for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            GL.glColor3f(0.5 + 0.5 * x, 0.25 + 0.25 * x, 0)
            GL.glVertex2f(x, y)
        GL.glEnd()
        GL.glDepthFunc(GL.GL_LESS)
        GL.glDepthMask(1)
        style = Cartoon(posterise=levels, line_width=0, outline_width=0.5, saturation=1.0)
        sun = Light((0.0, 0.0, 1.0, 0.0))
        layer = Layer(((mesh, camera),), lighting=Lighting((sun,)))
        backend.render(list(style.draws(layer)))
        found[levels] = {int(value) for value in look.pixels()[200].max(axis=1)}
    assert len(found[0]) > 100
    steps = np.array((0, 32, 64, 128, 191, 255))  # four levels, and half of the least
    assert all(np.abs(steps - value).min() <= 1 for value in found[4])
    assert len(found[4]) >= 5


def sides(picture, shade):
    return (np.abs(picture - np.asarray(shade)).max(axis=2) < 0.3).sum()


def test_hidden_line_drawings_show_features_or_all_sides(backend):
    """Quads that GL cuts in two: their diagonals are no sides."""
    flat = look._grid(lambda u, v: (2 * u - 1, 2 * v - 1, 0), 4, 4, False, False)
    camera = Camera(
        look.look_at((0, 0, 5), up=(0, 1, 0)), look.orthographic(1.5), (0, 0, 400, 400)
    )
    shown = {}
    for edges in ("features", "all"):
        style = HiddenLine(edges=edges, intersections="off", paper="app", line="#ff0000")
        look.clear()
        look.draw_base(flat, camera, (1, 1, 1))
        backend.render(list(style.draws(Layer(((flat, camera),)))))
        shown[edges] = (look.pixels()[..., 1] < 128).astype(int)
    features, every = shown["features"], shown["all"]
    assert features[90:310, 90:310].sum() == 0
    inner = every[90:310, 90:310]
    # Three lines each way; a diagonal of a quad would be on its middle.
    middles = [int(200 + 66.7 * k) for k in (-1.5, -0.5, 0.5, 1.5)]
    assert inner.sum() > 3 * 200
    for x in middles:
        for y in middles:
            assert every[y - 8 : y + 8, x - 8 : x + 8].sum() == 0


@pytest.mark.parametrize(
    ("edges", "hidden", "more"), [("features", "dashed", 60), ("features", "dimmed", 60)]
)
def test_hidden_lines_are_drawn_when_asked_for(backend, edges, hidden, more):
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 400))

    def ink(style):
        look.clear()
        look.draw_base(look.cube(), camera, (1, 1, 1))
        backend.render(list(style.draws(Layer(((look.cube(), camera),)))))
        return (look.pixels()[..., 1] < 220).sum()

    kept = {"edges": edges, "intersections": "off", "paper": "app", "width": 2.0}
    assert ink(HiddenLine(hidden=hidden, **kept)) > ink(HiddenLine(**kept)) + more


def test_surfaces_are_what_the_options_say():
    assert Cartoon().surface == Technical().surface == "paint"
    assert Cartoon(textures="off").surface == Technical(textures="off").surface == "colours"
    assert HiddenLine(polygons="#ff0000").surface == (1.0, 0.0, 0.0)
    assert HiddenLine(polygons="app").surface == "app"


def test_crossings_are_looked_for_where_polygons_are_few():
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 400))

    def looks(mesh, intersections):
        draws = HiddenLine(intersections=intersections).draws(Layer(((mesh, camera),)))
        return any(getattr(getattr(one, "wanted", None), "intersections", False) for one in draws)

    few, many = look.cube(), look.sphere(200, 120)
    assert [looks(few, word) for word in ("auto", "on", "off")] == [True, True, False]
    assert [looks(many, word) for word in ("auto", "on", "off")] == [False, True, False]


def test_dense_meshes_have_no_thicket_of_hidden_lines():
    camera = Camera(look.look_at((3, 2, 2.5)), look.perspective(), (0, 0, 400, 400))

    def shares(mesh, hidden):
        draws = Technical(hidden=hidden).draws(Layer(((mesh, camera),)))
        return {one.medium.uniforms["hidden_share"] for one in draws if isinstance(one, Lines)}

    few, many = look.cube(), look.sphere(200, 120)
    assert shares(few, "auto") == shares(few, "dashed") == shares(many, "dashed") == {0.0, 0.4}
    assert shares(many, "auto") == {0.0}


def test_greys_do_not_turn_olive_and_paints_keep_their_hue():
    """As they do with the paper's blue and yellow."""
    style = Technical()
    numbers = {name: getattr(style, name) for name in ("blue", "yellow", "alpha", "beta")}
    greys = np.repeat(np.linspace(0.1, 0.9, 9)[:, None], 3, axis=1)
    for hue, most in ((style.hue, 0.06), (0.0, 1.0)):
        warm = gooch(greys, np.ones(9), **numbers, hue=hue)
        cool = gooch(greys, -np.ones(9), **numbers, hue=hue)
        assert (warm[:, 0] > warm[:, 2]).all() and (cool[:, 2] > cool[:, 0]).all()
        olive = warm[:, 1] - (warm[:, 0] + warm[:, 2]) / 2  # between red and blue: neither
        assert (olive < most).all()
        assert (olive > 0.08).all() == (hue == 0.0)
    red = np.array([(0.8, 0.1, 0.1)])
    for toward in (-1.0, 0.0, 1.0):
        tone = gooch(red, np.array([toward]), **numbers, hue=style.hue)[0]
        assert tone[2] < 0.25 * tone[0] and abs(tone[1] - tone[2]) < 0.05
