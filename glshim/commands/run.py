"""``glshim run``: a program of somebody's, restyled."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import ClassVar

from glshim.commands import misplaced
from glshim.commands.command import HEADLESS, STYLE_DEFAULT, Command, add_program, style_asked
from glshim.control import keys
from glshim.running import environment, launch


class Run(Command):
    """The exit status is the program's own."""

    name: ClassVar[str] = "run"
    help: ClassVar[str] = "run a program in a style"
    usage: ClassVar[str | None] = "glshim run [options] (SCRIPT | -m MODULE) [ARGS...]"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        add_options(parser)
        add_program(parser, "run", required=True)

    def run(self, asked: argparse.Namespace) -> int:
        program = ["-m", *asked.module] if asked.module else [asked.script, *asked.arguments]
        misplaced.warn(asked, program)
        return run_program(program, asked)


def add_options(parser: argparse.ArgumentParser) -> None:
    """The options of a program that runs restyled."""
    parser.add_argument(
        "--style",
        help=f"style: NAME, NAME:option=value,... or FILE.toml ({STYLE_DEFAULT})",
    )
    parser.add_argument(
        "--keys", metavar="KEYS", help="live-control keys: on, off or ACTION=KEY,ACTION=KEY"
    )
    parser.add_argument("--frames", metavar="N", help="exit with status 0 after N frames")
    parser.add_argument(
        "--capture", metavar="OUT%03d.png",
        help="save each presented frame; %%03d is its number, from 1",
    )  # fmt: skip
    parser.add_argument(
        "--headless", action="store_true", help=HEADLESS
    )


def run_program(program: Sequence[str], asked: argparse.Namespace) -> int:
    """Run ``python *program`` with the parsed options; the exit status."""
    return launch.run(program, variables_of(asked), headless=asked.headless)


def variables_of(asked: argparse.Namespace) -> dict[str, str]:
    """The options as the variables that the program's start reads, checked here and now."""
    variables = {environment.STYLE: style_asked(asked.style)[1]}
    if asked.keys is not None:
        keys.parse_keys(asked.keys)
        variables[keys.KEYS] = asked.keys
    if asked.frames is not None:
        variables[environment.FRAMES] = str(environment.parse_frames(asked.frames))
    if asked.capture is not None:
        variables[environment.CAPTURE] = environment.parse_capture(asked.capture)
    return variables
