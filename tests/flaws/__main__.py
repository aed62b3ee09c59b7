"""`python -m tests.flaws OUT [--write]`: each flaw of the paper's method, before and after, side by
side; with --write into docs/pictures/flaws and docs/measurements/flaws.md."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from glshim.outputs.gl.backend import Backend
from tests import look
from tests.flaws.render import both
from tests.flaws.scenes import FURTHER, SCENES, SIZE, Scene

ROOT = Path(__file__).resolve().parents[2]
_SHOWN = 380
"""Pixels of one picture, square."""
_GAP, _HEAD = 8, 20


def side_by_side(scene: Scene, frames: tuple[np.ndarray, np.ndarray]) -> Image.Image:
    """Before and after with their captions, the scene's crop enlarged in whole steps."""
    left, top, right, bottom = scene.crop
    step = max(_SHOWN // max(right - left, bottom - top), 1)
    wide, high = (right - left) * step, (bottom - top) * step
    sheet = Image.new("RGB", (2 * wide + _GAP, high + _HEAD), "white")
    pen = ImageDraw.Draw(sheet)
    font = ImageFont.load_default(13)
    for k, (frame, caption) in enumerate(
        zip(frames, ("before: the paper as printed", "after: style raskar"), strict=True)
    ):
        part = Image.fromarray(np.ascontiguousarray(frame[::-1])).crop(scene.crop)
        x = k * (wide + _GAP)
        sheet.paste(part.resize((wide, high), Image.Resampling.NEAREST), (x, _HEAD))
        pen.text((x + 2, 2), caption, "black", font)
    pen.rectangle((wide, 0, wide + _GAP - 1, high + _HEAD), "#888888")
    return sheet


def save(sheet: Image.Image, path: Path) -> None:
    """A small PNG: few shades of grey need few colours."""
    sheet.convert("L").quantize(32).save(path, optimize=True)


def document(scenes: list[Scene]) -> str:
    """docs/measurements/flaws.md."""
    parts = [
        "# Flaws of the paper's method, before and after",
        "Left: Raskar 2001, sections 2.1 and 2.2, to the letter (`tests/flaws/paper.py`). "
        "Right: style `raskar`. One command draws and measures both, and "
        "`tests/golden/test_flaws.py` checks that each measure is 0 on the right and not on the "
        "left.",
        "    python -m tests.flaws out/flaws --write",
    ]
    for scene in scenes:
        parts += [
            f"## {scene.title[0].upper()}{scene.title[1:]}",
            scene.sentence,
            f"![before and after](../pictures/flaws/{scene.name}.png)",
        ]
    return "\n\n".join(parts) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m tests.flaws")
    parser.add_argument("out", type=Path)
    parser.add_argument("--write", action="store_true", help="into docs, too")
    parser.add_argument("--further", action="store_true", help="scenes that docs do not show, too")
    options = parser.parse_args()
    folders = [options.out] + [ROOT / "docs" / "pictures" / "flaws"] * options.write
    scenes = [make() for make in (*SCENES, *FURTHER * options.further)]
    with look.window(SIZE, SIZE):
        backend = Backend.attach()
        for scene in scenes:
            before, flawed, after, cured = both(backend, scene)
            sheet = side_by_side(scene, (before, after))
            for folder in folders if scene.sentence else folders[:1]:
                folder.mkdir(parents=True, exist_ok=True)
                save(sheet, folder / f"{scene.name}.png")
            bytes_ = (folders[0] / f"{scene.name}.png").stat().st_size
            print(f"{scene.name:10} before {scene.faults(flawed):8.1f}  "
                  f"after {scene.faults(cured):8.1f}  {bytes_:,} bytes")  # fmt: skip
    if options.write:
        page = ROOT / "docs" / "measurements" / "flaws.md"
        page.write_text(document(scenes[: len(SCENES)]), "utf-8")


if __name__ == "__main__":
    main()
