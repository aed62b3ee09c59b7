"""The gallery's page: one HTML file beside the folder of its pictures, with no scripts from
elsewhere. `compare` is a page with two pictures and a slider between them."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from urllib.parse import quote

from PIL import Image

from glshim.running.gallery.tiles import Tile
from glshim.system.writing import write_html


def write_page(path: Path, title: str, tiles: Sequence[Tile], columns: int, sheet: Path) -> None:
    """Write the page of all tiles; sheet: the contact sheet, which it links to."""
    failed = sum(bool(tile.fault) for tile in tiles)
    count = f"{len(tiles)} styles" if len(tiles) != 1 else "one style"
    _write(
        path, "page.html", title=escape(title), columns=str(columns),
        sheet=_link(sheet, path), count=count + (f", {failed} failed" if failed else ""),
        tiles="\n".join(_figure(tile, path) for tile in tiles),
    )  # fmt: skip


def write_comparison(path: Path, title: str, tiles: Sequence[Tile]) -> None:
    """Write a page with a slider between two tiles."""
    left, right = tiles
    width, height = Image.open(left.picture).size
    _write(
        path, "compare.html", title=escape(title), width=str(width), height=str(height),
        left=_link(left.picture, path), right=_link(right.picture, path),
        left_name=escape(left.name), right_name=escape(right.name),
        tiles="\n".join(_figure(tile, path) for tile in tiles),
    )  # fmt: skip


def _figure(tile: Tile, page: Path) -> str:
    name = escape(tile.name)
    if tile.fault:
        shown = f'<p class="fault" role="alert">{escape(tile.fault)}</p>'
    else:
        link = _link(tile.picture, page)
        width, height = Image.open(tile.picture).size
        shown = (
            f'<a href="{link}"><img src="{link}" width="{width}" height="{height}" '
            f'alt="{name}" loading="lazy"></a>'
        )
    notes = "".join(f'<p class="note">{escape(note)}</p>' for note in tile.notes[:3])
    details = ""
    if tile.details:
        details = f"<details><summary>options</summary><pre>{escape(tile.details)}</pre></details>"
    return (
        f'<figure id="{escape(quote(tile.name))}">{shown}<figcaption><h2>{name}</h2>'
        f"<p>{escape(tile.summary)}</p>{notes}{details}</figcaption></figure>"
    )


def _link(target: Path, page: Path) -> str:
    return escape(quote(target.relative_to(page.parent).as_posix()))


def _write(path: Path, template: str, **values: str) -> None:
    folder = files(__package__)
    look = (folder / "look.css").read_text("utf-8")
    text = (folder / template).read_text("utf-8")
    write_html(path, Template(text).substitute(values, look=look))
