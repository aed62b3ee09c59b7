"""What glshim says to the person on standard error: whole lines, marked, never an exception."""

from __future__ import annotations

import sys
import traceback
from contextlib import suppress

_said: set[str] = set()


def say(line: str) -> None:
    """One line on standard error (nowhere when the program has none)."""
    if sys.stderr is not None:
        with suppress(OSError, ValueError):  # closed, or a pipe nobody reads any more
            print(f"glshim: {line}", file=sys.stderr, flush=True)


def say_once(line: str) -> None:
    """`say`, unless this very line was said before."""
    if line not in _said:
        _said.add(line)
        say(line)


def say_fault(what: str, error: BaseException) -> None:
    """A fault of ours with its traceback, once; `what` says what happens now."""
    if what not in _said:
        _said.add(what)
        say(what + "\n" + "".join(traceback.format_exception(error)).rstrip())


def forget(beginning: str) -> None:
    """Say again what begins so, when it happens again."""
    for line in [line for line in _said if line.startswith(beginning)]:
        _said.discard(line)
