"""Runs a program exactly as ``python SCRIPT`` does, with GLSHIM_* variables set for it.

A new interpreter, not `runpy`: ``__main__``, ``sys.argv``, ``sys.path``, threads, pickling and exit
status are then Python's own.
"""

from __future__ import annotations

import os
import signal
import site
import subprocess
import sys
import sysconfig
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from types import FrameType
from typing import NoReturn

from glshim.errors import EnvironmentFault
from glshim.running.headless import headless_environment

STARTUP_FILE = "glshim.pth"


def run(program: Sequence[str], variables: Mapping[str, str], *, headless: bool) -> int:
    """Run ``python *program``; the exit status. On POSIX and with a screen it does not return:
    the program takes this process over, with its terminal, its signals and its process id.

    Raises `EnvironmentFault` when the program would run unstyled, or has no screen as asked for.
    """
    require_startup_file()
    command = [sys.executable, *interpreter_flags(), *program]
    if headless:
        with headless_environment() as environ:
            status = _wait_for(command, environ | dict(variables))
        return _leave_like(status)
    environ = {**os.environ, **variables}
    if os.name == "posix":
        _take_over(command, environ)
    return subprocess.call(command, env=environ)


def startup_file() -> Path | None:
    """The start-up file that this interpreter reads, None when it reads none of ours."""
    if sys.flags.no_site:
        return None
    folders = [sysconfig.get_path("purelib"), sysconfig.get_path("platlib")]
    folders += site.getsitepackages()
    if site.ENABLE_USER_SITE:
        folders.append(site.getusersitepackages())
    for folder in folders:
        path = Path(folder, STARTUP_FILE)
        if path.is_file():
            return path
    return None


def startup_fault() -> str:
    """Why Python would not start glshim with a program, and what to do; empty where it would."""
    if sys.flags.ignore_environment:
        return "python -I and python -E ignore the variables that glshim sets: leave out -I and -E"
    if startup_file() is not None:
        return ""
    if sys.flags.no_site:
        return "python -S reads no start-up files: run Python without -S, or call glshim.install()"
    for folder in sys.path:
        if Path(folder, STARTUP_FILE).is_file():
            return (
                f"glshim is in {os.path.abspath(folder)}, which is on PYTHONPATH: Python reads no "
                ".pth files there, so programs would run unstyled; install glshim into this Python "
                "(pip install, without --target), or call glshim.install() in the program"
            )
    return (
        f"{STARTUP_FILE} is not in the site-packages of {sys.executable}: install glshim into this "
        "Python (pip install .)"
    )


def require_startup_file() -> None:
    """Raises `EnvironmentFault` where Python would not start glshim with the program."""
    fault = startup_fault()
    if fault:
        raise EnvironmentFault(fault)


def interpreter_flags() -> list[str]:
    """The flags of this interpreter (-O, -W, -X ...), for another one."""
    flags: list[str] = subprocess._args_from_interpreter_flags()  # type: ignore[attr-defined]
    return flags


def _take_over(command: list[str], environ: dict[str, str]) -> NoReturn:
    for stream in (sys.stdout, sys.stderr):
        with suppress(Exception):
            stream.flush()
    os.execve(command[0], command, environ)


def _wait_for(command: list[str], environ: dict[str, str]) -> int:
    """Run beside us, since the screen must be stopped afterwards; signals go on to the program."""
    child = subprocess.Popen(command, env=environ)

    def forward(number: int, frame: FrameType | None) -> None:
        # The terminal gives Ctrl-C to the program as well.
        if number != signal.SIGINT or not os.isatty(0):
            child.send_signal(number)

    forwarded = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]
    before = {number: signal.signal(number, forward) for number in forwarded}
    try:
        return child.wait()
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _leave_like(status: int) -> int:
    """A program that a signal ended ends us by the same signal."""
    if status < 0:
        with suppress(OSError):  # SIGKILL has no handler to put back
            signal.signal(-status, signal.SIG_DFL)
        os.kill(os.getpid(), -status)
    return status
