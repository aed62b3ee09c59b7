"""Navigation from the lists of links in pages called `index.md`, which people read as they are."""

from __future__ import annotations

import re

from sphinx.application import Sphinx

HEADING = re.compile(r"^## (?P<caption>.+)$")
ENTRY = re.compile(r"^[-*] \[(?P<title>[^]]+)\]\((?P<page>[^):#]+)\.md\)")


def table_of(text: str) -> str:
    """Hidden tables of contents, one for each heading of the page with a list of links."""
    tables: list[list[str]] = [[]]
    for line in text.splitlines():
        if heading := HEADING.match(line):
            tables.append([f":caption: {heading['caption']}"])
        elif entry := ENTRY.match(line):
            tables[-1].append(f"{entry['title']} <{entry['page']}>")
    return "".join(
        "\n".join(["\n```{toctree}", ":hidden:", *table, "```\n"])
        for table in tables if any(not line.startswith(":") for line in table)
    )  # fmt: skip


def add_table(_app: Sphinx, name: str, source: list[str]) -> None:
    """What `source-read` calls: `source` holds the text of a page."""
    if name.rpartition("/")[2] == "index":
        source[0] += table_of(source[0])


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("source-read", add_table)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
