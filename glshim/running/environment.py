"""The GLSHIM_* variables that people set: what each does, and how they are read."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from glshim.control.keys import KEYS, LiveSettings, parse_keys, parse_styles
from glshim.control.pictures import NAME
from glshim.errors import StyleError, shown
from glshim.styling.texts import anchored

STYLE, FRAMES, CAPTURE = "GLSHIM_STYLE", "GLSHIM_FRAMES", "GLSHIM_CAPTURE"
STYLES, SAVE = "GLSHIM_STYLES", "GLSHIM_SAVE"
_MOST_TEXT = 1000
"""Characters of a number, at most: the zeros before it."""
_MOST_NAME = 250
"""Bytes of a file's name, at most; file systems allow 255, and numbers grow."""


@dataclass(frozen=True, slots=True)
class Settings:
    """What the environment asks for; None where it asks for nothing."""

    style: str | None = None
    """A style's text."""
    frames: int | None = None
    """End the program after so many presented frames."""
    capture: str | None = None
    """Where to write each frame: an absolute path with one ``%d`` for its number, or none."""
    live: LiveSettings | None = None
    """What keys do while the program runs."""


def read(environ: Mapping[str, str], folder: str = "") -> tuple[Settings, tuple[str, ...]]:
    """The settings, and a line for each variable that cannot be used (and then counts as unset).
    Relative paths are taken from the folder."""
    values: dict[str, Any] = {}
    complaints: list[str] = []
    for variable in VARIABLES:
        text = environ.get(variable.name, "")
        if not text.strip() or (variable.needs and values.get(variable.needs) is None):
            continue
        try:
            values[variable.name] = variable.parse(text, folder)
        except StyleError as error:
            complaints.append(f"{variable.name}: {error}; {variable.otherwise}")
    keys, live = values.get(KEYS), None
    if keys is not None:
        save = values.get(SAVE) or os.path.abspath(folder)
        live = LiveSettings(keys, values.get(STYLES, ()), save)
    settings = Settings(values.get(STYLE), values.get(FRAMES), values.get(CAPTURE), live)
    return settings, tuple(complaints)


def parse_frames(text: str, folder: str = "") -> int:
    """A whole number of frames, at least 1. Raises `StyleError`."""
    if not re.fullmatch(r"\s*0*[1-9][0-9]{0,17}\s*", text) or len(text) > _MOST_TEXT:
        raise StyleError(
            f"'{shown(text)}' is not a valid frame count: give a whole number from 1, "
            "of at most 18 digits"
        )
    return int(text)


def parse_capture(text: str, folder: str = "") -> str:
    """A file name, made absolute, with at most one ``%d`` or ``%03d``. Raises `StyleError`."""
    rest = re.sub("%0?[0-9]{0,2}d", "1", text, count=1)
    if "%" in rest or Path(rest).suffix.lower() != ".png":
        raise StyleError(
            f"'{shown(text)}' is not a valid file name for frames: it must end in .png "
            "and may contain one %d or %03d for the number of the frame"
        )
    if len(os.fsencode(os.path.basename(rest))) > _MOST_NAME:
        raise StyleError(f"'{shown(text)}' is too long for a file name")
    return os.path.abspath(os.path.join(folder, text))


def _style(text: str, folder: str) -> str:
    """Not parsed yet: that loads stylers."""
    return anchored(text.strip(), folder)


def _text(text: str, folder: str) -> str:
    return text.strip()


def _folder(text: str, folder: str) -> str:
    return os.path.abspath(os.path.join(folder, os.path.expanduser(text)))


@dataclass(frozen=True, slots=True)
class Variable:
    """One variable."""

    name: str
    example: str
    """A value, for people."""
    help: str
    """What it does."""
    parse: Callable[[str, str], Any]
    """Its value, of a text that is not blank and the folder that paths are taken from. Raises
    `StyleError`."""
    otherwise: str = ""
    """What happens where it raises."""
    needs: str = ""
    """The variable that it goes with; empty: it starts glshim by itself."""


VARIABLES = (
    Variable(STYLE, "STYLE", "restyles the program", _style),
    Variable(FRAMES, "N", "ends the program with status 0 after N presented frames", parse_frames,
             "the number of frames is not limited"),
    Variable(CAPTURE, "out%03d.png", "saves each presented frame; numbers start at 1",
             parse_capture, "no frames are saved"),
    Variable(KEYS, "on", "live control with keys", parse_keys, "live control is off"),
    Variable(STYLES, "A,B", "styles that the keys step through", parse_styles,
             "the keys step through all styles", needs=KEYS),
    Variable(SAVE, "FOLDER", "folder for pictures saved with a key", _folder, needs=KEYS),
    Variable(NAME, "NAME", "name of these pictures (default: the name of the program)", _text,
             needs=KEYS),
)  # fmt: skip
"""All of them. Those that need no other are named in ``_glshim_start.py`` and ``glshim.pth``, too,
which import nothing."""
