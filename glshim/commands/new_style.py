"""``glshim new-style``: a commented file to begin a style of one's own with."""

from __future__ import annotations

import argparse
import json
import keyword
import os
import shlex
import sys
import textwrap
from importlib.util import find_spec
from pathlib import Path
from typing import ClassVar

from glshim.commands.command import DEFAULT_STYLE, Command
from glshim.errors import EnvironmentFault, StyleError
from glshim.styling import texts
from glshim.styling.composite import Composite
from glshim.styling.options import Option, options_of
from glshim.styling.protocol import Styler
from glshim.styling.registry import FILE

_PYTHON = ".py"
_MODULE = '''\
"""A style of your own.

    glshim run --style FILE:CLASS your_app.py
    glshim view --style FILE:CLASS teapot      # a model, or a built-in shape
    glshim check-style FILE:CLASS              # validates it

While a program runs, save this file: the style is read again.
The guide: docs/guide/writing_a_styler.md in the repository of glshim.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import radians
from typing import ClassVar

from glshim import Colour, Features, Layer, Lines, Styler, ink, option


@dataclass(frozen=True)
class CLASS(Styler):
    """Outlines, and finer lines on creases."""  # `glshim styles` shows this line

    name: ClassVar[str] = "NAME"

    # Options: FILE:CLASS:ink=#203040,width=4
    # The default decides the kind: a colour, a number, True or False, a word of choices=(...).
    ink: Colour = option("#1a1a2e", help="colour of the lines")
    width: float = option(3.0, help="width of outlines", low=0.5, high=64, unit="px")
    creases: bool = option(True, help="draw lines on ridges and in valleys")
    crease_angle: float = option(
        40.0, help="smallest bend drawn as a crease", low=1, high=180, unit="degrees"
    )

    def draws(self, layer: Layer) -> Iterable[Lines]:
        """What to draw over a finished layer: all that the program drew into one depth buffer.

        No OpenGL here, and nothing that changes from call to call: equal layers, equal lines.
        """
        # Which lines: edges of the meshes in the layer, by kind. Angles are in radians.
        bend = radians(self.crease_angle)
        creases = Features(ridge_angle=radians(180) - bend, valley_angle=radians(180) + bend)
        outlines = Features(contours=True, boundary=True)

        # What they are drawn with. Also in glshim: dashes, pencil, brush, hand.
        # A line in a later coat lies over those of earlier coats.
        if self.creases:
            yield Lines(layer.bodies, creases, ink(0.5 * self.width, self.ink), coat=0)
        yield Lines(layer.bodies, outlines, ink(self.width, self.ink), coat=1)

        # For paper and effects on the whole picture yield a Pass: see the recipes in the guide.
'''
_SETTINGS = '''\
# A style of your own: STYLE with other options
#
#     glshim run --style FILE your_app.py
#     glshim view --style FILE teapot      # a model, or a built-in shape
#     glshim check-style FILE              # validates it
#
# While a program runs, save this file: it is read again.
# Below are all options with the values that they have in this style. To change one, remove the #
# before its name. `glshim styles` lists the styles that a file may extend.

extends = "STYLE"

'''


class NewStyle(Command):
    """Exit status: 0, or 2 where the file is there already or cannot be written."""

    name: ClassVar[str] = "new-style"
    help: ClassVar[str] = "write a commented file to start a style of your own"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument(
            "style", metavar="NAME", help="name of the style; NAME.py is written, or NAME.toml"
        )
        parser.add_argument(
            "--toml", action="store_true",
            help="write a style file, which sets options of another style, instead of Python",
        )  # fmt: skip
        parser.add_argument(
            "--extends", metavar="STYLE",
            help=f"style that the file starts from (default: {DEFAULT_STYLE}); implies --toml",
        )  # fmt: skip

    def run(self, asked: argparse.Namespace) -> int:
        """Write it, and say how to run it."""
        given = Path(asked.style)
        is_toml = asked.toml or asked.extends is not None or given.suffix == FILE
        suffix = FILE if is_toml else _PYTHON
        stem = given.stem if given.suffix in (FILE, _PYTHON) else given.name
        name = stem.replace("-", "_")
        path = given.with_name(name + suffix)
        _require_name(name, stem, is_module=not is_toml and not path.exists())
        if is_toml:
            style, text = str(path), settings(str(path), asked.extends or DEFAULT_STYLE)
        else:
            kind = "".join(part.capitalize() for part in name.split("_"))
            style = f"{path}:{kind}"
            text = _MODULE.replace("FILE", str(path)).replace("CLASS", kind).replace("NAME", name)
        _write(path, text)
        print(f"wrote {path}")
        style = shlex.quote(style)
        print(f"  run a program  glshim run --style {style} your_app.py")
        print(f"  view a model   glshim view --style {style} teapot")
        print(f"  validate it    glshim check-style {style}")
        return 0


def settings(path: str, style: str) -> str:
    """The text of a style file that extends a style, with all of its options in comments. Raises
    `StyleError`."""
    styler = texts.parse_style(style)
    parts = styler.parts if isinstance(styler, Composite) else (styler,)
    lines: dict[str, str] = {}
    for part in parts:
        for option in options_of(type(part)):
            line = _line(option, part)
            # One line is for all parts: where they differ, none says what they have.
            lines[option.name] = line if lines.get(option.name, line) == line else ""
    text = _SETTINGS.replace("STYLE", style).replace("FILE", path)
    return text + "\n".join(filter(None, lines.values()))


def _line(option: Option, styler: Styler) -> str:
    shown = option.show(getattr(styler, option.name))
    if option.kind == "switch":
        shown = "true" if shown == "on" else "false"
    elif option.kind not in ("number", "integer") or getattr(styler, option.name) is None:
        shown = json.dumps(shown)
    told = textwrap.fill(
        f"{option.help} ({option.allowed})", 100, initial_indent="#   ", subsequent_indent="#   "
    )
    return f"{told}\n# {option.name} = {shown}\n"


def _require_name(name: str, typed: str, *, is_module: bool) -> None:
    """Raises `StyleError` for what no style, or no file beside programs, can be called."""
    if not (name.isascii() and name.isidentifier()) or keyword.iskeyword(name):
        raise StyleError(f"{typed!r} is not a valid name: use letters, digits and _, as ink_lines")
    if is_module and (name in sys.stdlib_module_names or find_spec(name) is not None):
        raise StyleError(
            f"{name!r} is the name of a Python module: programs that import it would get this file "
            "instead; choose another name"
        )


def _write(path: Path, text: str) -> None:
    try:
        with path.open("x", encoding="utf-8") as file:  # never over another
            file.write(text)
    except FileExistsError:
        raise EnvironmentFault(
            f"{os.fspath(path)} exists already and is left as it is: choose another name"
        ) from None
    except OSError as error:
        raise EnvironmentFault(f"cannot write {path}: {error.strerror or error}") from error
