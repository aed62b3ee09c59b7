"""What ``sh scripts/setup demo`` says, with stand-ins for all that it calls."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
STAND_INS = ("ldconfig", "Xvfb", "apt-get", "apt-cache", "python3")


def setup(folder: Path, **variables: str) -> list[str]:
    """The lines of a run in a folder of its own, on a machine that seems to have all libraries."""
    libraries = re.findall(r"has_library (\w+)", (ROOT / "scripts" / "setup").read_text())
    said = {
        "glshim": 'echo "glshim $*"',
        "ldconfig": "echo '" + "\n".join(f"{name}.so.1 (" for name in libraries) + "'",
    }
    (folder / "scripts").mkdir()
    shutil.copy(ROOT / "scripts" / "setup", folder / "scripts")
    (folder / "bin").mkdir()
    (folder / ".venv" / "bin").mkdir(parents=True)
    programs = [*(folder / "bin" / name for name in STAND_INS),
                *(folder / ".venv" / "bin" / name for name in ("python", "glshim"))]  # fmt: skip
    for path in programs:
        path.write_text(f"#!/bin/sh\n{said.get(path.name, 'exit 0')}\n")
        path.chmod(0o755)
    plain = {key: os.environ[key] for key in ("HOME", "LANG") if key in os.environ}
    done = subprocess.run(
        ["sh", "scripts/setup", "demo"], cwd=folder, capture_output=True, text=True, timeout=60,
        env={**plain, "PATH": f"{folder / 'bin'}:/usr/bin:/bin", **variables}, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_with_a_display_it_says_that_it_is_done_and_how_the_demo_ends(tmp_path: Path) -> None:
    lines = setup(tmp_path, DISPLAY=":99")
    (began,) = (k for k, line in enumerate(lines) if line.startswith("glshim run"))
    before, after = "\n".join(lines[:began]), "\n".join(lines[began + 1 :])
    assert "done: glshim is installed" in before
    assert "press ESC" in before
    assert "the demo has ended" in after


def test_without_one_it_says_where_the_pictures_are(tmp_path: Path) -> None:
    lines = setup(tmp_path)
    assert sum(line.startswith("glshim run") for line in lines) == 2
    assert "raskar-12.png" in lines[-1]
