"""How bodies move before the viewer, some pixels a frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from glshim.model.batch import Item
from tests.coherence.subjects import Frame

DEGREES = 1.5
PIXELS = 2.7
NEARER = 0.97


def _middle(frame: Frame) -> tuple[np.ndarray, float]:
    """The middle of what is drawn, and its size, eye space."""
    ends = []
    for batch, camera in frame:
        points = batch.positions[batch.corners] @ camera.modelview[:3, :3].T
        points = points + camera.modelview[:3, 3]
        ends += [points.min(axis=0), points.max(axis=0)]
    low, high = np.min(ends, axis=0), np.max(ends, axis=0)
    return (low + high) / 2, float(np.linalg.norm(high - low))


def _moved(items: Sequence[Item], motion: np.ndarray) -> Frame:
    cameras: dict[int, Item] = {}
    for _, camera in items:
        cameras.setdefault(id(camera), (None, camera.under(motion @ camera.modelview)))
    return tuple((batch, cameras[id(camera)][1]) for batch, camera in items)


def _about(middle: np.ndarray, axis: Sequence[float], degrees: float) -> np.ndarray:
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    k = np.array(((0, -z, y), (z, 0, -x), (-y, x, 0)))
    a = np.radians(degrees)
    found = np.eye(4)
    found[:3, :3] += np.sin(a) * k + (1 - np.cos(a)) * k @ k
    found[:3, 3] = middle - found[:3, :3] @ middle
    return found


def _aside(frame: Frame, middle: np.ndarray, pixels: np.ndarray) -> np.ndarray:
    """Moved in the window."""
    camera = frame[0][1].affine()
    w = abs(camera.projection[3, :3] @ middle + camera.projection[3, 3])
    found = np.eye(4)
    for k in (0, 1):
        found[k, 3] = 2 * pixels[k] * w / camera.viewport[2 + k] / camera.projection[k, k]
    return found


def turn(frames: Sequence[Frame], k: int) -> Frame:
    """All turns about an upright axis."""
    frame = frames[0]
    return _moved(frame, _about(_middle(frame)[0], (0.0, 1.0, 0.25), DEGREES * k))


def orbit(frames: Sequence[Frame], k: int) -> Frame:
    """The viewer goes over it and comes nearer."""
    frame = frames[0]
    middle = _middle(frame)[0]
    motion = _about(middle, (1.0, 0.35, 0.0), DEGREES * k)
    return _moved(frame, _dolly(frame, middle, 0.5 * k) @ motion)


def _dolly(frame: Frame, middle: np.ndarray, k: float) -> np.ndarray:
    camera = frame[0][1].affine()
    found = np.eye(4)
    if camera.orthographic:
        found[:3, :3] /= NEARER**k
        found[:3, 3] = middle - found[:3, :3] @ middle
    else:
        found[:3, 3] = (NEARER**k - 1.0) * middle
    return found


def dolly(frames: Sequence[Frame], k: int) -> Frame:
    """The viewer comes nearer."""
    frame = frames[0]
    return _moved(frame, _dolly(frame, _middle(frame)[0], k))


def pan(frames: Sequence[Frame], k: int) -> Frame:
    """The viewer moves aside."""
    frame = frames[0]
    way = k * PIXELS * np.array((0.9, 0.44))
    return _moved(frame, _aside(frame, _middle(frame)[0], way))


def apart(frames: Sequence[Frame], k: int) -> Frame:
    """One object, of the middle size, moves before the others."""
    frame = frames[0]
    bodies: dict[object, list[Item]] = {}
    for item in frame:
        bodies.setdefault(item[1].key, []).append(item)
    order = sorted(bodies, key=lambda key: _middle(tuple(bodies[key]))[1])
    chosen = order[len(order) // 2]
    own = tuple(bodies[chosen])
    motion = _aside(own, _middle(own)[0], k * PIXELS * np.array((0.9, 0.44)))
    moved = {id(batch): camera for batch, camera in _moved(own, motion)}
    return tuple((batch, moved.get(id(batch), camera) if camera.key == chosen else camera)
                 for batch, camera in frame)  # fmt: skip


def own(frames: Sequence[Frame], k: int) -> Frame:
    """The program's own frames."""
    return tuple((batch, replace(camera)) for batch, camera in frames[k])


MOTIONS: dict[str, Callable[[Sequence[Frame], int], Frame]] = {
    "turn": turn, "orbit": orbit, "dolly": dolly, "pan": pan, "apart": apart, "own": own,
}  # fmt: skip


def fits(name: str, frames: Sequence[Frame], count: int) -> bool:
    """Whether a subject can move so."""
    if name == "own":
        return len(frames) >= count
    if name == "apart":
        return len({camera.key for _, camera in frames[0]}) > 1
    return True
