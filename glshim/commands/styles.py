"""``glshim styles``: the styles and looks that are installed, and their options."""

from __future__ import annotations

import argparse
import re
from collections.abc import Iterable, Iterator
from typing import ClassVar

from glshim.commands.command import Command
from glshim.styling import descriptions, registry

_WIDTH = 80
"""Columns of the short list, at most."""
_LEAST = 40
"""Columns that say enough."""


class Styles(Command):
    """Exit status 0."""

    name: ClassVar[str] = "styles"
    help: ClassVar[str] = "list styles and their options"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument(
            "names", nargs="*", metavar="NAME", help="styles whose options to print"
        )
        parser.add_argument(
            "--long", action="store_true", help="print the options of every style"
        )

    def run(self, asked: argparse.Namespace) -> int:
        if asked.names or asked.long:
            for name in asked.names or (*registry.names(), *registry.looks()):
                print(descriptions.of_name(name))
        else:
            print("\n".join(short_list(registry.names(), registry.looks())))
        return 0


def short_list(styles: Iterable[str], looks: Iterable[str]) -> Iterator[str]:
    """A line each, by name, and how to learn more."""
    styles, looks = tuple(styles), tuple(looks)
    column = max(map(len, (*styles, *looks)), default=0)
    for title, names in (("styles:", styles), ("looks (style files):", looks)):
        yield title
        for name in names:
            line = f"  {name:<{column}}  {descriptions.summary(name)}"
            yield _shortened(line.rstrip())
    yield "For options: glshim styles NAME, or glshim styles --long for all styles."


def _shortened(line: str) -> str:
    """Cut behind a part of the sentence where it is too long, or else between two words."""
    if len(line) <= _WIDTH:
        return line
    part = re.match(rf"(.{{{_LEAST},{_WIDTH}}})[,;:] ", line)
    return part[1] if part else line[: _WIDTH - 3].rpartition(" ")[0] + " ..."
