"""``glshim check-style``."""

from __future__ import annotations

import os
import subprocess
import sys
from contextlib import nullcontext

from glshim.running import launch
from glshim.running.headless import virtual_screen


def check_style(text: str, *, headless: bool) -> int:
    """Print what holds and what does not of a style: 0 where all does, 1 where not, 2 where there
    is no screen. Raises `EnvironmentFault`."""
    command = [sys.executable, *launch.interpreter_flags(), "-m", "glshim.checks", text]
    with virtual_screen() if headless else nullcontext(dict(os.environ)) as environ:
        plain = {key: value for key, value in environ.items() if not key.startswith("GLSHIM_")}
        status = subprocess.run(command, env=plain, check=False).returncode
    if status < 0:
        print(f"WRONG the process was ended by signal {-status}\n      a shader or a draw did that")
        return 1
    return status
