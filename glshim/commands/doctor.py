"""``glshim doctor``: what is here and what will not work, or what is seen of one program."""

from __future__ import annotations

import argparse
import os
import platform
import shutil
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path
from typing import ClassVar

from glshim import toolkits
from glshim.commands import doctor_program as program
from glshim.commands.command import Command
from glshim.driver.context import UNAVAILABLE
from glshim.errors import EnvironmentFault, StyleError
from glshim.running import environment, launch, probe, startup_cost
from glshim.running.headless import headless_environment
from glshim.styling import registry, texts
from glshim.toolkits import Part

_SCREENS = ("DISPLAY", "WAYLAND_DISPLAY", "PYOPENGL_PLATFORM")
"""Variables of others that say where a window opens."""

_PACKAGES = ("PyOpenGL", "PyOpenGL-accelerate", "numpy", "moderngl", "glfw", "Pillow", "trimesh")
_LIBRARIES = {
    "GL": "libgl1",
    "GLU": "libglu1-mesa",
    "GLUT": "libglut-dev; PyOpenGL does not find libglut.so.3.12",
    "GLE": "libgle3",
}

_UNTESTED = "untested: written without a chance to run it; check the result before you rely on it"


class Doctor(Command):
    """Exit status: 0, or 1 where something will not work here, or a program is not restyled."""

    name: ClassVar[str] = "doctor"
    help: ClassVar[str] = "diagnose this environment, or a program"
    usage: ClassVar[str | None] = "glshim doctor [options] [SCRIPT | -m MODULE] [ARGS...]"

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument(
            "--headless", action="store_true",
            help="test OpenGL without a display: on a virtual screen (Xvfb), or through EGL",
        )
        parser.add_argument(
            "--startup-cost", action="store_true",
            help="measure what glshim adds to the start of Python",
        )
        program.add_arguments(parser)

    def run(self, asked: argparse.Namespace) -> int:
        if asked.startup_cost:
            return print_startup_cost()
        if program.is_asked_for(asked):
            return program.examine(asked)
        return print_report(headless=asked.headless)


def print_report(*, headless: bool = False) -> int:
    """Print everything; the status is 1 when something of it will not work here."""
    troubles: list[str] = []
    _heading("glshim")
    ours = version_of("glshim") or "not installed"
    _row("version", f"{ours} on Python {platform.python_version()}, {platform.platform()}")
    found = launch.startup_file()
    _row("start-up file", found or "missing")
    if fault := launch.startup_fault():
        troubles.append(f"GLSHIM_STYLE has no effect: {fault}")
    _row("styles", ", ".join(registry.names()) or "none installed")
    _row("looks", ", ".join(registry.looks()) or "none installed")
    if not registry.names() or not registry.looks():
        troubles.append("styles or looks are missing: reinstall glshim (pip install .)")
    _environment(troubles)
    _heading("packages and libraries")
    for name in _PACKAGES:
        _row(name, version_of(name) or "not installed")
    for name, package in _LIBRARIES.items():
        library = _library(name)
        _row(name, library or f"not found (Debian: {package})")
        if library is None:
            troubles.append(f"programs that need {name} fail: PyOpenGL does not find this library")
    missing = "not found; --headless uses EGL, for some toolkits (Debian: xvfb)"
    _row("Xvfb", shutil.which("Xvfb") or missing)
    _context(headless, troubles)
    _toolkits()
    _heading("what does not work")
    for trouble in troubles:
        print(f"  {trouble}")
    print(
        "  programs with their own shaders, or in a core profile: they run unstyled"
    )
    print("  python -S: it reads no start-up files")
    return 1 if troubles else 0


def _library(name: str) -> str | None:
    """The library that PyOpenGL itself loads under that name."""
    try:
        from OpenGL.platform import PLATFORM

        found = getattr(PLATFORM, name)
    except Exception:  # PyOpenGL raises different errors from one platform to the next
        return None
    return getattr(found, "_name", None)


def _environment(troubles: list[str]) -> None:
    _heading("variables")
    for variable in environment.VARIABLES:
        _row(variable.name, os.environ.get(variable.name) or f"not set; {variable.help}")
    for name in _SCREENS:
        if name in os.environ:
            _row(name, os.environ[name])
    settings, complaints = environment.read(os.environ)
    troubles.extend(complaints)
    if settings.style is not None:
        try:
            texts.parse_style(settings.style)
        except StyleError as error:
            troubles.append(f"{environment.STYLE}: {error}")


def _context(headless: bool, troubles: list[str]) -> None:
    _heading("OpenGL" + (" without a display" if headless else ""))
    try:
        if headless:
            with headless_environment() as environ:
                found = probe.ask(environ)
        else:
            found = probe.ask(os.environ)
    except EnvironmentFault as error:
        _row("context", error)
        troubles.append(f"cannot open a window: {error}" + ("" if headless else "; try --headless"))
        return
    _row("vendor", found.vendor)
    _row("renderer", found.renderer)
    _row("version", f"{found.version}, GLSL {found.glsl}")
    _row("profile", found.profile)
    _row("window", f"{found.depth_bits} depth bits, {found.samples} samples")
    if found.shortcoming:
        _row("lines", f"no: {found.shortcoming}")
        troubles.append(f"cannot draw lines: {found.shortcoming}; programs run unstyled")
        return
    who = "the GPU (OpenGL 3.3)" if found.expands_on_gpu else "the CPU (OpenGL 2.1)"
    _row("lines", f"yes, expanded by {who}")
    if not found.expands_on_gpu:
        _row("unavailable", UNAVAILABLE)
        troubles.append(f"{UNAVAILABLE}, and this is {found.version}; other lines work")


def _toolkits() -> None:
    _heading("toolkits")
    missing: list[str] = []
    for toolkit in toolkits.used():
        distribution = toolkit.distribution or toolkit.package
        if not find_spec(toolkit.package):
            missing.append(distribution)
            continue
        known = toolkit.name in (distribution, toolkit.package)
        version = version_of(distribution) or "here"
        first, *others = toolkit.places(Part.FRAMES)
        _row(toolkit.name, f"{version if known else f'{distribution} {version}'}; "
             f"a frame ends at {first}")  # fmt: skip
        for other in others:
            _row("", f"or at {other}")
        _row("", f"tested with {toolkit.tested}" if toolkit.tested else _UNTESTED)
        for part, effect in toolkit.lacks.items():
            _row("", f"without {part.value}: {effect}")
    if missing:
        _row("not installed", ", ".join(missing))
    untested = [toolkit.name for toolkit in toolkits.used() if not toolkit.tested]
    if untested:
        _row("untested", f"{', '.join(untested)}: written without a chance to run it")


def print_startup_cost() -> int:
    """Print what the start-up file costs every start of Python that sets no GLSHIM_* variable."""
    path = launch.startup_file()
    if path is None:
        raise EnvironmentFault(f"{launch.STARTUP_FILE} is not installed into this Python")
    for variable in environment.VARIABLES:
        os.environ.pop(variable.name, None)
    file, times, starts = startup_cost.of_file(path), startup_cost.TIMES, startup_cost.STARTS
    print(f"start-up file                       {path}")
    print(f"no GLSHIM_* variable set            {file * 1e6:8.1f} us (median of {times})")
    print(f"  glshim modules imported           {startup_cost.imported() or 'nothing'}")
    plain, armed = startup_cost.of_python({}), startup_cost.of_python({environment.STYLE: "raskar"})
    print(f"whole start of Python, not set      {plain * 1e3:8.2f} ms (median of {starts})")
    print(f"whole start of Python, set          {armed * 1e3:8.2f} ms, no PyOpenGL imported")
    return 0


def version_of(distribution: str) -> str | None:
    """Of an installed one."""
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def _heading(text: str) -> None:
    print(f"\n{text}")


def _row(name: str, value: str | Path | EnvironmentFault) -> None:
    print(f"  {name:<22} {value}")
