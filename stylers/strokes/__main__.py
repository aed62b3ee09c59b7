"""``python -m stylers.strokes OUT [WIDTH]``: the textures of figure 6 of McGuire & Hughes 2004.

Writes one PNG a texture, black on white paper, the outside on top, which the option `texture` takes
as it is; and `sheet.png`, two repeats of each, one below the other.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from stylers.strokes import MADE, made

_ACROSS = 1024
"""Pixels across the sheet."""


def on_paper(name: str, width: float) -> NDArray[np.uint8]:
    """(H, W) a texture in black on white."""
    ink = made(name, width, 0.0)[0].pixels[..., 3]
    return np.asarray(255 - ink, np.uint8)


def sheet(width: float) -> Image.Image:
    """Every texture at its own size, as often as it fits, with room around it."""
    high, room = max(round(width), 1), round(0.5 * width) + 8
    paper = Image.new("L", (_ACROSS, (high + room) * len(MADE) + room), 255)
    for row, name in enumerate(MADE):
        length = max(round(made(name, width, 0.0)[1]), 1)
        one = Image.fromarray(on_paper(name, width)).resize((length, high), Image.Resampling.BOX)
        for at in range(0, _ACROSS, length):
            paper.paste(one, (at, room + row * (high + room)))
    return paper


def main(folder: str, width: float) -> None:
    out = Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    for name in MADE:
        Image.fromarray(on_paper(name, width)).save(out / f"{name}.png")
    sheet(width).save(out / "sheet.png")


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 48.0)
