"""What each kind of line costs, alone and together, in milliseconds of all processors (drawing
in software and numpy alike) and in vertices.

Raskar 2001, section 4: "the number of vertex transformations increases by a factor of 2 to 5".
"""

from collections.abc import Sequence
from fnmatch import fnmatch
from statistics import median

from .measure import Timing, rounds_of

KINDS = ("silhouettes", "ridges", "valleys", "intersections")
SCENES = (
    "display list, 10k polygons",
    "display list, 100k polygons",
    "immediate, 7k, another shape each frame",
    "display list, 10k, folded and crossing",
)
PAPER = "2 to 5"


def style(wanted: Sequence[str], *more: str) -> str:
    """Style raskar with only some kinds of line."""
    return "raskar:" + ",".join([f"{k}={'on' if k in wanted else 'off'}" for k in KINDS] + [*more])


MODES = {
    "plain": "plain",
    **{f"{kind} alone": style([kind]) for kind in KINDS},
    "all four": style(KINDS),
    "all four, connectivity off": style(KINDS, "connectivity=off"),
}


def cells(timing: dict[str, list[Timing]], mode: str) -> tuple[str, str]:
    """`milliseconds (multiple of plain)` and the vertex factor."""
    rounds, plain = timing[mode], timing["plain"]
    text = f"{1000 * median(t.processors for t in rounds):.1f}"
    if mode != "plain":
        ratio = median(t.processors / p.processors for t, p in zip(rounds, plain, strict=True))
        text += f" ({ratio:.1f}x)"
    own, mesh = rounds[0].vertices, plain[0].vertices
    return text, f"{own / mesh:.2f}" if own and mesh else "?"


def print_features(only: str, rounds: int, seconds: float, display: str) -> None:
    """The table, a row for each mode, two columns for each scene."""
    scenes = [scene for scene in SCENES if fnmatch(scene, f"*{only}*")]
    if not scenes:
        return
    print("Milliseconds of all processors together a frame (multiple of plain); vertices through")
    print("the pipeline, those of what glshim draws among them, over the mesh's own.")
    print()
    print(f"| lines | {' | '.join(f'{scene} | vertices' for scene in scenes)} |")
    print(f"|---|{'--:|--:|' * len(scenes)}", flush=True)
    timings = [rounds_of(scene, MODES.values(), rounds, seconds, display) for scene in scenes]
    for name, mode in MODES.items():
        row = [cell for timing in timings for cell in cells(timing, mode)]
        print(f"| {name} | {' | '.join(row)} |")
    print(f"| the paper: all | {' | '.join(['', PAPER] * len(scenes))} |")
