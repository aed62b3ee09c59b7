"""Figures of McGuire & Hughes 2004 made again."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from glshim_stylers.edge_mesh.paper import PaperLook, paper_passes
from PIL import Image

from glshim.model.camera import Camera
from glshim.outputs.gl.backend import Backend
from glshim.styling.protocol import Layer
from tests import look

SIZE = 400
CAPS = ("none", "paper", "round")
CAMERA = Camera(
    look.look_at((0.0, -2.9, 1.75), (0.0, -0.25, 0.85), up=(0, 0, 1)),
    look.perspective(34), (0, 0, SIZE, SIZE),
)  # fmt: skip
MESH = look.cylinder(14, 0.75, 0.9)


def figure5(out: Path) -> Path:
    """The rim of a cylinder seen at an angle, where the normals of the near rim point into the
    curve: without caps, with the paper's and with round ends. Writes one PNG, and says where."""
    path = out / "figure5.png"
    with look.window(SIZE, SIZE):
        tiles = figure5_tiles(Backend.attach())
    Image.fromarray(np.concatenate(tiles, axis=1)).save(path)
    return path


def figure5_tiles(backend: Backend) -> list[np.ndarray]:
    """Pictures (SIZE, SIZE, 3), the first row on top, in the order of `CAPS`."""
    tiles = []
    for caps in CAPS:
        look.clear()
        look.draw_base(MESH, CAMERA, (0.85, 0.85, 0.85))
        style = PaperLook(strokes="quads", caps=caps, widths=(22.0,) * 5)
        backend.render(paper_passes(style, Layer(((MESH, CAMERA),))))
        tiles.append(look.pixels(SIZE, SIZE)[::-1])
    return tiles
