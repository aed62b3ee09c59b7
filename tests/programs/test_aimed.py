"""Programs that are aimed at where a shim shows: what they print, and how they end, is as plain.

Each stands in `aimed`, and ran differently once. With a style, pictures change and nothing else.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from glshim.styling.registry import names
from tests.sweep import some

from .catalog import HERE
from .harness import ROOT

PROGRAMS = [
    "arrays_accepted", "bare_ctypes", "begin_value", "begin_wraps", "debug_messages", "keywords",
    *(f"memory_not_read {which}" for which in (
        "incomplete", "reversed_range", "far_element", "too_few", "generic_zero", "base_wraps")),
    "list_errors", "module_names", "multidraw_negative", "names", "pending_errors", "queries",
    "two_threads", "valid_calls", "vertex_program",
]  # fmt: skip
STYLES = [name for name in names() if name != "none"]
PLAIN_PICTURE = {
    "vertex_program": ("raskar",), "bare_ctypes": ("raskar",), "two_threads": ("raskar",),
}  # fmt: skip
"""They print pixels, which styles with a paper, or with paints of their own, change."""


def outcome(program: str, style: str | None, display: str) -> tuple[int, str, int]:
    """Its exit status, what it prints, and how many tracebacks there are on standard error."""
    name, *arguments = program.split()
    kept = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM")}
    kept |= {"DISPLAY": display, "PYTHONHASHSEED": "0", "PYTHONPATH": str(ROOT)}
    if style is not None:
        kept["GLSHIM_STYLE"] = style
    done = subprocess.run(
        [sys.executable, str(HERE / "aimed" / f"{name}.py"), *arguments],
        env=kept, capture_output=True, text=True, timeout=120, check=False)
    assert "switched off" not in done.stderr, done.stderr
    return done.returncode, done.stdout, done.stderr.count("Traceback")


@pytest.mark.parametrize("program", PROGRAMS)
def test_it_runs_as_plain(program: str, display: str) -> None:
    plain = outcome(program, None, display)
    assert plain[:1] + plain[2:] == (0, 0)
    for style in ("none", *some(PLAIN_PICTURE.get(program, STYLES), 1, PROGRAMS.index(program))):
        assert outcome(program, style, display) == plain, style
