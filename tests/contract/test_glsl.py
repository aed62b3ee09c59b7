"""Shaders are read as other files are."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WIDE = 100
SHADERS = sorted(
    path for room in ("glshim", "stylers", "tests", "demo_apps")
    for path in (ROOT / room).rglob("*.glsl")
)  # fmt: skip


@pytest.mark.parametrize("path", SHADERS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_no_line_is_wider_than_those_of_python(path):
    lines = path.read_text().splitlines()
    wide = [number for number, line in enumerate(lines, 1) if len(line) > WIDE]
    assert not wide, f"{path.name}: {wide}"
