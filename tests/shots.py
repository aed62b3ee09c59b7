"""`python -m tests.shots [OUT]`: shots of demo programs in every style, whole, in tiles, and large.

For each a row: how far the shot, three times as large and boxed down again, is from the program's
own frame (levels of a channel, mean), and how many pixels differ between the shot drawn at once and
the same in tiles (in all, and by more than 24 levels). Then a picture of 5000 pixels a side.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np
from PIL import Image

from glshim.commands.gallery import all_styles
from glshim.errors import StyleError
from glshim.styling.texts import parse_style

PROGRAMS = ("demo_apps.07_cad_part", "demo_apps.06_chess", "demo_apps.08_figure")
LARGE = (5000, 5000)


def pixels(path):
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


def shot(out, module, style, *options):
    """The picture and what was said about it."""
    done = subprocess.run(
        [sys.executable, "-m", "glshim", "shot", "-m", module, "--style", style, "-o", str(out),
         *map(str, options)], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{module}, {style}: {done.stderr.strip()}")
    return pixels(out), done.stderr.strip()


def usable(style):
    try:
        parse_style(style)
    except StyleError as error:
        print(f"left out: {error}", file=sys.stderr)
        return False
    return True


def main() -> None:
    out = Path(sys.argv[1] if len(sys.argv) > 1 else "out/shots")
    out.mkdir(parents=True, exist_ok=True)
    print("| program | style | x3, boxed: off by | tiles: unlike | by more than 24 | said |")
    print("|---|---|--:|--:|--:|---|")
    for module in PROGRAMS:
        for style in filter(usable, all_styles()):
            name = out / f"{module.rpartition('.')[2]}-{style}"
            plain, _ = shot(f"{name}-1.png", module, style, "--scale", 1)
            whole, _ = shot(f"{name}-3.png", module, style, "--scale", 3)
            tiled, said = shot(f"{name}-3-tiles.png", module, style, "--scale", 3, "--tile", 700)
            height, width, _ = plain.shape
            off = np.abs(whole.reshape(height, 3, width, 3, 3).mean(axis=(1, 3)) - plain).mean()
            apart = np.abs(whole - tiled).max(axis=2)
            print(f"| {module} | {style} | {off:.2f} | {(apart > 0).sum()} | {(apart > 24).sum()} "
                  f"| {said.partition(':')[2].strip()[:40]} |", flush=True)
    size = "{}x{}".format(*LARGE)
    large, said = shot(out / "large.png", PROGRAMS[0], "watercolour", "--size", size)
    assert large.shape == (LARGE[1], LARGE[0], 3)
    print(f"\n{out / 'large.png'}: {size}; {said}")


if __name__ == "__main__":
    main()
