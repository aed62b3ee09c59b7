"""``glshim doctor PROGRAM``: some frames of it, and what was seen of them."""

from __future__ import annotations

import argparse
import json
import os
from contextlib import nullcontext
from dataclasses import asdict

from glshim import toolkits
from glshim.commands import misplaced
from glshim.commands.command import STYLE_DEFAULT, add_program, style_asked
from glshim.errors import EnvironmentFault
from glshim.running import environment
from glshim.running.examine import Examined
from glshim.running.examine import examine as run
from glshim.running.headless import headless_environment

_FRAMES, _SECONDS = 30, 30.0
_MOST_NAMES = 4
"""Of one role, that are printed."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments that name a program, and how it is run."""
    parser.add_argument(
        "--style", metavar="STYLE", help=f"style to run the program in ({STYLE_DEFAULT})"
    )
    parser.add_argument(
        "--frames", default=str(_FRAMES), metavar="N",
        help="stop after N frames (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--timeout", type=float, default=_SECONDS, metavar="SECONDS",
        help="stop after this time (default: %(default)g)",
    )  # fmt: skip
    parser.add_argument(
        "--json", action="store_true",
        help="print JSON; the output of the program goes to standard error",
    )  # fmt: skip
    add_program(parser, "examine")


def is_asked_for(asked: argparse.Namespace) -> bool:
    """Whether a program is named."""
    return bool(asked.module or asked.script)


def examine(asked: argparse.Namespace) -> int:
    """Print what was seen; the status is 1 where the program is not restyled. Raises
    `EnvironmentFault` and `StyleError`."""
    command = ["-m", *asked.module] if asked.module else [asked.script, *asked.arguments]
    misplaced.warn(asked, command)
    frames = environment.parse_frames(asked.frames)
    if not asked.timeout > 0:
        raise EnvironmentFault("--timeout must be greater than zero")
    style = style_asked(asked.style)[1]
    with headless_environment() if asked.headless else nullcontext(dict(os.environ)) as environ:
        found = run(
            command, style, frames=frames, seconds=asked.timeout, environ=environ,
            to_stderr=asked.json,
        )  # fmt: skip
    if asked.json:
        print(json.dumps(_values(found), indent=2))
    else:
        _print(found)
    return 0 if found.is_restyled else 1


def _values(found: Examined) -> dict[str, object]:
    return {
        "command": list(found.command), "style": found.style, "ended": found.ended,
        "status": found.status, "seconds": round(found.seconds, 2),
        "restyled": found.is_restyled, "verdict": found.verdict,
        "seen": asdict(found.seen) if found.seen is not None else None,
    }  # fmt: skip


def _print(found: Examined) -> None:
    heading("program")
    row("command", " ".join(("python", *found.command)))
    row("style", found.style)
    row("ended", found.ended)
    seen = found.seen
    if seen is not None:
        row("OpenGL", seen.opengl or "unknown: no frame was presented")
        heading("frame ends")
        tested = {toolkit.name: toolkit.tested for toolkit in toolkits.used()}
        for name, count in seen.frame_ends.items():
            known = f"; tested with {tested[name]}" if tested.get(name) else ""
            row(name, f"{count}{known if name not in tested or known else '; untested'}")
        if not seen.frame_ends:
            row("none", "lines are added at the end of a frame, and none was seen")
        heading("PyOpenGL calls, by role")
        for role, calls in sorted(seen.calls.items(), key=lambda each: each[0] == "pass"):
            row("others" if role == "pass" else role, f"{sum(calls.values())}: {_most(calls)}")
        heading("restyled polygons, by path")
        for path, count in seen.polygons.items():
            row(path, count)
        row("total", f"{sum(seen.polygons.values())} in {seen.carried} draws")
        heading("what passes through")
        for why, count in sorted(seen.passed.items(), key=lambda each: -each[1]):
            row(f"{count} draws", f"of polygons: {why}")
        if seen.others:
            row(f"{seen.others} draws", "of lines, points and pixels")
        for why in seen.refused:
            row("a context", why)
        if not (seen.passed or seen.others or seen.refused):
            print("  nothing")
    heading("verdict")
    print(f"  {found.verdict}")


def _most(calls: dict[str, int]) -> str:
    names = sorted(calls, key=lambda name: -calls[name])
    told = ", ".join(f"{name} {calls[name]}" for name in names[:_MOST_NAMES])
    return told + (f" and {len(names) - _MOST_NAMES} more" if len(names) > _MOST_NAMES else "")


def heading(text: str) -> None:
    """A part of the report begins."""
    print(f"\n{text}")


def row(name: str, value: object) -> None:
    """One line of it."""
    print(f"  {name:<22} {value}")
