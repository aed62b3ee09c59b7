"""The documentation site: it is built without a warning, and each fault of a page is an error."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
needs_sphinx = pytest.mark.skipif(
    any(find_spec(name) is None for name in ("sphinx", "myst_parser", "furo")),
    reason="the extra docs is not installed: pip install -e '.[docs]'",
)


def built(repository: Path, out: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["sh", str(repository / "scripts" / "docs"), str(out)],
        env={**os.environ, "PYTHON": sys.executable, "NO_COLOR": "1"},
        capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip


@needs_sphinx
def test_the_site_is_built_with_every_page_and_every_public_name(tmp_path: Path) -> None:
    done = built(ROOT, tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    pages = [path.relative_to(ROOT / "docs") for path in (ROOT / "docs").rglob("*.md")]
    assert [page for page in pages if not (tmp_path / page.with_suffix(".html")).exists()] == []
    text = (tmp_path / "reference" / "api.html").read_text("utf-8")
    text = re.sub("<[^>]+>", "", text)
    assert "Restyle this process" in text
    assert "(V, 3) object space, after division by w." in text


@needs_sphinx
def test_each_fault_of_a_page_is_an_error(tmp_path: Path) -> None:
    shutil.copytree(ROOT / "docs" / "site", tmp_path / "docs" / "site")
    (tmp_path / "scripts").mkdir()
    shutil.copy(ROOT / "scripts" / "docs", tmp_path / "scripts" / "docs")
    (tmp_path / "docs" / "index.md").write_text(
        "# Pages\n\n## Guide\n\n- [One](one.md)\n\n[no page](two.md), [no place](one.md#two)\n"
        '\n<a href="three.html">no file</a> <a href="one.html#three">no anchor</a>\n'
    )
    (tmp_path / "docs" / "one.md").write_text("# One\n\n```{api}\ninstall\nremove\n```\n")
    (tmp_path / "docs" / "lost.md").write_text("# In no index\n")
    done = built(tmp_path, tmp_path / "out")
    assert done.returncode == 1
    for words in (
        "cross-reference target not found: 'two.md'", "local id not found in doc 'one': 'two'",
        "index.html: the link three.html leads nowhere",
        "index.html: the link one.html#three leads nowhere", "remove is no public name",
        "uninstall is in 0 lists", "lost.md: WARNING: document isn't included in any toctree",
    ):  # fmt: skip
        assert words in done.stderr
