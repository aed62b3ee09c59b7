"""The recipes of docs/guide/writing_a_styler.md, as they stand in the page."""

from __future__ import annotations

import ast
import itertools
import re
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from OpenGL import GL

import glshim
from glshim import parse_style
from glshim.checks import values, window
from glshim.checks.finding import finding
from glshim.checks.layers import SIDE, camera, cube, perspective, torus

SEEN = camera((4.5, 3.0, 3.0))
PAGE = Path(__file__).parents[2] / "docs" / "guide" / "writing_a_styler.md"
_SECTION = PAGE.read_text().split("\n## Recipes\n")[1].split("\n## ")[0]
RECIPES = {
    re.findall(r"class (\w+)\(Styler\)", text)[0]: text
    for text in re.findall(r"```python\n(.*?)```", _SECTION, re.DOTALL)
}


def style(folder: Path, name: str) -> str:
    path = folder / "my_style.py"
    path.write_text(RECIPES[name])
    return f"{path}:{name}"


def scene() -> None:
    """A cube and, behind it, a torus, on a grey ground."""
    GL.glViewport(0, 0, SIDE, SIDE)
    GL.glClearColor(0.9, 0.9, 0.9, 1.0)
    GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
    GL.glEnable(GL.GL_DEPTH_TEST)
    for mode, matrix in ((GL.GL_PROJECTION, perspective()), (GL.GL_MODELVIEW, SEEN.modelview)):
        GL.glMatrixMode(mode)
        GL.glLoadMatrixd(matrix.T)
    for mesh in (cube(), torus()):
        for k, (begin, end) in enumerate(itertools.pairwise(mesh.starts)):
            GL.glColor3f(0.5, 0.6 + 0.1 * (k % 3), 0.5)
            GL.glBegin(GL.GL_POLYGON)
            for corner in mesh.corners[begin:end]:
                GL.glVertex3fv(mesh.positions[corner])
            GL.glEnd()


def picture(style: str) -> NDArray[np.int_]:
    with glshim.style(style) as s:
        scene()
        return s.image().astype(int)


@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_keeps_to_what_all_styles_keep_to(tmp_path: Path, name: str) -> None:
    made = parse_style(style(tmp_path, name))
    assert [str(found) for check in values.CHECKS if (found := finding(check, made)).wrong] == []


@pytest.mark.gl
@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_draws_what_it_says(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with window.window():
        plain, shown = picture("none"), picture(style(tmp_path, name))
    assert capsys.readouterr().err == ""
    ground = (plain == plain[0, 0]).all(axis=2)
    changed = (np.abs(shown - plain) > 40).any(axis=2)

    def near(colour: tuple[int, int, int]) -> NDArray[np.bool_]:
        return np.asarray((np.abs(shown - colour) < 40).all(axis=2))

    if name == "Drafted":
        assert near((0xC0, 0x20, 0x20)).sum() > 500
        assert near((0x20, 0x40, 0xC0)).sum() > 20
        assert 0.005 < changed.mean() < 0.05
    elif name == "Beaded":
        assert near((0x80, 0x20, 0x60)).sum() > 1000
        assert 0.01 < changed.mean() < 0.1
    elif name == "Squared":
        assert (near((0xF8, 0xF4, 0xE8)) & ground).sum() > 0.7 * ground.sum()
        assert (near((0xB8, 0xCC, 0xE0)) & ground).sum() > 0.08 * ground.sum()
        assert 0.01 < changed[~ground].mean() < 0.2
    else:
        assert name == "Mosaic", "say here what this recipe draws"
        inner = shown[4:-4].reshape(-1, 2, *shown.shape[1:])[:, 0]  # rows of the same tiles
        assert (np.abs(np.diff(inner, axis=1)).max(axis=2) == 0).mean() > 0.7


def test_recipes_import_from_glshim_alone() -> None:
    assert len(RECIPES) >= 4
    for text in RECIPES.values():
        modules = {
            node.module for node in ast.walk(ast.parse(text)) if isinstance(node, ast.ImportFrom)
        }
        assert {name for name in modules if name and "glshim" in name} == {"glshim"}
