"""The contact sheet: pictures in a grid with captions, as one PNG."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from glshim.outputs.wrapping import wrapped
from glshim.running.gallery.tiles import Tile
from glshim.system.writing import write_picture

_WIDTH = 400
"""Pixels of a picture on the sheet."""
_MARGIN, _GAP = 32, 24
_NAME, _TEXT = 19, 14
_PAPER, _INK, _DIM, _RED = "#f6f5f2", "#1c1c1e", "#6c6c70", "#b3261e"


def write_contact_sheet(path: Path, title: str, tiles: Sequence[Tile], columns: int) -> None:
    """Write the tiles as one picture. Raises OSError where it cannot be written."""
    pictures = [None if tile.fault else Image.open(tile.picture).convert("RGB") for tile in tiles]
    shapes = [picture.height / picture.width for picture in pictures if picture]
    height = round(_WIDTH * max(shapes, default=0.75))
    cell = (_WIDTH + _GAP, height + 78 + _GAP)
    columns = min(columns, len(tiles))
    rows = -(-len(tiles) // columns)
    top = _MARGIN + 52
    size = (2 * _MARGIN + columns * cell[0] - _GAP, top + rows * cell[1] - _GAP + _MARGIN)
    sheet = Image.new("RGB", size, _PAPER)
    pen = ImageDraw.Draw(sheet)
    pen.text((_MARGIN, _MARGIN - 6), title, _INK, ImageFont.load_default(28))
    for number, (tile, picture) in enumerate(zip(tiles, pictures, strict=True)):
        x = _MARGIN + number % columns * cell[0]
        y = top + number // columns * cell[1]
        if picture is None:
            pen.rectangle((x, y, x + _WIDTH - 1, y + height - 1), outline=_RED, width=2)
            box = (x + 12, y + 12, _WIDTH - 24)
            _paragraph(pen, box, tile.fault, _RED, most=max(height // 20 - 2, 1))
        else:
            low = round(_WIDTH * picture.height / picture.width)
            sheet.paste(picture.resize((_WIDTH, low), Image.Resampling.LANCZOS), (x, y))
        _paragraph(pen, (x, y + height + 8, _WIDTH), tile.name, _INK, most=1, size=_NAME)
        _paragraph(pen, (x, y + height + 34, _WIDTH), tile.summary, _DIM, most=2)
    write_picture(path, sheet, optimize=True)


def _paragraph(
    pen: ImageDraw.ImageDraw, box: tuple[int, int, int], text: str, colour: str, *, most: int,
    size: int = _TEXT,
) -> None:  # fmt: skip
    """Text from a place on, in lines of a width, and no more of them than there may be."""
    x, y, width = box
    font = ImageFont.load_default(size)
    lines = wrapped(" ".join(text.split()), lambda line: pen.textlength(line, font), width)
    shown = lines[:most]
    if len(lines) > most or pen.textlength(shown[-1], font) > width:
        shown[-1] += " ..."
    for number, line in enumerate(shown):
        fitting = line
        while pen.textlength(fitting, font) > width:
            fitting = fitting.removesuffix("...")[:-1].rstrip(" ,:;(") + "..."
        pen.text((x, y + number * (size + 4)), fitting, colour, font)
