"""The paper's edge mesh on the GPU is the numpy references': decisions, strokes, poses."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from math import cos, radians

import numpy as np
import pytest
from glshim_stylers.edge_mesh.paper import CAP, KINDS, QUAD, PaperLook, paper_passes
from OpenGL import GL

from glshim.geometry.meshshaders.edge_mesh import features
from glshim.geometry.meshshaders.poses import Keyframes, Skin
from glshim.geometry.meshshaders.sieve import EdgeSieve
from glshim.geometry.references import thick_lines
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.passes.runner import seen_from
from glshim.styling.protocol import Layer
from glshim.styling.values import Body
from tests import look
from tests.captured import CapturingRunner
from tests.decision import edge_mesh as decision
from tests.figures import mcguire
from tests.score import meshes as scored
from tests.sweep import some

ALL = sum(KINDS)
VIEW = (10, 20, 640, 360)


@pytest.fixture(scope="module")
def run():
    with look.window():
        yield CapturingRunner()


@pytest.mark.parametrize("name", decision.MESHES)
def test_the_gpu_decides_as_equation_1(run, name):
    mesh = decision.MESHES[name]()
    mesh = look.batch(mesh.positions, look.polygons_of(mesh), key=name)
    row = decision.compare(run, mesh, decision.cameras())
    assert row.features > 100
    assert row.wrong == 0
    assert row.differ <= row.edges / 10_000


def test_the_band_is_narrow(run):
    row = decision.compare(run, scored.gear(), decision.cameras())
    assert row.unsure == 0


def resident_of(run, body):
    with Guard():
        found = run.residents.find(body.batches)
        run.residents.release()
    return found


ASKED = tuple(product([1, 2, 4, 16, ALL], ["torus", "bowl", "part", "terrain", "teapot"]))


@pytest.mark.parametrize(("wanted", "name"), some(ASKED, 12))
def test_the_sieve_keeps_every_feature(run, name, wanted):
    mesh = {**look.MESHES, **scored.MESHES}[name]()
    resident = resident_of(run, Body((mesh,), decision.cameras(1)[0]))
    sieve = EdgeSieve(resident.mesh, resident.edges)
    left = 0
    for camera in decision.cameras():
        body = Body((mesh,), camera)
        bits = decision.decided(run, decision.decide(body)) & wanted
        eye = np.array(seen_from(camera, (0.0, 0.0, 1.0, 0.0))["eye"])
        kept = sieve.candidates(eye, wanted, decision.ANGLES)
        assert np.isin(np.flatnonzero(bits), kept).all()
        if wanted == 1:  # ridges and valleys have the same candidates
            assert len(kept) <= 1.1 * np.count_nonzero(bits) + 10
        left += len(bits) - len(kept)
    assert left > 0


def cameras():
    tilted = look.look_at((2.5, -1.9, 1.6))
    off = look.perspective(60, 16 / 9)
    off[0, 2], off[1, 2] = 0.4, -0.2
    return {
        "perspective": Camera(tilted, look.perspective(50, 16 / 9), VIEW),
        "parallel": Camera(tilted, look.orthographic(2, 16 / 9), VIEW),
        "off centre": Camera(tilted, off, VIEW),
        "inside": Camera(look.look_at((0.9, 0.1, 0.05)), look.perspective(70, 16 / 9), VIEW),
    }


def reference(resident, camera, bits, parameters, halves):
    """Segments, reaches and lengths of every edge, in float64."""
    edges, mesh = resident.edges.indices, resident.mesh
    v = np.where(edges < 0, ~edges, edges)
    at, normals = mesh.positions.astype(float), np.rint(mesh.vertex_normals * 32767) / 32767
    opened = edges[:, 0] < 0
    kind = np.array([next((k for k in range(5) if b >> k & 1), 0) for b in bits])
    matrix = camera.projection @ camera.modelview
    half = (VIEW[2] / 2, VIEW[3] / 2)
    lines = thick_lines.segments(at[v[:, 0]], at[v[:, 1]], normals[v[:, 0]], normals[v[:, 1]],
                                 matrix, half=half)  # fmt: skip
    within = np.c_[at[v[:, 2]], np.ones(len(v))] @ matrix.T
    some = opened & (bits & 1 > 0) & (within[:, 3] > 0)
    with np.errstate(all="ignore"):
        lines = thick_lines.outwards(lines, within[:, :2] / within[:, 3:] * half, some)
    widths = np.array(LOOK.widths)[kind]
    half_quad = halves & (kind == 0)
    reach = np.where(half_quad, widths, widths / 2)
    origin = matrix[:, 3]
    c = origin[:2] / origin[3] * half
    u = thick_lines.along(lines, thick_lines.random_of(len(edges)), np.maximum(9.0, 3 * widths),
                          c, parameters)  # fmt: skip
    return lines, reach, half_quad, u


LOOK = PaperLook(strokes="half", widths=(8.0, 5.0, 6.0, 3.0, 4.0), valley_angle=130.0)


@pytest.mark.parametrize("name", cameras())
@pytest.mark.parametrize("strokes", ["quads", "half"])
@pytest.mark.parametrize("parameters", ["object", "screen"])
@pytest.mark.parametrize("make", [look.torus, scored.part, look.bowl])
def test_quads_and_caps_are_equations_2_to_5(run, name, strokes, parameters, make):
    camera = cameras()[name]
    mesh = make()
    body = Body((mesh,), camera)
    resident = resident_of(run, body)
    style = replace(LOOK, strokes=strokes, parameters=parameters)
    layer = Layer(((mesh, camera),))
    passes = {p.shader: replace(p, sieve=None) for p in paper_passes(style, layer)}
    names = {"gl_Position": 4, "grain": 2}
    with Guard():
        quads, caps = (
            run.varyings(passes[s], names)[0] for s in (QUAD, CAP)
        )
    turns = (radians(style.ridge_angle), radians(style.valley_angle))
    seen = seen_from(camera, (0.0, 0.0, 1.0, 0.0))
    eye = np.array(seen["eye"])
    bits = features(resident.edges.indices, resident.mesh.positions, eye, turns,
                    facing=seen["facing"])  # fmt: skip
    lines, reach, half, u = reference(resident, camera, bits, parameters, strokes == "half")
    drawn = (bits > 0) & lines.shown
    long = np.hypot(*(lines.finish - lines.start).T) > 0.5  # p of shorter ones is rounding
    sure = long & (np.abs((lines.start_normal * lines.perpendicular).sum(1)) > 1e-3)
    sure &= np.abs((lines.finish_normal * lines.perpendicular).sum(1)) > 1e-3
    sure &= np.abs(lines.finish).max(1) + np.abs(lines.start).max(1) < 1e5
    sure &= ~decision.unsure(resident.edges.indices, resident.mesh.positions, eye)
    there = quads["gl_Position"][:, 0, 2] < 2.0
    assert np.array_equal(there[sure], drawn[sure])
    some = sure & drawn
    assert some.sum() > 15

    def close(found, wanted):
        assert np.allclose(found, wanted, rtol=1e-4, atol=0.02), np.abs(found - wanted).max()

    size = np.array(VIEW[2:]) / 2
    places = np.where(half[:, None, None], thick_lines.half_quads(lines, reach),
                      thick_lines.quads(lines, reach))  # fmt: skip
    close((quads["gl_Position"][..., :2] * size)[some], places[some])
    close(quads["gl_Position"][some][:, (0, 1), 2], lines.depths[some])
    assert np.allclose(quads["gl_Position"][some, :, 3], 1.0)

    side = lines.sides[0]
    outer = thick_lines.outer_along(lines, reach, u, capped=True)
    across = np.where(half[:, None], [1.0, 1, 0, 0],
                      0.5 + np.outer(side, [0.5, 0.5, -0.5, -0.5]))  # fmt: skip
    onwards = np.where(half[:, None], np.c_[u, outer[:, ::-1]], u[:, [0, 1, 1, 0]])
    assert np.allclose(quads["grain"][some, :, 0], onwards[some], rtol=1e-3, atol=2e-3)
    assert np.array_equal(quads["grain"][some, :, 1], across[some])

    for first, cap, end in zip((0, 3), thick_lines.caps(lines, reach), (0, 1), strict=True):
        got = caps["gl_Position"][:, first : first + 3]
        normal = (lines.start_normal, lines.finish_normal)[end]
        leaning = np.abs(lines.perpendicular[:, 0] * normal[:, 1]
                         - lines.perpendicular[:, 1] * normal[:, 0]) > 1e-3  # fmt: skip
        fill = thick_lines.fills(cap)
        assert np.array_equal((got[:, 0, 2] < 2.0)[some & leaning], fill[some & leaning])
        filled = some & leaning & fill
        close((got[..., :2] * size)[filled], cap[filled])
        tip = np.where(lines.sides[end] * (1 - 2 * end) > 0, 2, 0)[filled]
        got_u = caps["grain"][filled, first + tip]
        assert np.allclose(got_u, np.c_[u[filled, end], 0 * tip], rtol=1e-3, atol=2e-3)


def test_equations_by_hand():
    at = np.array([[-0.5, 0.0, 0.0]]), np.array([[0.5, 0.0, 0.0]])
    normals = np.array([[-1.0, 1.0, 0.0]]), np.array([[0.0, -1.0, 0.0]])
    lines = thick_lines.segments(*at, *normals, np.eye(4), half=(100.0, 100.0))
    reach = np.array([2.0])
    assert np.allclose(lines.perpendicular, [[0, 1]])
    assert [s.tolist() for s in lines.sides] == [[1.0], [-1.0]]
    assert np.allclose(thick_lines.quads(lines, reach), [[[-50, -2], [50, -2], [50, 2], [-50, 2]]])
    assert np.allclose(thick_lines.half_quads(lines, reach),
                       [[[-50, 0], [50, 0], [50, 2], [-50, 2]]])  # fmt: skip
    start, finish = thick_lines.caps(lines, reach)
    assert np.allclose(start, [[[-50, 0], [-50, 2], [-50 - 2**0.5, 2**0.5]]])
    assert np.allclose(finish, [[[50, 0], [50, -2], [50, -2]]])
    assert thick_lines.fills(start).all() and not thick_lines.fills(finish).any()
    u = thick_lines.along(lines, np.array([0.25]), np.array([50.0]), np.zeros(2), "object")
    assert np.allclose(u, [[0.25, 2.25]])
    u = thick_lines.along(lines, np.array([0.25]), np.array([50.0]), np.array([50.0, 7]), "screen")
    assert np.allclose(u, [[-2.0, 0.0]])
    a = 2 * np.hypot(2**-0.5, 1 - 2**-0.5)
    outer = thick_lines.outer_along(lines, reach, np.array([[0.0, 1.0]]), capped=True)
    assert np.allclose(outer, [[a / (a + 100), 1.0]])


def test_an_edge_through_the_viewer_is_cut():
    matrix = look.perspective(near=0.1)
    behind = thick_lines.segments(
        np.array([[0.0, 0.1, -2.0], [0, 0, 1]]), np.array([[0.3, 0.1, 3.0], [0, 0, 2]]),
        np.ones((2, 3)), np.ones((2, 3)), matrix, half=(100.0, 100.0),
    )  # fmt: skip
    assert behind.shown.tolist() == [True, False]
    assert np.isfinite(behind.finish[0]).all()
    assert np.abs(behind.depths[0]).max() <= 1.0


def morph(mesh, share):
    bent = mesh.positions * (1.4, 0.7, 1.0) + 0.2 * np.sin(3 * mesh.positions[:, [1, 2, 0]])
    pair = mesh.positions, bent.astype(np.float32)
    normals = mesh.vertex_normals.astype(np.float32)
    turned = normals + 0.3 * normals[:, [1, 2, 0]]
    return Keyframes(pair, (normals, (turned / np.linalg.norm(turned, axis=1)[:, None])), share)


def bend(mesh, angle):
    """Two bones: the upper half turns, with a soft joint."""
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]], np.float32)
    upper = np.clip(0.5 + mesh.positions[:, 2], 0, 1).astype(np.float32)
    zero = np.zeros_like(upper)
    bones = np.tile(np.array([0, 1, 0, 0], np.int32), (len(upper), 1))
    weights = np.stack((1 - upper, upper, zero, zero), 1)
    return Skin(mesh.positions, mesh.vertex_normals.astype(np.float32),
                np.stack((np.eye(4, dtype=np.float32), turn)), bones, weights)  # fmt: skip


def tube():
    return look._grid(
        lambda u, v: (0.5 * np.cos(2 * np.pi * u), 0.5 * np.sin(2 * np.pi * u), 2.4 * v - 1.2),
        20, 24, True, False,
    )  # fmt: skip


POSES = {
    "morph 0": (look.torus, lambda m: morph(m, 0.0)),
    "morph 0.3": (look.torus, lambda m: morph(m, 0.3)),
    "morph 1": (look.torus, lambda m: morph(m, 1.0)),
    "tube 20": (tube, lambda m: bend(m, radians(20))),
    "tube 70": (tube, lambda m: bend(m, radians(70))),
}


@pytest.mark.parametrize("name", POSES)
def test_a_pose_is_the_mesh_moved_on_the_cpu(run, name):
    make, pose_of = POSES[name]
    mesh = make()
    triangles = mesh_triangles(run, mesh)
    changed = 0
    for camera in decision.cameras(6):
        body = Body((triangles,), camera)
        resident = resident_of(run, body)
        pose = pose_of(resident.mesh)
        moved, _ = pose.move()
        bits = decision.decided(run, decision.decide(body, pose=pose))
        seen = seen_from(camera, (0.0, 0.0, 1.0, 0.0))
        indices, eye = resident.edges.indices, np.array(seen["eye"])
        here = features(indices, moved, eye, decision.ANGLES, facing=seen["facing"])
        sure = ~decision.unsure(indices, moved, eye)
        assert sure.mean() > 0.99 and (here > 0).sum() > 20
        assert np.array_equal(bits[sure], here[sure])
        still = features(indices, resident.mesh.positions, eye, decision.ANGLES,
                         facing=seen["facing"])  # fmt: skip
        changed += int((here != still).sum())
    assert (changed > 0) == (name != "morph 0")


def mesh_triangles(run, mesh):
    """The same surface in triangles: all of its edges stay edges however it bends."""
    resident = resident_of(run, Body((mesh,), decision.cameras(1)[0]))
    return look.batch(resident.mesh.positions, resident.mesh.triangles.tolist())


def picture(backend, style, items, pose=None):
    look.clear()
    for mesh, camera in items:
        look.draw_base(mesh, camera)
    before = look.pixels()
    passes = paper_passes(style, Layer(tuple(items)))
    backend.render([replace(p, pose=pose) if p.element != "screen" else p for p in passes])
    return before, look.pixels()


@pytest.mark.parametrize("name", ["morph 0.3", "tube 70"])
@pytest.mark.parametrize("strokes", ["thin", "quads"])
def test_a_posed_picture_is_that_of_the_moved_mesh(run, name, strokes):
    make, pose_of = POSES[name]
    mesh = mesh_triangles(run, make())
    resident = resident_of(run, Body((mesh,), decision.cameras(1)[0]))
    pose = pose_of(resident.mesh)
    moved = look.batch(pose.move()[0].astype(np.float32), resident.mesh.triangles.tolist())
    backend = Backend.attach()
    camera = decision.cameras(3)[1]
    style = PaperLook(strokes=strokes, caps="none", hidden="solid")
    _, wanted = picture(backend, style, [(moved, camera)])
    look.clear()
    look.draw_base(moved, camera)
    still = Layer(((mesh, camera),))
    backend.render([replace(p, pose=pose) if p.element != "screen" else p
                    for p in paper_passes(style, still)])  # fmt: skip
    found = look.pixels()
    ink = (wanted == 0).all(axis=2)
    assert ink.sum() > 500
    assert ((found == 0).all(axis=2) != ink).sum() <= 0.01 * ink.sum()


def spheres(count):
    """Tori side by side on a grid, a camera each."""
    mesh = look.torus(12, 8)
    side = int(np.ceil(count**0.5))
    found = []
    for k in range(count):
        at = np.eye(4)
        at[:3, 3] = ((k % side + 0.5) / side * 3.6 - 1.8, (k // side + 0.5) / side * 3.6 - 1.8, -5)
        at[:3, :3] = look.look_at((1, 2, 1.5))[:3, :3] * (0.9 / side)
        found.append((mesh, Camera(at, look.orthographic(2.0), (0, 0, 400, 400))))
    return found


@pytest.mark.parametrize("count", [1, 9, 300])
def test_silhouettes_are_outside_of_their_bodies(run, count):
    backend = Backend.attach()
    items = spheres(count)
    style = PaperLook(strokes="half", widths=(3.0,) * 5, outer=True,
                      drawn=(True, False, False, False, False))  # fmt: skip
    before, after = picture(backend, style, items)
    inside = (before < 250).all(axis=2)
    ink = (before != after).any(axis=2)
    assert not (ink & inside).any()
    rim = ~inside & (np.roll(inside, 1, 0) | np.roll(inside, -1, 0)
                     | np.roll(inside, 1, 1) | np.roll(inside, -1, 1))  # fmt: skip
    assert (ink & rim).sum() > 0.97 * rim.sum()
    _, every = picture(backend, replace(style, outer=False), items)
    assert ((before != every).any(axis=2) & inside).any()


def test_a_cube_shows_nine_edges_and_hides_three():
    backend = Backend.attach()
    mesh = look.cube()
    for camera in decision.cameras(12):
        style = PaperLook(hidden="none")
        before, visible = picture(backend, style, [(mesh, camera)])
        _, both = picture(backend, replace(style, hidden="solid"), [(mesh, camera)])
        _, dashed = picture(backend, replace(style, hidden="dashed"), [(mesh, camera)])
        seen = (before != visible).any(axis=2)
        every = (before != both).any(axis=2)
        dashes = (before != dashed).any(axis=2)
        assert (seen <= dashes).all() and (dashes <= every).all()
        front, back = cube_edges(mesh, camera)
        assert share(seen, front) > 0.999  # no gap in a visible edge
        assert share(seen, back) < 0.02
        assert share(every, back) > 0.99
        assert 0.6 < share(dashes, back) < 0.9  # 0.56, and a pixel to both sides of each dash


def cube_edges(mesh, camera):
    """Pixels along visible and along hidden edges, away from the ends of these."""
    found = [[], []]
    points = np.c_[mesh.positions, np.ones(8)] @ (camera.projection @ camera.modelview).T
    window = (points[:, :2] / points[:, 3:] + 1) * 200
    polygons = look.polygons_of(mesh)
    fronts = [
        np.linalg.det(window[p[1:3]] - window[p[0]]) > 0 for p in polygons
    ]
    t = np.linspace(0.06, 0.94, 400)[:, None]
    for i in range(8):
        for j in range(i):
            sides = [f for p, f in zip(polygons, fronts, strict=True) if i in p and j in p]
            if len(sides) == 2:
                found[not any(sides)].append(window[i] + t * (window[j] - window[i]))
    front, back = (np.concatenate(f) for f in found)
    near = np.linalg.norm(back[:, None] - front[None, ::4], axis=2).min(1) < 4
    return front, back[~near]


def share(ink, places):
    """Of places, how many have ink within a pixel."""
    wide = ink.copy()
    for axis in (0, 1):
        wide = wide | np.roll(wide, 1, axis) | np.roll(wide, -1, axis)
    if not len(places):
        return 1.0
    x, y = np.clip(np.floor(places).astype(int), 0, 399).T
    return wide[y, x].mean()


def test_state_is_left_alone():
    backend = Backend.attach()
    GL.glLineWidth(3.0)
    items = spheres(3)
    picture(backend, PaperLook(strokes="half", outer=True, hidden="dashed"), items)
    assert GL.glGetFloatv(GL.GL_LINE_WIDTH) == 3.0
    assert GL.glGetError() == 0
    GL.glLineWidth(1.0)


def test_the_angles_are_the_looks(run):
    style = PaperLook(ridge_angle=80.0)
    camera = decision.cameras(1)[0]
    passes = list(paper_passes(style, Layer(((look.cube(), camera),))))
    assert passes[-1].uniforms["turns"][0] == cos(radians(80))


@pytest.mark.parametrize("make", [look.torus, look.bowl, look.cylinder])
def test_half_quads_lie_outside_however_the_polygons_wind(run, make):
    backend = Backend.attach()
    mesh = make()
    back = look.batch(mesh.positions, [p[::-1] for p in look.polygons_of(mesh)])
    style = PaperLook(strokes="half", caps="round", widths=(6.0,) * 5, outer=True,
                      drawn=(True, False, False, False, False))  # fmt: skip
    for camera in decision.cameras(4):
        before, one = picture(backend, style, [(mesh, camera)])
        _, other = picture(backend, style, [(back, camera)])
        ink = (before != one).any(axis=2)
        assert ink.sum() > 500
        assert (ink != (before != other).any(axis=2)).sum() < 0.02 * ink.sum()



def test_round_ends_close_the_gaps_of_figure_5(run):
    """Along the near rim the paper's caps leave wedges open, and round ends none."""
    none, paper, round_ = mcguire.figure5_tiles(Backend.attach())
    at = mcguire.MESH.positions
    near = at[(at[:, 2] > 0) & (at[:, 1] < -0.3)]
    places = np.c_[near, np.ones(len(near))] @ mcguire.CAMERA.modelview.T
    places = places @ mcguire.CAMERA.projection.T
    window = (places[:, :2] / places[:, 3:] + 1) * mcguire.SIZE / 2
    # Below each corner of the rim, a little within the strokes' lower side.
    columns, rows = np.floor(window - (0.0, 9.0)).astype(int).T
    columns = columns[:, None] + np.arange(-2, 3)
    open_ = [int((tile[::-1][rows[:, None], columns].max(axis=2) > 100).sum())
             for tile in (none, paper, round_)]  # fmt: skip
    assert open_[0] > 0 and open_[1] > 0
    assert open_[2] == 0
