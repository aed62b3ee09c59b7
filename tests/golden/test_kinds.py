"""Options by feature: what a person sees of them, in every style that draws lines."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from OpenGL import GL

from tests.differential.world import run

LINED = (
    "raskar", "edge_mesh", "edge_mesh:strokes=thin", "edge_mesh:strokes=quads", "crease", "fins",
    "hiddenline", "two_pass", "technical", "cartoon", "blueprint", "sketch", "brush", "pencil",
)  # fmt: skip
WISHED = """
[contour]
ink = "red"
dash = {dash}
width = 6
[ridge]
on = true
ink = "blue"
width = {width}
"""


def box() -> None:
    """Closed, grey, and turned."""
    GL.glRotatef(30.0, 1.0, 1.0, 0.0)
    GL.glColor3f(0.7, 0.7, 0.7)
    GL.glBegin(GL.GL_QUADS)
    for axis in range(3):
        for side in (-1, 1):
            for a, b in [(-1, -1), (1, -1), (1, 1), (-1, 1)][::side]:
                point = [0.0, 0.0, 0.0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, a, b
                GL.glVertex3f(*point)
    GL.glEnd()


def seen(style: str) -> tuple[int, int]:
    """Pixels that are much more red, and much more blue, than anything else."""
    red, green, blue = run(lambda app: box(), style).picture[..., :3].astype(int).T
    return (
        int((red - np.maximum(green, blue) > 40).sum()),
        int((blue - np.maximum(red, green) > 40).sum()),
    )


@pytest.mark.parametrize("style", LINED)
def test_contours_are_red_dashes_and_ridges_thin_and_blue(tmp_path: Path, style: str) -> None:
    def file(dash: float, width: float) -> str:
        path = tmp_path / f"{dash:g}_{width:g}.toml"
        more = 'paper = "white"\n' if style == "blueprint" else ""
        path.write_text(f'extends = "{style}"\n{more}' + WISHED.format(dash=dash, width=width))
        return str(path)

    (solid, wide), (dashed, thin) = seen(file(0, 6)), seen(file(16, 1))
    assert solid > 100
    # The fixed function's dashes have smooth ends.
    assert 0.3 * solid < dashed < (0.92 if style == "two_pass" else 0.85) * solid
    if "thin" in style:  # lines of a pixel, whatever their width
        assert thin == wide > 40
    else:
        assert 0 < thin < 0.6 * wide


def test_one_ink_is_of_lines_and_shading_and_kinds_have_their_own(tmp_path: Path) -> None:
    """Charcoal, whose shading is in the ink of all lines."""
    own = tmp_path / "own.toml"
    own.write_text('extends = "charcoal"\n[contour]\nink = "red"')
    (every, _), (contours, _), (none, _) = map(seen, ("charcoal:ink=red", str(own), "charcoal"))
    assert none == 0
    assert 100 < contours < every - 200
