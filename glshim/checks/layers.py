"""Layers to try stylers on: small meshes, and what apps send now and then."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.styling.values import Layer

Doubles = NDArray[np.float64]
SIDE = 240
"""Pixels of the window."""


def batch(
    points: object, polygons: Sequence[Sequence[int]], key: object = None
) -> PolygonBatch:
    """Polygons as lists of numbers of points (V, 3), with flat normals and one colour."""
    places = np.asarray(points, np.float32).reshape(-1, 3)
    corners = np.array([corner for polygon in polygons for corner in polygon], np.int32)
    sizes = [len(polygon) for polygon in polygons]
    starts = np.cumsum([0, *sizes]).astype(np.int32)
    with np.errstate(all="ignore"):
        flat = [_normal(places[np.asarray(polygon)]) for polygon in polygons]
    normals = np.repeat(np.array(flat, np.float32).reshape(-1, 3), sizes, axis=0)
    regions = np.ones(len(polygons), np.uint32)
    boundary = np.ones(len(corners), bool)
    return PolygonBatch(places, corners, starts, boundary, key, regions, normals)


def _normal(corners: NDArray[np.float32]) -> NDArray[np.float32]:
    area = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0)
    return np.asarray(area / max(float(np.linalg.norm(area)), 1e-30))


def cube(half: float = 0.9) -> PolygonBatch:
    """Six quads that share corners."""
    points = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return batch(points, faces, "cube")


def torus(rings: int = 24, sides: int = 12) -> PolygonBatch:
    """Quads of a smooth closed surface, without a key, as immediate mode sends it."""
    u, v = np.meshgrid(
        2 * np.pi * np.arange(rings) / rings, 2 * np.pi * np.arange(sides) / sides, indexing="ij"
    )
    r = 1.0 + 0.4 * np.cos(v)
    points = np.stack([r * np.cos(u), r * np.sin(u), 0.4 * np.sin(v)], axis=2).reshape(-1, 3)
    quads = [
        (i * sides + j, (i + 1) % rings * sides + j,
         (i + 1) % rings * sides + (j + 1) % sides, i * sides + (j + 1) % sides)
        for i in range(rings) for j in range(sides)
    ]  # fmt: skip
    return batch(points, quads)


def open_surface() -> PolygonBatch:
    """Two triangles with open sides."""
    return batch([(-1, -1, 0), (1, -1, 0), (1, 1, 0.2), (-1, 1, 0.2)], [(0, 1, 2), (0, 2, 3)])


def nothing() -> PolygonBatch:
    """No polygon at all."""
    return batch(np.empty((0, 3)), [])


def degenerate() -> PolygonBatch:
    """A point, a needle, a repeated corner, corners that are no numbers or far away; and one
    triangle that is one."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (np.nan, 0, 1), (np.inf, 1, 0), (1e30, -1e30, 1e30)]
    polygons = [(0, 0, 0), (0, 1, 1), (0, 1, 0, 1), (0, 1, 3), (2, 4, 1), (0, 1, 5), (0, 1, 2)]
    return batch(points, polygons)


def camera(eye: Sequence[float] = (3.0, 2.0, 2.0), *, flat: bool = False) -> Camera:
    """From a place to the origin; flat: by a parallel projection."""
    back = np.asarray(eye, float) / np.linalg.norm(eye)
    right = np.cross((0.0, 0.0, 1.0), back)
    right /= np.linalg.norm(right)
    modelview = np.eye(4)
    modelview[:3, :3] = right, np.cross(back, right), back
    modelview[:3, 3] = -modelview[:3, :3] @ np.asarray(eye, float)
    return Camera(modelview, parallel() if flat else perspective(), (0, 0, SIDE, SIDE))


def perspective(scale: float = 1.8, near: float = 0.5, far: float = 20.0) -> Doubles:
    """(4, 4) eye to clip."""
    return np.array([
        [scale, 0, 0, 0], [0, scale, 0, 0],
        [0, 0, (near + far) / (near - far), 2 * near * far / (near - far)], [0, 0, -1, 0],
    ])  # fmt: skip


def parallel(half: float = 2.0, near: float = 0.5, far: float = 20.0) -> Doubles:
    """(4, 4) eye to clip."""
    return np.array([
        [1 / half, 0, 0, 0], [0, 1 / half, 0, 0],
        [0, 0, -2 / (far - near), -(far + near) / (far - near)], [0, 0, 0, 1.0],
    ])  # fmt: skip


def usual() -> Layer:
    """Two solids, one in another."""
    seen = camera()
    return Layer(((cube(), seen), (torus(), seen)))


def odd() -> dict[str, Layer]:
    """What apps send now and then, by what it is."""
    seen, mirrored = camera(), camera()
    mirrored = mirrored.under(mirrored.modelview @ np.diag([-1.0, 1.0, 1.0, 1.0]))
    broken = seen.under(np.full((4, 4), np.nan))
    return {
        "an empty layer": Layer(()),
        "a batch without polygons": Layer(((nothing(), seen),)),
        "degenerate polygons": Layer(((degenerate(), seen),)),
        "an open surface": Layer(((open_surface(), seen),)),
        "a parallel projection": Layer(((cube(), camera(flat=True)),)),
        "a mirrored scene": Layer(((cube(), mirrored),)),
        "a matrix that squashes everything": Layer(((cube(), seen.under(np.zeros((4, 4)))),)),
        "a matrix that is no number": Layer(((cube(), broken),)),
        "a layer over another": Layer(((cube(), seen),), over=True),
        "a layer that is partly over another": Layer(
            ((cube(), seen),), over=True, bare=((0, 0, 32, 200),)
        ),
        "a layer on another's depth": Layer(((cube(), seen),), over=True, fresh=False),
        "a light at a place": Layer(((cube(), seen),), light=(1.0, 2.0, 3.0, 1.0)),
    }
