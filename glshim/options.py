"""Style texts, style files and the GLSHIM_* environment, each to one checked value."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from glshim.errors import StyleError, UnknownNameError, nearest
from glshim.styling import registry
from glshim.styling.protocol import Option, Styler, options_of
from stylers.looks import looks

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

STYLE, FRAMES, CAPTURE = "GLSHIM_STYLE", "GLSHIM_FRAMES", "GLSHIM_CAPTURE"
NAME_KEY = "style"
"""The key of a style file that names the style."""


def parse_style(text: str, folder: str = "") -> Styler:
    """``name``, ``name:key=value,key=value`` or the path of a TOML file with the same keys. A name
    is a style's, or a look's: that of a style file that comes with glshim. Paths in a text are
    taken from the folder, those in a file from where that lies.

    Raises `StyleError` with one clear line: what is wrong, and the nearest right thing.
    """
    text = text.strip()
    if not text.isprintable():
        raise StyleError(f"{text!r} is no style: it holds characters that are not printable")
    if text.endswith(".toml"):
        return load_style(Path(folder, text))
    name, _, assignments = text.partition(":")
    look = looks().get(name.strip())
    styler = load_style(look) if look else _load(name.strip())()
    pieces = (piece for piece in assignments.split(",") if piece.strip())
    return replace(styler, **dict(_parsed(type(styler), piece, folder) for piece in pieces))


def load_style(path: Path) -> Styler:
    """A style file: ``style = "raskar"`` and a line for every option that is not its default.

    Raises `StyleError` naming the file, and the line where there is one.
    """
    try:
        content = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:  # ValueError: bytes that are no UTF-8, or no path
        reason = getattr(error, "strerror", None) or error
        raise StyleError(f"cannot read style file {str(path)!r}: {reason}") from error
    try:
        table = tomllib.loads(content)
    except tomllib.TOMLDecodeError as error:
        raise StyleError(f"{path}: {error}") from error
    name = table.pop(NAME_KEY, None)
    if not isinstance(name, str):
        raise StyleError(f'{path}: a style file names its style: {NAME_KEY} = "raskar"')
    key = NAME_KEY
    try:
        styler = _load(name)
        values = {}
        for key, value in table.items():
            option = _option(styler, key)
            # A file may write a switch as the command line does.
            words = isinstance(value, str) and option.kind == "switch"
            values[key] = option.parse(value) if words else option.check(value, str(path.parent))
        key = ""
        return styler(**values)
    except StyleError as error:
        line = " ".join(str(error).splitlines())  # the file's texts may hold line ends
        raise StyleError(f"{path}{_line_of(key, content)}: {line}") from error


def _line_of(key: str, content: str) -> str:
    for number, line in enumerate(content.splitlines(), start=1):
        if key and re.match(rf"""\s*(["']?){re.escape(key)}\1\s*=""", line):
            return f":{number}"
    return ""


def _load(name: str) -> type[Styler]:
    try:
        return registry.load(name)
    except UnknownNameError as error:
        if os.path.isfile(name):  # (never raises, unlike Path's)
            raise StyleError(
                f"{name} is a file: a style file is given alone, as NAME.toml"
            ) from error
        known = (*registry.names(), *looks())
        raise _unknown(f"no style is called {name!r}", name, known) from error


def _parsed(styler: type[Styler], piece: str, folder: str) -> tuple[str, Any]:
    key, equals, value = (part.strip() for part in piece.partition("="))
    option = _option(styler, key)
    if not equals:
        raise StyleError(f"{key} has no value: write {key}={option.show(option.default)}")
    return key, option.parse(value, folder)


def _option(styler: type[Styler], key: str) -> Option:
    options = {option.name: option for option in options_of(styler)}
    if key not in options:
        raise _unknown(f"style {styler.name!r} has no option {key!r}", key, options)
    return options[key]


def _unknown(what: str, name: str, known: Iterable[str]) -> UnknownNameError:
    known = tuple(known)
    near = nearest(name, known)
    if near:
        hint = f"did you mean {' or '.join(near)}?"
    else:
        hint = f"there are {', '.join(known)}" if known else "it has none"
    return UnknownNameError(f"{what}: {hint}", near)


@dataclass(frozen=True, slots=True)
class Settings:
    """What the environment asks for; None where it asks for nothing."""

    style: str | None = None
    frames: int | None = None
    """End the program after so many presented frames."""
    capture: str | None = None
    """Where to write each frame: an absolute path with one ``%d`` for its number, or none."""


def parse_frames(text: str) -> int:
    """A whole number of frames, at least 1. Raises `StyleError`."""
    if not re.fullmatch(r"\s*[0-9]+\s*", text) or int(text) < 1:
        raise StyleError(f"{text!r} is no number of frames: give a whole number from 1")
    return int(text)


def parse_capture(text: str, folder: str = "") -> str:
    """A file name, made absolute, with at most one ``%d`` or ``%03d``. Raises `StyleError`."""
    rest = re.sub("%0?[0-9]*d", "", text, count=1)
    if "%" in rest or not text.lower().endswith(".png"):
        raise StyleError(
            f"{text!r} is no file name for frames: it ends in .png "
            "and holds one %d or %03d, or none, for the frame's number"
        )
    return os.path.abspath(os.path.join(folder, text))


def read_environment(
    environ: Mapping[str, str], folder: str = ""
) -> tuple[Settings, tuple[str, ...]]:
    """The settings, and a line for each variable that cannot be used (and then counts as unset).
    Relative paths are taken from the folder.

    The style's text is not parsed here: that loads stylers.
    """
    complaints: list[str] = []

    def read(variable: str, parse: Any, consequence: str) -> Any:
        text = environ.get(variable, "")
        if not text.strip():
            return None
        try:
            return parse(text)
        except StyleError as error:
            complaints.append(f"{variable}: {error}; {consequence}")
            return None

    style = environ.get(STYLE, "").strip()
    settings = Settings(
        style=(os.path.join(folder, style) if style.endswith(".toml") else style) or None,
        frames=read(FRAMES, parse_frames, "the program runs on without an end"),
        capture=read(CAPTURE, lambda text: parse_capture(text, folder), "no frames are written"),
    )
    return settings, tuple(complaints)


def describe_look(name: str) -> str:
    """A look for people: the first line of its file, and the text that says the same."""
    path = looks()[name]
    styler = load_style(path)
    summary = path.read_text(encoding="utf-8").partition("\n")[0].lstrip("# ")
    changed = (
        f"{o.name}={o.show(getattr(styler, o.name))}"
        for o in options_of(type(styler))
        if getattr(styler, o.name) != o.default
    )
    return f"{name}: {summary}\n  {styler.name}:{','.join(changed)}"


def describe(styler: type[Styler]) -> str:
    """A style for people: its first line of documentation and a line for each option."""
    summary = (styler.__doc__ or "").strip().splitlines()
    lines = [f"{styler.name}: {summary[0]}" if summary else styler.name]
    options = options_of(styler)
    widths = [
        max((len(text) for text in column), default=0)
        for column in zip(*((o.name, o.show(o.default), o.allowed) for o in options), strict=True)
    ]
    for option in options:
        cells = (option.name, option.show(option.default), option.allowed)
        padded = (cell.ljust(width) for cell, width in zip(cells, widths, strict=True))
        lines.append(f"  {'  '.join(padded)}  {option.help}")
    return "\n".join(lines)
