"""Every style that README and docs name, and every style file that they show, is one."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from glshim.styling.texts import parse_style, split_styles

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]
FILES = re.compile(r"STYLE|\bA,B\b|\.py\b|\.toml\b")
"""Placeholders, and files that readers would write."""


def style_lists(text: str) -> list[str]:
    """What variables, options of the command and calls from Python name."""
    found = re.findall(r"(?:GLSHIM_STYLES?=|--styles? )\"?([^\s`\"]+)", text)
    found += re.findall(r"glshim\.(?:install|style|parse_style)\(\"([^\"]+)\"", text)
    found += [name for pair in re.findall(r"--compare (\w+) (\w+)", text) for name in pair]
    return [style for style in found if not FILES.search(style)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_styles_that_a_page_names_are_styles(page: Path) -> None:
    for text in style_lists(page.read_text(encoding="utf-8")):
        for style in split_styles(text):
            assert parse_style(style).name


def test_the_texts_on_the_page_of_styles_are_styles() -> None:
    page = (ROOT / "docs" / "guide" / "styles.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"## Style text\n\n.*?\n\n((?:    .+\n)+)", page)
    texts = [line.strip() for line in block.splitlines()]
    assert len(texts) > 4
    for text in texts:
        assert FILES.search(text) or parse_style(text).name


def test_the_style_files_on_pages_are_style_files(tmp_path: Path) -> None:
    shown = [
        block
        for page in PAGES
        for block in re.findall(r"```toml\n(.*?)```", page.read_text("utf-8"), re.DOTALL)
        if re.search(r"^(extends|style) =", block, re.MULTILINE)
    ]
    assert shown
    for number, block in enumerate(shown):
        file = tmp_path / f"{number}.toml"
        file.write_text(block)
        assert parse_style(str(file)).name


def test_the_reader_of_styles_sees_variables_options_and_calls() -> None:
    text = '`GLSHIM_STYLE=raskar`, --styles none,a:b=#1 x; glshim.style("c", d=1) --style STYLE'
    assert style_lists(text) == ["raskar", "none,a:b=#1", "c"]
