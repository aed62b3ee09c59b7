"""Style texts and style files, each to one checked styler."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from glshim.errors import StyleError, UnknownNameError, shown
from glshim.styling import fromfile, registry
from glshim.styling.composite import Composite
from glshim.styling.lookup import targets
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Styler
from glshim.styling.registry import FILE
from glshim.styling.stylefiles import EXTENDS, StyleFileError, read_style_file

MOST_FILES = 16
"""Style files that extend each other, at most."""
MOST_PARTS = 8
"""Styles that are put together, at most."""
_ASSIGNMENT = re.compile(r"[\w.]+\s*=")
_PLUS = re.compile(
    r"\+(?=\s*(?:[^\W\d]\w*\s*(?:[:+]|\Z)|[^+,;=]*\.toml\s*(?:\+|\Z)|[^+,;=]*\.py\s*:))"
)
"""Between styles, and not within the path of a picture."""
_BEGINS = re.compile(r"[^\W\d]\w*\s*(?::|\Z)|[^+,;=]*(?:\.toml\Z|\.py\s*:)")


def parse_style(
    text: str, folder: str = "", files: list[Path] | None = None, chain: tuple[Path, ...] = ()
) -> Styler:
    """A name, the path of a style file (TOML), or a class in a Python file, the first and the last
    with options after it: ``name:key=value,key=value``, ``my_style.py:MyStyle:key=value``. A name
    is a style's, or a look's: that of an installed style file. Paths in a text are taken from the
    folder, those in a file from where that lies. Several with ``+`` between them are put together
    (`Composite`).

    files: receives every file that the style depends on, even if the text is not valid.
    chain: the style files that extend this text, the outermost first.
    Raises `StyleError` with one line that says what is wrong and names the nearest valid word.
    """
    text = text.strip()
    files = [] if files is None else files
    _require_printable(text)
    parts = parts_of(text, folder)
    if len(parts) > 1:
        return together(parse_style(part, folder, files, chain) for part in parts)
    if text.endswith(FILE):
        return load_style(Path(folder, text), files, chain)
    if fromfile.is_named_in(text):
        path, name, assignments = fromfile.split(text)
        styler = _load(f"{path}:{name}", folder, files)()
    else:
        name, _, assignments = text.partition(":")
        look = registry.look(name.strip())
        styler = load_style(look, files, chain) if look else _load(name.strip(), folder, files)()
    stylers = _parts(styler)
    values: list[dict[str, Any]] = [{} for _ in stylers]
    for piece in filter(str.strip, assignments.split(",")):
        for number, found in _parsed([*map(type, stylers)], piece, folder):
            values[number] |= found
    return together(map(changed, stylers, values))


def load_style(
    path: Path, files: list[Path] | None = None, chain: tuple[Path, ...] = ()
) -> Styler:
    """A style file: ``style = "raskar"``, or ``extends`` and any style text, or several, and a line
    for every option that is not what it is there.

    Raises `StyleError` naming the file, and the line where there is one.
    """
    files = [] if files is None else files
    files.append(path)
    file = read_style_file(path)
    key, names = file.base
    if key == EXTENDS:
        chain = (*chain, path)
        if len(chain) > MOST_FILES:
            raise StyleError(f"{path}: more than {MOST_FILES} style files extend each other")
        for part in (part for name in names for part in parts_of(name, file.folder)):
            if part.isprintable() and any(_same(Path(file.folder, part), each) for each in chain):
                raise file.fault((key,), f"extends {part}, which extends this file: a circle")
        try:
            base = together(parse_style(name, file.folder, files, chain) for name in names)
        except StyleFileError as error:
            raise StyleFileError(f"{error} (extended by {path}:{file.line((key,))})") from error
        except StyleError as error:
            raise file.fault((key,), str(error)) from error
    else:
        try:
            base = _load(names[0], file.folder, files)()
        except StyleError as error:
            raise file.fault((key,), str(error)) from error
    try:
        stylers = _parts(base)
        return together(map(changed, stylers, file.options(*map(type, stylers))))
    except StyleFileError:
        raise
    except StyleError as error:  # values that are fine alone
        raise StyleFileError(f"{path}: {error}") from error


def together(stylers: Iterable[Styler]) -> Styler:
    """One styler as it is; of several what `Composite` makes of them."""
    parts = tuple(part for styler in stylers for part in _parts(styler))
    if len(parts) > MOST_PARTS:
        raise StyleError(f"more than {MOST_PARTS} styles are put together")
    return parts[0] if len(parts) == 1 else Composite(parts)


def changed(styler: Styler, values: Mapping[str, Any]) -> Styler:
    """A styler with other values of some options, by today's names. A value for all lines (``ink``,
    ``width``) undoes those that were set for some of them before, unless they are given, too.
    Raises `StyleError`."""
    undone = {
        option.name: None
        for option in options_of(type(styler))
        if option.follows in values and getattr(styler, option.name) is not None
    }
    try:
        return replace(styler, **{**undone, **values})
    except StyleError:
        raise
    except Exception as error:  # the constructor of somebody's styler
        line = " ".join(str(error).splitlines())
        raise StyleError(
            f"style {styler.name!r} does not take these options: {type(error).__name__}: {line}"
        ) from error


def parts_of(text: str, folder: str = "") -> list[str]:
    """The style texts that a text puts together with ``+``; one of none such, and of a path that
    has this character."""
    if "+" not in text or _is_file(text, folder):
        return [text]
    first, _, rest = text.partition("+")
    whole = [first.strip(), rest.strip()] if _is_file(rest, folder) else _PLUS.split(text)
    parts = [part.strip() for part in whole]
    return parts if all(_BEGINS.match(part) or _is_file(part, folder) for part in parts) else [text]


def _is_file(text: str, folder: str) -> bool:
    return is_path(text) and os.path.isfile(os.path.join(folder, text.strip()))


def _parts(styler: Styler) -> tuple[Styler, ...]:
    return styler.parts if isinstance(styler, Composite) else (styler,)


def with_options(styler: Styler, options: Mapping[str, Any], folder: str = "") -> Styler:
    """A styler with other values of options, by name or as tables of features: values as Python has
    them, or as texts. Raises `StyleError`."""
    if not options:
        return styler
    stylers = _parts(styler)
    kinds = [*map(type, stylers)]
    values: list[dict[str, Any]] = [{} for _ in stylers]
    for name, given in options.items():
        table = given if isinstance(given, Mapping) else {"": given}
        for rest, value in table.items():
            for number, target in targets(kinds, (name, rest) if rest else (name,)):
                values[number] |= target.values(partial(_taken, value, folder))
    return together(map(changed, stylers, values))


def split_styles(text: str) -> list[str]:
    """The style texts of a list: ``raskar; sketch:width=3,ink=#ff0000, mine.toml``.

    A semicolon parts two, and so does a comma, unless ``option=value`` follows it, which goes on
    with the options before. Reading a list loads nothing: the texts may be of no use.
    Raises `StyleError` for options that follow no style's options.
    """
    found: list[str] = []
    for part in text.split(";"):
        begins = True
        for piece in filter(None, map(str.strip, part.split(","))):
            if begins or not _ASSIGNMENT.match(piece):
                found.append(piece)
            elif has_options(found[-1]):
                found[-1] += "," + piece
            elif is_path(piece):
                found.append(piece)
            elif found[-1].endswith(FILE):
                raise StyleError(f"{piece} follows {found[-1]}: options go into the file")
            else:
                raise StyleError(f"{piece} follows {found[-1]}: write {found[-1]}:{piece}")
            begins = False
    return found


def has_options(text: str) -> bool:
    """Whether a style text has come to its options, perhaps none of them yet."""
    if fromfile.is_named_in(text):
        return text.count(":", len(os.path.splitdrive(text)[0])) > 1
    return ":" in text


def anchored(text: str, folder: str) -> str:
    """A style text whose paths, if it has some, are taken from the folder."""
    parts = parts_of(text, folder)
    return "+".join(os.path.join(folder, part) if is_path(part) else part for part in parts)


def is_path(text: str) -> bool:
    """Whether a style text is a style file, or begins with a Python file."""
    return text.endswith(FILE) or fromfile.is_named_in(text)


def name_of(text: str) -> str:
    """What a style text is called: its file without the ending, its class, or its first word."""
    parts = parts_of(text)
    if len(parts) > 1:
        return "+".join(map(name_of, parts))
    if text.endswith(FILE):
        return Path(text).stem
    path, name, _ = fromfile.split(text)
    return name if fromfile.is_named_in(text) else path.strip()


def _require_printable(text: str) -> None:
    """Raises `StyleError`."""
    if not text.isprintable():
        raise StyleError(
            f"'{shown(text)}' is not a style: it holds characters that are not printable"
        )


def _same(one: Path, other: Path) -> bool:
    return os.path.realpath(one) == os.path.realpath(other)


def _load(name: str, folder: str, files: list[Path]) -> type[Styler]:
    """A class by its name, or by that of a Python file and its own."""
    _require_printable(name)
    if fromfile.is_named_in(name):
        path, word, assignments = fromfile.split(name)
        whole = Path(folder, path)
        files.extend(fromfile.watched(whole))
        if assignments:
            raise StyleError(f"{name}: the options have lines of their own in a style file")
        return fromfile.load(whole, word)
    try:
        return registry.load(name)
    except UnknownNameError as error:
        if registry.look(name):
            raise StyleError(f'{name} is a look: write {EXTENDS} = "{name}"') from error
        if os.path.isfile(name):  # (never raises, unlike Path's)
            raise StyleError(
                f"{name} is a file: a style file is given alone, as NAME.toml"
            ) from error
        raise


def _parsed(
    stylers: list[type[Styler]], piece: str, folder: str
) -> Iterator[tuple[int, dict[str, Any]]]:
    """What ``key=value`` gives each styler that knows the key, by number."""
    key, equals, value = (part.strip() for part in piece.partition("="))
    for number, target in targets(stylers, tuple(key.split("."))):
        if not equals:
            option = target.options[0]
            raise StyleError(f"{key} has no value: write {key}={option.show(option.default)}")
        yield number, target.values(partial(_read, value, folder))


def _read(value: str, folder: str, option: Option) -> Any:
    return option.parse(value, folder)


def _taken(value: Any, folder: str, option: Option) -> Any:
    read = option.parse if isinstance(value, str) else option.check
    return read(value, folder)
