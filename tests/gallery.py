"""``python -m tests.gallery OUT [NUMBER ...]``: the pictures of the bundled demos, as README and
docs/guide/demos.md show them.

Writes for each numbered program the page and the contact sheet that ``glshim gallery`` makes,
``sheets/NAME.png`` (the sheet with 256 colours, smaller, for the repository), and
``demos.png``: every program once, each in another style.

``python -m tests.gallery docs/pictures --front`` writes README's own pictures, taken by ``glshim
shot``: ``front.png``, a program plain and restyled, and ``front/STYLE.png``.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
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
BESIDE = ("08_figure", ("none", "pen_and_ink"))
"""The program of ``front.png``, and its styles from left to right."""
FRONT = ("07_cad_part", ("blueprint", "sketch", "cartoon", "watercolour"))
SCALE = 2


def programs() -> list[Path]:
    """The numbered ones."""
    return sorted((ROOT / "demo_apps").glob("[0-9][0-9]_*.py"))


def picture(out: Path, program: str, style: str) -> Path:
    """Where ``glshim gallery`` wrote one."""
    return out / f"{program}_files" / f"{style}.png"


def save_small(whole: Image.Image, target: Path, share: float = 0.6) -> None:
    """Write a picture with 256 colours, that share as wide."""
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


def taken(folder: Path, program: str, style: str) -> Image.Image:
    """A shot of a program, drawn larger and reduced: lines without steps."""
    path = folder / f"{program}-{style}.png"
    subprocess.run(
        [sys.executable, "-m", "glshim", "shot", f"demo_apps/{program}.py", "--style", style,
         "--frame", str(FRAME), "--scale", str(SCALE), "-o", str(path)], cwd=ROOT, check=True)
    return Image.open(path).convert("RGB")


def front(out: Path) -> None:
    """README's pictures."""
    (out / "front").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        program, styles = BESIDE
        pair = [taken(Path(name), program, style) for style in styles]
        wide = Image.new("RGB", (sum(each.width for each in pair), pair[0].height))
        for number, each in enumerate(pair):
            wide.paste(each, (number * each.width, 0))
        save_small(wide, out / "front.png", 0.7 / SCALE)
        program, styles = FRONT
        for style in styles:
            save_small(taken(Path(name), program, style), out / f"front/{style}.png", 0.7 / SCALE)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.gallery", description="Writes PNGs.")
    parser.add_argument("out", type=Path, help="folder")
    parser.add_argument("numbers", nargs="*", metavar="NUMBER", help="only these programs, e.g. 01")
    parser.add_argument("--front", action="store_true", help="README's own pictures, no others")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    if given.front:
        front(given.out)
        return 0
    for program in programs():
        if given.numbers and program.name[:2] not in given.numbers:
            continue
        page = given.out / f"{program.stem}.html"
        status = subprocess.call(
            [sys.executable, "-m", "glshim", "gallery", str(program), "-o", str(page),
             "--frame", str(FRAME), "--columns", "4", "--styles", ",".join(STYLES)], cwd=ROOT)
        if status:
            return status
        sheet = Image.open(page.with_suffix(".png")).convert("RGB")
        save_small(sheet, given.out / "sheets" / f"{program.stem}.png")
    if not given.numbers:
        demos(given.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
