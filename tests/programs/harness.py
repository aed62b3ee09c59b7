"""Runs a program under one of the modes and compares what it presented."""

import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from .catalog import HERE, Program
from .sources import Launch, cache_folder, launch

PLAIN = None  # no style: glshim is not there at all
ROOT = HERE.parent.parent  # of the glshim that these tests are about, wherever another is installed
Picture = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class Run:
    """What one run presented: pictures of (height, width, 3) uint8, first to last."""

    pictures: tuple[Picture, ...]
    log: str
    status: int
    shimmed: bool = False  # whether glshim was at work in the program's process

    def same_as(self, other: "Run") -> bool:
        return len(self.pictures) == len(other.pictures) > 0 and all(
            np.array_equal(a, b) for a, b in zip(self.pictures, other.pictures, strict=True))

    def changed_pixels(self, other: "Run") -> int:
        """The most pixels that differ in one frame; -1 where the runs cannot be compared."""
        if len(self.pictures) != len(other.pictures) or not self.pictures:
            return -1
        counts = [-1 if a.shape != b.shape else int((a != b).any(axis=2).sum())
                  for a, b in zip(self.pictures, other.pictures, strict=True)]
        return -1 if -1 in counts else max(counts)

    def save(self, path: Path) -> Path | None:
        """Write the last picture as PNG."""
        if not self.pictures:
            return None
        path.parent.mkdir(parents=True, exist_ok=True)
        Image.fromarray(self.pictures[-1]).save(path)
        return path

    def fault(self) -> str:
        """The last line of the log where the run failed, else nothing."""
        if self.status == 0 and self.pictures:
            return ""
        if self.status < 0:
            return f"ended by signal {-self.status}"
        lines = self.log.strip().splitlines()
        return lines[-1] if lines else f"status {self.status}, nothing presented"


def environment(style: str | None, display: str, start: Launch,
                seed: str = "") -> dict[str, str]:
    home = cache_folder() / f"home{display}"  # empty, and the same in every run
    shutil.rmtree(home, ignore_errors=True)
    if seed:
        shutil.copytree(seed, home)
    home.mkdir(parents=True, exist_ok=True)
    kept = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    kept |= {
        "DISPLAY": display,
        "PYTHONHASHSEED": "0",
        "PYTHONFAULTHANDLER": "1",
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONPATH": os.pathsep.join(map(str, (ROOT, *start.paths))),
        "LD_LIBRARY_PATH": os.pathsep.join(map(str, start.libraries)),
        "TCLLIBPATH": str(start.tcl or ""),
        "HOME": str(home),
        "QT_QPA_PLATFORM": "xcb",
        "SDL_AUDIODRIVER": "dummy",
        "SDL_VIDEODRIVER": "x11",
        "SDL_MOUSE_RELATIVE": "0",
        "PYGAME_HIDE_SUPPORT_PROMPT": "1",
    }
    if style is not PLAIN:
        kept["GLSHIM_STYLE"] = style
    return kept


def run(program: Program, style: str | None, display: str, limit: float = 60.0,
        start: Launch | None = None) -> Run:
    """Run the program until it has presented its frames; `style` None leaves glshim out. `start`
    says how where its source does not."""
    start = start or launch(program)
    with tempfile.TemporaryDirectory() as scratch:
        out = Path(scratch) / "frames.npz"
        log = Path(scratch) / "log"
        with log.open("w") as stream:
            try:
                runner = [sys.executable, str(HERE / "frozen.py"), str(out), str(program.frames)]
                status = subprocess.run(
                    [*runner, *start.command], cwd=start.folder,
                    env=environment(style, display, start, program.home),
                    stdin=subprocess.DEVNULL, stdout=stream, stderr=subprocess.STDOUT,
                    timeout=limit, check=False).returncode
            except subprocess.TimeoutExpired:
                status = 124
                stream.write(f"\nended after {limit:.0f} s\n")
        pictures: tuple[Any, ...] = ()
        shimmed = False
        if out.exists():
            with np.load(out) as saved:
                pictures = tuple(saved[name] for name in saved.files if name != "shimmed")
                shimmed = bool(saved["shimmed"])
        return Run(pictures, log.read_text(errors="replace"), status, shimmed)
