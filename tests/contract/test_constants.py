"""GL constants stand in the sources by name, and the generated file holds those in use."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MASK = 0xFFFF


def test_the_generated_file_is_up_to_date() -> None:
    done = subprocess.run(
        [sys.executable, str(ROOT / "scripts" / "constants"), "--check"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.stdout, done.returncode) == ("", 0)


def hexadecimal(path: Path) -> list[str]:
    """Numbers from 0x100 to 0xFFFE that are written in hexadecimal, with their lines."""
    text = path.read_text(encoding="utf-8")
    found = []
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Constant) and type(node.value) is int:
            written = ast.get_source_segment(text, node) or ""
            if written.lower().startswith("0x") and 0x100 <= node.value < MASK:
                found.append(f"{path.relative_to(ROOT)}:{node.lineno}: {written}")
    return found


@pytest.mark.parametrize("room", ["bindings", "sources", "outputs", "running", "checks"])
def test_no_bare_number_stands_for_a_constant(room: str) -> None:
    paths = sorted((ROOT / "glshim" / room).rglob("*.py"))
    assert [line for path in paths for line in hexadecimal(path)] == []
