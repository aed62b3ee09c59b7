"""The tiles of a gallery: a picture in a style, and what is said of it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from glshim.errors import StyleError
from glshim.running.gallery.runs import Run
from glshim.styling import descriptions

PLAIN = "none"


@dataclass(frozen=True, slots=True)
class Tile:
    """One picture of a gallery."""

    name: str
    summary: str
    details: str
    """The options, as text of several lines."""
    picture: Path
    fault: str = ""
    """Why there is no picture; empty when there is."""
    notes: tuple[str, ...] = ()


def tile(ended: Run) -> Tile:
    """Of a run in a style, which is called by its text."""
    if ended.name == PLAIN:
        name, summary, details = "plain", "The program's own picture.", ""
    else:
        name = ended.name
        try:
            summary, details = descriptions.of_text(name)
        except StyleError as error:  # its file was changed since the runs began
            summary, details = str(error), ""
    return Tile(name, summary, details, ended.picture, ended.fault, ended.notes)


def file_names(texts: Sequence[str]) -> list[str]:
    """A file name for each style, all different."""
    names: list[str] = []
    for text in texts:
        stem = re.sub(r"[^\w.-]+", "_", Path(text).name if text.endswith(".toml") else text)
        stem = stem.strip("._")[:60] or "style"
        count = sum(name.rpartition("~")[0] == stem or name == stem + ".png" for name in names)
        names.append(f"{stem}~{count + 1}.png" if count else f"{stem}.png")
    return names
