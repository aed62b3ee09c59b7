"""``glshim gallery``: one program under many styles, on a page."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import ClassVar

from glshim.commands.command import Command
from glshim.errors import EnvironmentFault, StyleError
from glshim.notices import say
from glshim.running import subjects
from glshim.running.gallery.runs import MOST_JOBS, Run, jobs_here, run_all, styled
from glshim.running.gallery.tiles import PLAIN, Tile, file_names, tile
from glshim.styling import registry, texts
from glshim.system.writing import PAGES, PICTURES, picture_target

_SECONDS = 180.0


class Gallery(Command):
    """Exit status: 0; 1 where some style has no picture (its tile says why); 2 for a command that
    makes no sense; 130 after Ctrl-C."""

    name: ClassVar[str] = "gallery"
    help: ClassVar[str] = "run a program in every style and put the pictures on a page"
    usage: ClassVar[str | None] = (
        "glshim gallery [options] (SCRIPT | -m MODULE | MODEL) [ARGS...] [-o OUT.html]"
    )

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        subjects.add_arguments(parser)
        parser.add_argument(
            "-o", "--output", default="gallery.html", metavar="OUT.html",
            help="page to write; OUT.png is a contact sheet (default: %(default)s)",
        )  # fmt: skip
        parser.add_argument(
            "--styles", metavar="A,B,...", help="limit to these styles (default: all)"
        )
        parser.add_argument(
            "--compare", nargs=2, metavar=("A", "B"), help="compare two styles with a slider"
        )
        parser.add_argument(
            "--columns", type=int, default=4, metavar="N",
            help="pictures per row (default: %(default)s)",
        )  # fmt: skip
        parser.add_argument(
            "-j", "--jobs", type=int, metavar="N",
            help=f"runs at the same time (default: one per processor, at most {MOST_JOBS})",
        )  # fmt: skip
        parser.add_argument(
            "--timeout", type=float, default=_SECONDS, metavar="SECONDS",
            help="time limit for each run (default: %(default)g)",
        )  # fmt: skip

    def run(self, asked: argparse.Namespace) -> int:
        """Make the gallery."""
        from tqdm import tqdm

        from glshim.running.gallery.contact_sheet import write_contact_sheet
        from glshim.running.gallery.page import write_comparison, write_page

        subject, frame = subjects.subject_of(asked), subjects.frame_of(asked)
        chosen = asked.compare or texts.split_styles(asked.styles or "")
        names = chosen or all_styles()
        styles, unusable = _checked(names, tolerant=not chosen)
        jobs = jobs_here() if asked.jobs is None else asked.jobs
        if min(asked.columns, jobs) < 1 or not asked.timeout > 0:
            raise EnvironmentFault("--columns, --jobs and --timeout must be greater than zero")
        page = Path(asked.output).absolute()
        if page.suffix.lower() not in (".html", ".htm"):
            raise EnvironmentFault(f"{asked.output!r} is not a page: its name must end in .html")
        folder, sheet = page.with_name(page.stem + "_files"), page.with_suffix(".png")
        for path, beginnings in ((page, PAGES), (sheet, PICTURES)):
            try:  # now, not after all runs
                picture_target(path, beginnings)
            except OSError as error:
                raise EnvironmentFault(f"cannot write {path}: {error}") from error
        try:
            folder.mkdir(parents=True, exist_ok=True)
            runs = [
                styled(text, style, frame, folder / name)
                for text, style, name in zip(names, styles, file_names(names), strict=True)
                if text not in unusable
            ]
            with tqdm(total=len(runs), desc=subject.title, unit="style") as bar:

                def done(ended: Run) -> None:
                    bar.set_postfix_str(ended.name)
                    bar.update()

                ended = run_all(subject.command, runs, asked.timeout, done, jobs)
            tiles = [tile(run, subject.title) for run in ended]
            tiles += [
                Tile(text, "", folder / "none", subject.title, fault=why)
                for text, why in unusable.items()
            ]
            write_contact_sheet(sheet, subject.title, tiles, asked.columns)
            failed = [each for each in tiles if each.fault]
            if asked.compare and not failed:
                write_comparison(page, subject.title, tiles)
            else:
                write_page(page, subject.title, tiles, asked.columns, sheet)
        except KeyboardInterrupt:
            say(f"interrupted; the pictures made so far are in {folder}")
            return 130
        except OSError as error:
            raise EnvironmentFault(f"cannot write the gallery {page}: {error}") from error
        for each in failed:
            say(f"{each.name}: {each.fault}")
        print(page)
        return 1 if failed else 0


def _checked(names: list[str], *, tolerant: bool) -> tuple[list[str], dict[str, str]]:
    """The styles as `GLSHIM_STYLE` takes them; when tolerant, what is wrong with those that cannot
    be had: one that is installed and does not load is a tile without a picture."""
    styles, unusable = [], {}
    for text in names:
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
