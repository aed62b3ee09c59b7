"""Runs random programs in processes of their own: Mesa crashes on some of them, plain as styled.

``python -m tests.property.worker`` reads pickled questions from standard input and answers on
standard output. It never touches GL itself; each run is a fork of it.
"""

from __future__ import annotations

import os
import pickle
import subprocess
import sys
from collections.abc import Callable
from typing import Any

from glshim import pipeline
from glshim.checks import observe
from glshim.styling import texts
from tests.differential.world import Outcome, run

from .calls import Step, play

CRASHED = "crashed"


def _forked(call: Callable[[], Any]) -> Any:
    """What the call gives in a process of its own, or that it died of it."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        try:
            with os.fdopen(writer, "wb") as out:
                pickle.dump(call(), out)
        except BaseException as error:
            print(f"{type(error).__name__}: {error}", file=sys.stderr, flush=True)
            os._exit(1)
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader, "rb") as answers:
        said = answers.read()
    _, status = os.waitpid(child, 0)
    return pickle.loads(said) if status == 0 else CRASHED


def _outcome(program: list[Step], style: str | None) -> Outcome | str:
    found: Outcome | str = _forked(lambda: run(lambda app: play(app, program), style))
    return found


def _prepare() -> None:
    """What every fork would find out again: modules, and what GL answers."""
    assert pipeline
    texts.parse_style("raskar")

    def queries() -> dict[int, str]:
        run(lambda app: None)
        return observe.queries

    observe.queries.update(_forked(queries))


def compare(program: list[Step], style: str, pictures: bool) -> dict[str, Any]:
    """Differences between plain and styled; none where two plain runs differ, or crash."""
    plain = _outcome(program, None)
    styled = _outcome(program, style)
    if isinstance(plain, str):
        return {}
    if isinstance(styled, str):
        return {} if isinstance(_outcome(program, None), str) else {"process": CRASHED}
    found = plain.differences(styled, pictures=pictures)
    if found:
        again = _outcome(program, None)
        if isinstance(again, str) or plain.differences(again):
            return {}
    return found


class Worker:
    """Asks a worker process."""

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-m", "tests.property.worker"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )  # fmt: skip

    def differences(self, program: list[Step], style: str, pictures: bool) -> dict[str, Any]:
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        pickle.dump((program, style, pictures), self._process.stdin)
        self._process.stdin.flush()
        found: dict[str, Any] = pickle.load(self._process.stdout)
        return found

    def close(self) -> None:
        assert self._process.stdin is not None
        self._process.stdin.close()
        self._process.wait()


def main() -> None:
    questions = sys.stdin.buffer
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what anything prints is no answer
    _prepare()
    while True:
        try:
            question = pickle.load(questions)
        except EOFError:
            return
        pickle.dump(compare(*question), answers)
        answers.flush()


if __name__ == "__main__":
    main()
