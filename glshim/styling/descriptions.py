"""Styles and looks for people: what they are, and their options."""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from glshim.errors import StyleError
from glshim.styling import registry
from glshim.styling.composite import Composite
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Styler
from glshim.styling.registry import FILE
from glshim.styling.stylefiles import read_text
from glshim.styling.texts import load_style, name_of, parse_style, parts_of

_WIDTH = 100
"""Characters of a line, at most."""


def of_styler(styler: type[Styler]) -> str:
    """A style: its first line of documentation, and its options with defaults and ranges. Those
    that several kinds of lines have of their own share a row."""
    summary = (styler.__doc__ or "").strip().splitlines()
    lines = [f"{styler.name}: {summary[0]}" if summary else styler.name]
    options = options_of(styler)
    kinds = {option.name: _kind(option) for option in options}
    rows = [
        (option.name, option.show(option.default), f"{option.help} [{option.allowed}]")
        for option in options
        if not kinds[option.name]
    ]
    wide, deep = (max((len(row[k]) for row in rows), default=0) for k in (0, 1))
    for name, default, text in rows:
        lines += _row(f"{name:{wide}}  {default:{deep}}", text)
    parts: dict[str, list[str]] = {}
    for option in options:
        if kinds[option.name]:
            parts.setdefault(kinds[option.name], []).append(option.follows)
    alike: dict[tuple[str, ...], list[str]] = {}
    for kind, own in parts.items():
        alike.setdefault(tuple(own), []).append(kind)
    for shared, some in alike.items():
        names = ", ".join(f"KIND_{part}" for part in shared)
        lines += _row(names, f"of one kind of lines: {', '.join(some)} (auto: as of all lines)")
    return "\n".join(lines)


def _kind(option: Option) -> str:
    """The kind of lines whose own option this is, empty where it is that of no kind."""
    ending = f"_{option.follows}"
    return option.name.removesuffix(ending) if option.name.endswith(ending) else ""


def _row(begins: str, text: str) -> list[str]:
    """A row, gone on with below where it is long."""
    return textwrap.wrap(
        text, _WIDTH, initial_indent=f"  {begins}  ", subsequent_indent=" " * (len(begins) + 4),
        break_long_words=False,
    )  # fmt: skip


def of_look(name: str) -> str:
    """A look: the first line of its file, and the text that says the same."""
    path = registry.look(name)
    assert path is not None
    styler = load_style(path)
    summary = read_text(path).partition("\n")[0].lstrip("# ")
    return f"{name}: {summary}\n  {styler.name}:{','.join(changed_options(styler))}"


def summary(name: str) -> str:
    """What is installed under a name, in a few words: without its source, which stands in
    brackets; what is wrong with it where it cannot be loaded."""
    try:
        first = of_name(name).partition("\n")[0].removeprefix(name).lstrip(": ")
    except StyleError as error:
        return f"cannot be loaded: {error}"
    return re.sub(r"\s*\([^()]*\)", "", first).rstrip(".")


def of_name(name: str) -> str:
    """What is installed under a name. Raises `StyleError`."""
    return of_look(name) if registry.look(name) else of_styler(registry.load(name))


def of_text(text: str) -> tuple[str, str]:
    """A style text: one line that says what it is, and several about its options, or its file.
    Raises `StyleError`."""
    parts = parts_of(text)
    if len(parts) > 1:
        each = [(name_of(part), *of_text(part)) for part in parts]
        lined = " and ".join(name for name, *_ in each[1:])
        more = "\n".join(f"{name}: {what}\n{options}" for name, what, options in each)
        return f"surfaces of {each[0][0]}, lines of {lined}", more
    name = text.partition(":")[0].strip()
    if text.endswith(FILE):
        try:
            return load_style(Path(text)).name, read_text(Path(text))
        except OSError as error:
            raise StyleError(f"cannot read style file {text!r}: {error}") from error
    known = name in registry.names() or registry.look(name)
    told = of_name(name) if known else of_styler(type(parse_style(text)))
    first, _, details = told.partition("\n")
    return first.partition(": ")[2], details


def changed_options(styler: Styler) -> list[str]:
    """``ink=#ff0000``: the options that are not their defaults."""
    if isinstance(styler, Composite):
        return [text for part in styler.parts for text in changed_options(part)]
    return [
        f"{each.name}={each.show(getattr(styler, each.name))}"
        for each in options_of(type(styler))
        if getattr(styler, each.name) != each.default
    ]
