"""What is drawn: small meshes, and the bodies of bundled programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np

from glshim.model.batch import Item, PolygonBatch
from glshim.model.camera import Camera
from tests import look
from tests.coherence.record import recorded
from tests.score import meshes

ROOT = Path(__file__).parents[2]
WIDTH, HEIGHT = 400, 300
LIGHT = (-0.45, 0.65, 0.61)
"""Direction to the light, eye space of the first frame."""
Frame = tuple[Item, ...]
FRAMES = 5
"""Recorded of a program."""


def _placed(batch: PolygonBatch, x: float, y: float, z: float, turn: float) -> Item:
    c, s = np.cos(turn), np.sin(turn)
    place = np.eye(4)
    place[:2, :2] = (c, -s), (s, c)
    place[:3, 3] = x, y, z
    view = look.look_at((5.5, 3.5, 4.0), target=(0, 0, 0.4), up=(0, 0, 1))
    lens = look.perspective(aspect=WIDTH / HEIGHT)
    return batch, Camera(view @ place, lens, (0, 0, WIDTH, HEIGHT))


def solids() -> list[Frame]:
    """A torus, a cube, a cylinder and a ball on a floor."""
    floor = look.batch([(-3, -3, -0.01), (3, -3, -0.01), (3, 3, -0.01), (-3, 3, -0.01)],
                       [(0, 1, 2, 3)])  # fmt: skip
    placed = (
        (floor, 0.0, 0.0, -0.2, 0.0), (look.cube(0.7), 0.9, 1.1, 0.55, 0.5),
        (look.torus(48, 24, 0.9, 0.35), -0.3, -1.0, 0.25, 0.0),
        (look.cylinder(28, 0.5, 0.9), -1.4, 0.9, 0.75, 0.0),
        (look.sphere(28, 18, 0.6), 1.6, -0.7, 0.4, 0.2),
    )  # fmt: skip
    return [tuple(
        _placed(replace(batch, key=f"solid {k}"), *place)
        for k, (batch, *place) in enumerate(placed)
    )]  # fmt: skip


def scan() -> list[Frame]:
    """A smooth body of 20,000 triangles."""
    return [(_placed(replace(meshes.scan(), key="scan"), 0.0, 0.0, 0.5, 0.4),)]


def _program(name: str) -> Callable[[], list[Frame]]:
    def found() -> list[Frame]:
        frames = recorded(ROOT / "demo_apps" / f"{name}.py", FRAMES + 1)[1:]
        return [tuple((batch, _small(camera)) for batch, camera in frame) for frame in frames]

    return found


def _small(camera: Camera) -> Camera:
    """The same view in a small window."""
    x, y, width, height = camera.viewport
    share = min(WIDTH / max(x + width, 1), HEIGHT / max(y + height, 1))
    port = tuple(round(share * side) for side in camera.viewport)
    return replace(camera, viewport=port, scissor=None, stencil=None)


SUBJECTS: dict[str, Callable[[], list[Frame]]] = {
    "solids": solids,
    "08_figure": _program("08_figure"),
    "03_robot_arm": _program("03_robot_arm"),
    "07_cad_part": _program("07_cad_part"),
    "scan": scan,
    "01_gears": _program("01_gears"),
    "cloth": _program("cloth"),
}
SHORT = ("solids", "08_figure")


@cache
def subject(name: str) -> tuple[Frame, ...]:
    """The frames of a subject: one, or a program's own."""
    return tuple(SUBJECTS[name]())


def triangles(batch: PolygonBatch) -> np.ndarray:
    """(T, 3) corners, as fans."""
    from glshim.model.polygons import fans

    return fans(batch.starts).corners


def colours(frame: Sequence[Item]) -> list[np.ndarray]:
    """For each batch (C, 3) colours of its corners: a hue of its own under a light that the surface
    keeps, so that a picture of them is carried along to the bit."""
    found = []
    for k, (batch, camera) in enumerate(frame):
        hue = np.array([0.55 + 0.4 * np.cos(2.4 * k + turn) for turn in (0.0, 2.1, 4.2)])
        points = batch.positions[batch.corners].astype(float)
        if batch.normals is not None and batch.normals.any():
            normals = batch.normals.astype(float)
        else:
            normals = np.zeros_like(points)
            at = triangles(batch)
            a, b, c = (points[at[:, i]] for i in range(3))
            np.add.at(normals, at.ravel(), np.repeat(np.cross(b - a, c - a), 3, axis=0))
        normals = normals @ camera.normal_matrix.T
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-12)[:, None]
        light = 0.5 + 0.5 * normals @ np.array(LIGHT)
        found.append(np.clip(hue * (0.25 + 0.75 * light[:, None]), 0.0, 1.0))
    return found
