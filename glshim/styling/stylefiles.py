"""Style files: TOML that names a style, or extends one, and gives options flat or by feature.

::

    extends = "charcoal"       # a look, a style, another file; or: style = "edge_mesh"
    paper = "#d8c8a8"          # an option
    [ridge]                    # options by feature: ridges, ridge_width, ridge_angle
    on = true
    width = 4
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from glshim.errors import StyleError
from glshim.styling.lookup import Key, targets
from glshim.styling.options import Option
from glshim.styling.protocol import Styler
from glshim.system.reading import read_small

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

STYLE, EXTENDS = "style", "extends"
"""The keys that say what the options are of: a style, or whatever a style text may name."""
MOST_PARTS = 16
"""Parts of a dotted key, at most: TOML's readers take the square of it."""

_TOKEN = re.compile(
    r'''(?P<string>"""[^"\\]*(?:(?:\\.|"(?!""))[^"\\]*)*(?:"""(?:"{0,2})|\\?\Z)|'''
    r'''"(?:\\[^\n]|[^"\\\n])*"?|'''
    r"'''[^']*(?:'(?!'')[^']*)*(?:'''(?:'{0,2})|\Z)|'[^'\n]*'?)"
    r"|(?P<comment>#[^\n]*)|(?P<open>[\[{])|(?P<close>[\]}])|(?P<end>\n)",
    re.DOTALL,
)
"""What decides where a statement of TOML ends. A string that does not end is one, too: so no text
takes more than one look."""
_LONG_KEY = re.compile(rf"(?<![\w-])(?:[\w-]+[ \t]*\.[ \t]*){{{MOST_PARTS}}}")
_UNQUOTED = re.compile(
    r"\s*([\w.-]{1,60})\s*=\s*(#[\da-fA-F]{3,8}|[a-zA-Z][\w.:/-]{0,60})\s*(?:#.*)?\Z"
)
_PLACE = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)\Z", re.DOTALL)
"""How TOML's readers end what they say of a fault."""


class StyleFileError(StyleError):
    """A style file is not valid; the message begins with its path and the line."""


@dataclass(frozen=True, slots=True)
class StyleFile:
    """A style file as it is written, read as TOML and not yet understood."""

    path: Path
    content: str
    table: Mapping[str, Any]

    @property
    def base(self) -> tuple[str, tuple[str, ...]]:
        """`STYLE` or `EXTENDS`, and what is named there. Raises `StyleFileError`."""
        given = [key for key in (STYLE, EXTENDS) if key in self.table]
        if not given:
            raise StyleFileError(
                f'{self.path}: a style file names its style: {STYLE} = "raskar", '
                f'or what it extends: {EXTENDS} = "charcoal"'
            )
        if len(given) > 1:
            line = self.line((STYLE,))
            raise self.fault((EXTENDS,), f"{EXTENDS} beside {STYLE} (line {line}): give one")
        (key,) = given
        value = self.table[key]
        if isinstance(value, str):
            return key, (value,)
        several = isinstance(value, list) and all(isinstance(name, str) for name in value)
        if not several or key == STYLE or not value:
            written = f'{EXTENDS} = ["cartoon", "edge_mesh"]' if several else f'{key} = "raskar"'
            raise self.fault(given, f"{key} names its style as a text: {written}")
        return key, tuple(value)

    def options(self, *stylers: type[Styler]) -> list[dict[str, Any]]:
        """The checked values that the file gives to options of each styler: of several to all that
        have them. Raises `StyleFileError`."""
        places: list[dict[str, Key]] = [{} for _ in stylers]
        values: list[dict[str, Any]] = [{} for _ in stylers]
        for key, value in self._assignments():
            try:
                for k, target in targets(stylers, key):
                    found = target.values(partial(self._checked, value))
                    for name in found.keys() & places[k].keys():
                        first = self.line(places[k][name])
                        raise StyleError(f"{name} was given before (line {first})")
                    places[k] |= dict.fromkeys(found, key)
                    values[k] |= found
            except StyleError as error:
                raise self.fault(key, str(error)) from error
        return values

    def _checked(self, value: Any, option: Option) -> Any:
        # A file may write switches, and what follows another option, as the command line does.
        words = isinstance(value, str) and (option.kind == "switch" or option.follows)
        return option.parse(value, self.folder) if words else option.check(value, self.folder)

    def _assignments(self) -> Iterator[tuple[Key, Any]]:
        for key, value in self.table.items():
            if isinstance(value, Mapping):
                yield from (((key, inner), own) for inner, own in value.items())
            elif key not in (STYLE, EXTENDS):
                yield (key,), value

    @property
    def folder(self) -> str:
        """What paths in the file are relative to."""
        return str(self.path.parent)

    def line(self, key: Sequence[str]) -> int:
        """The line from 1 of the statement that gives a key its value."""
        number = 1
        header: list[str] = []
        for statement in _statements(self.content):
            try:
                table: Any = tomllib.loads(statement)
            except (ValueError, RecursionError):
                table = {}
            if statement.lstrip(" \t").startswith("["):
                header = []
            if _holds(_within(header, table), key):
                return number
            if statement.lstrip(" \t").startswith("["):
                header = _header(table)
            number += statement.count("\n")
        return number

    def fault(self, key: Sequence[str], message: str) -> StyleFileError:
        """An error at a key; the file's own texts in it may hold line ends."""
        return StyleFileError(f"{self.path}:{self.line(key)}: {message}")


def read_style_file(path: Path) -> StyleFile:
    """Read a file as TOML. Raises `StyleError` where it cannot be read, `StyleFileError` where it
    is not TOML."""
    try:
        content = read_text(path)
    except (OSError, ValueError) as error:  # ValueError: bytes that are not UTF-8, or not a path
        reason = getattr(error, "strerror", None) or error
        raise StyleError(f"cannot read style file {str(path)!r}: {reason}") from error
    found = _LONG_KEY.search(_TOKEN.sub(_without_strings, content))
    if found:
        raise StyleFileError(f"{path}: a key has more than {MOST_PARTS} parts: [feature] has one")
    try:
        return StyleFile(path, content, tomllib.loads(content))
    except (ValueError, RecursionError) as error:  # ValueError: not TOML, or a number too long
        found = _PLACE.match(str(error))
        place, reason = "", str(error)
        if found:
            lines = content.rstrip().split("\n")
            line, column = int(found[2] or len(lines)), int(found[3] or len(lines[-1]))
            place, reason = f":{line}:{column}", _unquoted(lines[line - 1]) or found[1]
        raise StyleFileError(f"{path}{place}: {reason}") from error


def read_text(path: Path) -> str:
    """The text of a style file. Raises OSError, ValueError."""
    text = read_small(path).decode("utf-8-sig")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _unquoted(line: str) -> str:
    """What to write where a line gives a key a text without quotes, as ``paper = #e8dcc8``."""
    found = _UNQUOTED.match(line)
    return f'text values need quotes: write {found[1]} = "{found[2]}"' if found else ""


def _without_strings(found: re.Match[str]) -> str:
    return "_" if found["string"] else "" if found["comment"] else found[0]


def _statements(content: str) -> Iterator[str]:
    """The statements of a valid file in turn, each with its line ends; so are the empty lines and
    the comments between them."""
    depth = begin = 0
    for found in _TOKEN.finditer(content):
        if found["open"]:
            depth += 1
        elif found["close"]:
            depth -= 1
        elif found["end"] and depth == 0:
            yield content[begin : found.end()]
            begin = found.end()
    yield content[begin:]


def _header(table: Any) -> list[str]:
    """The key of ``[a.b]``, which is alone in its statement."""
    parts: list[str] = []
    while isinstance(table, Mapping) and table:
        ((part, table),) = table.items()
        parts.append(part)
    return parts


def _within(header: Sequence[str], table: Any) -> Any:
    for part in reversed(header):
        table = {part: table} if table else {}
    return table


def _holds(table: Any, key: Sequence[str]) -> bool:
    for part in key:
        if not isinstance(table, Mapping) or part not in table:
            return False
        table = table[part]
    return True
