"""`python -m tests.benchmarks.fins`: what fins and creases cost over the mesh alone, for 1, 10 and
100 objects of 112,000 triangles together, each turning under a matrix of its own.

The geometry shader over every triangle, as Rideout 2010 and Hajagos 2012 have it, and with the
sieve, which leaves it those that may have a line: the same picture. Each run is a process of its
own; the modes take turns, and ratios are medians over the rounds.
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

from glshim_stylers.crease import Crease
from glshim_stylers.fins import Fins, as_printed

from glshim.running.headless import virtual_screen
from glshim.styling.passes import Pass
from glshim.styling.protocol import Layer, Styler

SCENES = {
    count: f"{count} object{'s' * (count > 1)}, 112,000 triangles" for count in (1, 10, 100)
}


@dataclass(frozen=True)
class Unsieved(Styler):
    """A style whose shaders run over every element."""

    name: ClassVar[str] = "unsieved"
    style: Styler = Fins()  # noqa: RUF009 (frozen)

    @property
    def wants_normals(self) -> bool:
        """As the style."""
        return self.style.wants_normals

    def draws(self, layer: Layer) -> Iterable[object]:
        for one in self.style.draws(layer):
            yield as_printed(replace(one, sieve=None)) if isinstance(one, Pass) else one


@dataclass(frozen=True)
class Mode:
    """A style that is timed."""

    style: Styler | None
    targets: tuple[int, ...] = ()
    """Numbers of objects at which it may take `TARGET` times the mesh alone."""


TARGET = 1.5
ALONE = "mesh alone"
MODES = {
    ALONE: Mode(None),
    "fins, all triangles": Mode(Unsieved(Fins())),
    "fins": Mode(Fins(), (1, 10, 100)),
    "fins, lit": Mode(Fins(fill="lit")),
    "fins, cel": Mode(Fins(fill="cel")),
    "crease, all triangles": Mode(Unsieved(Crease())),
    "crease": Mode(Crease(), (1, 10, 100)),
}


def child(mode: str, count: int, seconds: float) -> None:
    """Times one mode in this process."""
    import glshim
    from tests.benchmarks import scenes

    style = MODES[mode].style
    if style is not None:
        glshim.install(style)
    print(json.dumps(scenes.timed(SCENES[count], seconds)))


def run(mode: str, count: int, seconds: float, screen: dict[str, str]) -> float:
    """The middle of a mode's frame times, in seconds."""
    command = [sys.executable, "-m", "tests.benchmarks.fins", "--child", mode,
               "--objects", str(count), "--seconds", str(seconds)]  # fmt: skip
    done = subprocess.run(command, env=os.environ | screen, capture_output=True, text=True,
                          check=False)  # fmt: skip
    if done.returncode or "glshim:" in done.stderr:
        raise SystemExit(f"{mode}: {done.stderr.strip()}")
    return float(median(json.loads(done.stdout.splitlines()[-1])["frames"]))


def measured(counts: Iterable[int], rounds: int, seconds: float) -> int:
    """Prints the table; how many targets were missed."""
    missed = 0
    print("| objects | drawn | ms a frame | of the mesh alone | target |")
    print("|--:|---|--:|--:|--:|")
    with virtual_screen() as screen:
        for count in counts:
            times: dict[str, list[float]] = {mode: [] for mode in MODES}
            for _ in range(rounds):
                for mode, found in times.items():
                    found.append(run(mode, count, seconds, screen))
            for mode, found in times.items():
                ratio = median(t / m for t, m in zip(found, times[ALONE], strict=True))
                aims = count in MODES[mode].targets
                missed += aims and ratio > TARGET
                print(f"| {count} | {mode} | {1000 * median(found):.1f} | {ratio:.2f} "
                      f"| {TARGET if aims else ''} |", flush=True)  # fmt: skip
    return missed


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.fins", description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--seconds", type=float, default=1.0, help="frames' time in one run")
    parser.add_argument("--objects", type=int, action="append", choices=SCENES, metavar="N")
    parser.add_argument("--child", choices=MODES, help=argparse.SUPPRESS)
    parser.add_argument("--check", action="store_true", help="exit status 1 on a missed target")
    choice = parser.parse_args()
    if choice.child:
        child(choice.child, choice.objects[0], choice.seconds)
        return 0
    missed = measured(choice.objects or SCENES, choice.rounds, choice.seconds)
    return int(choice.check and missed > 0)


if __name__ == "__main__":
    sys.exit(main())
