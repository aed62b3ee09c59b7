"""Starts the scenes in processes of their own, with and without glshim."""

import json
import os
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

MODES = ("plain", "none", "raskar")
SCRIPT = Path(__file__).with_name("scenes.py")


class BenchmarkError(Exception):
    """A scene failed; the message is what it last said."""


@dataclass(frozen=True, slots=True)
class Timing:
    """Seconds: the first frame, and the middle of those after the warm-up."""

    first: float
    middle: float
    processors: float
    """The time of all processors for a frame: what else the machine does hardly counts."""
    vertices: float | None
    """What a frame sends through the pipeline; None where OpenGL does not count."""


def child(mode: str, display: str, *arguments: str) -> Any:
    """What `scenes.py` prints, under a mode: "plain" or a style."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    environment["DISPLAY"] = display
    if mode != "plain":
        environment["GLSHIM_STYLE"] = mode
    done = subprocess.run([sys.executable, str(SCRIPT), *arguments], env=environment,
                          capture_output=True, text=True, check=False)
    if done.returncode:
        said = done.stderr.strip().splitlines() or [f"status {done.returncode}"]
        raise BenchmarkError(f"{arguments[1]} under {mode}: {said[-1]}")
    return json.loads(done.stdout.splitlines()[-1])


def rounds_of(
    scene: str, modes: Iterable[str], rounds: int, seconds: float, display: str
) -> dict[str, list[Timing]]:
    """Every mode once, one after the other, and all that again."""
    timing: dict[str, list[Timing]] = {mode: [] for mode in modes}
    for _ in range(rounds):
        for mode, found in timing.items():
            r = child(mode, display, "time", scene, str(seconds))
            found.append(Timing(r["first"], median(r["frames"]), r["processors"], r["vertices"]))
    return timing


def remembered(scene: str, frames: int, mode: str, display: str) -> list[int]:
    """Bytes in memory after each tenth of the frames."""
    return list(child(mode, display, "memory", scene, str(frames))["bytes"])
