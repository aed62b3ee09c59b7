"""`python -m tests.benchmarks.edge_mesh`: what the paper's lines cost over the mesh alone, and the
memory of the edge mesh over the input mesh's, beside the paper's own numbers.

McGuire & Hughes 2004, section 5: 100,000 polygons, 250 fps for the mesh alone, 36 with contour
lines, 5 with quads and caps. Section 3.1: the edge mesh is 9 times the input mesh, at 16 bits. Each
run is a process of its own; the modes take turns, and ratios are medians over the rounds.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace
from statistics import median
from typing import ClassVar

from glshim_stylers.edge_mesh.paper import PaperLook, paper_passes

from glshim.running.headless import virtual_screen
from glshim.styling.passes import Pass
from glshim.styling.protocol import Layer, Styler

SCENE = "display list, 100k polygons"
CONTOURS = (True, False, False, False, False)
THIN = PaperLook(drawn=CONTOURS)
QUADS = PaperLook(strokes="quads", drawn=CONTOURS)
LOOKS: dict[str, PaperLook | None] = {
    "mesh alone": None,
    "thin contours": THIN,
    "contours as quads and caps": QUADS,
    "thin, every kind": PaperLook(),
    "quads and caps, every kind": PaperLook(strokes="quads"),
    "thin contours, hidden ones dashed": replace(THIN, hidden="dashed"),
    "outer quads with round ends": replace(QUADS, caps="round", outer=True),
}
PAPER = {"thin contours": 250 / 36, "contours as quads and caps": 250 / 5}
TARGETS = {"thin contours": 1.5, "contours as quads and caps": 3.0}
INPUT_VERTEX = 52
"""Bytes of a vertex of the input mesh as the paper counts them: colour, position, normal, two
texture coordinates, in 32 bits."""


@dataclass(frozen=True)
class Paper(Styler):
    """The passes alone, without a style's options."""

    name: ClassVar[str] = "paper"
    look: PaperLook = THIN
    sieved: bool = True

    def draws(self, layer: Layer) -> Iterable[Pass]:
        for one in paper_passes(self.look, layer):
            yield one if self.sieved else replace(one, sieve=None)


def child(mode: str, seconds: float, sieved: bool) -> None:
    """Times one mode in this process."""
    import glshim
    from tests.benchmarks import scenes

    look = LOOKS[mode]
    if look is not None:
        glshim.install(Paper(look, sieved))
    print(json.dumps(scenes.timed(SCENE, seconds)))


def run(mode: str, seconds: float, sieved: bool, screen: dict[str, str]) -> float:
    """The middle of a mode's frame times, in seconds."""
    command = [sys.executable, "-m", "tests.benchmarks.edge_mesh", "--child", mode,
               "--seconds", str(seconds), *([] if sieved else ["--no-sieve"])]  # fmt: skip
    done = subprocess.run(command, env=os.environ | screen, capture_output=True, text=True,
                          check=False)  # fmt: skip
    if done.returncode or "glshim:" in done.stderr:
        raise SystemExit(f"{mode}: {done.stderr.strip()}")
    return float(median(json.loads(done.stdout.splitlines()[-1])["frames"]))


def print_memory() -> None:
    """Bytes of the textures that the passes read, over those of the input mesh."""
    from glshim.outputs.gl.device.guard import Guard
    from tests import look
    from tests.benchmarks import scenes
    from tests.captured import CapturingRunner
    from tests.score import meshes

    quads = scenes.sphere(100_000)[:, :, 3:].reshape(-1, 3)
    made = {
        "sphere, 100k quads": look.batch(quads, _fours(len(quads))),
        "scan, 20k triangles": meshes.scan(),
        "teapot": meshes.teapot(),
    }
    print("| mesh | vertices | edges | input mesh | edge mesh | of that edges | ratio | paper |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    with look.window():
        run_ = CapturingRunner()
        for name, batch in made.items():
            with Guard():
                resident = run_.residents.find((batch,))
                run_.residents.release()
            vertices, edges = len(resident.mesh.positions), len(resident.edges.rows)
            texels = 24 * vertices + 16 * edges  # without the triangles, which lines do not read
            whole = INPUT_VERTEX * vertices
            print(f"| {name} | {vertices:,} | {edges:,} | {whole:,} | {texels:,} | {16 * edges:,} "
                  f"| {texels / whole:.2f} | {4 * 37 * edges / whole:.1f} |")  # fmt: skip


def _fours(count: int) -> list[list[int]]:
    return [[i, i + 1, i + 2, i + 3] for i in range(0, count, 4)]


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.edge_mesh",
                                     description=__doc__)  # fmt: skip
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1.0, help="frames' time in one run")
    parser.add_argument("--no-sieve", action="store_true",
                        help="the GPU decides over every edge, as the paper's does")  # fmt: skip
    parser.add_argument("--child", choices=LOOKS, help=argparse.SUPPRESS)
    parser.add_argument("--check", action="store_true", help="exit status 1 on a missed target")
    choice = parser.parse_args()
    if choice.child:
        child(choice.child, choice.seconds, not choice.no_sieve)
        return 0
    with virtual_screen() as screen:
        times: dict[str, list[float]] = {mode: [] for mode in LOOKS}
        for _ in range(choice.rounds):
            for mode, found in times.items():
                found.append(run(mode, choice.seconds, not choice.no_sieve, screen))
        print("| lines | ms a frame | of the mesh alone | target | the paper |")
        print("|---|--:|--:|--:|--:|")
        missed = 0
        for mode, found in times.items():
            ratio = median(t / m for t, m in zip(found, times["mesh alone"], strict=True))
            target = TARGETS.get(mode)
            missed += target is not None and ratio > target
            theirs = f"{PAPER[mode]:.1f}" if mode in PAPER else ""
            print(f"| {mode} | {1000 * median(found):.1f} | {ratio:.2f} "
                  f"| {target or ''} | {theirs} |")  # fmt: skip
        print()
        os.environ.update(screen)
        print_memory()
    return int(choice.check and missed > 0)


if __name__ == "__main__":
    sys.exit(main())
