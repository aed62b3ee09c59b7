"""Galleries: which styles they show, how pictures are called, and what their tiles say."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from glshim.commands.gallery import all_styles
from glshim.outputs.wrapping import wrapped
from glshim.running.gallery.runs import styled
from glshim.running.gallery.tiles import Tile, file_names, tile

PAGE = Path(__file__).parents[2] / "docs" / "guide" / "writing_a_styler.md"


def test_every_style_is_there_once_and_the_plain_one_first() -> None:
    styles = all_styles()
    assert styles[0] == "none" and len(set(styles)) == len(styles)
    assert {"raskar", "edge_mesh", "watercolour"} <= set(styles)


def test_pictures_have_names_of_their_own() -> None:
    texts = ["raskar:a=1", "raskar:a,1", "raskar_a_1", "../x/raskar.toml", "raskar", "::"]
    names = file_names(texts)
    assert len(set(names)) == len(texts)
    assert all("/" not in name and name.endswith(".png") for name in names)


def tile_of(text: str) -> Tile:
    return tile(styled(text, text, 3, Path("x.png")))


@pytest.mark.parametrize(
    ("text", "summary", "details"),
    [
        ("none", "The program's own picture.", ""),
        ("raskar:ridges=off", "", "ridge_angle"),
        ("charcoal:paper=#ffffff", "", "edge_mesh:"),
    ],
)
def test_a_tile_says_what_its_style_is(text: str, summary: str, details: str) -> None:
    made = tile_of(text)
    assert made.name == ("plain" if text == "none" else text)
    assert made.summary.startswith(summary)
    assert made.summary
    assert details in made.details


def test_a_tile_of_a_file_shows_the_file_and_of_a_class_its_options(tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text('style = "raskar"  # mine\n')
    assert (tile_of(str(mine)).summary, tile_of(str(mine)).details) == ("raskar", mine.read_text())
    glow = tmp_path / "my_style.py"
    glow.write_text(PAGE.read_text().split("```python\n")[1].split("```")[0])
    made = tile_of(f"{glow}:Glow:ink=#ff0000")
    assert made.summary
    assert "sharpness" in made.details


@given(st.text("ab ", max_size=40), st.integers(1, 12))
def test_wrapped_lines_hold_the_whole_text_and_fit(text: str, room: int) -> None:
    lines = wrapped(text, len, room)
    assert " ".join(lines) == text
    assert all(len(line) <= room or " " not in line for line in lines)
