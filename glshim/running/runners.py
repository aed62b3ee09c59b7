"""Who runs the program's code piece by piece and goes on with the next one: test runners, shells.

An exception that ends a program ends only one piece there: a test fails, a cell stops. A process
that is ended beneath them takes away what they had to report.
"""

from __future__ import annotations

import sys
import threading
from types import FrameType

_RUNNERS = {
    "_pytest": "pytest",
    "unittest.case": "unittest",
    "unittest.suite": "unittest",
    "unittest.loader": "unittest",
    "doctest": "doctest",
    "behave": "behave",
    "robot": "Robot Framework",
    "IPython": "IPython",
}
"""By the module, or package, whose code calls the program's."""


def runner() -> str:
    """The outermost one that the program's main thread runs under, for people; empty where there is
    none."""
    found = ""
    frame: FrameType | None = sys._current_frames().get(threading.main_thread().ident or 0)
    while frame is not None:
        module = str(frame.f_globals.get("__name__", ""))
        for name, title in _RUNNERS.items():
            if module == name or module.startswith(name + "."):
                found = title
        frame = frame.f_back
    return found
