"""What the last word of a command line may become: commands, options, styles and their options."""

from __future__ import annotations

import argparse
import re
import shlex
from collections.abc import Iterator, Sequence
from contextlib import suppress

from glshim.errors import GlshimError
from glshim.styling import registry, texts
from glshim.styling.composite import Composite
from glshim.styling.options import Option, options_of

_STYLES = {"--style", "--styles", "--compare", "--extends"}
"""Options whose values are styles."""
_STYLE_WORDS = {"styles", "check-style"}
"""Commands whose words are styles."""
_TAKES_WORDS = {"run", "doctor"}
"""Commands that leave all that follows the program to that."""


def words_of(line: str) -> list[str]:
    """The words of a line, the last one empty where the line ends between words."""
    try:
        words = shlex.split(line)
    except ValueError:  # an open quote
        words = line.split()
    return [*words, ""] if not words or line[-1:].isspace() else words


def candidates(root: argparse.ArgumentParser, words: Sequence[str]) -> list[str]:
    """All that the last word may become, sorted; none where only files or the program's own words
    come in question. words: of the line, ``glshim`` first; root: the parser of the whole line."""
    *before, current = words[1:]
    commands = _commands(root)
    if not before:
        found = [*commands, *_flags(root)] if current[:1] == "-" else [*commands]
    elif before[0] not in commands:
        found = []
    else:
        found = [*_of_command(commands[before[0]], before, current)]
    return sorted(each for each in found if each.startswith(current) and each != current)


def _of_command(
    parser: argparse.ArgumentParser, before: Sequence[str], current: str
) -> Iterator[str]:
    name, *given = before
    actions = {flag: action for action in parser._actions for flag in action.option_strings}
    option, positionals = "", 0
    waiting = 0
    for word in given:
        if waiting:
            waiting -= 1
        elif word in actions:
            option, waiting = word, _values_of(actions[word])
            if option == "-m":
                positionals += 1
        elif not word.startswith("-"):
            positionals += 1
    if name in _TAKES_WORDS and positionals and not (option == "-m" and waiting):
        return
    flag, equals, value = current.partition("=")
    if equals and flag in actions:  # --style=raskar
        yield from (f"{flag}={each}" for each in _values(flag, actions[flag], value))
    elif waiting:
        yield from _values(option, actions[option], current)
    elif current.startswith("-"):
        yield from _flags(parser)
    elif name in _STYLE_WORDS:
        names_alone = name == "styles"
        yield from ([*registry.names(), *registry.looks()] if names_alone else _styles(current))
    else:
        for action in parser._actions:
            if not action.option_strings and action.choices:
                yield from map(str, action.choices)


def _values(flag: str, action: argparse.Action, current: str) -> Iterator[str]:
    if flag in _STYLES:
        yield from _styles(current)
    elif flag == "--keys":
        yield from ("on", "off")
    elif action.choices:
        yield from map(str, action.choices)


def _styles(current: str) -> Iterator[str]:
    """Names of styles, and after a colon options: ``raskar:ridge_width=4,texture=pen``."""
    head = re.match(r".*[+;]", current)  # those of several styles before
    before = head[0] if head else ""
    current = current[len(before) :]
    name, colon, assignments = current.partition(":")
    if not colon:
        yield from (before + each for each in (*registry.names(), *registry.looks()))
        return
    with suppress(GlshimError):
        styler = texts.parse_style(name)
        parts = styler.parts if isinstance(styler, Composite) else (styler,)
        done, comma, last = assignments.rpartition(",")
        start = f"{before}{name}:{done}{comma}"
        used = {each.partition("=")[0].strip() for each in done.split(",")}
        for option in (option for part in parts for option in options_of(type(part))):
            key, equals, _ = last.partition("=")
            if not equals and option.name not in used:
                yield f"{start}{option.name}="
            elif equals and key == option.name:
                yield from (f"{start}{key}={each}" for each in _choices(option))


def _choices(option: Option) -> tuple[str, ...]:
    return ("on", "off") if option.kind == "switch" else option.choices


def _commands(root: argparse.ArgumentParser) -> dict[str, argparse.ArgumentParser]:
    for action in root._actions:
        if isinstance(action, argparse._SubParsersAction):
            found: dict[str, argparse.ArgumentParser] = action.choices
            return found
    return {}


def _flags(parser: argparse.ArgumentParser) -> Iterator[str]:
    for action in parser._actions:
        if action.help != argparse.SUPPRESS:
            yield from (flag for flag in action.option_strings if flag.startswith("--"))


def _values_of(action: argparse.Action) -> int:
    """How many words an option takes."""
    if action.nargs is None:
        return 1
    return action.nargs if isinstance(action.nargs, int) else 1
