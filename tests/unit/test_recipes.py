"""The recipes of docs/guide/writing_a_styler.md, as they stand in the page."""

from __future__ import annotations

import ast
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from glshim import parse_style
from glshim.checks import values
from glshim.checks.finding import finding

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


def picture(path: Path, style: str) -> NDArray[np.int_]:
    """(H, W, 3) of the viewer's teapot, which says nothing of glshim's."""
    plain = {key: text for key, text in os.environ.items() if not key.startswith("GLSHIM")}
    done = subprocess.run(
        [sys.executable, "-m", "glshim_demos.viewer", "--wait", "teapot"], check=True, timeout=60,
        env=plain | {"GLSHIM_STYLE": style, "GLSHIM_FRAMES": "1", "GLSHIM_CAPTURE": str(path)},
        capture_output=True, text=True,
    )  # fmt: skip
    assert "glshim" not in done.stderr
    return np.asarray(Image.open(path).convert("RGB")).astype(int)


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> NDArray[np.int_]:
    return picture(tmp_path_factory.mktemp("plain") / "plain.png", "none")


@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_keeps_to_what_all_styles_keep_to(tmp_path: Path, name: str) -> None:
    made = parse_style(style(tmp_path, name))
    assert [str(found) for check in values.CHECKS if (found := finding(check, made)).wrong] == []


@pytest.mark.programs
@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_draws_what_it_says(
    tmp_path: Path, name: str, plain: NDArray[np.int_]
) -> None:
    shown = picture(tmp_path / "shown.png", style(tmp_path, name))
    ground = (plain == plain[0, 0]).all(axis=2)
    changed = (np.abs(shown - plain) > 40).any(axis=2)

    def near(colour: tuple[int, int, int]) -> NDArray[np.bool_]:
        return np.asarray((np.abs(shown - colour) < 40).all(axis=2))

    if name == "Drafted":
        assert near((0xC0, 0x20, 0x20)).sum() > 500
        assert near((0x20, 0x40, 0xC0)).sum() > 20
        assert 0.005 < changed.mean() < 0.05
    elif name == "Beaded":
        assert near((0x80, 0x20, 0x60)).sum() > 2000
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
