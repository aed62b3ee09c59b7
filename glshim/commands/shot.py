"""``glshim shot``: one picture of a program, at any size."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path
from typing import ClassVar

from glshim.commands.command import STYLE_DEFAULT, Command, style_asked
from glshim.errors import EnvironmentFault
from glshim.notices import say
from glshim.running import subjects
from glshim.running.environment import STYLE
from glshim.running.gallery.runs import Run, run_all
from glshim.running.shots.plan import MOST_SIDE, VARIABLE, Plan, parse_scale, parse_size

_SECONDS = 600.0
_LEAST_TILE = 64


class Shot(Command):
    """Exit status: 0; 1 where there is no picture, with the reason; 2 for a command that makes no
    sense; 130 after Ctrl-C."""

    name: ClassVar[str] = "shot"
    help: ClassVar[str] = "render one frame of a program at any size"
    usage: ClassVar[str | None] = (
        "glshim shot [options] (SCRIPT | -m MODULE | MODEL) [ARGS...] [-o OUT.png]"
    )

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        subjects.add_arguments(parser)
        parser.add_argument(
            "-o", "--output", default="shot.png", metavar="OUT.png",
            help="picture to write (default: %(default)s)",
        )  # fmt: skip
        parser.add_argument(
            "--style", help=f"as for glshim run ({STYLE_DEFAULT})"
        )
        size = parser.add_mutually_exclusive_group()
        size.add_argument("--size", metavar="WxH", help="size in pixels, e.g. 6000x4500")
        size.add_argument("--scale", metavar="K", help="multiple of the window size (default: 4)")
        parser.add_argument(
            "--tile", type=int, default=MOST_SIDE, metavar="N",
            help="maximum tile side in pixels; smaller tiles need less memory and more frames "
            "(default: %(default)s)",
        )  # fmt: skip
        parser.add_argument(
            "--timeout", type=float, default=_SECONDS, metavar="SECONDS",
            help="time limit (default: %(default)g)",
        )  # fmt: skip

    def run(self, asked: argparse.Namespace) -> int:
        """Take the shot."""
        subject = subjects.subject_of(asked)
        picture = Path(asked.output).absolute()
        if picture.suffix.lower() != ".png":
            raise EnvironmentFault(f"{asked.output!r} is not a picture: its name must end in .png")
        if asked.tile < _LEAST_TILE or not asked.timeout > 0:
            raise EnvironmentFault(
                f"--tile must be at least {_LEAST_TILE}, --timeout greater than zero"
            )
        plan = Plan(str(picture), subjects.frame_of(asked), tile=asked.tile)
        if asked.size is not None:
            plan = replace(plan, size=parse_size(asked.size))
        else:
            plan = replace(plan, scale=parse_scale(asked.scale or "4"))
        name, style = style_asked(asked.style)
        variables = {STYLE: style, VARIABLE: plan.as_text()}
        try:
            picture.parent.mkdir(parents=True, exist_ok=True)
            shot = Run(name, variables, picture)
            (ended,) = run_all(subject.command, [shot], asked.timeout)
        except KeyboardInterrupt:
            say("interrupted; no picture was written")
            return 130
        except OSError as error:
            raise EnvironmentFault(f"cannot write {picture}: {error}") from error
        for note in ended.notes:
            say(note)
        if ended.fault:
            say(ended.fault)
            return 1
        print(picture)
        return 0
