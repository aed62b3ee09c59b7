"""The fins of the GPU are the numpy reference's, and that says where surfaces turn away."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from glshim_stylers.fins import Fins, as_printed

from glshim.geometry.recovery.halfedges import twins, with_adjacency
from glshim.geometry.recovery.mesh import mesh as recovered
from glshim.geometry.references.fins import drawn_sides, facing, fins
from glshim.model.camera import Camera
from glshim.outputs.gl.device.guard import Guard
from glshim.styling.protocol import Layer
from tests import look
from tests.captured import CapturingRunner

SHAPE: dict[str, Any] = {"half_width": 2.5, "overhang": 0.3, "spine": False}
"""Without the spine test, which leaves out short fins that it says are hidden."""
VIEW = (10, 20, 640, 360)
TILTED = look.look_at((2.5, -1.9, 1.6))
WIDE = look.perspective(50, 16 / 9)
MIRROR = np.diag((-1.0, 1.0, 1.0, 1.0))


def mobius(count=24, width=0.35):
    """A strip that no winding suits."""
    turn = 2 * np.pi * np.arange(count) / count
    rim = [
        [((1 + s * np.cos(a / 2)) * np.cos(a), (1 + s * np.cos(a / 2)) * np.sin(a),
          s * np.sin(a / 2)) for a in turn] for s in (-width, width)
    ]  # fmt: skip
    quads = [[i, i + 1, count + i + 1, count + i] for i in range(count - 1)]
    quads.append([count - 1, count, 0, 2 * count - 1])
    # In triangles: drivers cut bent quads along either diagonal.
    return look.batch([*rim[0], *rim[1]], [[a, *pair] for a, *rest in quads
                                          for pair in (rest[:2], rest[1:])])  # fmt: skip


def inside_out(mesh):
    return look.batch(mesh.positions, [p[::-1] for p in look.polygons_of(mesh)])


def book():
    """Three pages at one back: an edge of three triangles and more."""
    points = [(0, 0, -0.8), (0, 0, 0.8), (1, 0, 0), (-0.6, 0.8, 0), (-0.6, -0.8, 0)]
    return look.batch(points, [[0, 1, 2], [1, 0, 3], [0, 1, 4]])


MESHES = {
    "torus": look.torus, "bowl": look.bowl, "cube": look.cube, "Moebius strip": mobius,
    "inside out": lambda: inside_out(look.torus()), "three on an edge": book,
}  # fmt: skip
CAMERAS = {
    "perspective": Camera(TILTED, WIDE, VIEW),
    "parallel": Camera(TILTED, look.orthographic(2, 16 / 9), VIEW),
    "mirrored": Camera(TILTED @ MIRROR, WIDE, VIEW),
    "clockwise": Camera(TILTED, WIDE, VIEW, front_ccw=False),
    "depth turned": Camera(TILTED, WIDE, VIEW, depth_range=(0.9, 0.2)),
    "clip planes": Camera(TILTED, WIDE, VIEW,
                          clip_planes=((0.6, 0.8, 0.0, 0.1), (0.1, -0.3, 1.0, 3.7))),
    "inside": Camera(look.look_at((0.93, 0.13, 0.05)), look.perspective(70, 16 / 9), VIEW),
    "near plane cuts": Camera(TILTED, look.perspective(50, 16 / 9, near=3.4), VIEW),
    "behind the viewer": Camera(look.look_at((2.5, -1.9, 1.6), (5, -4, 3.4)), WIDE, VIEW),
}  # fmt: skip


@pytest.fixture(scope="module")
def run():
    with look.window():
        yield CapturingRunner()


def six_of(mesh):
    return with_adjacency(mesh.triangles, twins(mesh))


@pytest.mark.parametrize("make", MESHES)
@pytest.mark.parametrize("seen", CAMERAS)
@pytest.mark.parametrize("joints", ["none", "overhang", "round"])
@pytest.mark.parametrize("over", ["triangles", "halfedges"])
def test_the_gpu_emits_the_reference(run, make, seen, joints, over):
    batch, camera = MESHES[make](), CAMERAS[seen]
    mesh, style = recovered(batch), Fins(**SHAPE, joints=joints)
    (one,) = style.draws(Layer(((batch, camera),)))
    one = as_printed(one) if over == "triangles" else replace(one, sieve=None)
    names = {"gl_Position": 4, "reach": 3}
    with Guard():
        found = run.varyings(one, names)[0]
    six = six_of(mesh)
    sides = drawn_sides(six, mesh.positions, camera)
    wanted = fins(
        six, mesh.positions, sides, camera, half_width=2.5,
        overhang=0.3 if joints == "overhang" else 0.0, rounded=joints == "round",
    )  # fmt: skip
    strips = corners_of(found, camera)
    if seen == "behind the viewer":
        assert len(strips) == len(wanted.side) == 0
        return
    # Rounding decides about no edge of these views, so both have the same in the same order.
    assert not unsure(six, mesh.positions, camera).any()
    assert len(strips) == len(wanted.side) > 2
    near = np.abs(wanted.corners).max(axis=(1, 2)) < 1e5
    assert near.mean() > 0.9
    assert np.allclose(strips[near, :, :2], wanted.corners[near], rtol=1e-4, atol=0.02)
    assert np.allclose(strips[near, :, 2:4], wanted.reach[near], rtol=1e-4, atol=0.02)
    depths = wanted.ends[:, (0, 0, 1, 1), 2]
    assert np.allclose(strips[near, :, 4], depths[near], atol=1e-5)


def corners_of(found, camera):
    """(F, 4, 5) pixels, reach and depth of each strip's corners, of triangles of feedback."""
    x, y, width, height = camera.viewport
    place = found["gl_Position"]
    assert np.allclose(place[..., 3], 1.0)
    pixels = place[..., :2] * (width / 2, height / 2) + (x + width / 2, y + height / 2)
    pairs = np.concatenate((pixels, found["reach"]), axis=2).reshape(-1, 2, 3, 5)
    strips = []
    for first, second in pairs:
        last = [q for q in second if not any(np.array_equal(q, p) for p in first)]
        assert len(last) == 1
        strips.append([*sorted(first.tolist(), key=lambda p: (p[2], p[3])), last[0].tolist()])
    return np.array(strips).reshape(-1, 4, 5)


def unsure(six, positions, camera):
    """Triangles that float32 may take for facing the other way."""
    corners = positions.astype(float)[six[:, ::2]]
    lengths = np.linalg.norm(np.diff(corners, axis=1), axis=2).prod(axis=1)
    centre = camera.object_centre
    reach = np.linalg.norm(centre[:3]) + abs(centre[3]) * np.abs(corners).max()
    return np.abs(facing(corners, camera)) < 1e-6 * lengths * reach


def test_corners_by_hand():
    """An open triangle: three fins round it, to the right of edges that run counter-clockwise."""
    batch = look.batch([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]])
    mesh, camera = recovered(batch), Camera(np.eye(4), np.eye(4), (0, 0, 200, 100))
    six = six_of(mesh)
    sides = drawn_sides(six, mesh.positions, camera)
    assert sides.open.tolist() == [True] * 3
    quads = fins(six, mesh.positions, sides, camera, half_width=3.0, overhang=0.1)
    side = 3.0
    first = int(np.flatnonzero((quads.ends[:, :, 1] == 50.0).all(axis=1))[0])
    assert np.allclose(quads.ends[first], [[100, 50, 0.5], [200, 50, 0.5]])
    assert np.allclose(
        quads.corners[first],
        [[90, 50 + side], [90, 50 - side], [210, 50 + side], [210, 50 - side]],
    )
    rounded = fins(six, mesh.positions, sides, camera, half_width=3.0, rounded=True)
    assert np.allclose(rounded.corners[first][:, 0], [97, 97, 203, 203])
    bare = fins(six, mesh.positions, sides, camera, half_width=3.0)
    assert np.allclose(bare.corners[first][:, 0], [100, 100, 200, 200])
    assert np.isfinite(bare.corners).all()


@pytest.mark.parametrize("make", ["torus", "bowl", "cube", "inside out"])
def test_contours_are_where_projected_triangles_turn(make):
    """The article's own test, of triangles all before the viewer: signed areas in the window."""
    mesh = recovered(MESHES[make]())
    for k, direction in enumerate(look.directions(12)):
        lens = look.perspective() if k % 2 else look.orthographic()
        camera = Camera(look.look_at(5 * direction), lens, (0, 0, 400, 400))
        clip = np.c_[mesh.positions, np.ones(len(mesh.positions))]
        clip = clip @ (camera.projection @ camera.modelview).T
        flat = clip[:, :2] / clip[:, 3:]
        a, b, c = np.moveaxis(flat[mesh.triangles], 1, 0)
        front = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0] > 0
        pairs = mesh.faces[mesh.faces[:, 1] >= 0]
        wanted = int((front[pairs[:, 0]] != front[pairs[:, 1]]).sum())
        sides = drawn_sides(six_of(mesh), mesh.positions, camera)
        assert int((~sides.open).sum()) == wanted
        assert int(sides.open.sum()) == int((mesh.faces[:, 1] < 0).sum())


def test_a_twisted_edge_has_one_fin_where_the_strip_folds_over():
    """Of a Moebius strip each edge where both triangles lie on one side of it in the window is
    drawn once, twisted or not."""
    strip = mobius(5)
    askew = 0.2 * np.random.default_rng(3).standard_normal(strip.positions.shape)
    mesh = recovered(look.batch(strip.positions + askew, look.polygons_of(strip)))
    six = six_of(mesh)
    assert mesh.twisted.sum() > 0
    folded = 0
    for direction in look.directions(60):
        camera = Camera(look.look_at(5 * direction), look.orthographic(), (0, 0, 400, 400))
        sides = drawn_sides(six, mesh.positions, camera)
        drawn = {}
        for triangle, side, alone in zip(*sides, strict=True):
            if not alone:
                ends = mesh.triangles[triangle][[side, (side + 1) % 3]]
                key = tuple(sorted(ends.tolist()))
                drawn[key] = drawn.get(key, 0) + 1
        flat = mesh.positions @ camera.modelview[:3, :3].T
        for (v0, v1), (v2, v3), twisted, pair in zip(
            mesh.edges, mesh.opposite, mesh.twisted, mesh.faces, strict=True
        ):
            if pair[1] < 0:
                continue
            along = (flat[v1] - flat[v0])[:2]
            beside = [along[0] * (flat[v] - flat[v0])[1] - along[1] * (flat[v] - flat[v0])[0]
                      for v in (v2, v3)]  # fmt: skip
            if min(np.abs(beside)) < 1e-6:
                continue
            wanted = int(beside[0] * beside[1] > 0)
            assert drawn.get(tuple(sorted((int(v0), int(v1)))), 0) == wanted
            folded += wanted * int(twisted)
    assert folded > 3
