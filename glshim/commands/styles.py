"""``glshim styles``: the styles and looks that are installed, with their options."""

from __future__ import annotations

import argparse
from typing import ClassVar

from glshim.commands.command import Command
from glshim.styling import descriptions, registry


class Styles(Command):
    """Exit status 0."""

    name: ClassVar[str] = "styles"
    help: ClassVar[str] = "list the styles and their options"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument("names", nargs="*", metavar="NAME", help="only these")

    def run(self, asked: argparse.Namespace) -> int:
        for name in asked.names or (*registry.names(), *registry.looks()):
            print(descriptions.of_name(name))
        return 0
