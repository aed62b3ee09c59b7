"""The command line: ``glshim run|view|gallery|shot|styles ...``, or ``python -m glshim``.

Exit status: the program's own under ``run`` and ``view``; 2 for a command that makes no sense (a
style, a number, a screen that is not there), before any window opens; 130 after Ctrl-C; 141 where
nobody reads the output any more. Each command's file says what else it may be.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Sequence

from glshim.commands.check_style import CheckStyle
from glshim.commands.command import Command
from glshim.commands.completion import Completion
from glshim.commands.doctor import Doctor, version_of
from glshim.commands.gallery import Gallery
from glshim.commands.new_style import NewStyle
from glshim.commands.run import Run
from glshim.commands.shot import Shot
from glshim.commands.styles import Styles
from glshim.commands.view import View
from glshim.errors import GlshimError
from glshim.notices import say

COMMANDS: tuple[Command, ...] = (
    Run(), View(), Gallery(), Shot(), Styles(), NewStyle(), CheckStyle(), Doctor(), Completion(),
)  # fmt: skip
"""All of them, in the order of the help text."""


_INTERRUPTED, _NOBODY_READS = 130, 141
"""What a shell gives for programs that SIGINT and SIGPIPE end."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command; its exit status."""
    try:
        try:
            typed = sys.argv[1:] if arguments is None else list(arguments)
            parser = _parser()
            if not typed:  # the first thing that people type
                parser.print_help()
                return 2
            asked = parser.parse_args(typed, argparse.Namespace(typed=typed))
            status: int = asked.command.run(asked)
        finally:
            sys.stdout.flush()
    except GlshimError as error:
        say(str(error))
        return 2
    except KeyboardInterrupt:
        return _INTERRUPTED
    except BrokenPipeError:  # ``glshim styles | head`` has read what it wanted
        # The interpreter flushes once more at its end, which must not fail either.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return _NOBODY_READS
    return status


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="glshim", description="Restyle PyOpenGL programs without changing them."
    )
    version = version_of("glshim") or "(not installed)"
    parser.add_argument("--version", action="version", version=f"glshim {version}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for command in COMMANDS:
        command.add_to(commands)
    parser.set_defaults(root=parser)
    return parser


if __name__ == "__main__":
    sys.exit(main())
