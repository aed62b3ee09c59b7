"""Every link of the built site that stays within it leads to a file or to a place in a page."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from sphinx.application import Sphinx
from sphinx.util import logging

LOG = logging.getLogger(__name__)


class Page(HTMLParser):
    """The places and the links of a page."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.places: set[str] = {""}
        self.links: list[str] = []
        self.feed(path.read_text("utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if name == "id" and value:
                self.places.add(value)
            elif name in ("href", "src") and value:
                self.links.append(value)


def lost(folder: Path) -> list[tuple[str, str]]:
    """Pairs of a page and a link of it that leads nowhere. `folder` holds the built site."""
    pages = {path.resolve(): Page(path) for path in sorted(folder.rglob("*.html"))}
    found = []
    for path, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            known = pages[target].places if target in pages else {"", parts.fragment}
            if not target.is_file() or unquote(parts.fragment) not in known:
                found.append((str(path.relative_to(folder.resolve())), link))
    return found


def loaded(folder: Path) -> list[str]:
    """What the built pages would load from other hosts: there should be nothing."""
    tags = re.compile(r"<(?:script|link|img)[^>]*(?:src|href)=\"((?:https?:)?//[^\"]*)")
    texts = (path.read_text("utf-8") for path in folder.rglob("*.html"))
    return sorted({address for text in texts for address in tags.findall(text)})


def check(app: Sphinx, exception: Exception | None) -> None:
    """What `build-finished` calls."""
    if exception is None and app.builder.name == "html":
        for page, link in lost(Path(app.outdir)):
            LOG.warning("%s: the link %s leads nowhere", page, link)
        for address in loaded(Path(app.outdir)):
            LOG.warning("the site would load %s", address)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("build-finished", check)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
