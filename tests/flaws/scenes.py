"""One scene a flaw of the paper's method: what stands there, how it is drawn, what is measured."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from tests import look
from tests.flaws import measure
from tests.flaws.measure import Picture

SIZE = 400
PORT = (0, 0, SIZE, SIZE)
Items = list[tuple[PolygonBatch, Camera]]


@dataclass(frozen=True)
class Scene:
    """Objects with lines before others without, a style, and a measure that is 0 where the flaw
    is not."""

    name: str
    title: str
    sentence: str
    items: Items
    """Whose lines are asked about."""
    faults: Callable[[Picture], float]
    behind: Items = field(default_factory=list)
    """What else stands there (it gets lines, too)."""
    silhouette_width: float | None = None
    ridge_width: float | None = None
    """Of the visible line in pixels."""
    quad_width: float | None = None
    """Of one of the paper's quads, in pixels; None: half the ridge's."""
    ridge_angle: float = 120.0
    crop: tuple[int, int, int, int] = (0, 0, SIZE, SIZE)
    """Left, top, right, bottom of the part to show, in pixels from the upper left."""


def _camera(eye, target=(0, 0, 0), fov=30.0, near=0.1, up=(0.0, 0.0, 1.0)) -> Camera:
    return Camera(look.look_at(eye, target, up), look.perspective(fov, near=near), PORT)


def box(low, high) -> PolygonBatch:
    """An upright box between two corners."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    b = look.cube(1.0)
    return look.batch((low + high) / 2 + b.positions * (high - low) / 2, look.polygons_of(b))


def prism(sides, radius, half, at=(0.0, 0.0, 0.0), turn=0.0) -> PolygonBatch:
    """An upright regular prism; turn in degrees."""
    b = look.cylinder(sides, radius, half)
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    points = b.positions.astype(float) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
    return look.batch(points + at, look.polygons_of(b))


def threshold() -> Scene:
    """Hexagonal bolts: every fold of their sides is 120 degrees, the threshold."""
    camera = _camera((4, -7, 4.5), (0, 0, -0.1))
    places = [(x, y) for x in (-1.1, 0, 1.1) for y in (-1.0, 0.2)]
    bolts = [
        (prism(6, 0.45, 0.4, (x, y, 0), 17 * k + 5), camera) for k, (x, y) in enumerate(places)
    ]
    return Scene(
        "threshold",
        "z-fighting near the threshold",
        "The sides of hexagonal bolts meet at exactly the threshold of 120 degrees. Left: the "
        "added quads lie in the neighbours' planes and fight with them. Right: it is decided once "
        "whether such a fold is a ridge.",
        bolts,
        measure.in_part,
        ridge_width=6,
        crop=(50, 110, 240, 300),
    )


def cracks() -> Scene:
    """The inner side of a coarse ring with ridges of 40 px."""
    return Scene(
        "cracks",
        "cracks between wide quads",
        "Ridges of 40 px on a coarse ring. Left: wedges stay open between the quads of "
        "consecutive edges. Right: the stroke of each edge has round ends, and no wedge stays "
        "open.",
        [(look.torus(16, 8, 1.0, 0.6), _camera((0, -3, 4), fov=24.0))],
        lambda p: measure.gaps_along(p, 40),
        ridge_width=40,
        ridge_angle=150,
    )


def corners() -> Scene:
    """An octagonal nut with wide lines: the folds of its sides, 135 degrees, are no ridges."""
    camera = _camera((1.0, -4, 4.2), fov=34.0)
    return Scene(
        "corners",
        "gaps at corners",
        "The rim of an octagonal nut. Left: every quad ends at a right angle to its own edge, so "
        "a wedge stays open at each corner, and the corners of the silhouette are cut. Right: "
        "each line reaches around its corner to the next.",
        [(prism(8, 1.2, 0.55, turn=10), camera)],
        lambda p: measure.gaps_at_corners(p, 32) + measure.gaps_around(p, 24),
        silhouette_width=24,
        ridge_width=32,
    )


def thickness() -> Scene:
    """The rim of a can, in front a ridge and at the back a silhouette."""
    camera = _camera((0.6, -6, 2.3), (0, 0, 0.1), fov=26.0)

    def uneven(picture: Picture) -> float:
        found = rim_widths(picture, 8.0)
        return float(np.maximum(np.abs(found - 8.0) - 0.75, 0).sum())

    return Scene(
        "thickness",
        "ridges that change thickness where they turn into silhouettes",
        "The rim of a can is a ridge in front and a silhouette at the back, both of width w. "
        "Left: two quads of width w make the ridge twice as thick. Right: w is the width of the "
        "visible line, all the way round.",
        [(prism(32, 1.1, 0.75), camera)],
        uneven,
        silhouette_width=8,
        ridge_width=8,
        quad_width=8,
    )


def rim_widths(picture: Picture, width: float) -> np.ndarray:
    """Pixels of ink across the upper rim of the can, all the way round, but where its own upright
    silhouettes and the lower rim come near."""
    batch, camera = picture.items[0]
    clip = np.c_[batch.positions, np.ones(len(batch.positions))]
    clip = clip @ (camera.projection @ camera.modelview).T
    window = np.c_[(clip[:, :3] / clip[:, 3:] + 1) / 2] * (SIZE, SIZE, 1)
    half = len(window) // 2
    rim = np.stack([window[half:], np.roll(window[half:], -1, axis=0)], axis=1)
    flat = {tuple(np.round(p, 3)) for p in rim[:, 0, :2]}
    every = np.concatenate([picture.segments("ridges"), picture.segments("outlines")])
    others = [s for s in every if not all(tuple(np.round(p, 3)) in flat for p in s[:, :2])]
    return measure.widths(picture, rim, width, np.array(others))


def diamond(at, radius, depth) -> PolygonBatch:
    """A double pyramid whose rim stands upright in x and z and whose tips point along y."""
    points = [(radius, 0, 0), (0, 0, radius), (-radius, 0, 0), (0, 0, -radius),
              (0, -depth, 0), (0, depth, 0)]  # fmt: skip
    faces = [(k, (k + 1) % 4, 4) for k in range(4)] + [((k + 1) % 4, k, 5) for k in range(4)]
    return look.batch(np.array(points, float) + at, faces)


GAPS = (0.001, 0.005, 0.02, 0.05)
"""Between an edge and the wall behind it."""
PLACES = ((-0.68, 0.62), (0.68, 0.62), (-0.68, -0.62), (0.68, -0.62))
"""Of the objects before the wall, in x and z."""


def wall() -> Scene:
    """Plates that stand out of a wall."""
    camera = _camera((1.6, -6, 2.0), fov=30.0)
    plates = [(box((x - 0.4, -gap, z - 0.38), (x + 0.4, 0.1, z + 0.38)), camera)
              for gap, (x, z) in zip(GAPS, PLACES, strict=True)]  # fmt: skip
    return Scene(
        "wall",
        "lines lost into a wall close behind",
        "Plates 0.8 wide that stand 0.001, 0.005, 0.02 and 0.05 out of a wall. Left: the quads "
        "lean back into the wall, and half of each line is lost. Right: a line that is visible at "
        "its edge is drawn in its full width.",
        plates,
        lambda p: measure.gaps_along(p, 10, beside=True),
        behind=[(_wall(), camera)],
        ridge_width=10,
    )


def slabs() -> Scene:
    """Silhouettes of slabs before a wall."""
    camera = _camera((1.6, -6, 2.0), fov=30.0)
    boxes = [(box((x - 0.4, -gap - 0.25, z - 0.38), (x + 0.4, -gap, z + 0.38)), camera)
             for gap, (x, z) in zip(GAPS, PLACES, strict=True)]  # fmt: skip
    return Scene(
        "slabs", "slabs before a wall", "", boxes, lambda p: measure.gaps_around(p, 10),
        behind=[(_wall(), camera)], silhouette_width=10,
    )  # fmt: skip


def diamonds() -> Scene:
    """Silhouettes of diamonds half sunk into a wall."""
    camera = _camera((0.9, -6, 0.8), fov=30.0)
    stones = [(diamond((x, -gap, z), 0.52, 0.4), camera)
              for gap, (x, z) in zip(GAPS, PLACES, strict=True)]  # fmt: skip
    return Scene(
        "diamonds", "diamonds half sunk into a wall", "", stones,
        lambda p: measure.gaps_around(p, 10), behind=[(_wall(), camera)], silhouette_width=10,
    )  # fmt: skip


def sheets() -> Scene:
    """Outlines of single quads, their backs to the viewer, whose far sides come close to a wall."""
    camera = _camera((1.6, -6, 2.0), fov=30.0)
    quads = []
    for gap, (x, z) in zip(GAPS, PLACES, strict=True):
        corners = [(x - 0.4, -gap - 0.5, z - 0.38), (x - 0.4, -gap - 0.5, z + 0.38),
                   (x + 0.4, -gap, z + 0.38), (x + 0.4, -gap, z - 0.38)]  # fmt: skip
        quads.append((look.batch(corners, [[0, 1, 2, 3]]), camera))
    return Scene(
        "sheets", "sheets before a wall", "", quads, lambda p: measure.gaps_around(p, 10),
        behind=[(_wall(), camera)], silhouette_width=10,
    )  # fmt: skip


def before_wall(shape: str, gap: float, eye) -> Scene:
    """A "slab", a "ball" or a "can", a gap before a wall, with silhouettes of 10 px."""
    if shape == "slab":
        body = box((-0.5, -gap - 0.25, -0.4), (0.5, -gap, 0.4))
    else:
        made = look.sphere(24, 14, 0.4) if shape == "ball" else prism(24, 0.4, 0.4)
        body = look.batch(made.positions - (0, 0.4 + gap, 0), look.polygons_of(made))
    camera = _camera(eye, fov=18.0)
    return Scene(
        shape, shape, "", [(body, camera)], lambda p: measure.gaps_around(p, 10),
        behind=[(_wall(), camera)], silhouette_width=10,
    )  # fmt: skip


def _wall() -> PolygonBatch:
    return look.batch([(-4, 0, -4), (4, 0, -4), (4, 0, 4), (-4, 0, 4)], [[0, 1, 2, 3]])


def ball(direction=(3.3, -4, 2.2)) -> Scene:
    """A ball with silhouettes and ridges of 40 px, seen from a direction."""
    eye = 5.6 * np.asarray(direction) / np.linalg.norm(direction)
    return Scene(
        "ball", "a ball with wide lines", "", [(look.sphere(10, 7, 1.2), _camera(eye))],
        lambda p: measure.gaps_along(p, 40) + measure.gaps_around(p, 40),
        silhouette_width=40, ridge_width=40, ridge_angle=179,
    )  # fmt: skip


def cube(direction=(3.5, -4, 3)) -> Scene:
    """A cube with silhouettes and ridges of 40 px, seen from a direction."""
    eye = 6.1 * np.asarray(direction) / np.linalg.norm(direction)
    return Scene(
        "cube", "a cube with wide lines", "", [(look.cube(), _camera(eye, fov=36.0))],
        lambda p: measure.gaps_along(p, 40) + measure.gaps_at_corners(p, 40)
        + measure.gaps_around(p, 40),
        silhouette_width=40, ridge_width=40,
    )  # fmt: skip


def near() -> Scene:
    """A beam that begins behind the viewer and runs away from him."""
    camera = _camera((0.7, 0.0, 1.0), (0.25, 6.0, -0.4), fov=60.0, near=0.2)

    def uneven(picture: Picture) -> float:
        found = beam_widths(picture, 10.0)
        return float(np.maximum(np.abs(found - 10.0) - 0.75, 0).sum())

    return Scene(
        "near",
        "lines crossing the near plane",
        "A beam that begins behind the viewer. Left: a width divided by depth means nothing "
        "behind the viewer, and the lines flare. Right: edges are cut at the near plane first.",
        [(box((-0.3, -3, -0.2), (0.3, 14, 0.3)), camera)],
        uneven,
        silhouette_width=10,
        ridge_width=10,
    )


def beam_widths(picture: Picture, width: float) -> np.ndarray:
    """Pixels of ink across the long edges of the beam, as far as the window shows them."""
    batch, camera = picture.items[0]
    matrix = camera.projection @ camera.modelview
    lines = []
    low, high = batch.positions.min(axis=0), batch.positions.max(axis=0)
    for x, z in ((high[0], high[2]), (low[0], high[2]), (high[0], low[2])):
        t = np.linspace(0, 1, 4000)[:, None]
        points = np.array([x, low[1], z]) + t**2 * np.array([0, high[1] - low[1], 0])
        clip = np.c_[points, np.ones(len(points))] @ matrix.T
        clip = clip[clip[:, 2] > -clip[:, 3]]
        at = (clip[:, :3] / clip[:, 3:] + 1) / 2 * (SIZE, SIZE, 1)
        at = at[((at[:, :2] > 0) & (at[:, :2] < SIZE)).all(axis=1)]
        lines.append(at[[0, -1]])
    segments = np.array(lines)
    return np.concatenate([
        measure.widths(picture, segments[k : k + 1], width, np.delete(segments, k, axis=0))
        for k in range(3)
    ])  # fmt: skip


SCENES = (threshold, cracks, corners, thickness, wall, near)
"""In the order of the documents."""
FURTHER = (slabs, diamonds, sheets, ball, cube)
"""Measured only."""
