"""Loads a model in a process of its own, so that the window goes on meanwhile.

`python -m demo_apps.viewer.loading MODEL` writes pickles on its standard output: how far it is, and
in the end the model, or what is wrong with it.
"""

import os
import pickle
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from queue import Empty, Queue
from threading import Thread
from typing import Any

from .models import ModelError, check, load
from .prepare import Ready, prepared

PATH = Path(__file__).parents[2]  # where demo_apps is found


def work(name: str) -> None:
    """What the process does."""
    out = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # whatever a reader prints is no pickle

    def tell(what: Any) -> None:
        pickle.dump(what, out, pickle.HIGHEST_PROTOCOL)
        out.flush()

    try:
        tell(prepared(load(name), lambda phase, share: tell((phase, share))))
    except ModelError as fault:
        tell(fault)
    except MemoryError:
        tell(ModelError(f"{Path(name).name} does not fit into memory"))


class Loading:
    """One model on its way. Raises ModelError at once for a name that is nothing."""

    def __init__(self, name: str) -> None:
        check(name)
        self.name = name
        self.phase, self.share = "reading", 0.0
        path = os.pathsep.join(filter(None, (str(PATH), os.environ.get("PYTHONPATH"))))
        self._process = subprocess.Popen(
            [sys.executable, "-m", __name__, name], env={**os.environ, "PYTHONPATH": path},
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
        self._told: Queue[Any] = Queue()
        Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as stream:
            try:
                while True:
                    self._told.put(pickle.load(stream))
            except (EOFError, pickle.UnpicklingError, ValueError, OSError):
                self._told.put(None)

    def poll(self, seconds: float = 0.0) -> Ready | None:
        """The model once it is there, after at most so many seconds. Raises ModelError."""
        while True:
            try:
                told = self._told.get(timeout=seconds) if seconds else self._told.get_nowait()
            except Empty:
                return None
            if isinstance(told, tuple):
                self.phase, self.share = told
                continue
            self.stop()
            if isinstance(told, Ready):
                return told
            name = Path(self.name).name
            raise told or ModelError(f"{name}: the process that reads it was killed")

    @property
    def ended(self) -> bool:
        """Whether the process is gone."""
        return self._process.poll() is not None

    def stop(self) -> None:
        """Give it up."""
        self._process.terminate()
        self._process.wait()


if __name__ == "__main__":
    # By its own name: what it sends is found again under that.
    import_module(__spec__.name).work(sys.argv[1])
