"""What a command is: one file beside this one, and a place in the list of `glshim.commands.cli`."""

from __future__ import annotations

import argparse
from abc import ABC, abstractmethod
from typing import Any, ClassVar

DEFAULT_STYLE = "raskar"
"""The style that is drawn in unless another is asked for."""


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
        parser.set_defaults(command=self)

    @abstractmethod
    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        """Add its own arguments."""

    @abstractmethod
    def run(self, asked: argparse.Namespace) -> int:
        """Do it; the exit status. Raises `GlshimError`, which ends with status 2."""
