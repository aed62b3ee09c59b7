"""Visible intersections are found by the GPU from all sides, and nothing where nothing crosses."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from OpenGL import GL

from glshim.driver.functions import gl
from glshim.linework import intersections as geometry
from glshim.linework.groups import grouped
from glshim.model.camera import Camera
from glshim.model.lines import Line
from glshim.outputs.gl.device.devices import ModernDevice
from glshim.outputs.gl.device.guard import Guard
from glshim.outputs.gl.device.plain import OFF
from glshim.outputs.gl.device.triangles import triangles as fans
from glshim.outputs.gl.frame.depth import DepthCopy
from glshim.outputs.gl.frame.frame import Frame, depth_margin
from glshim.outputs.gl.lines.crossings import Crossings
from glshim.styling.lines import Medium
from glshim.styling.media.ink import SHADER
from glshim.styling.protocol import Layer, Lines
from glshim.styling.wishes import Choice
from tests import look
from tests.sweep import some

SIZE = 400
VIEWS = 12


class Finder:
    """`Crossings` and what the backend does about it."""

    def __init__(self) -> None:
        with Guard():
            self.crossings = Crossings(ModernDevice())
            self.depth = DepthCopy()

    def __call__(self, *items, drawn=None, greater=False):
        """(L, 17) records of items in the app's picture of them, or of drawn, and its depth."""
        look.clear()
        for b, camera in items if drawn is None else drawn:
            look.draw_base(b, camera)
        depth = look.depths(SIZE, SIZE)
        with Guard():
            for capability in OFF:
                gl.glDisable(capability)
            self.depth.take((0, 0, SIZE, SIZE), 24)
            lines = Lines(Layer(items).bodies, Choice(intersections=True), Medium(SHADER))
            (group,) = grouped([lines])
            found = self.crossings.find(group.items, Frame(self.depth, depth_margin(24), greater))
        assert GL.glGetError() == 0
        return found, depth


@pytest.fixture(scope="module")
def finder():
    with look.window(SIZE, SIZE):
        yield Finder()


@pytest.fixture(scope="module")
def teapot():
    return look.teapot()


def turned(x, y, z, shift=(0.0, 0.0, 0.0)):
    """(4, 4) a rotation by angles in radians about the axes, then a shift."""
    out = np.eye(4)
    for k, a in enumerate((x, y, z)):
        turn = np.eye(4)
        i, j = (k + 1) % 3, (k + 2) % 3
        turn[i, i] = turn[j, j] = np.cos(a)
        turn[i, j], turn[j, i] = -np.sin(a), np.sin(a)
        out = turn @ out
    out[:3, 3] = shift
    return out


def plate(cells=1, half=1.6):
    return look._grid(
        lambda u, v: ((2 * u - 1) * half, (2 * v - 1) * half, 0.0), cells, cells, False, False
    )


def camera_for(k, direction):
    projection = look.perspective() if k % 2 else look.orthographic()
    return Camera(look.look_at(5 * direction), projection, (0, 0, SIZE, SIZE))


def placed(camera, *meshes):
    """Meshes with their places, under a camera."""
    return [(b, replace(camera, modelview=camera.modelview @ at)) for b, at in meshes]


def window(points, camera):
    """(N, 3) eye space to pixels and window depth."""
    clip = np.c_[points, np.ones(len(points))] @ camera.projection.T
    return (clip[:, :3] / clip[:, 3:] * 0.5 + 0.5) * (SIZE, SIZE, 1.0)


def sampled(segments, camera, step=0.5):
    """(N, 3) window points along eye-space segments, about one per half pixel."""
    ends = window(segments.reshape(-1, 3), camera).reshape(-1, 2, 3)
    count = np.ceil(np.linalg.norm(np.diff(ends[:, :, :2], axis=1)[:, 0], axis=1) / step) + 1
    count = np.maximum(count, 2).astype(int)
    which = np.repeat(np.arange(len(ends)), count)
    at = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    share = (at / (count - 1)[which])[:, None]
    return ends[which, 0] * (1 - share) + ends[which, 1] * share


def clearly_seen(points, depth, camera):
    """Whether nothing lies clearly (6 pixels at 45 degrees) before points (N, 3) in the 3 x 3
    pixels about them: a line in a hollow lies a little behind what is beside it."""
    slack = 1.2e-3 if camera.orthographic else 3e-4
    column, row = np.floor(points[:, :2]).astype(int).T
    inside = ((points[:, :2] > 2) & (points[:, :2] < SIZE - 2)).all(axis=1)
    column, row = np.clip(column, 1, SIZE - 2), np.clip(row, 1, SIZE - 2)
    around = [depth[row + i, column + j] for i in (-1, 0, 1) for j in (-1, 0, 1)]
    return inside & (points[:, 2] < np.min(around, axis=0) + slack)


def missing(truth, found):
    """(K, 3) truth points (N, 3) farther than a pixel from all found points."""
    far = np.ones(len(truth), bool)
    for start in range(0, len(truth), 2000):
        part = truth[start : start + 2000, None, :2] - found[None, :, :2]
        if len(found):
            far[start : start + 2000] = (part**2).sum(axis=2).min(axis=1) > 1.0
    return truth[far]


def truth_of(*meshes):
    """(M, 2, 3) all segments between two meshes with their places, world space, and (M,) which of
    them lie where the surfaces bend enough for a line."""
    parts = [fans(b).astype(float) @ at[:3, :3].T + at[:3, 3] for b, at in meshes]
    corners = np.concatenate(parts)
    owner = np.repeat(np.arange(2, dtype=np.int32), [len(part) for part in parts])
    beside = geometry.neighbours(corners.astype(np.float32), owner)
    pairs = []
    low, high = corners.min(axis=1), corners.max(axis=1)
    split = len(parts[0])
    for one in range(split):
        meet = (low[one] <= high[split:] + 1e-4) & (low[split:] <= high[one] + 1e-4)
        other = np.flatnonzero(meet.all(axis=1)) + split
        pairs.append(np.stack((np.full(len(other), one), other), axis=1))
    ends, rows = geometry.segments(corners, beside, np.concatenate(pairs))
    one, other = (
        np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
        for t in corners[np.concatenate(pairs)[rows]].transpose(1, 0, 2, 3)
    )
    sine = np.linalg.norm(np.cross(one, other), axis=1)
    sine /= np.linalg.norm(one, axis=1) * np.linalg.norm(other, axis=1)
    return ends, sine > np.sin(np.radians(21.0))


AT = turned(0.4, 0.7, 0.2, (0.3, 0.45, 0.2))
PAIRS = {
    "torus torus": (look.torus, AT, look.torus),
    "sphere plate": (look.sphere, np.eye(4), lambda: plate(7)),
    "box box": (look.cube, AT, look.cube),
    "cylinder plate": (look.cylinder, np.eye(4), lambda: plate(8)),
    "cylinder box": (look.cylinder, AT, lambda: look.cube(0.6)),
    "torus sphere": (look.torus, AT, lambda: look.sphere(radius=0.9)),
    "dense torus box": (lambda: look.torus(120, 60), AT, lambda: look.cube(0.6)),
    "dense sphere dense plate": (
        lambda: look.sphere(160, 80, radius=1.0), np.eye(4), lambda: plate(60)
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", some(tuple(PAIRS), 4))
def test_every_visible_crossing_is_found(finder, name):
    first, at, second = PAIRS[name]
    meshes = (first(), at), (second(), np.eye(4))
    (world, bent), total = truth_of(*meshes), 0
    for k, direction in enumerate(look.directions(VIEWS)):
        camera = camera_for(k, direction)
        items = placed(camera, *meshes)
        records, depth = finder(*items)
        found = sampled(records[:, Line.ENDS].reshape(-1, 2, 3).astype(float), camera)
        eye = world @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
        truth, meant = sampled(eye, camera), sampled(eye[bent], camera)
        seen = meant[clearly_seen(meant, depth, camera)]
        total += len(seen)
        lost = missing(seen, found)
        assert not len(lost), f"view {k}: {len(lost)} of {len(seen)} lost, e.g. {lost[:3]}"
        assert not len(missing(found, truth))
    assert total > 2000


@pytest.mark.parametrize("cells", some([(400, 200, 60), (900, 450, 300)], 1))
def test_triangles_smaller_than_pixels(finder, cells):
    """The circle in which a sphere of up to 800000 triangles meets a floor has no gap."""
    ball = replace(look.sphere(*cells[:2], radius=1.0), key=cells)
    floor = replace(plate(cells[2]), key=(cells, "floor"))
    angle = np.linspace(0, 2 * np.pi, 2000)
    circle = np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1)
    for k, direction in enumerate(look.directions(4)):
        camera = camera_for(k, direction)
        records, depth = finder(*placed(camera, (ball, np.eye(4)), (floor, np.eye(4))))
        found = sampled(records[:, Line.ENDS].reshape(-1, 2, 3).astype(float), camera)
        eye = circle @ camera.modelview[:3, :3].T + camera.modelview[:3, 3]
        truth = window(eye, camera)
        seen = truth[clearly_seen(truth, depth, camera)]
        lost = missing(seen, found)
        assert len(seen) > 500 and not len(lost), f"view {k}: {len(lost)} of {len(seen)} lost"


@pytest.mark.parametrize("name", ["torus", "sphere", "bowl", "cube", "cylinder", "dense"])
def test_closed_meshes_have_none(finder, name):
    mesh = {**look.MESHES, "dense": lambda: look.torus(160, 80)}[name]()
    for k, direction in enumerate(look.directions(VIEWS)):
        records, _ = finder((mesh, camera_for(k, direction)))
        assert not len(records), f"view {k}: {len(records)}"


def test_a_box_that_stands_on_a_floor_has_none(finder):
    for cells in (1, 6, 9):
        for k, direction in enumerate(look.directions(VIEWS)):
            camera = camera_for(k, direction)
            box, floor = look.cube(0.5), plate(cells)
            for up in (0.5, 0.5 + 1e-7):
                items = placed(camera, (box, turned(0, 0, 0.3, (0.1, 0.2, up))), (floor, np.eye(4)))
                assert not len(finder(*items)[0])


def test_the_teapots_spout_and_handle_go_through_its_body(finder, teapot):
    """And nothing else of it, but flaps of its knob thinner than a pixel."""
    total = 0
    for k, direction in enumerate(look.directions(VIEWS)):
        camera = camera_for(k, direction)
        ends = finder((teapot, camera))[0][:, :6].reshape(-1, 2, 3).astype(float)
        turn = camera.modelview[:3, :3]
        ends = (ends - camera.modelview[:3, 3]) @ turn
        at_the_side = np.abs(ends[:, :, 0]).min(axis=1) > 0.7
        flaps = ends[~at_the_side]
        assert (np.linalg.norm(flaps[:, 1] - flaps[:, 0], axis=1) < 0.01).all(), f"view {k}"
        total += int(at_the_side.sum())
    assert total > 100


def count_in(found, camera, low, high):
    """How many window points of records lie in a column range."""
    points = sampled(found[:, :6].reshape(-1, 2, 3).astype(float), camera)
    return int(((points[:, 0] > low) & (points[:, 0] < high)).sum())


def crossing_squares(camera):
    """A small plate through each of two others, in the left and in the right half."""
    upright = turned(np.pi / 2, 0, 0)
    return [
        (plate(3, 0.5), replace(camera, modelview=camera.modelview @ at))
        for x in (-0.8, 0.8)
        for at in (turned(0, 0, 0, (x, 0, 0)), turned(0, 0, 0, (x, 0, 0)) @ upright)
    ]


SQUARES = Camera(look.look_at((0.3, -3, 3)), look.perspective(), (0, 0, SIZE, SIZE))


@pytest.mark.parametrize("what", ["nothing", "scissor", "clip plane", "port", "known", "greater"])
def test_only_where_the_app_draws(finder, what):
    """Scissor, clip planes, another viewport, something in front that the shim does not know."""
    camera = SQUARES
    if what == "scissor":
        camera = replace(camera, scissor=(0, 0, SIZE // 2, SIZE))
    if what == "clip plane":
        plane = np.array((-1.0, 0, 0, 0)) @ np.linalg.inv(camera.modelview)
        camera = replace(camera, clip_planes=(tuple(plane),))
    if what == "port":
        camera = replace(camera, viewport=(100, 50, 200, 200))
    items = crossing_squares(camera)
    drawn = None
    if what == "known":  # a wall in front of the right half
        wall = plate(1, 1.0), replace(camera, modelview=camera.modelview @ turned(
            0.8, 0, 0, (1.05, -0.8, 0.8)))  # fmt: skip
        drawn = [*items, wall]
    if what == "greater":
        camera = replace(camera, depth_range=(1.0, 0.0))
        items = crossing_squares(camera)
        GL.glDepthFunc(GL.GL_GREATER)
        GL.glClearDepth(0.0)
    records, _ = finder(*items, drawn=drawn, greater=what == "greater")
    GL.glDepthFunc(GL.GL_LESS)
    GL.glClearDepth(1.0)
    left, right = count_in(records, SQUARES, 0, 200), count_in(records, SQUARES, 200, 400)
    assert left > 100
    assert (right > 100) == (what in ("nothing", "port", "greater"))


def test_many_small_objects_and_streams(finder):
    """A hundred boxes on the corners of each other, each under its own camera or all in one."""
    box = look.cube(0.12)
    camera = SQUARES
    grid = [(0.2 * i - 1, 0.2 * j - 1, 0) for i in range(10) for j in range(10)]
    places = [turned(0.1, 0.2, 0.3, shift) for shift in grid]
    moved = placed(camera, *((box, at) for at in places))
    keyed = placed(camera, *((replace(box, key="box"), at) for at in places))
    points = [
        replace(box, positions=(box.positions @ at[:3, :3].T + at[:3, 3]).astype(np.float32))
        for at in places
    ]
    together = [(b, camera) for b in points]
    counts = [len(finder(*items)[0]) for items in (moved, keyed, keyed, together)]
    assert min(counts) > 400
    assert max(counts) - min(counts) < 0.02 * max(counts)
