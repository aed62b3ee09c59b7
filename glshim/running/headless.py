"""A virtual screen of our own, Xvfb, started on a free display and stopped again; or no screen."""

from __future__ import annotations

import ctypes
import os
import select
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress

from glshim import toolkits
from glshim.errors import EnvironmentFault
from glshim.notices import say_once
from glshim.running.startup import DISPLAYLESS
from glshim.toolkits import Part

_INSTALL = (
    "apt-get install xvfb libgl1-mesa-dri (Debian, Ubuntu) or dnf install xorg-x11-server-Xvfb "
    "mesa-dri-drivers (Fedora)"
)
_DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY")
SCREEN = "1280x1024x24"
_SECONDS_TO_START = 20.0
PR_SET_PDEATHSIG = 1
"""From linux/prctl.h: the signal that a process gets when its parent dies."""


@contextmanager
def headless_environment() -> Iterator[dict[str, str]]:
    """The environment of a program on a `virtual_screen`. Where there is no Xvfb, one in which some
    toolkits draw without any screen, which is said in one line. Raises `EnvironmentFault`."""
    if shutil.which("Xvfb") is not None or not _has_egl():
        with virtual_screen() as environ:
            yield environ
        return
    able = [toolkit for toolkit in toolkits.used() if toolkit.displayless is not None]
    windows = ", ".join(toolkit.name for toolkit in able if toolkit.package != "OpenGL")
    say_once(
        f"Xvfb is not installed: running without a screen, through EGL. That works for {windows} "
        f"and programs without a window; other toolkits need Xvfb: {_INSTALL}"
    )
    plain = {name: text for name, text in os.environ.items() if name not in _DISPLAYS}
    ours = {name: text for each in able for name, text in (each.displayless or {}).items()}
    yield {"PYOPENGL_PLATFORM": "egl", **plain, **ours, DISPLAYLESS: "1"}


def prepare() -> None:
    """In a process of ours that opens windows by itself: as such an environment asks for."""
    if DISPLAYLESS in os.environ:
        toolkits.watch(Part.DISPLAYLESS)


def _has_egl() -> bool:
    with suppress(OSError):
        ctypes.CDLL("libEGL.so.1")
        return True
    return False


@contextmanager
def virtual_screen(screen: str = SCREEN) -> Iterator[dict[str, str]]:
    """A running virtual screen; gives the environment that puts a program on it.

    `screen` is its width, height and depth as Xvfb reads them.

    Raises `EnvironmentFault` when there is no Xvfb or it does not start.
    """
    program = shutil.which("Xvfb")
    if program is None:
        raise EnvironmentFault(f"--headless needs Xvfb, which is not installed: {_INSTALL}")
    reader, writer = os.pipe()
    # -displayfd: Xvfb picks a free display and writes its number when it is ready.
    # -noreset: it stays when a program closes its last window to open another.
    server = subprocess.Popen(
        [program, "-displayfd", str(writer), "-screen", "0", screen, "-nolisten", "tcp",
         "-noreset", "+extension", "GLX"],
        pass_fds=[writer], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, preexec_fn=_die_with_parent,  # noqa: PLW1509 (one thread)
    )  # fmt: skip
    os.close(writer)
    try:
        display = _read_display(reader, server)
        yield environment_on(display, os.environ)
    finally:
        os.close(reader)
        _stop(server)


def environment_on(display: str, environ: Mapping[str, str]) -> dict[str, str]:
    """The environment of a program on that X display: toolkits must not prefer a Wayland one."""
    changed = {key: text for key, text in environ.items() if key != "WAYLAND_DISPLAY"}
    return changed | {"DISPLAY": display, "XDG_SESSION_TYPE": "x11"}


def _read_display(reader: int, server: subprocess.Popen[bytes]) -> str:
    ready, _, _ = select.select([reader], [], [], _SECONDS_TO_START)
    number = os.read(reader, 16).strip().decode() if ready else ""
    if not number:
        server.kill()
        _, errors = server.communicate()
        reason = errors.decode(errors="replace").strip().splitlines()
        raise EnvironmentFault(
            f"cannot start Xvfb: {reason[-1] if reason else 'no reason given'}"
        )
    return f":{number}"


def _stop(server: subprocess.Popen[bytes]) -> None:
    server.terminate()
    try:
        server.wait(5)
    except subprocess.TimeoutExpired:
        server.kill()
        server.wait()
    if server.stderr is not None:
        server.stderr.close()


def _die_with_parent() -> None:
    """In the server's process: leave when we are killed, and let Ctrl-C be the program's alone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
