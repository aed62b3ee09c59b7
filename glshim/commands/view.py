"""``glshim view``: a model in the bundled viewer, restyled."""

from __future__ import annotations

import argparse
import os
from typing import ClassVar

from glshim.commands.command import Command
from glshim.commands.run import add_options, run_program
from glshim.control import keys
from glshim.running.subjects import VIEWER
from glshim.styling.colours import HOW, format_colour, parse_colour


class View(Command):
    """The exit status is the viewer's own."""

    name: ClassVar[str] = "view"
    help: ClassVar[str] = "show a model in a style"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        add_options(parser)
        parser.add_argument(
            "--up", choices=("x", "y", "z"),
            help="the model's axis that points up (default: z for STL, y for others)",
        )  # fmt: skip
        parser.add_argument("--background", metavar="COLOUR", help=HOW)
        parser.add_argument(
            "model", nargs="?", help="an OBJ, PLY, STL or glTF file, or a built-in shape"
        )

    def run(self, asked: argparse.Namespace) -> int:
        if asked.keys is None and keys.KEYS not in os.environ:
            asked.keys = "on"
        # Frames that are counted or written are to show the model, not that it is on its way.
        options = ["--wait"] if asked.frames is not None or asked.capture is not None else []
        if asked.up is not None:
            options += ["--up", asked.up]
        if asked.background is not None:
            options += ["--background", format_colour(parse_colour(asked.background))]
        model = [asked.model] if asked.model else []
        return run_program(["-m", VIEWER, *options, *model], asked)
