"""Models made ready to be drawn: smooth normals, indexed vertices, one size. Plain numpy."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..shapes import Floats, Ints, polygon_normals, smooth, unit
from .models import Model, Part

CREASE = 35.0  # degrees by which polygons turn at most where a surface is smooth
Progress = Callable[[str, float], None]


@dataclass(frozen=True, slots=True)
class Surface:
    """Vertices (v, ...) and polygons (m, corners) that index them."""

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    polygons: tuple[NDArray[np.uint32], ...]
    colours: NDArray[np.float32] | None = None
    places: NDArray[np.float32] | None = None  # in the picture
    picture: NDArray[np.uint8] | None = None


@dataclass(frozen=True, slots=True)
class Ready:
    """A model that fills the sphere of radius 1."""

    surfaces: tuple[Surface, ...]
    triangles: int
    size: tuple[float, float, float]  # of its box, in the file's units


def prepared(model: Model, progress: Progress = lambda phase, share: None) -> Ready:
    """Centred, scaled, with normals."""
    points = [part.mesh.points for part in model]
    low = np.min([p.min(axis=0) for p in points], axis=0)
    high = np.max([p.max(axis=0) for p in points], axis=0)
    centre = (low + high) / 2
    radius = max(*(np.linalg.norm(p - centre, axis=1).max() for p in points), 1e-300)
    surfaces = []
    for done, part in enumerate(model):
        begin, step = done / len(model), 1 / len(model)
        surfaces.append(surface(part, centre, radius, lambda share, begin=begin, step=step:
                                progress("preparing", begin + step * share)))
    triangles = sum(len(p) * (p.shape[1] - 2) for part in model for p in part.mesh.polygons)
    return Ready(tuple(surfaces), triangles, tuple((high - low).tolist()))


def surface(part: Part, centre: Floats, radius: float,
            progress: Callable[[float], None]) -> Surface:
    """Corners share a vertex where all polygons around their point are smooth with each other; at
    the others each corner has one of its own."""
    mesh = part.mesh
    points = (mesh.points - centre) / radius
    flat = [areas(points, polygons) for polygons in mesh.polygons]
    progress(0.2)
    weights = np.concatenate([np.repeat(n, p.shape[1], 0)
                              for n, p in zip(flat, mesh.polygons, strict=True)])
    numbers = np.concatenate([p.ravel() for p in mesh.polygons])
    spot = welded(points.astype(np.float32))
    progress(0.4)
    place = spot[numbers]
    sums = np.stack([np.bincount(place, weights[:, i], spot.max() + 1) for i in range(3)], axis=1)
    mean = unit(sums)
    # Those that all lie within half the angle of their mean lie within the angle of each other.
    near = np.einsum("ij,ij->i", mean[place], unit(weights)) >= np.cos(np.radians(CREASE / 2))
    progress(0.6)
    folded = np.zeros(len(mean), bool)
    folded[place[~near]] = True
    own = folded[place]
    progress(0.7)
    apart = smooth(place[own], weights[own], CREASE) if own.any() else np.empty((0, 3))
    rows = np.concatenate([np.arange(len(points)), numbers[own]])  # the point of each vertex
    index = numbers.copy()
    index[own] = len(points) + np.arange(own.sum())
    ends = np.cumsum([p.size for p in mesh.polygons])[:-1]
    polygons = tuple(part.reshape(p.shape).astype(np.uint32)
                     for part, p in zip(np.split(index, ends), mesh.polygons, strict=True))
    progress(1.0)
    return Surface(points[rows].astype(np.float32),
                   np.concatenate([mean[spot], apart]).astype(np.float32), polygons,
                   taken(mesh.colours, rows), taken(part.places, rows), part.picture)


def areas(points: Floats, polygons: Ints) -> Floats:
    """Normals (m, 3) of polygons, as long as twice their areas."""
    if polygons.shape[1] != 3:
        return polygon_normals(points[polygons])
    a, b, c = (points[polygons[:, i]] for i in range(3))
    return np.cross(b - a, c - a)


def taken(values: Floats | None, rows: Ints) -> NDArray[np.float32] | None:
    return None if values is None else np.asarray(values)[rows].astype(np.float32)


def welded(points: NDArray[np.float32]) -> Ints:
    """The number of the place of each point (n, 3): the same for the same three numbers."""
    bits = np.ascontiguousarray(points + np.float32(0.0)).view(np.uint32).astype(np.uint64)
    key = np.zeros(len(points), np.uint64)
    for column in bits.T:  # odd multipliers mix three words into one of 64 bits
        key = (key ^ column) * np.uint64(0x9E3779B97F4A7C15)
        key ^= key >> np.uint64(29)
    return np.unique(key, return_inverse=True)[1].ravel()
