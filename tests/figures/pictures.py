"""Figures 1, 7, 8 and 11 of McGuire & Hughes 2004 made again, of programs and meshes of our own."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from PIL import Image

from tests.figures.rabbit import write_rabbit
from tests.figures.shots import DEMOS, sheet, shot

LOOKS = ("pen_and_ink", "charcoal", "anime", "watercolour")
"""The order of figure 7."""
_VIEW = ("-m", "demo_apps.viewer", "--wait")
_UNTEXTURED = "edge_mesh:ridges=off,valleys=off,smooth=on"
_FURRY = "edge_mesh:ridges=off,valleys=off,texture=cartoon_fur,contour_width=26"


@contextmanager
def rabbit() -> Iterator[str]:
    """The path of a rabbit's head."""
    with tempfile.TemporaryDirectory() as folder:
        yield str(write_rabbit(Path(folder) / "rabbit.ply"))


def figure1() -> list[Image.Image]:
    """Hidden lines, realistic fur, shadow volumes, cartoon fur."""
    middle, arm = (80, 0, 560, 480), (150, 0, 630, 480)
    with rabbit() as head:
        return [
            shot("hiddenline:hidden=dashed", *_VIEW, "gear").crop(middle),
            shot("fur", *_VIEW, head).crop(middle),
            shot("shadow", str(DEMOS / "03_robot_arm.py"), frames=14).crop(arm),
            shot("cartoon_fur", *_VIEW, head).crop(middle),
        ]


def figure7() -> list[Image.Image]:
    """The four looks of one model, in the order of `LOOKS`."""
    program = str(DEMOS / "08_figure.py")
    return [shot(look, program, frames=14).crop((40, 0, 600, 480)) for look in LOOKS]


def figure8() -> list[Image.Image]:
    """Textures by the screen, and by edges: on a dense mesh those are noise."""
    style = f"{_FURRY},strokes=half,caps=none,parameters="
    with rabbit() as head:
        return [
            shot(style + way, *_VIEW, head).crop((120, 0, 520, 480)) for way in ("screen", "object")
        ]


def figure11() -> list[Image.Image]:
    """Contours; suggestive contours with them; and the shading that shows the mesh."""
    more = f"{_UNTEXTURED},suggestive=on"
    styles = (f"{_UNTEXTURED},tone=paper,paper=#ffffff", f"{more},tone=paper,paper=#ffffff", more)
    with rabbit() as head:
        return [shot(style, *_VIEW, head).crop((120, 0, 520, 480)) for style in styles]


FIGURES = {"figure1": (figure1, 2), "figure7": (figure7, 2), "figure8": (figure8, 2),
           "figure11": (figure11, 3)}  # fmt: skip
"""What makes the tiles of a figure, and its columns."""


def write_figures(out: Path) -> Iterator[Path]:
    """One PNG a figure; says where each is."""
    for name, (make, columns) in FIGURES.items():
        path = out / f"{name}.png"
        sheet(make(), columns).save(path)
        yield path
