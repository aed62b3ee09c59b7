"""What only Togl's frames could go wrong with: they end inside a command of Tcl's."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from .catalog import HERE
from .harness import ROOT
from .sources import LIBRARIES, TCL, SourceMissing, fetched


def run(app: str, display: str, folder: Path, **variables: str) -> tuple[int, list[str]]:
    """Exit status, and what it says."""
    try:
        togl = fetched("Togl")
    except SourceMissing as reason:
        pytest.skip(str(reason))
    environ = os.environ | variables | {
        "DISPLAY": display, "PYTHONPATH": str(ROOT), "TCLLIBPATH": f"{togl}/{TCL['Togl']}",
        "LD_LIBRARY_PATH": f"{togl}/{LIBRARIES['Togl']}",
    }  # fmt: skip
    done = subprocess.run(
        [sys.executable, str(HERE / "apps" / f"{app}.py")], env=environ, cwd=folder,
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    return done.returncode, (done.stdout + done.stderr).splitlines()


@pytest.mark.parametrize("style", ["none", "raskar"])
def test_what_a_signal_handler_raises_leaves_the_programs_call(
    style: str, display: str, tmp_path: Path
) -> None:
    status, said = run("togl_signals", display, tmp_path, GLSHIM_STYLE=style)
    assert (status, said) == (0, ["heard 40 of 40", "the main loop has returned"])


def test_the_main_loop_is_left_after_the_frames(display: str, tmp_path: Path) -> None:
    pictures = {"GLSHIM_FRAMES": "4", "GLSHIM_CAPTURE": "%d.png"}
    status, said = run("togl_views", display, tmp_path, GLSHIM_STYLE="raskar", **pictures)
    assert (status, said) == (0, ["the main loop has returned"])
    assert sorted(path.name for path in tmp_path.iterdir()) == [f"{n}.png" for n in (1, 2, 3, 4)]
