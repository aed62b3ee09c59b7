"""Real frames of a mesh with lines, judged view by view."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from OpenGL import GL

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look
from tests.score import smooth, truth
from tests.score.ink import Verdict, inked, judge
from tests.score.sight import BESIDE, SURE, UNSURE, Places, Scene, places
from tests.score.subjects import SUBJECTS

SIZE = 480

@dataclass(frozen=True)
class View:
    """One mesh under one camera: pictures (SIZE, SIZE, 3), row 0 at the bottom."""

    number: int
    camera: Camera
    before: np.ndarray
    after: dict[str, np.ndarray]
    """By kind alone, and "all"."""
    places: dict[str, Places]
    verdicts: dict[str, Verdict]


@dataclass
class Tally:
    """Verdicts of many views added up."""

    ink: int = 0
    right: int = 0
    sure: int = 0
    found: int = 0
    close: int = 0
    unsure: int = 0
    beside: int = 0
    dots: list[tuple[int, int, int]] = field(default_factory=list)
    """View, column, row."""
    worst: float = 2.0
    worst_view: int = -1

    def add(self, view: int, verdict: Verdict) -> None:
        for name in ("ink", "right", "sure", "found", "close", "unsure", "beside"):
            setattr(self, name, getattr(self, name) + getattr(verdict, name))
        self.dots += [(view, x, y) for x, y in verdict.dots]
        least = min(verdict.precision, verdict.recall)
        if least < self.worst:
            self.worst, self.worst_view = least, view

    @property
    def precision(self) -> float:
        return self.right / self.ink if self.ink else 1.0

    @property
    def recall(self) -> float:
        return self.found / self.sure if self.sure else 1.0

    @property
    def close_recall(self) -> float:
        return self.close / self.sure if self.sure else 1.0

    @property
    def unsure_share(self) -> float:
        """Of the places that are seen, those that may go without ink."""
        return self.unsure / max(self.unsure + self.sure, 1)

    @property
    def beside_share(self) -> float:
        """Places that are hidden but may have ink, over those that are seen."""
        return self.beside / max(self.unsure + self.sure, 1)

    def passes(self, limit: float) -> bool:
        return self.precision >= limit and self.recall >= limit and not self.dots


def camera_path(count=24) -> list[Camera]:
    """Around the mesh from all sides, in turns orthographic and in perspective."""
    return [
        Camera(
            look.look_at(5 * direction),
            look.perspective() if k % 2 else look.orthographic(1.75),
            (0, 0, SIZE, SIZE),
        )
        for k, direction in enumerate(look.directions(count))
    ]


def visible(mesh: truth.Body, camera: Camera, kinds: Iterable[str]) -> dict[str, Places]:
    """The places along the lines of some kinds."""
    scene = Scene(mesh, camera)
    found = truth.lines(mesh, camera) | smooth.lines(mesh, camera)
    return {kind: places(scene, found[kind]) for kind in kinds}


def look_at_views(
    backend: Backend, batch: PolygonBatch, count=24, *, width=None, only=None, name="raskar"
) -> Iterator[View]:
    """Views of a mesh, drawn and judged; a window of SIZE is current. only: view numbers.
    name: of the style."""
    subject = SUBJECTS[name]
    kinds_drawn = tuple(subject.switches)
    if subject.welds:
        batch = replace(batch, positions=batch.positions[truth.weld(batch.positions)])
    mesh = truth.body(batch)
    for number, camera in enumerate(camera_path(count)):
        if only is not None and number not in only:
            continue
        true = visible(mesh, camera, kinds_drawn)
        look.clear()
        look.draw_base(batch, camera)
        before = look.pixels(SIZE, SIZE)
        after, verdicts = {}, {}
        alone = [(kind, (kind,)) for kind in kinds_drawn]
        together = [("all", kinds_drawn)] if len(alone) > 1 else []
        for what, kinds in alone + together:
            chosen = subject.style(kinds, width)
            look.clear()
            look.draw_base(batch, camera)
            backend.render(chosen.draws(Layer(((batch, camera),))))
            GL.glFinish()
            after[what] = look.pixels(SIZE, SIZE)
            widths = [(true[kind], subject.reaches(chosen, kind)) for kind in kinds]
            verdicts[what] = judge(inked(before, after[what]), widths)
        yield View(number, camera, before, after, true, verdicts)


COLOURS = {
    "silhouettes": (20, 20, 20),
    "ridges": (20, 60, 220),
    "valleys": (220, 40, 30),
    "intersections": (20, 160, 40),
    "creases": (150, 60, 200),
    "smooth": (240, 150, 20),
}


def truth_picture(view: View) -> np.ndarray:
    """The truth over the mesh: each kind in its colour, pale where it is not SURE; row 0 on top."""
    picture = view.before.copy()
    for kind, true in view.places.items():
        for seen in (BESIDE, UNSURE, SURE):
            at = np.floor(true.points[true.sight == seen, :2]).astype(int)
            colour = np.array(COLOURS[kind])
            picture[at[:, 1], at[:, 0]] = colour if seen == SURE else (colour + 2 * 230) // 3
    return picture[::-1]


def error_picture(view: View, name: str) -> np.ndarray:
    """Right ink dark, stray ink red, missed truth blue, dots circled in magenta; row 0 on top."""
    verdict = view.verdicts[name]
    picture = 255 - (255 - view.before) // 3
    ink = inked(view.before, view.after[name])
    picture[ink] = (70, 70, 70)
    picture[verdict.stray_at] = (255, 0, 0)
    at = np.floor(verdict.missed_at).astype(int)
    picture[at[:, 1], at[:, 0]] = (0, 60, 255)
    turns = np.linspace(0, 2 * np.pi, 40)
    for x, y in verdict.dots:
        ring = np.stack([x + 6 * np.cos(turns), y + 6 * np.sin(turns)], axis=1).round().astype(int)
        ring = np.clip(ring, 0, SIZE - 1)
        picture[ring[:, 1], ring[:, 0]] = (255, 0, 255)
    return picture[::-1]
