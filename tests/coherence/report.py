"""How still each style is while its objects move.

Bodies of meshes and of bundled programs move by some pixels a frame; their matrices are known, so
every pixel of a frame is carried on to where its surface is in the next. Printed are, for each
style, means over motions and subjects:

* pops: of 1000 pixels of line, how many appear or vanish in a frame though nothing hides them;
* kept: of 100 pixels of line, how many are still in the same stroke;
* line drift: pixels a frame by which dashes and textures slide along their strokes;
* surface drift: pixels a frame by which the pattern of surfaces (dabs, hatching) slides over them;
* flicker: levels (of 255) by which pixels of surfaces differ from what is carried there.

`--motions` and `--subjects` print rows for each instead of means. `patterns` and `turning` are the
tables of docs/measurements/edge_mesh.md and fins.md.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from multiprocessing import get_context

import numpy as np

from glshim.linework.groups import grouped
from glshim.model.lights import Light, Lighting
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.fixed import FixedPen
from glshim.styling import registry
from glshim.styling.composite import is_line
from glshim.styling.fixed import BackFaces
from glshim.styling.lines import Lines
from glshim.styling.passes import Pass
from glshim.styling.protocol import Layer, Styler
from glshim.styling.texts import parse_style
from tests import look
from tests.coherence import carry, patterns, pixels, turning
from tests.coherence.carry import Carrier
from tests.coherence.motions import MOTIONS, fits
from tests.coherence.strokes import Kept, Samples, sampled
from tests.coherence.subjects import (
    HEIGHT,
    LIGHT,
    SHORT,
    SUBJECTS,
    WIDTH,
    Frame,
    colours,
    subject,
)

GREY = 0.5
BACKGROUND = 0.8
LIGHTING = Lighting((Light((*LIGHT, 0.0)),))
"""As the light that is painted on surfaces."""
SHORT_STYLES = (
    "none", "raskar", "edge_mesh", "crease", "hiddenline", "fins", "two_pass", "cartoon",
    "technical", "blueprint", "sketch", "brush", "pencil", "watercolour", "charcoal", "pen_and_ink",
    "edge_mesh:smooth=on,suggestive=on", "raskar:dash=16",
)  # fmt: skip


@dataclass
class Result:
    """Of one style, motion and subject, or of several."""

    lost: int = 0
    told: int = 0
    strokes: Kept = field(default_factory=Kept)
    drift: pixels.Drift = field(default_factory=pixels.Drift)
    flicker: list[float] = field(default_factory=list)

    def row(self) -> str:
        kept = self.strokes
        cells = (
            (1000.0 * self.lost / self.told if self.told > 50 else None, "{:.1f}"),
            (100.0 * kept.kept / kept.met if kept.met else None, "{:.1f}"),
            (kept.drift / kept.patterned if kept.patterned > 50 else None, "{:.2f}"),
            (self.drift.mean, "{:.2f}"),
            (float(np.mean(self.flicker)) if self.flicker else None, "{:.2f}"),
        )
        return " | ".join("–" if value is None else form.format(value) for value, form in cells)

    def add(self, other: Result) -> None:
        self.lost += other.lost
        self.told += other.told
        for name in ("met", "kept", "drift", "patterned"):
            value = getattr(self.strokes, name) + getattr(other.strokes, name)
            setattr(self.strokes, name, value)
        self.drift.pixels += other.drift.pixels
        self.drift.blocks += other.drift.blocks
        self.flicker += other.flicker


@dataclass(frozen=True)
class Shown:
    """A frame in a style."""

    frame: Frame
    depth: np.ndarray
    whole: np.ndarray
    """(H, W, 3)."""
    lines: np.ndarray
    """(H, W) where the ink of lines alone is."""
    surfaces: np.ndarray | None
    base: np.ndarray
    samples: Samples


class Studio:
    """Draws the frames of a subject in a style."""

    def __init__(self, style: Styler, frames: Sequence[Frame]) -> None:
        self.backend, self.fixed, self.style = Backend.attach(), FixedPen(), style
        self.shades = colours(frames[0])

    def shown(self, frame: Frame) -> Shown:
        style = self.style
        draws = list(style.draws(Layer(self._told(frame))))
        lines = [replace(draw, fill=None) if isinstance(draw, BackFaces) else draw
                 for draw in draws if is_line(draw)]  # fmt: skip
        others = [draw for draw in draws if not is_line(draw)]
        surface = style.surface
        base = self._drawn(frame, (), surface, BACKGROUND)
        whole = self._drawn(frame, draws, surface, BACKGROUND)
        depth = look.depths(WIDTH, HEIGHT)
        groups = [group for group in grouped(one for one in lines if isinstance(one, Lines))]
        finder = self.backend._finder
        samples = sampled([(group, finder.records(group)) for group in _once(groups)], depth)
        flat = self._drawn(frame, (), (GREY,) * 3, GREY)
        alone = self._drawn(frame, lines, (GREY,) * 3, GREY) if lines else flat
        ink = np.abs(alone.astype(float) - flat).max(axis=2) > pixels.INK
        surfaces = self._drawn(frame, others, surface, BACKGROUND) if others else None
        return Shown(frame, depth, whole, ink, surfaces, base, samples)

    def _told(self, frame: Frame) -> Frame:
        """What the style asks to be told of a frame."""
        cameras = {id(camera): camera for _, camera in frame}
        if self.style.wants_lights:
            cameras = {name: replace(camera, lit=True, lighting=LIGHTING)
                       for name, camera in cameras.items()}  # fmt: skip
        normals = {} if self.style.wants_normals else {"normals": None}
        return tuple((replace(batch, **normals), cameras[id(camera)]) for batch, camera in frame)

    def surfaces(self, frame: Frame, *, holds: bool = True) -> np.ndarray:
        """(H, W, 3) without lines; holds: whether passes know where surfaces lie on their objects.
        """
        draws = [draw for draw in self.style.draws(Layer(self._told(frame)))
                 if not is_line(draw)]  # fmt: skip
        kept = [draw for draw in draws
                if holds or not (isinstance(draw, Pass) and draw.element != "screen")]  # fmt: skip
        return self._drawn(frame, kept, self.style.surface, BACKGROUND)

    def _drawn(self, frame: Frame, draws: Sequence, surface: object, shade: float) -> np.ndarray:
        carry.clear(shade)
        carry.draw_base(frame, self.shades, surface)
        faces = [draw for draw in draws if isinstance(draw, BackFaces)]
        rest = [draw for draw in draws if not isinstance(draw, BackFaces)]
        if faces:
            self.fixed.render(faces)
        if rest:
            self.backend.render(rest)
        return look.pixels(WIDTH, HEIGHT)


def _once(groups: Sequence) -> Iterator:
    """Groups that differ in more than in their coats."""
    seen = set()
    for group in groups:
        if group.name not in seen:
            seen.add(group.name)
            yield group


def measured(
    style: Styler, motion: str, frames: Sequence[Frame], count: int, carrier: Carrier
) -> Result:
    """Of a style over one motion of a subject."""
    found = Result()
    studio = Studio(style, frames)  # a new one: what was drawn before a motion is forgotten
    before: Shown | None = None
    for k in range(count):
        now = studio.shown(MOTIONS[motion](frames, k))
        if before is not None:
            ahead = carrier.motion(before.frame, now.frame, now.depth)
            back = carrier.motion(now.frame, before.frame, before.depth)
            for pair in ((before, now, ahead), (now, before, back)):
                missed, told = pixels.lost(pair[0].lines, pair[1].lines, pair[2], pair[0].depth)
                found.lost, found.told = found.lost + missed, found.told + told
            found.strokes.add(before.samples, now.samples, ahead, before.depth)
            for one, other, carried in ((before, now, ahead), (now, before, back)):
                depths = one.depth, other.depth
                found.flicker.append(pixels.flicker((one.whole, other.whole), carried, depths))
            if k == 1 and now.surfaces is not None and before.surfaces is not None:
                found.drift.add(before.surfaces, now.surfaces, before.base, ahead)
        before = now
    return found


HEAD = "pops | kept | line drift | surface drift | flicker |\n|"


def main(given: list[str]) -> int:
    if given[:1] == ["patterns"]:
        return patterns.main()
    if given[:1] == ["turning"]:
        return turning.main(given[1:])
    parser = argparse.ArgumentParser(
        prog="python -m tests.coherence", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )  # fmt: skip
    parser.add_argument("--all", action="store_true", help="all styles, looks and subjects")
    parser.add_argument("--style", action="append", metavar="STYLE", help="only this one")
    parser.add_argument("--subject", action="append", choices=SUBJECTS, help="only this one")
    parser.add_argument("--motion", action="append", choices=MOTIONS, help="only this one")
    parser.add_argument("--motions", action="store_true", help="a row for each motion")
    parser.add_argument("--subjects", action="store_true", help="a row for each subject")
    parser.add_argument("--frames", type=int, default=4, metavar="N")
    args = parser.parse_args(given)
    every = [name for name in (*registry.names(), *registry.looks()) if name != "none"]
    styles = args.style or (every if args.all else SHORT_STYLES)
    names = args.subject or (tuple(SUBJECTS) if args.all else SHORT)
    motions = args.motion or tuple(MOTIONS)
    kept = [("style", True), ("motion", args.motions), ("subject", args.subjects)]
    labels = [label for label, wanted in kept if wanted]
    print("| " + " | ".join(labels) + " | " + HEAD + "---|" * len(labels) + "--:|" * 5, flush=True)
    made = {name: subject(name) for name in names}  # programs have windows of their own
    for text in styles:
        # A process each: contexts keep what was made in them.
        work = (text, made, tuple(motions), tuple(labels), args.frames)
        with get_context("spawn").Pool(1) as one:
            for row in one.apply(rows_of, work):
                print(row, flush=True)
    return 0


def rows_of(
    text: str, made: Mapping[str, Sequence[Frame]], motions: tuple[str, ...],
    labels: tuple[str, ...], count: int,
) -> list[str]:  # fmt: skip
    """The rows of a style."""
    rows: dict[tuple[str, ...], Result] = {}
    with look.window(WIDTH, HEIGHT):
        carrier = Carrier(WIDTH, HEIGHT)
        for name, motion in product(made, motions):
            if not fits(motion, made[name], count):
                continue
            found = measured(parse_style(text), motion, made[name], count, carrier)
            cells = {"style": f"`{text}`", "motion": motion, "subject": name}
            rows.setdefault(tuple(cells[label] for label in labels), Result()).add(found)
    return ["| " + " | ".join(key) + f" | {result.row()} |" for key, result in rows.items()]
