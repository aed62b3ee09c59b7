"""``python -m tests.fuzz.worker STYLE FLAGS``: plays pickled programs from standard input, and
writes what was seen to standard output. Style ``plain``: without glshim."""

from __future__ import annotations

import faulthandler
import logging
import os
import pickle
import re
import sys
from typing import Any

FAULT = re.compile(r"by a fault of glshim|is switched off")
PLAIN = "plain"


def main(style: str, flags: str) -> None:
    """Until standard input ends."""
    questions = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    log = os.memfd_create("log")
    os.dup2(log, 1)
    os.dup2(log, 2)
    faulthandler.enable()
    logging.disable()
    import OpenGL

    from tests.fuzz.program import FLAGS

    for name, value in FLAGS[flags].items():
        setattr(OpenGL, name, value)
    import glfw

    from tests.fuzz.stage import Note, Stage

    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        raise SystemExit("there is no display")
    start = _style(style)
    while True:
        try:
            steps = pickle.load(questions)
        except EOFError:
            return
        start()
        at = os.lseek(log, 0, os.SEEK_END)
        notes = Stage().play(steps)
        sys.stderr.flush()
        said = os.pread(log, 1 << 16, at).decode(errors="replace")
        if style != PLAIN and FAULT.search(said):
            notes.append(Note(-1, "fault", said))
        pickle.dump(notes, answers)
        answers.flush()


def _style(style: str) -> Any:
    """Installs it; gives what begins each program with it."""
    if style == PLAIN:
        return lambda: None
    import glshim
    from glshim import notices, pipeline

    glshim.install(style)

    def start() -> None:
        notices.forget("")
        if pipeline._current is not None and pipeline._current.broken:
            glshim.install(style)

    return start


if __name__ == "__main__":
    main(*sys.argv[1:])
