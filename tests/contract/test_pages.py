"""README and the pages of docs: every file, folder, link and module that they name is there."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
SOURCES = ("glshim", "stylers", "demo_apps", "tests", "scripts", "docs")
SUFFIXES = (".py", ".glsl", ".toml", ".md", ".html", ".css", ".pth", ".start")
EXAMPLES = {
    "mine.toml", "my_app.py", "my_style.py", "path/my_style.py", "out.html", "out/demo", "out/fuzz",
    "out_files/",
}  # fmt: skip
"""What readers would make themselves."""


def ours() -> set[str]:
    """The names of our files."""
    found = {path.name for folder in SOURCES for path in (ROOT / folder).rglob("*.*")}
    return found | {path.name for path in ROOT.iterdir()}


NAMES = ours()


def named(text: str) -> Iterator[str]:
    """Files and folders: words in backticks with an ending of ours, or with slashes alone."""
    for code in re.findall(r"`([^`\n]+)`", text):
        for word in re.split(r"[\s:,=\"]+", code):
            if Path(word).suffix in SUFFIXES or re.fullmatch(r"(\w+/)+\w*", word):
                yield word


def is_there(word: str, page: Path) -> bool:
    """Whether a word is a path from the top, from the package or from the page, or the name of a
    file of ours."""
    return word in NAMES or any(
        (base / word).exists() for base in (ROOT, ROOT / "glshim", page.parent)
    )


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_what_a_page_names_is_there(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    lost = [word for word in named(text) if word not in EXAMPLES and not is_there(word, page)]
    links = re.findall(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)", text)
    lost += [link for link in links if not (page.parent / link).exists()]
    modules = re.findall(r"-m ((?:glshim|stylers|demo_apps|tests)(?:\.\w+)*)", text)
    lost += [module for module in modules if find_spec(module) is None]
    assert lost == []


def test_the_reader_of_pages_sees_files_folders_and_examples() -> None:
    text = "`a/b.py: f` and `glshim/c`, `a/` or `1/2`; `x=d.toml,e.glsl` a/f.py `and/or not`"
    assert [*named(text)] == ["a/b.py", "glshim/c", "a/", "1/2", "d.toml", "e.glsl", "and/or"]
    assert is_there("spec/roles.py", ROOT / "README.md")
    assert is_there("../reference/security.md", ROOT / "docs" / "guide" / "live.md")
    assert not is_there("render/pen.py", ROOT / "README.md")
