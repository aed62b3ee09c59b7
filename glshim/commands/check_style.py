"""``glshim check-style``: whether a style keeps to what all styles keep to."""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
from contextlib import nullcontext
from typing import ClassVar

from glshim.commands.command import HEADLESS, Command
from glshim.running import launch
from glshim.running.headless import headless_environment


class CheckStyle(Command):
    """Exit status: 0 where all holds, 1 where something does not, 2 where there is no screen."""

    name: ClassVar[str] = "check-style"
    help: ClassVar[str] = "validate a style"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument(
            "style", metavar="STYLE",
            help="style to validate: NAME, FILE.toml or my_style.py:MyStyle",
        )  # fmt: skip
        parser.add_argument("--headless", action="store_true", help=HEADLESS)

    def run(self, asked: argparse.Namespace) -> int:
        """Print what holds and what does not. Raises `EnvironmentFault`."""
        python = [sys.executable, *launch.interpreter_flags()]
        with headless_environment() if asked.headless else nullcontext(dict(os.environ)) as environ:
            plain = {key: value for key, value in environ.items() if not key.startswith("GLSHIM_")}
            # In a process of its own: a shader or a draw may take it down.
            status = _printed([*python, "-m", "glshim.checks", asked.style], plain)
        if status < 0:
            print(f"WRONG the process was killed by signal {-status}")
            print("      a shader or a draw call of the style crashed the driver")
            return 1
        return status


def _printed(command: list[str], environ: dict[str, str]) -> int:
    """The exit status of a command whose output we print, so that it is we who hear it where nobody
    reads on."""
    with subprocess.Popen(command, env=environ, stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        try:
            for line in child.stdout:
                print(line, end="", flush=True)
        except BaseException:
            child.kill()
            raise
    return child.returncode
