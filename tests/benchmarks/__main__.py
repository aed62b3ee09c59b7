"""`python -m tests.benchmarks`: plain PyOpenGL against the styles `none` and `raskar`, as a table.

Each cell is a process of its own (`scenes.py`, an ordinary program); the modes take turns, round
after round, so that what else the machine does meets them alike. Times are medians, ratios are
medians over the rounds of mode to plain, with half of the span between the least and the largest.
Takes about three minutes; `--thorough` measures longer and adds what each kind of line costs
(`--features`), in a quarter of an hour.
"""

import argparse
import fnmatch
import sys
from pathlib import Path
from statistics import median

from glshim.errors import EnvironmentFault
from glshim.running.headless import virtual_screen

from .features import print_features
from .measure import MODES, BenchmarkError, Timing, remembered, rounds_of

# The most that a mode may take, as a multiple of plain.
TARGETS = {
    "immediate": {"none": 1 / 3, "raskar": 1.0},
    "1,000 glBegin": {"none": 1.0},
    "display list": {"none": 1.05},
    "buffer object": {"none": 1.05},
}
SCENES = (
    "immediate, 7k vertices",
    "immediate, 40k vertices",
    "immediate, 7k, glVertex3fv of lists",
    "immediate, 7k, another shape each frame",
    "1,000 glBegin/glEnd of one quad",
    "display list, 10k polygons",
    "display list, 100k polygons",
    "buffer object, 100k polygons",
    "2,000 matrix calls, 500 glCallList",
    "glCallLists of 500 lists",
)
REMEMBERED = ("immediate, 7k vertices", "display list, 10k polygons", "fresh lists",
              "fresh buffers", "fresh shapes in C")


def target(scene: str, mode: str) -> float | None:
    for start, limits in TARGETS.items():
        if scene.startswith(start):
            return limits.get(mode)
    return None


def cell(timing: dict[str, list[Timing]], scene: str, mode: str) -> tuple[str, bool]:
    """`milliseconds (ratio ±spread)`, bold where it misses its target, and whether it does."""
    rounds = timing[mode]
    milliseconds = 1000 * median(t.middle for t in rounds)
    if mode == "plain":
        return f"{milliseconds:.2f}", False
    ratios = [t.middle / p.middle for t, p in zip(rounds, timing["plain"], strict=True)]
    multiple, spread = median(ratios), (max(ratios) - min(ratios)) / 2
    limit = target(scene, mode)
    missed = limit is not None and multiple > limit
    text = f"{milliseconds:.2f} ({multiple:.2f}x ±{spread:.2f})"
    return (f"**{text}**" if missed else text), missed


def print_times(choice: argparse.Namespace, display: str) -> int:
    print("Milliseconds a frame; in brackets, the multiple of plain and its spread in the rounds.")
    print("Bold: over its target.")
    print()
    print("| scene | plain | none | raskar | raskar, first frame |")
    print("|---|--:|--:|--:|--:|")
    misses = 0
    for scene in SCENES:
        if not fnmatch.fnmatch(scene, f"*{choice.only}*"):
            continue
        timing = rounds_of(scene, MODES, choice.rounds, choice.seconds, display)
        cells = []
        for mode in MODES:
            text, missed = cell(timing, scene, mode)
            cells.append(text)
            misses += missed
        first = 1000 * median(t.first for t in timing["raskar"])
        print(f"| {scene} | {' | '.join(cells)} | {first:.1f} |", flush=True)
    return misses


def print_styles(choice: argparse.Namespace, display: str) -> None:
    modes = ("plain", *choice.styles.split(","))
    print("Milliseconds a frame; in brackets, the multiple of plain.")
    print()
    print(f"| scene | {' | '.join(modes)} |")
    print("|---|" + "--:|" * len(modes))
    for scene in SCENES:
        if fnmatch.fnmatch(scene, f"*{choice.only}*"):
            timing = rounds_of(scene, modes, choice.rounds, choice.seconds, display)
            cells = (cell(timing, scene, mode)[0] for mode in modes)
            print(f"| {scene} | {' | '.join(cells)} |", flush=True)


def print_memory(frames: int, display: str) -> None:
    print(f"Megabytes in memory over {frames:,} frames: after a tenth, after half, at the end.")
    print()
    print("| scene | plain | none | raskar |")
    print("|---|--:|--:|--:|")
    for scene in REMEMBERED:
        cells = []
        for mode in MODES:
            sizes = [size / 2**20 for size in remembered(scene, frames, mode, display)]
            cells.append(" → ".join(f"{sizes[i]:.1f}" for i in (0, 4, 9)))
        print(f"| {scene} | {' | '.join(cells)} |", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks", description=__doc__)
    parser.add_argument("--thorough", action="store_true",
                        help="5 rounds of 0.6 seconds, and both tables")
    parser.add_argument("--rounds", type=int, help="how often each mode is run (4)")
    parser.add_argument("--seconds", type=float, help="frames' time in one run (0.3)")
    parser.add_argument("--only", default="*", metavar="PATTERN", help="scenes to run, a glob")
    parser.add_argument("--memory", type=int, metavar="FRAMES", nargs="?", const=10_000,
                        help="memory over so many frames instead of times")
    parser.add_argument("--features", action="store_true",
                        help="only what each kind of line costs, the second table")
    parser.add_argument("--styles", metavar="A,B,...", help="only these styles' times")
    parser.add_argument("--check", action="store_true", help="exit status 1 on a missed target")
    choice = parser.parse_args()
    choice.rounds = choice.rounds or (5 if choice.thorough else 4)
    choice.seconds = choice.seconds or (0.6 if choice.thorough else 0.3)
    try:
        with virtual_screen() as screen:
            display = screen["DISPLAY"]
            if choice.memory:
                print_memory(choice.memory, display)
                return 0
            if choice.styles:
                print_styles(choice, display)
                return 0
            misses = 0 if choice.features else print_times(choice, display)
            if choice.thorough:
                print()
            if choice.features or choice.thorough:
                print_features(choice.only, choice.rounds, choice.seconds, display)
    except (EnvironmentFault, BenchmarkError) as reason:
        print(f"{Path(sys.executable).name} -m tests.benchmarks: {reason}", file=sys.stderr)
        return 2
    return 1 if misses and choice.check else 0


if __name__ == "__main__":
    sys.exit(main())
