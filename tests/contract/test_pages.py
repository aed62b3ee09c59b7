"""README and the pages of docs: every file, folder, link and module that they name is there, and
every style is on its page."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest

from glshim.styling import registry

ROOT = Path(__file__).parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")])
SOURCES = ("glshim", "stylers", "demo_apps", "tests", "scripts", "docs")
SUFFIXES = (".py", ".glsl", ".toml", ".md", ".html", ".css", ".pth", ".start")
EXAMPLES = {
    "mine.toml", "my_app.py", "your_app.py", "my_style.py", "path/my_style.py", "out.html",
    "out/demo", "out/fuzz", "out/site", "out_files/",
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


def links(text: str) -> list[str]:
    """What a page links to and shows, addresses of other hosts aside."""
    return re.findall(r"\]\(([^):\s]+)\)", text)


def leads_somewhere(link: str, page: Path) -> bool:
    """Whether a file is there and, of a page, the heading."""
    path, _, place = link.partition("#")
    target = page.parent / path if path else page
    return target.exists() and (not place or place in places(target))


@cache
def places(page: Path) -> set[str]:
    """The anchors of a page's headings."""
    headings = re.findall(r"^#+ (.+)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_what_a_page_names_is_there(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    lost = [word for word in named(text) if word not in EXAMPLES and not is_there(word, page)]
    lost += [link for link in links(text) if not leads_somewhere(link, page)]
    modules = re.findall(r"-m ((?:glshim|stylers|demo_apps|tests)(?:\.\w+)*)", text)
    lost += [module for module in modules if find_spec(module) is None]
    assert lost == []


def test_readme_is_short_and_leads_to_the_pages_of_the_guide() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(readme.splitlines()) < 150
    guide = {f"docs/guide/{page.name}" for page in (ROOT / "docs" / "guide").glob("*.md")}
    assert guide - {link.partition("#")[0] for link in links(readme)} == set()


def test_the_page_of_styles_has_every_style_and_look() -> None:
    page = (ROOT / "docs" / "guide" / "styles.md").read_text(encoding="utf-8")
    rows = "".join(re.findall(r"^\| (`.*?) \|", page, re.MULTILINE))
    assert set(re.findall(r"`(\w+)`", rows)) == {*registry.names(), *registry.looks()}


def test_the_changelog_has_the_usual_form() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    headings = re.findall(r"^#+ .+", text, re.MULTILINE)
    assert headings[:2] == ["# Changelog", "## [Unreleased]"]
    kinds = "Added|Changed|Deprecated|Removed|Fixed|Security"
    for heading in headings[2:]:
        assert re.fullmatch(rf"## \[[\d.]+\] - \d{{4}}-\d\d-\d\d|### ({kinds})", heading)
    assert re.findall(r"^[*-] .+", text.partition("\n### ")[0], re.MULTILINE) == []


def test_links_lead_to_pages_and_headings() -> None:
    page = ROOT / "README.md"
    found = links("[a](docs/index.md#guide) ![b](none.png) [c](https://host/x.md) [d](#limits)")
    assert found == ["docs/index.md#guide", "none.png", "#limits"]
    assert [leads_somewhere(link, page) for link in found] == [True, False, True]
    assert not leads_somewhere("docs/index.md#speed", page)


def test_users_are_told_where_the_tests_can_be_run() -> None:
    """`pip install` brings no tests."""
    users = [ROOT / "README.md", *(ROOT / "docs" / "guide").glob("*.md")]
    silent = [
        (page.name, part)
        for page in users
        for part in page.read_text(encoding="utf-8").split("\n\n")
        if "-m tests" in part and "clone of the repository" not in part
    ]
    assert silent == []
    assert "-m tests" in (ROOT / "docs" / "guide" / "gallery.md").read_text(encoding="utf-8")


def test_the_reader_of_pages_sees_files_folders_and_examples() -> None:
    text = "`a/b.py: f` and `glshim/c`, `a/` or `1/2`; `x=d.toml,e.glsl` a/f.py `and/or not`"
    assert [*named(text)] == ["a/b.py", "glshim/c", "a/", "1/2", "d.toml", "e.glsl", "and/or"]
    assert is_there("spec/roles.py", ROOT / "README.md")
    assert is_there("../reference/security.md", ROOT / "docs" / "guide" / "live.md")
    assert not is_there("render/pen.py", ROOT / "README.md")
