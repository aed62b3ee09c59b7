"""The way in at interpreter start-up: `glshim.pth` (and `glshim.start`, PEP 829) call `start`.

A module of its own at the top level, so that a start-up file can look at the environment without
importing the package `glshim`.
"""

import os
import sys

VARIABLES = ("GLSHIM_STYLE", "GLSHIM_FRAMES", "GLSHIM_CAPTURE", "GLSHIM_KEYS")


def start() -> None:
    """Arm glshim when one of its variables is set. Never raises: the program comes first."""
    sys.modules.pop(__name__, None)  # the program may have a module of that name
    # ``python -E`` and ``-I`` mean: nothing that the environment says.
    if sys.flags.ignore_environment or not any(name in os.environ for name in VARIABLES):
        return
    try:
        from glshim.system.modules import OURS_ALONE, begin

        begin()
        with OURS_ALONE:
            from glshim.running.startup import arm

        arm()
    except Exception as error:
        if sys.stderr is not None:
            print(f"glshim: cannot start, the program runs plain: {error!r}", file=sys.stderr)
