"""Reference pictures: demo programs in style raskar, small, with a frozen clock.

They are compared to the pixel where the same Mesa drew them, and looked at for what must hold
anywhere else. `python -m tests.golden.update` rewrites them; look at each before you keep it.
"""

from __future__ import annotations

import dataclasses
import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from tests.programs.catalog import OURS, Program
from tests.programs.harness import PLAIN, run

FOLDER = Path(__file__).with_name("stored")
RECORD = FOLDER / "renderer.json"
SIZE = (320, 240)
STYLE = "raskar:ink=#e8641b,silhouette_width=3,ridge_width=2,ridge_angle=120,intersections=on"
UNPAINTED = (  # see test_animated_meshes, test_chess, test_numbered_demos
    "viewer", "08_figure", "bending_arm", "06_chess", "01_gears", "02_solar_system",
    "04_molecule", "05_terrain", "09_gcode", "10_textured_room",
)  # fmt: skip
VIEWER_SHAPES = ("torus", "cube", "knot", "bowl")

_ASK = """
import glfw, json
from OpenGL import GL
glfw.init()
glfw.window_hint(glfw.VISIBLE, False)
window = glfw.create_window(16, 16, "ask", None, None)
glfw.make_context_current(window)
print(json.dumps({name: GL.glGetString(getattr(GL, name)).decode()
                  for name in ("GL_RENDERER", "GL_VERSION")}))
"""

Picture = NDArray[np.uint8]


@cache
def renderer(display: str) -> dict[str, str]:
    """GL_RENDERER and GL_VERSION of the display."""
    environment = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    done = subprocess.run([sys.executable, "-c", _ASK], env=environment | {"DISPLAY": display},
                          capture_output=True, text=True, check=True)  # fmt: skip
    found: dict[str, str] = json.loads(done.stdout.splitlines()[-1])
    return found


def programs() -> dict[str, Program]:
    """What is painted, by the name of its picture."""
    found = {p.name.rpartition("/")[2]: p for p in OURS}
    found = {name: program for name, program in found.items() if name not in UNPAINTED}
    viewer = next(p for p in OURS if p.name.endswith("viewer"))
    for shape in VIEWER_SHAPES:
        found[f"viewer_{shape}"] = dataclasses.replace(viewer, arguments=(shape,))
    return found


def painted(program: Program, display: str, style: str | None) -> Picture:
    """The middle of the program's last picture: cut, not scaled, so that lines keep their width."""
    result = run(program, style, display)
    assert not result.fault(), result.log
    picture = result.pictures[-1]
    top, left = (picture.shape[0] - SIZE[1]) // 2, (picture.shape[1] - SIZE[0]) // 2
    return picture[max(top, 0) :, max(left, 0) :][: SIZE[1], : SIZE[0]]


def stored(name: str) -> Picture:
    return np.asarray(Image.open(FOLDER / f"{name}.png").convert("RGB"))


def recorded() -> dict[str, str]:
    found: dict[str, str] = json.loads(RECORD.read_text(encoding="utf-8"))
    return found


def update(display: str) -> list[Path]:
    """Rewrite all pictures and the record of what drew them."""
    FOLDER.mkdir(exist_ok=True)
    written = []
    for name, program in programs().items():
        path = FOLDER / f"{name}.png"
        Image.fromarray(painted(program, display, STYLE)).save(path, optimize=True)
        written.append(path)
    RECORD.write_text(json.dumps(renderer(display), indent=1) + "\n", encoding="utf-8")
    return written


def plain(program: Program, display: str) -> Picture:
    return painted(program, display, PLAIN)
