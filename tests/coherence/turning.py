"""How much lines flicker while an object turns slowly: ``python -m tests.coherence turning``.

Each style draws the same frames, a quarter of a degree apart, lines alone on white, silhouettes
and open edges of the same width. With I(t) the share of a pixel that ink covers in frame t:

* flicker: the sum over pixels and frames of |I(t-1) - 2 I(t) + I(t+1)|, over that of I(t). A line
  that moves steadily adds little; one that jumps, pops up or goes adds all of its ink;
* blinks: pixels a frame with ink in t, where neither t-1 nor t+1 has any within a pixel around.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from glshim_stylers.crease import Crease
from glshim_stylers.edge_mesh import EdgeMesh
from glshim_stylers.fins import Fins
from glshim_stylers.raskar import Raskar
from OpenGL import GL
from PIL import Image

from glshim.model.batch import PolygonBatch
from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer, Styler
from tests import look
from tests.score import meshes, truth

SIZE, WIDTH, STEP = 400, 3.0, 0.25
FRAMES = 80
INK = 0.1
"""Share of a pixel that counts as ink for blinks."""
_CONTOURS = {"ridges": False, "valleys": False}
_EDGE_MESH = EdgeMesh(**_CONTOURS, contour_width=WIDTH, boundary_width=WIDTH)
STYLES: dict[str, Styler] = {
    "raskar": Raskar(**_CONTOURS, silhouette_width=WIDTH),
    "edge_mesh": _EDGE_MESH,
    "edge_mesh, quads": replace(_EDGE_MESH, strokes="quads"),
    "crease": Crease(creases=False, silhouette_width=WIDTH),
    "fins": Fins(half_width=WIDTH / 2 + 0.5),  # the rim fades over a pixel, half of it outside
}
BASIS = "edge_mesh"
"""The style that others are held to."""


def lathe(columns: int = 48) -> PolygonBatch:
    """A chess piece: a profile of foot, shaft, collar and head, turned about the z axis."""
    foot = [(0.62, -1.3), (0.62, -1.14), (0.5, -1.08), (0.5, -0.98), (0.4, -0.9), (0.28, -0.7)]
    shaft = [(0.2, -0.4), (0.17, -0.05), (0.17, 0.2), (0.21, 0.3)]
    collar = [(0.36, 0.38), (0.36, 0.44), (0.22, 0.5)]
    head = [(0.2, 0.56), (0.3, 0.75), (0.36, 0.95), (0.34, 1.08), (0.22, 1.16), (0.08, 1.2)]
    profile = foot + shaft + collar + head
    rings = [[(r * np.cos(a), r * np.sin(a), z) for a in 2 * np.pi * np.arange(columns) / columns]
             for r, z in profile]  # fmt: skip
    quads = [[i * columns + j, i * columns + (j + 1) % columns,
              (i + 1) * columns + (j + 1) % columns, (i + 1) * columns + j]
             for i in range(len(profile) - 1) for j in range(columns)]  # fmt: skip
    top = (len(profile) - 1) * columns
    ends = [list(range(columns))[::-1], [top + j for j in range(columns)]]
    return look.batch(np.concatenate(rings), quads + ends)


def teapot() -> PolygonBatch:
    """GLUT's on its foot, its patches made to meet to the bit."""
    pot = meshes.teapot()
    upright = pot.positions[:, (0, 2, 1)] * np.array((1, -1, 1), np.float32)
    return replace(pot, positions=upright[truth.weld(pot.positions)])


MESHES: dict[str, Callable[[], PolygonBatch]] = {
    "torus": lambda: look.torus(48, 24),
    "teapot": teapot,
    "scan": meshes.scan,
    "lathe": lathe,
}


@dataclass(frozen=True)
class Flicker:
    """Of one turn."""

    flicker: float
    blinks: float
    ink: float
    """Pixels a frame."""


def cameras(frames: int, step: float = STEP) -> Iterator[Camera]:
    """The object turns about the z axis by step degrees a frame, seen from a little above."""
    view = look.look_at((4.2, 1.0, 2.2), up=(0, 0, 1))
    for frame in range(frames):
        a = np.radians(33.0 + step * frame)
        turn = np.eye(4)
        turn[:2, :2] = (np.cos(a), -np.sin(a)), (np.sin(a), np.cos(a))
        yield Camera(view @ turn, look.perspective(), (0, 0, SIZE, SIZE))


def inks(
    backend: Backend, style: Styler, batch: PolygonBatch, views: Sequence[Camera]
) -> Iterator[np.ndarray]:
    """(SIZE, SIZE) shares of black ink, frame by frame; a window of SIZE is current."""
    for camera in views:
        look.clear()
        look.draw_base(batch, camera, shade=(1.0, 1.0, 1.0))
        backend.render(style.draws(Layer(((batch, camera),))))
        GL.glFinish()
        yield 1.0 - look.pixels(SIZE, SIZE)[..., 0] / 255.0


def measured(frames: Iterator[np.ndarray]) -> Flicker:
    """What changes from frame to frame and back."""
    before, now = next(frames), next(frames)
    apart = ink = 0.0
    blinks = count = 0
    for after in frames:
        apart += float(np.abs(before - 2.0 * now + after).sum())
        ink += float(now.sum())
        around = _widened(np.maximum(before, after) >= INK)
        blinks += int(((now >= INK) & ~around).sum())
        before, now, count = now, after, count + 1
    return Flicker(apart / max(ink, 1.0), blinks / count, ink / count)


def _widened(mask: np.ndarray) -> np.ndarray:
    """(h, w) bool: within a pixel of the mask, corners too."""
    height, width = mask.shape
    wide = np.pad(mask, 1)
    return np.any([wide[i : i + height, j : j + width] for i in range(3) for j in range(3)], axis=0)


def table(
    made: dict[str, PolygonBatch], frames: int, step: float, out: Path | None
) -> dict[str, dict[str, Flicker]]:
    """By mesh and style, printed as it is found."""
    print("| mesh | style | flicker | over edge_mesh | blinks a frame | ink, px a frame |")
    print("|---|---|--:|--:|--:|--:|")
    found: dict[str, dict[str, Flicker]] = {}
    with look.window(SIZE, SIZE):
        backend = Backend.attach()
        for mesh, given in made.items():
            batch = replace(given, key=mesh)
            views = list(cameras(frames, step))
            rows = found[mesh] = {}
            for name, style in STYLES.items():
                rows[name] = measured(kept(inks(backend, style, batch, views), out, mesh, name))
            for name, row in rows.items():
                print(f"| {mesh} | {name} | {row.flicker:.4f} "
                      f"| {row.flicker / rows[BASIS].flicker:.2f} | {row.blinks:.2f} "
                      f"| {row.ink:.0f} |", flush=True)  # fmt: skip
    return found


def kept(
    frames: Iterator[np.ndarray], out: Path | None, mesh: str, name: str
) -> Iterator[np.ndarray]:
    """The same frames; pictures of them in a folder."""
    for number, ink in enumerate(frames):
        if out is not None:
            out.mkdir(parents=True, exist_ok=True)
            picture = np.rint(255.0 * (1.0 - ink[::-1])).astype(np.uint8)
            file = f"{mesh}-{name.replace(', ', '_')}-{number:03d}.png"
            Image.fromarray(picture).save(out / file)
        yield ink


def main(given: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.coherence turning", description=__doc__)
    parser.add_argument("--frames", type=int, default=FRAMES, metavar="N")
    parser.add_argument("--step", type=float, default=STEP, metavar="DEGREES")
    parser.add_argument("--only", action="append", choices=MESHES)
    parser.add_argument("--out", type=Path, metavar="DIR", help="every frame as a picture")
    parser.add_argument("--check", action="store_true",
                        help=f"exit status 1 where fins or creases flicker more than {BASIS}")
    args = parser.parse_args(given)
    made = {name: MESHES[name]() for name in args.only or MESHES}  # GLUT has a window of its own
    found = table(made, args.frames, args.step, args.out)
    worse = [(mesh, name) for mesh, rows in found.items() for name, row in rows.items()
             if name.startswith(("fins", "crease")) and row.flicker > rows[BASIS].flicker]
    for mesh, name in worse:
        print(f"{mesh}: {name} flickers more than {BASIS}")
    return int(args.check and bool(worse))
