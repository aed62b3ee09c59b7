"""Style shadow against rays: what a pixel shows is dark where a triangle is between it and the
light."""

from __future__ import annotations

import glfw
import numpy as np
import pytest
from glshim_stylers.shadow import Shadow
from OpenGL import GL

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look

SIZE = 120
PORT = (0, 0, SIZE, SIZE)
VIEW = look.look_at((3.5, -4.5, 3.4), (0, 0, 0.2), (0, 0, 1))
UPRIGHT = VIEW[:3, :3] @ (-0.5, -0.2, 0.9)
BACKGROUND, LIT, DARK = 0, 1, 2


def sheet(half=2.6, height=-0.6, cuts=4):
    axis = np.linspace(-half, half, cuts + 1)
    points = [(x, y, height) for x in axis for y in axis]
    n = cuts + 1
    quads = [(i * n + j, (i + 1) * n + j, (i + 1) * n + j + 1, i * n + j + 1)
             for i in range(cuts) for j in range(cuts)]  # fmt: skip
    return look.batch(points, quads)


def placed(x=0.0, y=0.0, z=0.0, turn=0.0, scale=(1.0, 1.0, 1.0)):
    c, s = np.cos(turn), np.sin(turn)
    found = np.eye(4)
    found[:3, :3] = np.array(((c, -s, 0), (s, c, 0), (0, 0, 1))) * scale
    found[:3, 3] = x, y, z
    return found


def triangles(batch):
    """(T, 3, 3) corners."""
    fans = [(p[0], p[k], p[k + 1]) for p in look.polygons_of(batch) for k in range(1, len(p) - 1)]
    return batch.positions[np.array(fans)].astype(float)


def hits(origins, ways, corners, least):
    """(N,) the nearest hit past least of each ray, in lengths of its way, and its triangle.

    Möller and Trumbore 1997, with the triple products turned so that all rays meet all triangles
    in products of matrices: (o - a) . (d x v) = v . (o x d) - d . (v x a), and so on.
    """
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    u, v = b - a, c - a
    normal, va, au = np.cross(u, v), np.cross(v, a), np.cross(a, u)
    nearest, which = np.full(len(origins), np.inf), np.full(len(origins), -1)
    for start in range(0, len(origins), 512):
        part = slice(start, start + 512)
        o, d = origins[part], ways[part]
        moment = np.cross(o, d)
        det = -d @ normal.T
        with np.errstate(divide="ignore", invalid="ignore"):
            s = (moment @ v.T - d @ va.T) / det
            r = (-moment @ u.T - d @ au.T) / det
            t = (o @ normal.T - (a * normal).sum(1)) / det
        inside = (s >= 0) & (r >= 0) & (s + r <= 1) & (t > least) & (np.abs(det) > 1e-14)
        t = np.where(inside, t, np.inf)
        nearest[part], which[part] = t.min(1), t.argmin(1)
    return nearest, which


def truth(items, light, turned_away):
    """(H, W) BACKGROUND, LIT or DARK, and whether rays and raster must agree there."""
    corners = []
    for batch, camera in items:
        points = triangles(batch)
        corners.append(points @ camera.modelview[:3, :3].T + camera.modelview[:3, 3])
    corners = np.concatenate(corners)
    depth = look.depths(SIZE, SIZE)
    y, x = np.mgrid[:SIZE, :SIZE] + 0.5
    ndc = np.stack((x / SIZE * 2 - 1, y / SIZE * 2 - 1, depth * 2.0 - 1, np.ones_like(x)), 2)
    unprojection = np.linalg.inv(items[0][1].projection)
    seen, near = (at.reshape(-1, 4) @ unprojection.T
                  for at in (ndc, ndc * (1, 1, 0, 1) - (0, 0, 1, 0)))  # fmt: skip
    seen, near = seen[:, :3] / seen[:, 3:], near[:, :3] / near[:, 3:]
    there = depth.ravel() < 1.0
    way = seen - near
    length, which = hits(near, way, corners, 0.0)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[which]
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    towards = light[:3] - light[3] * seen
    unit = towards / np.linalg.norm(towards, axis=1, keepdims=True)
    slant = (normal * unit).sum(1)
    view = (normal * way).sum(1) / np.linalg.norm(way, axis=1)
    away = slant * view > 0.0  # light and viewer on different sides
    distance, _ = hits(seen, towards, corners, 1e-3)
    between = distance < (1.0 if light[3] else np.inf)
    dark = np.where(away, turned_away == "shadow", between)
    found = np.where(there, np.where(dark, DARK, LIT), BACKGROUND).reshape(SIZE, SIZE)
    sure = ~there | (np.abs(slant) > 0.08) & (np.abs(view) > 0.08) & (np.abs(length - 1) < 1e-2)
    sure = sure.reshape(SIZE, SIZE)
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            sure &= found == np.roll(found, (dy, dx), (0, 1))
    return found, sure


@pytest.fixture(scope="module")
def backend():
    with look.window(SIZE, SIZE):
        yield Backend.attach()


def picture(backend, items, lamp, **options):
    look.clear()
    GL.glFrontFace(GL.GL_CCW)
    for batch, camera in items:
        look.draw_base(batch, camera)
    styler = Shadow(**{"darkness": 1.0, **options})
    backend.render(styler.draws(Layer(tuple(items), tuple(map(float, lamp)))))
    shade = look.pixels(SIZE, SIZE)[:, :, 0]
    return np.where(shade == 255, BACKGROUND, np.where(shade > 100, LIT, DARK))


def check(backend, items, light, *, least=50, **options):
    found = picture(backend, items, light, **options)
    wanted, sure = truth(items, light, options.get("turned_away", "app"))
    assert sure.mean() > 0.4
    wrong = sure & (found != wanted)
    assert not wrong.any(), f"{wrong.sum()} pixels, one at {np.argwhere(wrong)[0]}"
    assert (sure & (wanted == DARK)).sum() >= least, "a scene with hardly a shadow shows nothing"
    return found


def seen(*bodies, view=VIEW, projection=None, port=PORT):
    projection = look.perspective() if projection is None else projection
    return [(batch, Camera(view @ place, projection, port)) for batch, place in bodies]


TORUS = look.torus(20, 10)
SCENES = {
    "cube on a floor": [(sheet(), np.eye(4)), (look.cube(0.6), placed(turn=0.4))],
    "torus over a sheet": [(sheet(height=-1.0), np.eye(4)), (TORUS, placed(z=0.3))],
    "open bowl": [(sheet(height=-1.3), np.eye(4)), (look.bowl(), placed())],
    "sheet over a sheet": [(sheet(), np.eye(4)), (sheet(0.8), placed(z=1.2, turn=0.3))],
    "mirrored and plain": [
        (sheet(height=-0.9), np.eye(4)), (TORUS, placed(x=-0.7, scale=(-0.7, 0.7, 0.7))),
        (look.cube(0.5), placed(x=0.7, y=-0.4)), (look.cube(0.3), placed(x=0.2, y=0.3, z=1.0)),
    ],
    "one over the other": [
        (sheet(), np.eye(4)), (look.cube(0.5), placed()), (sheet(0.5), placed(z=1.6)),
        (look.bowl(), placed(z=1.6, scale=(0.4, 0.4, -0.4))),
    ],
}  # fmt: skip
LIGHTS = {
    "directional": (*UPRIGHT, 0.0),
    "point": (*(VIEW[:3, :3] @ (-1.4, -0.6, 2.9) + VIEW[:3, 3]), 1.0),
    "point of another w": (*(-2.0 * (VIEW[:3, :3] @ (1.2, 1.0, 2.8) + VIEW[:3, 3])), -2.0),
}


@pytest.mark.parametrize("lens", ["perspective", "orthographic"])
@pytest.mark.parametrize("light", LIGHTS)
@pytest.mark.parametrize("scene", SCENES)
def test_rays_agree(backend, scene, light, lens):
    projection = look.perspective() if lens == "perspective" else look.orthographic(2.6)
    lamp = np.array(LIGHTS[light])
    lamp = lamp / lamp[3] if lamp[3] else lamp
    items = seen(*SCENES[scene], projection=projection)
    found = picture(backend, items, LIGHTS[light])
    assert (check(backend, items, lamp) == found).all()


@pytest.mark.parametrize("light", LIGHTS)
def test_faces_that_look_away_are_in_shadow_where_asked_for(backend, light):
    lamp = np.array(LIGHTS[light])
    lamp = lamp / lamp[3] if lamp[3] else lamp
    for scene in ("cube on a floor", "torus over a sheet", "open bowl"):
        check(backend, seen(*SCENES[scene]), lamp, turned_away="shadow")


def test_the_viewer_may_stand_in_a_shadow(backend):
    roof = look.cube(2.5), placed(x=2.5, y=-3.0, z=7.0)
    items = seen(*SCENES["cube on a floor"], roof)
    light = np.array((*(VIEW[:3, :3] @ (0.0, 0.0, 1.0)), 0.0))
    place = roof[1][:3, 3] @ VIEW[:3, :3].T + VIEW[:3, 3]
    corners = triangles(roof[0]) @ VIEW[:3, :3].T + place
    assert np.isfinite(hits(np.zeros((1, 3)), light[None, :3], corners, 0.0)[0]).all()
    found = check(backend, items, light)
    assert (found == LIT).sum() > 500


@pytest.mark.parametrize("view", [(3.0, 0.0, 0.0), (0.0, 3.0, 0.1), (0.1, 0.2, 3.0)])
def test_a_light_that_shines_from_the_viewer_shows_no_shadow(backend, view):
    for projection in (look.perspective(), look.orthographic(2.0)):
        items = seen((TORUS, np.eye(4)), (look.cube(0.3), placed()),
                     view=look.look_at(view), projection=projection)  # fmt: skip
        light = (0.0, 0.0, 1.0, 0.0) if projection[3, 3] else (0.0, 0.0, 0.0, 1.0)
        found = picture(backend, items, light)
        assert (found == DARK).sum() < 0.004 * (found != BACKGROUND).sum()


@pytest.mark.parametrize("seed", range(12))
def test_light_along_a_flat_polygon_leaks_nowhere(backend, seed):
    """The parts of a polygon are on the same side of the light but for the last bits."""
    random = np.random.default_rng(seed)
    turn = np.linalg.qr(random.normal(size=(3, 3)))[0]
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    solid = look.cylinder(7 + seed, 0.5, 0.5)
    points = solid.positions @ turn.T.astype(np.float32)
    solid = look.batch(points, look.polygons_of(solid))
    items = seen((sheet(height=-1.0), np.eye(4)), (solid, np.eye(4)))
    corners = triangles(solid)
    side = corners[random.integers(0, 2 * len(corners) // 3)]
    along = side[1] - side[0] + random.uniform(-0.5, 0.5) * (side[2] - side[0])
    along *= np.sign(along[2]) or 1.0
    along /= np.linalg.norm(along)
    check(backend, items, np.array((*(VIEW[:3, :3] @ along), 0.0)), least=0)


def test_the_light_moves_and_the_mesh_too(backend):
    dark = set()
    for k in range(6):
        light = np.array((*(VIEW[:3, :3] @ (np.cos(k), np.sin(k), 1.2)), 0.0))
        torus = look.torus(20, 10, 0.7 + 0.05 * k, 0.3)
        found = check(backend, seen((sheet(height=-1.0), np.eye(4)), (torus, placed(z=0.2))), light)
        dark.add((found == DARK).sum())
    assert len(dark) > 3


def test_bodies_need_not_shadow_themselves(backend):
    items = seen(*SCENES["torus over a sheet"])
    light = np.array((*(VIEW[:3, :3] @ (-0.8, 0.1, 0.25)), 0.0))
    whole = picture(backend, items, light)
    found = picture(backend, items, light, self_shadows=False)
    alone = picture(backend, items[1:], light, self_shadows=False)
    assert (alone != DARK).all()
    torus = alone == LIT
    assert ((whole == DARK) & torus).sum() > 5
    assert (found[torus] == LIT).all()
    assert (found == whole)[~torus].mean() > 0.999


def test_a_fixed_light_and_the_look(backend):
    items = seen(*SCENES["cube on a floor"])
    turn, lift = np.radians(40.0), np.radians(60.0)
    light = np.cos(lift) * np.sin(turn), np.sin(lift), np.cos(lift) * np.cos(turn), 0.0
    there = picture(backend, items, light)
    fixed = picture(backend, items, (0, 0, 1, 0), light="fixed", azimuth=40, elevation=60)
    assert (there == fixed).all() and (there == DARK).any()
    picture(backend, items, light, darkness=0.5, tint="#ff0000")
    pixel = look.pixels(SIZE, SIZE)[there == DARK][0].astype(int)
    assert np.abs(pixel - (102 + 127.5, 102, 102)).max() <= 1
    picture(backend, items, light, darkness=0.0)
    assert (look.pixels(SIZE, SIZE)[there == DARK] == 204).all()


def test_reversed_depth_is_the_same(backend):
    items = seen(*SCENES["cube on a floor"])
    light = LIGHTS["directional"]
    plain = picture(backend, items, light)
    GL.glClearDepth(0.0)
    GL.glDepthFunc(GL.GL_GREATER)
    back = [(b, Camera(c.modelview, c.projection, PORT, depth_range=(1.0, 0.0))) for b, c in items]
    found = picture(backend, back, light)
    GL.glClearDepth(1.0)
    GL.glDepthFunc(GL.GL_LESS)
    assert (found == plain).mean() > 0.998


def test_the_apps_stencil_and_depth_stay(backend):
    items = seen(*SCENES["cube on a floor"])
    look.clear()
    for batch, camera in items:
        look.draw_base(batch, camera)
    GL.glEnable(GL.GL_SCISSOR_TEST)
    GL.glScissor(20, 30, 70, 50)
    GL.glClearStencil(0x5A)
    GL.glClear(GL.GL_STENCIL_BUFFER_BIT)
    GL.glDisable(GL.GL_SCISSOR_TEST)
    GL.glClearStencil(0)

    def stencil():
        raw = GL.glReadPixels(0, 0, SIZE, SIZE, GL.GL_STENCIL_INDEX, GL.GL_UNSIGNED_BYTE)
        return np.frombuffer(raw, np.uint8).copy()

    before, depth = stencil(), look.depths(SIZE, SIZE)
    assert set(before) == {0, 0x5A}
    backend.render(Shadow().draws(Layer(tuple(items), LIGHTS["directional"])))
    assert (stencil() == before).all()
    assert (look.depths(SIZE, SIZE) == depth).all()
    assert GL.glGetError() == 0


def test_a_window_without_stencil_and_depth(backend):
    kept = glfw.get_current_context()
    wanted = picture(backend, seen(*SCENES["cube on a floor"]), LIGHTS["directional"])
    for name, bits in ((glfw.DEPTH_BITS, 0), (glfw.STENCIL_BITS, 0)):
        glfw.window_hint(name, bits)
    handle = glfw.create_window(SIZE, SIZE, "bare", None, None)
    glfw.make_context_current(handle)
    try:
        found = picture(Backend.attach(), seen(*SCENES["cube on a floor"]), LIGHTS["directional"])
        floor = (wanted != BACKGROUND) & (found == DARK)
        assert floor.any()
        assert (floor & (wanted == DARK)).sum() > 0.95 * (wanted == DARK).sum()
    finally:
        glfw.make_context_current(kept)
        glfw.destroy_window(handle)
        glfw.window_hint(glfw.DEPTH_BITS, 24)
        glfw.window_hint(glfw.STENCIL_BITS, 8)


def test_several_samples_a_pixel(backend):
    """But for the pixels at edges, where a depth may be any sample's."""
    items = seen(*SCENES["cube on a floor"])
    plain = picture(backend, items, LIGHTS["directional"])
    with look.multisampled(SIZE, SIZE):
        found = picture(Backend.attach(), items, LIGHTS["directional"])
    assert (plain == DARK).sum() > 100
    assert (found != plain).mean() < 0.015
