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
from glshim.styling.categories import CATEGORIES, categories_of
from glshim.styling.descriptions import of_text
from glshim.styling.texts import parse_style

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
    return tile(styled(text, text, 3, Path("x.png")), "gears.py")


@pytest.mark.parametrize(
    ("text", "categories", "option"),
    [
        ("none", (), None),
        ("raskar:ridges=off", ("lines",), ("ridges", "off", "on")),
        ("charcoal:paper=#ffffff", ("paper",), ("paper", "#ffffff", "app")),
        ("brush", ("paint", "paper"), None),
        ("cartoon", ("paint",), None),
        ("hiddenline", ("paper",), None),
        ("fur", ("effects",), None),
        ("sketch+raskar", ("paper", "lines"), None),
    ],
)
def test_a_tile_says_what_its_style_is(
    text: str, categories: tuple[str, ...], option: tuple[str, str, str] | None
) -> None:
    made = tile_of(text)
    assert made.name == text
    own = text == "none"
    assert made.summary == ("The program's own picture." if own else of_text(text)[0])
    assert made.summary
    assert made.categories == categories
    assert set(categories) <= set(CATEGORIES)
    if option is not None:
        assert option in [(row.name, row.value, row.default) for row in made.rows]
        changed = [row.value != row.default for row in made.rows]
        assert changed == sorted(changed, reverse=True)


def test_all_styles_have_a_category() -> None:
    lacking = [name for name in all_styles() if not categories_of(parse_style(name))]
    assert lacking == ["none"]


def test_a_picture_is_described_to_those_who_do_not_see_it() -> None:
    assert tile_of("none").description == "gears.py without a style"
    assert tile_of("anime").description.startswith("gears.py in style anime: ")


def test_a_tile_of_a_file_shows_the_file_and_of_a_class_its_options(tmp_path: Path) -> None:
    mine = tmp_path / "mine.toml"
    mine.write_text('style = "raskar"  # mine\n')
    assert (tile_of(str(mine)).summary, tile_of(str(mine)).source) == ("raskar", mine.read_text())
    glow = tmp_path / "my_style.py"
    glow.write_text(PAGE.read_text().split("```python\n")[1].split("```")[0])
    made = tile_of(f"{glow}:Glow:ink=#ff0000")
    assert made.summary
    assert "sharpness" in [row.name for row in made.rows]


@given(st.text("ab ", max_size=40), st.integers(1, 12))
def test_wrapped_lines_hold_the_whole_text_and_fit(text: str, room: int) -> None:
    lines = wrapped(text, len, room)
    assert " ".join(lines) == text
    assert all(len(line) <= room or " " not in line for line in lines)
