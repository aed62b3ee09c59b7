"""How far stroke patterns move from frame to frame on a turning object.

``python -m tests.coherence patterns`` turns the teapot and prints, for the paper's two
parameterisations (McGuire & Hughes 2004, section 4), for arc length along chains, and for arc
length that follows the frame before: the mean, over all points of visible contours, of the pixels
by which the pattern has moved against the nearest point of a contour in the frame before. Two
numbers: against where that was on the screen, and against where the turning surface has carried
it. A pattern that has nothing to do with the last one moves a quarter of its length.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from glshim.geometry.recovery.mesh import mesh
from glshim.geometry.window import window
from glshim.linework.coherence import Past
from glshim.linework.feature_lines import EdgeLines, feature_lines
from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.styling.wishes import Features, Pattern
from tests import look

LENGTH = 40.0
SIZE = 400
Strokes = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
"""(L, 2, 2) lines in the window, (L,) and (L,) repeats at both ends, (L,) whether they are seen."""


def cameras(frames: int, step: float) -> Iterator[Camera]:
    """The object turns about its axis by so many degrees a frame."""
    view = look.look_at((0, 2.0, 5.2), up=(0, 1, 0))
    for frame in range(frames):
        angle = np.radians(30.0 + step * frame)
        turn = np.eye(4)
        turn[0, 0] = turn[2, 2] = np.cos(angle)
        turn[0, 2], turn[2, 0] = np.sin(angle), -np.sin(angle)
        yield Camera(view @ turn, look.perspective(), (0, 0, SIZE, SIZE))


def seen(places: np.ndarray, batch: PolygonBatch, camera: Camera) -> np.ndarray:
    """(N,) whether nothing lies before places in the window (N, 3) and all the pixels about."""
    look.clear()
    look.draw_base(batch, camera)
    depth = look.depths(SIZE, SIZE)
    x, y = (np.clip(places[:, k].astype(int), 1, SIZE - 2) for k in (0, 1))
    around = [depth[y + j, x + i] for i in (-1, 0, 1) for j in (-1, 0, 1)]
    return np.max(around, axis=0) >= places[:, 2] - 1e-3


class Method:
    """Strokes of contours, frame by frame."""

    def __init__(self, batch: PolygonBatch, name: str, smooth: bool = False) -> None:
        pattern = Pattern((LENGTH,) * 8, 1.0)
        self.batch, self.lines, self.name = batch, EdgeLines(mesh(batch)), name
        self.wanted = Features(contours=True, smooth=smooth, pattern=pattern)
        self.past: Past | None = None

    def frame(self, camera: Camera) -> Strokes:
        past = self.past if self.name == "coherent" else None
        objects = [(self.lines, camera.modelview)]
        records, self.past = feature_lines(objects, camera, self.wanted, past)
        self.records = records
        places = [window(records[:, k : k + 3].astype(float), camera) for k in (0, 3)]
        ends = np.stack([place[:, :2] for place in places], axis=1)
        self.seen = seen((places[0] + places[1]) / 2, self.batch, camera)
        if self.name in ("arc length", "coherent"):
            return ends, records[:, 16], records[:, 17], self.seen
        return self.paper(ends, records, camera)

    def paper(self, ends: np.ndarray, records: np.ndarray, camera: Camera) -> Strokes:
        step = ends[:, 1] - ends[:, 0]
        if self.name == "object":
            # The edge's own number, whatever the view: of its ends in object space.
            back = np.linalg.inv(camera.modelview)
            places = [records[:, k : k + 3] @ back[:3, :3].T + back[:3, 3] for k in (0, 3)]
            middle = np.round((places[0] + places[1]) * 512)
            r = np.mod(np.sin(middle @ (12.9898, 78.233, 37.719)) * 43758.5453, 1.0)
            return ends, r, r + np.hypot(*step.T) / LENGTH, self.seen
        centre = window(camera.modelview[None, :3, 3], camera)[0, :2]
        axis = (np.abs(step[:, 1]) > np.abs(step[:, 0])).astype(int)
        u = (ends - centre)[np.arange(len(ends))[:, None], [0, 1], axis[:, None]] / LENGTH
        return ends, u[:, 0], u[:, 1], self.seen


def samples(strokes: Strokes) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """(N, 2) places every three pixels, (N,) repeats there, (N, 2) how these grow in a pixel."""
    ends, first, last, seen = strokes
    ends, first, last = ends[seen], first[seen], last[seen]
    size = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    counts = np.ceil(np.minimum(size, 400.0) / 3.0).astype(int)
    line = np.repeat(np.arange(len(ends)), counts)
    begin = np.repeat(np.cumsum(counts) - counts, counts)
    share = (np.arange(len(line)) - begin + 0.5) / counts[line]
    step = ends[line, 1] - ends[line, 0]
    phase = first[line] + share * (last - first)[line]
    slope = ((last - first)[line] / np.maximum((step**2).sum(axis=1), 1e-9))[:, None] * step
    return ends[line, 0] + share[:, None] * step, phase, slope


def moved(before: Strokes, now: Strokes) -> np.ndarray:
    """(N,) pixels by which the pattern moved, at points that had a line within 6 pixels."""
    (old, old_phase, slope), (new, phase, _) = samples(before), samples(now)
    found = []
    for start in range(0, len(new), 512):
        some = new[start : start + 512]
        away = ((some[:, None] - old[None]) ** 2).sum(axis=2)
        nearest = away.argmin(axis=1)
        near = away[np.arange(len(some)), nearest] < 36.0
        there = old_phase[nearest] + (slope[nearest] * (some - old[nearest])).sum(axis=1)
        apart = phase[start : start + 512] - there
        apart -= np.rint(apart)
        found.append(np.abs(apart[near]) * LENGTH)
    return np.concatenate(found)


def carried(strokes: Strokes, records: np.ndarray, before: Camera, now: Camera) -> Strokes:
    """Strokes as the turning object carries them on."""
    motion = now.modelview @ np.linalg.inv(before.modelview)
    ends = [records[:, k : k + 3] @ motion[:3, :3].T + motion[:3, 3] for k in (0, 3)]
    places = [window(end.astype(float), now)[:, :2] for end in ends]
    return np.stack(places, axis=1), *strokes[1:]


def mean_shift(method: Method, frames: int = 60, step: float = 2.0) -> tuple[float, float]:
    """Mean movement of the pattern, pixels a frame: against the screen, and against the surface."""
    shifts, last = [], None
    for camera in cameras(frames, step):
        now = method.frame(camera)
        if last is not None:
            before, records, old = last
            shifts.append((moved(before, now), moved(carried(before, records, old, camera), now)))
        last = now, method.records, camera
    return tuple(float(np.concatenate(found).mean()) for found in zip(*shifts, strict=True))


NAMES = ("object", "screen", "arc length", "coherent")


def main() -> int:
    batch = look.teapot()
    with look.window(SIZE, SIZE):
        report(batch)
    return 0


def report(batch: PolygonBatch) -> None:
    print(f"pattern of {LENGTH:g} px on contours of the teapot, turning; pixels a frame")
    print(f"{'':24}" + "".join(f"{step:>10g} deg" for step in (0.5, 1, 2, 4)))
    for smooth in (False, True):
        for name in NAMES:
            found = [mean_shift(Method(batch, name, smooth), step=step) for step in (0.5, 1, 2, 4)]
            label = f"{name}, smooth" if smooth else name
            print(f"{label:24}" + "".join(f"{a:7.2f}{b:7.2f}" for a, b in found))
