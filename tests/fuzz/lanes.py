"""Worker processes: one is told programs, gives what was seen, and is replaced when it dies."""

from __future__ import annotations

import os
import pickle
import select
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress

from tests.fuzz.program import ENVIRONMENTS
from tests.fuzz.stage import Note
from tests.fuzz.worker import PLAIN

SECONDS = 45.0
"""A program takes some tens of milliseconds; on a busy machine, with its first shaders, seconds."""
PLAIN_SECONDS = 12.0
"""Some call lists that call themselves, and take the driver for ever: they are not compared."""
_ENVIRONMENT = {
    "LP_NUM_THREADS": "0", "OPENBLAS_NUM_THREADS": "1", "PYTHONHASHSEED": "0",
    "XDG_SESSION_TYPE": "x11",
}  # fmt: skip


class Lane:
    """A process that plays programs in one style."""

    def __init__(self, style: str, flags: str, perturb: int = 0) -> None:
        """perturb: what fresh memory is filled with."""
        self.style, self.flags = style, flags
        self._seconds = PLAIN_SECONDS if style == PLAIN else SECONDS
        self._environment = {k: v for k, v in os.environ.items() if not k.startswith("GLSHIM_")}
        self._environment |= _ENVIRONMENT | ENVIRONMENTS.get(flags, {})
        if perturb:
            # Python's own pools of small objects are made of pages that begin as zeros.
            self._environment |= {"MALLOC_PERTURB_": str(perturb), "PYTHONMALLOC": "malloc"}
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> subprocess.Popen[bytes]:
        """The process; it need not be waited for."""
        if self._process is None:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "tests.fuzz.worker", self.style, self.flags],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=self._environment,
            )  # fmt: skip
        return self._process

    def ask(self, steps: Sequence[str]) -> None:
        """Begin to play; :meth:`answer` must follow."""
        process = self.start()
        assert process.stdin is not None
        with suppress(BrokenPipeError):
            pickle.dump(tuple(steps), process.stdin)
            process.stdin.flush()

    def answer(self) -> list[Note] | str:
        """What was seen, or how the process died."""
        process = self.start()
        assert process.stdout is not None
        ready, _, _ = select.select([process.stdout], [], [], self._seconds)
        if not ready:
            self.end()
            return "hangs"
        try:
            notes: list[Note] = pickle.load(process.stdout)
            return notes
        except (EOFError, pickle.UnpicklingError):
            status = process.wait()
            self.close()
            return f"dies of {signal.Signals(-status).name}" if status < 0 else f"exits {status}"

    def play(self, steps: Sequence[str]) -> list[Note] | str:
        """Both."""
        self.ask(steps)
        return self.answer()

    def end(self) -> None:
        """End the process, whatever it is at."""
        self.start().kill()
        self.close()

    def close(self) -> None:
        """Let the process end."""
        process, self._process = self._process, None
        if process is not None:
            assert process.stdin is not None
            assert process.stdout is not None
            with suppress(BrokenPipeError):
                process.stdin.close()
            process.stdout.close()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
