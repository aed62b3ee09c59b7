"""The gallery's page: one HTML file beside the folder of its pictures, with no scripts from
elsewhere. `compare` is a page with two pictures and a slider between them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from urllib.parse import quote

from PIL import Image

from glshim.running.gallery.tiles import Row, Tile
from glshim.styling.categories import CATEGORIES
from glshim.system.writing import write_html


def write_page(path: Path, title: str, tiles: Sequence[Tile], columns: int, sheet: Path) -> None:
    """Write the page of all tiles; sheet: the contact sheet, which it links to."""
    failed = sum(bool(tile.fault) for tile in tiles)
    count = f"{len(tiles)} styles" if len(tiles) != 1 else "1 style"
    counts = Counter(word for tile in tiles for word in tile.categories)
    _write(
        path, "page.html", title=escape(title), columns=str(columns),
        sheet=_link(sheet, path), count=count + (f", {failed} failed" if failed else ""),
        filters="\n".join(
            f'<button type="button" aria-pressed="false" value="{escape(word)}" '
            f'title="{escape(CATEGORIES.get(word, word))}">{escape(word)} '
            f"<small>{counts[word]}</small></button>"
            for word in sorted(counts, key=[*CATEGORIES, *counts].index)
        ),
        tiles="\n".join(_figure(tile, path) for tile in tiles),
    )  # fmt: skip


def write_comparison(path: Path, title: str, tiles: Sequence[Tile]) -> None:
    """Write a page with a slider between two tiles."""
    left, right = tiles
    width, height = Image.open(left.picture).size
    _write(
        path, "compare.html", title=escape(title), width=str(width), height=str(height),
        left=_link(left.picture, path), right=_link(right.picture, path),
        left_alt=escape(left.description), right_alt=escape(right.description),
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
            f'alt="{escape(tile.description)}" loading="lazy"></a>'
        )
    notes = "".join(f'<p class="note">{escape(note)}</p>' for note in tile.notes[:3])
    words = escape(" ".join(tile.categories))
    tags = "".join(f"<li>{escape(word)}</li>" for word in tile.categories)
    return (
        f'<figure id="{escape(quote(tile.name))}" data-categories="{words}">{shown}'
        f"<figcaption><h2>{name}</h2><p>{escape(tile.summary)}</p>{notes}"
        + (f'<ul class="tags" aria-label="categories">{tags}</ul>' if tags else "")
        + _details(tile)
        + "</figcaption></figure>"
    )


def _details(tile: Tile) -> str:
    """The options, which are read on demand."""
    if tile.source:
        inside = f"<pre>{escape(tile.source)}</pre>"
    elif tile.rows:
        inside = f"<dl>{''.join(map(_row, tile.rows))}</dl>"
    else:
        return ""
    count = f" ({len(tile.rows)})" if tile.rows and not tile.source else ""
    return f"<details><summary>options{count}</summary>{inside}</details>"


def _row(row: Row) -> str:
    changed = row.value != row.default
    default = f"; default: {row.default}" if changed else ""
    return (
        f"<dt{' class=changed' if changed else ''}><code>{escape(row.name)}</code> "
        f"<code>{escape(row.value)}</code></dt>"
        f"<dd>{escape(row.help)} <small>({escape(row.allowed + default)})</small></dd>"
    )


def _link(target: Path, page: Path) -> str:
    return escape(quote(target.relative_to(page.parent).as_posix()))


def _write(path: Path, template: str, **values: str) -> None:
    folder = files(__package__)
    look = (folder / "look.css").read_text("utf-8")
    text = (folder / template).read_text("utf-8")
    write_html(path, Template(text).substitute(values, look=look))
