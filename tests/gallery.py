"""``python -m tests.gallery OUT [NUMBER ...]``: the pictures of the bundled demos, as README and
docs/guide/gallery.md show them.

Writes for each numbered program the page and the contact sheet that ``glshim gallery`` makes,
``sheets/NAME.png`` (the sheet with 256 colours and half as large, for the repository), and
``demos.png``: every program once, each in another style.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).parent.parent
STYLES = ("none", "sketch", "blueprint", "brush", "pencil", "cartoon", "technical", "hiddenline",
          "raskar", "edge_mesh", "crease", "fins")  # fmt: skip
FRAME = 8
SHOWN = {
    "01_gears": "cartoon", "02_solar_system": "pencil", "03_robot_arm": "technical",
    "04_molecule": "brush", "05_terrain": "sketch", "06_chess": "pencil",
    "07_cad_part": "blueprint", "08_figure": "cartoon", "09_gcode": "hiddenline",
    "10_textured_room": "sketch",
}  # fmt: skip
TILE, ACROSS = (320, 240), 5


def programs() -> list[Path]:
    """The numbered ones."""
    return sorted((ROOT / "demo_apps").glob("[0-9][0-9]_*.py"))


def picture(out: Path, program: str, style: str) -> Path:
    """Where ``glshim gallery`` wrote one."""
    return out / f"{program}_files" / f"{style}.png"


def small(path: Path, target: Path, share: float = 0.6) -> None:
    """The same with 256 colours, that share as wide."""
    whole = Image.open(path).convert("RGB")
    size = round(whole.width * share), round(whole.height * share)
    reduced = whole.resize(size, Image.Resampling.LANCZOS).quantize(256, dither=Image.Dither.NONE)
    target.parent.mkdir(parents=True, exist_ok=True)
    reduced.save(target, optimize=True)


def demos(out: Path) -> None:
    """``demos.png``."""
    width, height = TILE
    names = [program.stem for program in programs()]
    sheet = Image.new("RGB", (width * ACROSS, height * -(-len(names) // ACROSS)))
    for number, name in enumerate(names):
        tile = Image.open(picture(out, name, SHOWN[name])).convert("RGB").resize(TILE)
        sheet.paste(tile, (number % ACROSS * width, number // ACROSS * height))
    sheet.quantize(256, dither=Image.Dither.NONE).save(out / "demos.png", optimize=True)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.gallery", description="Writes PNGs.")
    parser.add_argument("out", type=Path, help="folder")
    parser.add_argument("numbers", nargs="*", metavar="NUMBER", help="only these programs, e.g. 01")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    for program in programs():
        if given.numbers and program.name[:2] not in given.numbers:
            continue
        page = given.out / f"{program.stem}.html"
        status = subprocess.call(
            [sys.executable, "-m", "glshim", "gallery", str(program), "-o", str(page),
             "--frame", str(FRAME), "--columns", "4", "--styles", ",".join(STYLES)], cwd=ROOT)
        if status:
            return status
        small(page.with_suffix(".png"), given.out / "sheets" / f"{program.stem}.png")
    if not given.numbers:
        demos(given.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
