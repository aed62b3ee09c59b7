"""Starts a program for some frames, as ``python`` starts it, and reads what was seen of it."""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from glshim.running import environment, launch
from glshim.running.examination.findings import VARIABLE, Findings

_TO_LEAVE = 5.0
"""Seconds that a program is given to end when it is asked to."""


@dataclass(frozen=True, slots=True)
class Examined:
    """How a program ran, and what was seen of it."""

    command: tuple[str, ...]
    """What follows ``python``."""
    style: str
    frames: int
    """After which it was to end."""
    status: int | None
    """Its exit status; minus the number of a signal; None: it was stopped, its time was over."""
    seconds: float
    seen: Findings | None
    """None where it never imported PyOpenGL."""

    @property
    def ended(self) -> str:
        """How it ended, in words."""
        seen = self.seen.frames if self.seen is not None else 0
        within = f"in {self.seconds:.1f} s"
        if self.status is None:
            return f"stopped after {self.seconds:.0f} s and {_frames(seen)}"
        if self.status < 0:
            return f"killed by signal {-self.status} after {_frames(seen)}, {within}"
        if self.status == 0 and seen >= self.frames:
            return f"stopped after {_frames(seen)}, {within}"
        return f"exited with status {self.status} after {_frames(seen)}, {within}"

    @property
    def is_restyled(self) -> bool:
        """Whether lines come, where they can be seen."""
        return self.seen is not None and bool(self.seen.added and self.seen.frames)

    @property
    def verdict(self) -> str:
        """What comes of it, and what to do."""
        seen = self.seen
        if seen is None:
            return (
                "not restyled: PyOpenGL was not imported, and glshim restyles only programs that "
                "draw through it. If the program starts another one that draws, examine that one"
            )
        if not self.is_restyled:
            told = seen.why or "; ".join(seen.refused)
            return f"not restyled: {told or 'nothing was drawn during the run'}"
        passed = sum(seen.passed.values())
        if not passed:
            return "restyled: all polygons"
        share = seen.carried / (seen.carried + passed)
        why = max(seen.passed, key=lambda each: seen.passed[each])
        part = f"{share:.0%}" if share < 0.995 else "nearly all"
        return (
            f"partly restyled: {part} of the draw calls for polygons; the others are left "
            f"unstyled, mostly because {why}"
        )


def _frames(count: int) -> str:
    return f"{count or 'no'} frame{'' if count == 1 else 's'}"


def examine(
    command: Sequence[str], style: str, *, frames: int, seconds: float,
    environ: Mapping[str, str], to_stderr: bool = False,
) -> Examined:  # fmt: skip
    """Run ``python *command`` until so many frames have ended or so many seconds are over.
    to_stderr: what it prints. Raises `EnvironmentFault` where it would run unstyled."""
    launch.require_startup_file()
    plain = {name: text for name, text in environ.items() if not name.startswith("GLSHIM_")}
    with tempfile.TemporaryDirectory(prefix="glshim-doctor-") as folder:
        variables = {
            environment.STYLE: style, environment.FRAMES: str(frames), VARIABLE: folder,
        }  # fmt: skip
        began = time.monotonic()
        child = subprocess.Popen(
            [sys.executable, *launch.interpreter_flags(), *command], env=plain | variables,
            stdout=sys.stderr.fileno() if to_stderr else None,
        )  # fmt: skip
        status = _wait(child, seconds)
        return Examined(
            tuple(command), style, frames, status, time.monotonic() - began, _read(Path(folder))
        )


def _wait(child: subprocess.Popen[bytes], seconds: float) -> int | None:
    """The exit status, None where it has to be stopped; Ctrl-C stops it too."""
    try:
        return child.wait(seconds)
    except (subprocess.TimeoutExpired, KeyboardInterrupt):
        child.terminate()
        try:
            child.wait(_TO_LEAVE)
        except (subprocess.TimeoutExpired, KeyboardInterrupt):
            child.kill()
            child.wait()
        return None


def _read(folder: Path) -> Findings | None:
    """Of its processes the one that drew most."""
    found = []
    for path in folder.glob("*.json"):
        with suppress(OSError, ValueError, TypeError, KeyError):
            found.append(Findings.of_text(path.read_text(encoding="utf-8")))
    return max(found, key=lambda each: (each.frames, len(each.calls)), default=None)
