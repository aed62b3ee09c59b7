"""The tiles of a gallery: a picture in a style, and what is said of it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from glshim.errors import StyleError
from glshim.running.gallery.runs import Run
from glshim.styling import descriptions
from glshim.styling.categories import categories_of
from glshim.styling.composite import Composite
from glshim.styling.options import options_of
from glshim.styling.protocol import Styler
from glshim.styling.registry import FILE
from glshim.styling.stylefiles import read_text
from glshim.styling.texts import parse_style

PLAIN = "none"


@dataclass(frozen=True, slots=True)
class Row:
    """One option, for people."""

    name: str
    value: str
    """Here."""
    default: str
    """What it is unless a style says otherwise."""
    allowed: str
    help: str


@dataclass(frozen=True, slots=True)
class Tile:
    """One picture of a gallery."""

    name: str
    """The style's text."""
    summary: str
    picture: Path
    program: str = ""
    """What is shown."""
    categories: tuple[str, ...] = ()
    """Of `glshim.styling.categories`."""
    rows: tuple[Row, ...] = ()
    source: str = ""
    """The style file, where it is one of the user's."""
    fault: str = ""
    """Why there is no picture; empty when there is."""
    notes: tuple[str, ...] = ()

    @property
    def description(self) -> str:
        """For those who do not see the picture."""
        if self.name == PLAIN:
            return f"{self.program} without a style"
        summary = f": {self.summary}" if self.summary else ""
        return f"{self.program} in style {self.name}{summary}"


def tile(ended: Run, program: str) -> Tile:
    """Of a run in a style, which is called by its text."""
    name, styler, source = ended.name, None, ""
    try:
        summary, _ = descriptions.of_text(name)
        styler = parse_style(name)
        source = read_text(Path(name)) if name.endswith(FILE) else ""
    except (StyleError, OSError) as error:  # its file was changed since the runs began
        summary = str(error)
    if name == PLAIN:
        summary = "The program's own picture."
    return Tile(
        name, summary, ended.picture, program,
        categories_of(styler) if styler is not None else (),
        rows_of(styler) if styler is not None else (), source, ended.fault, ended.notes,
    )  # fmt: skip


def rows_of(styler: Styler) -> tuple[Row, ...]:
    """The options of a style, those that are not their defaults first."""
    if isinstance(styler, Composite):
        return tuple(row for part in styler.parts for row in rows_of(part))
    found = [
        Row(each.name, each.show(getattr(styler, each.name)), each.show(each.default),
            each.allowed, each.help)
        for each in options_of(type(styler))
    ]  # fmt: skip
    return tuple(sorted(found, key=lambda row: row.value == row.default))


def file_names(texts: Sequence[str]) -> list[str]:
    """A file name for each style, all different."""
    names: list[str] = []
    for text in texts:
        stem = re.sub(r"[^\w.-]+", "_", Path(text).name if text.endswith(".toml") else text)
        stem = stem.strip("._")[:60] or "style"
        count = sum(name.rpartition("~")[0] == stem or name == stem + ".png" for name in names)
        names.append(f"{stem}~{count + 1}.png" if count else f"{stem}.png")
    return names
