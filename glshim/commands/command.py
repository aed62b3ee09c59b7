"""What a command is: one file beside this one, and a place in the list of `glshim.commands.cli`."""

from __future__ import annotations

import argparse
import os
from abc import ABC, abstractmethod
from typing import Any, ClassVar

from glshim.errors import StyleError
from glshim.running.environment import STYLE
from glshim.running.subjects import style_variable

DEFAULT_STYLE = "raskar"
"""The style that is drawn in unless another is asked for."""
HEADLESS = "run without a display: on a virtual screen (Xvfb), or through EGL"
"""Of ``--headless``, for help texts."""
STYLE_DEFAULT = f"default: {STYLE}, or {DEFAULT_STYLE}"
"""The default of ``--style``, for help texts."""


def style_asked(given: str | None) -> tuple[str, str]:
    """The style of ``--style``, else of `STYLE`, else the default: its text, and the same as the
    variable takes it from any folder. Raises `StyleError`, naming the variable if it is that
    one's."""
    if given is not None:
        return given, style_variable(given)
    text = os.environ.get(STYLE, "")
    if not text.strip():
        return DEFAULT_STYLE, style_variable(DEFAULT_STYLE)
    try:
        return text.strip(), style_variable(text)
    except StyleError as error:
        raise StyleError(f"{STYLE}: {error}") from error


def add_program(parser: argparse.ArgumentParser, verb: str, *, required: bool = False) -> None:
    """The arguments that name a program: a script or a module, each with arguments of its own.
    verb: what becomes of it, for help texts."""
    what = parser.add_mutually_exclusive_group(required=required)
    what.add_argument(
        "-m", dest="module", nargs=argparse.REMAINDER,
        help=f"module to {verb}, with its arguments, as in python -m",
    )  # fmt: skip
    what.add_argument("script", nargs="?", help=f"script to {verb}")
    parser.add_argument("arguments", nargs=argparse.REMAINDER, help="arguments of the script")


class Command(ABC):
    """One command of the command line."""

    name: ClassVar[str]
    """The word after ``glshim``."""
    help: ClassVar[str]
    """One line of the list of commands."""
    usage: ClassVar[str | None] = None
    """How it is called, where argparse's own line would mislead."""

    def add_to(self, commands: Any) -> None:
        """Add it to argparse's subparsers."""
        parser = commands.add_parser(self.name, help=self.help, usage=self.usage)
        self.add_arguments(parser)
        parser.set_defaults(command=self, parser=parser)

    @abstractmethod
    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        """Add its own arguments."""

    @abstractmethod
    def run(self, asked: argparse.Namespace) -> int:
        """Do it; the exit status. Raises `GlshimError`, which ends with status 2."""
