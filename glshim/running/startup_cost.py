"""What glshim adds to every start of Python, measured."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Mapping
from pathlib import Path
from statistics import median

TIMES, STARTS = 2000, 15
"""How often the start-up file is run, and how often Python is started."""


def of_file(path: Path) -> float:
    """Seconds that the start-up file takes where no GLSHIM_* variable is set."""
    line = path.read_text(encoding="utf-8")
    costs = []
    for _ in range(TIMES):
        began = time.perf_counter()
        exec(line, {})  # what `site` does with it
        costs.append(time.perf_counter() - began)
    return median(costs)


def of_python(variables: Mapping[str, str]) -> float:
    """Seconds that a whole start of Python takes."""
    costs = []
    for _ in range(STARTS):
        began = time.perf_counter()
        subprocess.run([sys.executable, "-c", "pass"], env={**os.environ, **variables}, check=True)
        costs.append(time.perf_counter() - began)
    return median(costs)


def imported() -> str:
    """The modules of ours that a start of Python imports, in one line."""
    code = "import sys; print(*(m for m in sys.modules if 'glshim' in m))"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    return done.stdout.strip()
