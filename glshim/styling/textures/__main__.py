"""``python -m glshim.styling.textures OUT [WIDTH]``: figure 6 of McGuire & Hughes 2004.

Writes one PNG a texture, black on white paper, the outside on top, which the option `texture` takes
as it is; and `sheet.png` with all of them at WIDTH pixels (48), one below the other.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from glshim.styling.textures import MADE, made

_ACROSS = 1024
"""Pixels across the sheet."""


def on_paper(name: str, width: float) -> NDArray[np.uint8]:
    """(H, W) a texture in black on white."""
    ink = made(name, width, 0.0)[0].pixels[..., 3]
    return np.asarray(255 - ink, np.uint8)


def sheet(width: float) -> Image.Image:
    """Every texture at its own size, repeated, with room around it; on top those of the figure, in
    its order."""
    high, room = max(round(width), 1), round(0.5 * width) + 8
    paper = Image.new("L", (_ACROSS, (high + room) * len(MADE) + room), 255)
    for row, name in enumerate(reversed(MADE)):
        length = max(round(made(name, width, 0.0)[1]), 1)
        one = Image.fromarray(on_paper(name, width)).resize((length, high), Image.Resampling.BOX)
        for at in range(0, _ACROSS, length):
            paper.paste(one, (at, room + row * (high + room)))
    return paper


def main() -> None:
    program = "python -m glshim.styling.textures"
    parser = argparse.ArgumentParser(prog=program, description="Writes PNGs.")
    parser.add_argument("out", type=Path, help="folder")
    parser.add_argument("width", type=float, nargs="?", default=48.0, help="of a line, in pixels")
    given = parser.parse_args()
    if not 0.5 <= given.width <= 256.0:
        parser.error("the width lies between 0.5 and 256 pixels")
    given.out.mkdir(parents=True, exist_ok=True)
    for name in MADE:
        Image.fromarray(on_paper(name, given.width)).save(given.out / f"{name}.png")
    sheet(given.width).save(given.out / "sheet.png")


if __name__ == "__main__":
    main()
