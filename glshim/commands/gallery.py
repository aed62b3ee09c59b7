"""The command ``glshim gallery``.

Exit status: 0; 1 where some style has no picture (its tile says why); 2 for a command that makes no
sense; 130 after Ctrl-C.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path
from typing import Any

from glshim.errors import EnvironmentFault, StyleError
from glshim.notices import say
from glshim.running import subjects
from glshim.running.gallery.runs import Run, run_all, styled
from glshim.running.gallery.sheet import Tile
from glshim.styling import registry, texts

PLAIN = "none"
_SECONDS = 180.0


def add_command(commands: Any) -> None:
    """Add it to the subparsers."""
    parser = commands.add_parser(
        "gallery", help="run a program once per style and show all pictures",
        usage="glshim gallery [options] (SCRIPT | -m MODULE | MODEL) [ARGS...] [-o OUT.html]",
    )  # fmt: skip
    subjects.add_arguments(parser)
    parser.add_argument(
        "-o", "--output", default="gallery.html", metavar="OUT.html",
        help="the page; OUT.png is the contact sheet (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument("--styles", metavar="A,B,...", help="only these (default: all)")
    parser.add_argument(
        "--compare", nargs=2, metavar=("A", "B"), help="a page with a slider between two styles"
    )
    parser.add_argument("--columns", type=int, default=4, metavar="N", help="pictures in a row")
    parser.add_argument(
        "--timeout", type=float, default=_SECONDS, metavar="SECONDS",
        help="for each run (default: %(default)g)",
    )  # fmt: skip
    parser.set_defaults(command=run)


def run(asked: argparse.Namespace) -> int:
    """Make the gallery; its exit status."""
    from tqdm import tqdm

    from glshim.running.gallery.page import write_comparison, write_page
    from glshim.running.gallery.sheet import write_sheet

    subject, frame = subjects.subject_of(asked), subjects.frame_of(asked)
    chosen = asked.compare or split_styles(asked.styles or "")
    texts = chosen or all_styles()
    styles, unusable = _checked(texts, tolerant=not chosen)
    if asked.columns < 1 or not asked.timeout > 0:
        raise EnvironmentFault("--columns and --timeout are greater than zero")
    page = Path(asked.output).absolute()
    if page.suffix.lower() not in (".html", ".htm"):
        raise EnvironmentFault(f"{asked.output!r} is no name for a page: it ends in .html")
    folder = page.with_name(page.stem + "_files")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        runs = [
            styled(text, style, frame, folder / name)
            for text, style, name in zip(texts, styles, _file_names(texts), strict=True)
            if text not in unusable
        ]
        with tqdm(total=len(runs), desc=subject.title, unit="style") as bar:

            def done(ended: Run) -> None:
                bar.set_postfix_str(ended.name)
                bar.update()

            tiles = [_tile(ended) for ended in run_all(subject.command, runs, asked.timeout, done)]
        tiles += [Tile(text, "", "", folder / "none", fault) for text, fault in unusable.items()]
        sheet = page.with_suffix(".png")
        write_sheet(sheet, subject.title, tiles, asked.columns)
        failed = [tile for tile in tiles if tile.fault]
        if asked.compare and not failed:
            write_comparison(page, subject.title, tiles)
        else:
            write_page(page, subject.title, tiles, asked.columns, sheet)
    except KeyboardInterrupt:
        say(f"stopped; the pictures made so far are in {folder}")
        return 130
    except OSError as error:
        raise EnvironmentFault(f"cannot write the gallery {page}: {error}") from error
    for tile in failed:
        say(f"{tile.name}: {tile.fault}")
    print(page)
    return 1 if failed else 0


def _checked(texts: list[str], *, tolerant: bool) -> tuple[list[str], dict[str, str]]:
    """The styles as `GLSHIM_STYLE` takes them; when tolerant, what is wrong with those that cannot
    be had: one that is installed and does not load is a tile without a picture."""
    styles, unusable = [], {}
    for text in texts:
        try:
            styles.append(subjects.style_variable(text))
        except StyleError as error:
            if not tolerant:
                raise
            styles.append(text)
            unusable[text] = str(error)
    return styles, unusable


def all_styles() -> list[str]:
    """Every installed style and look, the program's own picture first."""
    return list(dict.fromkeys((PLAIN, *registry.names(), *registry.looks())))


def split_styles(text: str) -> list[str]:
    """``a,b:key=value,key=value,c`` in styles: a piece with ``=`` and no ``:`` goes on with the
    options of the style before it."""
    found: list[str] = []
    for piece in text.split(","):
        if found and ":" in found[-1] and re.match(r"\s*\w+\s*=", piece):
            found[-1] += "," + piece
        elif piece.strip():
            found.append(piece.strip())
    return found


def _file_names(texts: list[str]) -> list[str]:
    """A file name for each style, all different."""
    names: list[str] = []
    for text in texts:
        stem = re.sub(r"[^\w.-]+", "_", Path(text).name if text.endswith(".toml") else text)
        stem = stem.strip("._")[:60] or "style"
        count = sum(name.rpartition("~")[0] == stem or name == stem + ".png" for name in names)
        names.append(f"{stem}~{count + 1}.png" if count else f"{stem}.png")
    return names


def _tile(ended: Run) -> Tile:
    name = ended.name.partition(":")[0].strip()
    details, summary = "", ""
    if name in registry.looks():
        details = texts.describe_look(name)
    elif not name.endswith(".toml"):
        details = texts.describe(registry.load(name))
    first, _, details = details.partition("\n")
    summary = first.partition(": ")[2]
    if name.endswith(".toml"):
        try:
            details = Path(name).read_text(encoding="utf-8")
        except OSError as error:
            raise StyleError(f"cannot read style file {name!r}: {error}") from error
        summary = texts.load_style(Path(name)).name
    if ended.name == PLAIN:
        name, summary, details = "plain", "The program's own picture.", ""
    else:
        name = ended.name
    return Tile(name, summary, details, ended.picture, ended.fault, ended.notes)
