"""The polygons and cameras of a program's frames, whose clocks stand still while one is drawn."""

from __future__ import annotations

import pickle
import runpy
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar

from glshim.model.batch import Item
from glshim.running.headless import headless_environment
from glshim.styling.protocol import Layer, Styler

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Recorder(Styler):
    """Draws nothing, and keeps the lowest layer of each frame in a file."""

    name: ClassVar[str] = "recorder"
    out: Path = Path()
    frames: list[tuple[Item, ...]] = field(default_factory=list)
    keys: dict[Any, int] = field(default_factory=dict)

    @property
    def wants_normals(self) -> bool:
        return True

    def draws(self, layer: Layer) -> Iterable[Any]:
        if not layer.over:
            self.frames.append(tuple(
                (replace(batch, key=self._number(batch.key)), camera)
                for batch, camera in layer.items
            ))  # fmt: skip
            self.out.write_bytes(pickle.dumps(self.frames))
        return ()

    def _number(self, key: Any) -> tuple[str, int] | None:
        return None if key is None else ("recorded", self.keys.setdefault(key, len(self.keys)))

    def __post_init__(self) -> None:
        """These are no options."""


def recorded(program: Path, frames: int) -> list[tuple[Item, ...]]:
    """Of so many frames of a program, which runs in a process of its own."""
    with headless_environment() as environ, tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "frames.pickle")
        own = {"GLSHIM_STYLE": "none", "GLSHIM_STILL": "1", "GLSHIM_FRAMES": str(frames),
               "PYTHONPATH": str(ROOT)}  # fmt: skip
        done = subprocess.run(
            [sys.executable, "-m", "tests.coherence.record", str(out), str(program)],
            env={**environ, **own}, cwd=ROOT, capture_output=True, text=True, timeout=300,
            check=False,
        )  # fmt: skip
        if not out.exists():
            raise RuntimeError(f"{program} was not recorded: {done.stderr[-2000:]}")
        found: list[tuple[Item, ...]] = pickle.loads(out.read_bytes())
    return found


def main(out: str, program: str) -> None:
    from OpenGL import GL  # noqa: F401 (glshim begins where it is imported)

    import glshim
    from tests.coherence.record import Recorder  # not of __main__, which the program becomes

    glshim.install(Recorder(Path(out)))
    sys.argv = [program]
    sys.path[0] = str(Path(program).parent)
    runpy.run_path(program, run_name="__main__")


if __name__ == "__main__":
    main(*sys.argv[1:])
