"""Fetches other people's programs from the package registry, once, into a cache elsewhere."""

import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from .catalog import HERE, Program

DISTRIBUTIONS = {
    "PyOpenGL-Demo": ("PyOpenGL-Demo==3.1.1", "--no-binary", ":all:"),
    "Planet3D": ("Planet3D==0.3.0",),
    "phalcopulse": ("phalcopulse==0.1.5",),
    "PyOpenGL": ("PyOpenGL==3.1.10", "--no-binary", ":all:"),  # its tests
    "psutil": ("psutil",),  # they import it
    "pyopengltk": ("pyopengltk==0.0.4",),
    "PySDL2": ("PySDL2==0.9.17", "pysdl2-dll"),
    "pyglet": ("pyglet==2.1.19",),
    "six": ("six",),  # PyOpenGL-Demo imports it
    "imageio": ("imageio",),  # phalcopulse imports it
    "PyQt5": ("PyQt5==5.15.11", "PyQt5-sip", "PyQt5-Qt5", "configobj"),  # for dxf2gcode
}
DEBIAN = {  # packages of Debian, unpacked, not installed; the libraries are for Qt's wheel
    "dxf2gcode": ("dxf2gcode", "libxcb-icccm4", "libxcb-keysyms1", "libxcb-xinerama0"),
    "Togl": ("libtogl2", "libxmu6"),
}
NEEDS = {"PyOpenGL-Demo": ("six",), "phalcopulse": ("imageio",), "dxf2gcode": ("PyQt5",)}
PLACES = {"dxf2gcode": "usr/lib/python3/dist-packages"}  # where a source's modules lie
MODULES = {  # that are here, or are not
    "pyopengltk": "tkinter", "Togl": "tkinter", "wx": "wx", "PyGObject": "gi",
}
LIBRARIES = {"dxf2gcode": "usr/lib/x86_64-linux-gnu", "Togl": "usr/lib/x86_64-linux-gnu"}
TCL = {"Togl": "usr/lib/tcltk"}  # where packages of Tcl's lie


class SourceMissing(Exception):
    """A distribution could not be fetched; the message says why."""


def cache_folder() -> Path:
    default = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "glshim-tests"
    return Path(os.environ.get("GLSHIM_TEST_CACHE", default))


@cache
def unpacked(name: str) -> Path:
    """The folder in which the distribution lies unpacked."""
    folder = cache_folder() / name
    if folder.is_dir():
        return folder
    folder.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=folder.parent) as scratch:
        download(name, Path(scratch))
        content = Path(scratch) / "content"
        for archive in [path for path in Path(scratch).iterdir() if path.is_file()]:
            unpack(archive, content)
        inside = list(content.iterdir())
        source_distribution = name in DISTRIBUTIONS and len(inside) == 1
        (inside[0] if source_distribution else content).rename(folder)
    return folder


def download(name: str, folder: Path) -> None:
    if name in DEBIAN:
        if not (shutil.which("apt-get") and shutil.which("dpkg")):
            raise SourceMissing(f"{name} is a package of Debian, and this is none")
        command = ["apt-get", "download", "-q", *DEBIAN[name]]
    else:
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps",
                   *DISTRIBUTIONS[name]]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        reason = (done.stderr.strip().splitlines() or [f"{command[0]} said nothing"])[-1]
        raise SourceMissing(f"{name} could not be fetched: {reason}")


def unpack(archive: Path, folder: Path) -> None:
    if archive.suffix == ".deb":
        subprocess.run(["dpkg", "-x", archive, folder], check=True)
    elif archive.suffix == ".whl":
        with zipfile.ZipFile(archive) as wheel:
            wheel.extractall(folder)
    else:
        with tarfile.open(archive) as tar:
            tar.extractall(folder, filter="data")


def fetched(name: str) -> Path | None:
    """The same, where this Python has what it needs besides; None where that is all."""
    needed = MODULES.get(name)
    if needed and find_spec(needed) is None:
        raise SourceMissing(f"this Python has no {needed}")
    return unpacked(name) if name in DISTRIBUTIONS or name in DEBIAN else None


@dataclass(frozen=True, slots=True)
class Launch:
    """How a program is started."""

    command: tuple[str, ...]
    folder: Path  # the working folder
    paths: tuple[Path, ...] = ()  # folders of Python modules
    libraries: tuple[Path, ...] = ()  # folders of shared libraries
    tcl: Path | None = None  # the folder of packages of Tcl's


def launch(program: Program) -> Launch:
    """Fetch the program where need be and say how it is started."""
    folder = HERE.parent.parent
    paths: list[Path] = []
    libraries: list[Path] = []
    source = fetched(program.source)
    if source is not None:
        folder = source
        paths = [folder / PLACES.get(program.source, ""),
                 *map(unpacked, NEEDS.get(program.source, ()))]
        if program.source in LIBRARIES:
            libraries = [folder / LIBRARIES[program.source]]
    command, where = tuple(program.script.split()), folder
    if command[0] != "-m":
        script = folder / program.script  # an absolute script stays itself
        command, where = (str(script),), script.parent
    tcl = folder / TCL[program.source] if program.source in TCL else None
    return Launch((*command, *program.arguments), where, tuple(paths), tuple(libraries), tcl)
