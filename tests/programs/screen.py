"""A virtual screen of its own for the programs, so that nothing else's windows lie over theirs."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager


class NoScreen(Exception):
    """No virtual screen can be started; the message says what to install."""


@contextmanager
def virtual_screen(width: int = 1280, height: int = 1024) -> Iterator[str]:
    """Start Xvfb on a free display and give its name."""
    if shutil.which("Xvfb") is None:
        raise NoScreen("Xvfb is not installed (Debian: apt install xvfb)")
    reader, writer = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writer), "-screen", "0", f"{width}x{height}x24",
         "-noreset", "-nolisten", "tcp"],
        pass_fds=(writer,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with os.fdopen(reader) as numbers:
            number = numbers.readline().strip()
        if not number:
            raise NoScreen(f"Xvfb ended at once with status {server.wait()}")
        yield f":{number}"
    finally:
        server.terminate()
        server.wait()
