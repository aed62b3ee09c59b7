"""The two ways to animate a mesh of McGuire and Hughes 2004, 3.6, as the demos do them on the CPU:
key frames (`figure`) and bones (`bending_arm`). No window: only the meshes at a time."""

import importlib
from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from demo_apps import bending_arm
from glshim.linework.intersections import neighbours, segments
from tests.sweep import some

figure = importlib.import_module("demo_apps.08_figure")

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

CYCLE = len(figure.STEPS) / figure.PACE  # seconds
MODEL, ARM = figure.Model(), bending_arm.Arm()
MOVING: dict[str, tuple[Indices, Callable[[float], tuple[Floats, Floats]], Floats]] = {
    "figure": (MODEL.triangles, MODEL.at, np.arange(0.0, CYCLE, CYCLE / 24)),
    "bending_arm": (ARM.triangles, ARM.skinned, np.arange(0.0, 30.0, 0.7)),
}
animated = pytest.mark.parametrize("name", MOVING)


def crossing(corners: Floats) -> int:
    """In how many places triangles (T, 3, 3) pass through each other."""
    low, high = corners.min(axis=1), corners.max(axis=1)
    near = np.triu((low[:, None] <= high).all(axis=2) & (low <= high[:, None]).all(axis=2), 1)
    ends, _ = segments(corners, neighbours(corners.astype(np.float32)), np.argwhere(near))
    return len(ends)


def volume(corners: Floats) -> float:
    a, b, c = corners.transpose(1, 0, 2)
    return float((a * np.cross(b, c)).sum() / 6)


@animated
def test_it_is_one_closed_skin_wound_counter_clockwise(name: str) -> None:
    triangles, at, times = MOVING[name]
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 2)
    directed = {(a, b) for a, b in sides.tolist()}
    assert len(directed) == len(sides)
    assert all((b, a) in directed for a, b in directed)
    assert np.array_equal(np.unique(triangles), np.arange(len(at(0.0)[0])))
    volumes = [volume(at(float(time))[0][triangles]) for time in times]
    assert min(volumes) > 0.9 * max(volumes) > 0


@animated
def test_it_never_passes_through_itself(name: str) -> None:
    triangles, at, times = MOVING[name]
    poses = some(times.tolist(), 13)
    assert [crossing(at(time)[0][triangles]) for time in poses] == [0] * len(poses)
    rest = at(0.0)[0][triangles]
    assert crossing(np.concatenate([rest, rest + 0.05])) > 100


@animated
def test_normals_go_with_the_skin(name: str) -> None:
    """They are not made anew each frame, yet stay near those of the moved mesh."""
    triangles, at, times = MOVING[name]
    for time in times:
        points, normals = at(float(time))
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        true = bending_arm.normals_of(points, triangles)
        assert np.median((normals * true).sum(axis=1)) > 0.99


def test_the_figures_vertices_go_straight_from_key_frame_to_key_frame() -> None:
    for key in range(2 * len(figure.STEPS)):
        start, middle, end = (MODEL.at((key + part) / figure.PACE)[0] for part in (0, 0.25, 1))
        assert np.allclose(start, MODEL.positions[key % len(figure.STEPS)])
        assert np.allclose(middle, 0.75 * start + 0.25 * end)
        assert np.abs(end - start).max() > 0.1
        assert start[:, 1].min() == 0.0  # it stands on the floor


def test_each_vertex_of_the_arm_follows_at_most_four_bones() -> None:
    assert ARM.bones.shape == ARM.weights.shape == (len(ARM.points), 4)
    assert np.allclose(ARM.weights.sum(axis=1), 1.0)
    assert (ARM.weights >= 0).all()
    used = (ARM.weights > 1e-9).sum(axis=1)
    assert set(used) == {1, 2, 3, 4}
    assert set(ARM.bones[ARM.weights > 1e-9]) == set(range(len(bending_arm.pose(0.0))))


def test_the_arm_bends_and_does_not_stretch_along_a_bone() -> None:
    rigid = ARM.weights[:, 0] > 1 - 1e-9
    for bone in range(len(bending_arm.pose(0.0))):
        own = rigid & (ARM.bones[:, 0] == bone)
        assert own.sum() > 8
        rest, moved = ARM.points[own], ARM.skinned(3.0)[0][own]
        lengths = [np.linalg.norm(p[:, None] - p, axis=2) for p in (rest, moved)]
        assert np.allclose(*lengths)
        assert not np.allclose(rest, moved, atol=0.1)
