"""Options that stand after the program, and so are the program's, where they look like ours."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib.machinery import PathFinder
from pathlib import Path

from glshim.notices import say

_MOST_TEXT = 1 << 20
"""Bytes of a program's text that are read."""


def warn(asked: argparse.Namespace, program: Sequence[str]) -> None:
    """Say what to type, in one line, where options of the command stand among the program's own
    arguments. The program gets them all the same: it may have options of that name.

    Nothing is said where its text shows that it has, or after ``--``.
    program: what follows ``python``, the last of what was typed.
    """
    typed: Sequence[str] = asked.typed
    before = typed[: len(typed) - len(program)]
    places = 2 if program[0] == "-m" else 1
    name, arguments = program[places - 1], program[places:]
    found, rest = _ours(asked.parser, arguments)
    if not found or "--" in before:
        return
    text = _text_of(program)
    if any(option.partition("=")[0].encode() in text for option in found):
        return
    command = shlex.join(["glshim", *before, *found, *program[:places], *rest])
    say(f"options after {name} go to the program; to give them to glshim, type: {command}")


def _ours(
    parser: argparse.ArgumentParser, arguments: Sequence[str]
) -> tuple[list[str], list[str]]:
    """The parser's own long options among the arguments with their values, and the others."""
    known = {
        option: action.nargs != 0
        for action in parser._actions if action.dest not in ("help", "module")
        for option in action.option_strings if option.startswith("--")
    }  # fmt: skip
    found: list[str] = []
    others: list[str] = []
    left = list(arguments)
    while left:
        word = left.pop(0)
        option, equals, _ = word.partition("=")
        if option not in known:
            others.append(word)
            continue
        found.append(word)
        if known[option] and not equals and left:
            found.append(left.pop(0))
    return found, others


def _text_of(program: Sequence[str]) -> bytes:
    """The program's source; nothing where it cannot be read."""
    places = _module_files(program[1]) if program[0] == "-m" else [Path(program[0])]
    for path in places:
        with suppress(OSError, ValueError):
            if path.is_file():
                with path.open("rb") as file:
                    return file.read(_MOST_TEXT)
    return b""


def _module_files(name: str) -> list[Path]:
    """Where ``python -m`` would find a module, without importing what it lies in."""
    first, *others = name.split(".")
    with suppress(ImportError, ValueError):
        spec = PathFinder.find_spec(first, [os.getcwd(), *sys.path])
        if spec is not None and spec.submodule_search_locations is None:
            return [Path(spec.origin or "")]
        if spec is not None and spec.submodule_search_locations is not None:
            places = [Path(folder, *others) for folder in spec.submodule_search_locations]
            return [
                file for place in places for file in (place / "__main__.py", Path(f"{place}.py"))
            ]
    return []
