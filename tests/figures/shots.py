"""Pictures of unmodified programs under glshim, and sheets of them."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).parents[2]
DEMOS = ROOT / "demo_apps"
GAP = 8


@cache
def shot(style: str, *program: str, frames: int = 3) -> Image.Image:
    """The last of so many frames of a program in a style; it is run as ``glshim run`` runs it.
    Each is taken once."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "frame.png"
        command = [sys.executable, "-m", "glshim", "run", "--style", style, "--frames", str(frames),
                   "--capture", str(path), *program]  # fmt: skip
        environ = {**os.environ, "PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path[1:]])}
        done = subprocess.run(
            command, cwd=ROOT, env=environ, capture_output=True, text=True, timeout=120, check=False
        )
        if done.returncode or not path.exists():
            raise RuntimeError(f"{style} of {' '.join(program)}: {done.stderr.strip()[-2000:]}")
        return Image.open(path).convert("RGB")


def sheet(tiles: Sequence[Image.Image], columns: int) -> Image.Image:
    """Pictures of one size side by side on white."""
    width, height = tiles[0].size
    rows = -(-len(tiles) // columns)
    size = (columns * (width + GAP) - GAP, rows * (height + GAP) - GAP)
    found = Image.new("RGB", size, "white")
    for k, tile in enumerate(tiles):
        found.paste(tile, ((k % columns) * (width + GAP), (k // columns) * (height + GAP)))
    return found
