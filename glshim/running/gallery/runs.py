"""Runs a program once per style, a few at a time, each on a virtual screen; none outlives us."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from types import FrameType
from typing import IO

from glshim.errors import EnvironmentFault
from glshim.running import environment, launch
from glshim.running.headless import headless_environment
from glshim.running.subjects import surroundings
from glshim.system.writing import picture_target

MOST_JOBS = 8
"""Runs at the same time, at most, unless the user asks for more."""
_FAILURES = ("is switched off", "runs unstyled")
"""What glshim says where a picture would be the program's own in place of the style's."""
_MARK = "glshim: "
_LOOK_AGAIN = 0.05


@dataclass(frozen=True, slots=True)
class Run:
    """One run of the program."""

    name: str
    """For people, such as a style's text."""
    variables: Mapping[str, str]
    """GLSHIM_* variables that it has besides those of all runs."""
    picture: Path
    """Where it leaves its picture."""
    fault: str = ""
    """Why it has no picture, or not the right one; empty when it has."""
    notes: tuple[str, ...] = ()
    """Other lines that glshim said."""


def run_all(
    command: Sequence[str],
    runs: Sequence[Run],
    timeout: float,
    done: Callable[[Run], None] = lambda run: None,
    jobs: int = 1,
) -> list[Run]:
    """The runs with what became of them, in their order. command: what follows ``python``;
    timeout: seconds for each; done: told of each as it ends; jobs: runs at the same time.

    Raises `EnvironmentFault` where there is no virtual screen or glshim would not be started, and
    `KeyboardInterrupt` once everything is stopped.
    """
    launch.require_startup_file()
    program = [sys.executable, *launch.interpreter_flags(), *command]
    waiting = list(enumerate(runs))
    ended: dict[int, Run] = {}
    with _terminations(), ExitStack() as stack:
        free = [stack.enter_context(headless_environment()) for _ in range(min(jobs, len(runs)))]
        children: list[_Child] = []
        stack.callback(_kill_all, children)
        while waiting or children:
            while waiting and free:
                number, run = waiting.pop(0)
                children.append(_Child(number, run, free.pop(0), program, timeout))
            for child in list(children):
                outcome = child.look()
                if outcome is not None:
                    children.remove(child)
                    free.append(child.screen)
                    ended[child.number] = outcome
                    done(outcome)
            time.sleep(_LOOK_AGAIN)
    return [ended[number] for number in range(len(runs))]


def jobs_here() -> int:
    """Runs at the same time that suit this machine."""
    return min(os.cpu_count() or 1, MOST_JOBS)


class _Child:
    """A run under way, in a process group of its own."""

    def __init__(
        self, number: int, run: Run, screen: dict[str, str], program: list[str], timeout: float
    ) -> None:
        self.number, self.run, self.screen = number, run, screen
        self._ends = time.monotonic() + timeout
        self._timeout = timeout
        self._log: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115 - closed in look and kill
        try:
            picture_target(run.picture).unlink(missing_ok=True)
        except OSError as error:
            raise EnvironmentFault(f"cannot write {run.picture}: {error}") from error
        self._process = subprocess.Popen(
            program, env={**surroundings(screen), **run.variables}, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=self._log, start_new_session=True,
        )  # fmt: skip

    def look(self) -> Run | None:
        """The run with its outcome once it has ended."""
        status = self._process.poll()
        late = status is None and time.monotonic() > self._ends
        if status is None and not late:
            return None
        self._stop()
        self._log.seek(0)
        lines = self._log.read().decode(errors="replace").splitlines()
        self._log.close()
        return _outcome(self.run, status, lines, self._timeout)

    def kill(self) -> None:
        """End it now."""
        self._stop()
        self._log.close()

    def _stop(self) -> None:
        with suppress(ProcessLookupError):  # whatever it started goes too
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()


def _kill_all(children: list[_Child]) -> None:
    for child in children:
        child.kill()


def _outcome(run: Run, status: int | None, lines: list[str], timeout: float) -> Run:
    said = tuple(line.removeprefix(_MARK) for line in lines if line.startswith(_MARK))
    wrong = [line for line in said if any(mark in line for mark in _FAILURES)]
    if wrong:
        fault = wrong[0] + (f" ({lines[-1]})" if lines[-1].removeprefix(_MARK) != wrong[0] else "")
    elif status is None:
        shown = "some frames, not all" if run.picture.exists() else "no frame"
        fault = f"timed out after {timeout:g} s with {shown}"
    elif status:
        how = f"was killed by signal {-status}" if status < 0 else f"exited with status {status}"
        fault = f"the program {how}" + (f": {lines[-1]}" if lines else "")
    else:
        fault = "" if run.picture.exists() else "the program exited before presenting a frame"
    return replace(run, fault=fault, notes=tuple(line for line in said if line not in wrong))


@contextmanager
def _terminations() -> Iterator[None]:
    """SIGTERM and SIGHUP end us as Ctrl-C does: with the runs stopped."""

    def interrupt(number: int, frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    before = {number: signal.signal(number, interrupt) for number in (signal.SIGTERM,
                                                                      signal.SIGHUP)}  # fmt: skip
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def styled(name: str, style: str, frame: int, picture: Path) -> Run:
    """A run that writes its frame of that number in a style."""
    variables = {
        environment.STYLE: style,
        environment.FRAMES: str(frame),
        environment.CAPTURE: str(picture.absolute()),
    }
    return Run(name, variables, picture)
